#include "lessons/lesson_lines.h"

#include <algorithm>
#include <string>

#include "base/quoted.h"
#include "lessons/lesson.h"

namespace rasterwalk {

namespace {

bool is_clean(std::string_view line) {
    const auto is_control = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
    };
    return is_utf8(line) && std::none_of(line.begin(), line.end(), is_control);
}

} // namespace

bool check_lines(const std::vector<std::string_view>& lines, FaultList& faults) {
    const auto refuse_lines = [&](auto is_good, const std::string& sentence) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!is_good(lines[i])) faults.refuse(static_cast<int>(i) + 1, sentence);
        }
    };
    if (lines.size() > static_cast<std::size_t>(most_lesson_lines)) {
        faults.refuse(most_lesson_lines,
                      "a lesson may have at most " + std::to_string(most_lesson_lines) + " lines.");
    }
    refuse_lines([](std::string_view line) { return line.size() <= longest_lesson_line; },
                 "the line is longer than " + std::to_string(longest_lesson_line) + " bytes.");
    if (faults.is_beyond_limits()) return false;
    refuse_lines(is_clean, "the line is not plain UTF-8 text, or contains control characters.");
    return !faults.is_beyond_limits();
}

} // namespace rasterwalk
