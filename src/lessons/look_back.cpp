#include "lessons/look_back.h"

#include <cctype>
#include <string>
#include <string_view>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::string_view label = "**Look back.** ";

int count_words(std::string_view text) {
    int words = 0;
    bool is_in_word = false;
    for (const char sign : text) {
        const bool is_blank = std::isspace(static_cast<unsigned char>(sign)) != 0;
        if (!is_blank && !is_in_word) ++words;
        is_in_word = !is_blank;
    }
    return words;
}

/// "... ([lesson 5](05-row-table.md))."
bool ends_with_lesson(std::string_view text) {
    constexpr std::string_view end = ".md)).";
    text = trimmed(text);
    const std::size_t target = text.rfind("](");
    if (!text.ends_with(end) || target == text.npos) return false;
    const std::size_t begin = target + 2, length = text.size() - end.size();
    return begin < length && text.substr(begin, length - begin).find(')') == text.npos;
}

/// @param line of its quote
void check_words(const LessonPrediction& prediction, int line, FaultList& faults) {
    std::string_view text = prediction.text;
    if (text.empty()) return; // is reported already
    if (text.starts_with(label)) {
        text.remove_prefix(label.size());
    } else {
        faults.add(line, "the quote of a look back begins with '**Look back.**'.");
    }
    if (count_words(text) > most_look_back_words) {
        faults.add(line, "the quote of a look back may have at most " +
                             std::to_string(most_look_back_words) + " words.");
    }
}

} // namespace

void check_looks_back(const Lesson& lesson, FaultList& faults) {
    for (const LessonStep& step : lesson.steps) {
        for (const LessonPart& part : step.parts) {
            if (part.kind != LessonPart::Kind::prediction) continue;
            const LessonPrediction& prediction =
                lesson.predictions[static_cast<std::size_t>(part.index)];
            if (!prediction.looks_back) continue;
            if (prediction.step > 0) {
                faults.add(prediction.line, "a prediction with look_back belongs in the opening.");
            } else if (&part != &step.parts.back()) {
                faults.add(prediction.line, "a look back is the last part of the opening.");
            }
            if (prediction.then) {
                faults.add(prediction.then->line,
                           "a look back has no 'then': the picture stays as it is.");
            }
            check_words(prediction, part.line, faults);
            if (!ends_with_lesson(prediction.because)) {
                faults.add(prediction.because_line, "'because' of a look back must end with a link "
                                                    "to a lesson: ([lesson 5](05-row-table.md)).");
            }
        }
    }
}

} // namespace rasterwalk
