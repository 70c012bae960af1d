#include "lessons/lesson_picture.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view screenshots = "../screenshots/";

bool is_within(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

/// The file itself, with symbolic links resolved.
fs::path find_picture(const fs::path& folder, std::string_view target) {
    const bool is_screenshot = target.starts_with(screenshots);
    const std::string_view inner = target.substr(is_screenshot ? screenshots.size() : 0);
    const bool leads_out = fs::path(inner).is_absolute() || inner.find("..") != inner.npos ||
                           inner.find(':') != inner.npos || inner.find('\\') != inner.npos;
    const auto refuse = [&] {
        throw UsageError(
            fmt::format("the picture {} must be a PNG in the lessons folder or in ../screenshots/.",
                        in_quotes(target)));
    };
    if (leads_out || !inner.ends_with(".png")) refuse();
    std::error_code fault;
    const fs::path inside = is_screenshot ? folder / ".." / "screenshots" : folder;
    const fs::path root = fs::canonical(inside.empty() ? "." : inside, fault);
    const fs::path file = fault ? fs::path() : fs::canonical(root / inner, fault);
    if (fault) throw UsageError("there is no picture " + in_quotes(target) + ".");
    if (!is_within(file, root)) refuse();
    if (!fs::is_regular_file(file, fault)) {
        throw UsageError("there is no picture " + in_quotes(target) + ".");
    }
    return file;
}

} // namespace

Image read_lesson_picture(const std::string& folder, const std::string& target) {
    const fs::path file = find_picture(folder, target);
    try {
        return read_png(file.string(), largest_lesson_picture);
    } catch (const Error& fault) {
        // "path: sentence", with the picture's name as in the lesson.
        std::string_view sentence = fault.what();
        const std::string path = file.string() + ": ";
        if (sentence.starts_with(path)) sentence.remove_prefix(path.size());
        throw UsageError(fmt::format("the picture {}: {}", in_quotes(target), sentence));
    }
}

} // namespace rasterwalk
