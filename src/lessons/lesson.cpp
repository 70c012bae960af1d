#include "lessons/lesson.h"

#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "lessons/lesson_reader.h"
#include "text/markdown_text.h"

namespace rasterwalk {

Lesson parse_lesson(std::string_view text, const std::string& path) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf"; // some editors write it
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (text.size() <= largest_lesson) return read_lesson_lines(text, path);
    Lesson lesson = read_lesson_lines("", path);
    lesson.faults = {{0, "the lesson is larger than 1 MB."}};
    return lesson;
}

Lesson read_lesson(const std::string& path) {
    try {
        return parse_lesson(read_file(path, largest_lesson), path);
    } catch (const Error& fault) {
        Lesson lesson = parse_lesson("", path);
        std::string sentence = fault.what();
        // The sentence already begins with the path.
        const std::string cannot = "cannot read '" + path + "': ";
        if (sentence.starts_with(path + ": ")) {
            sentence.erase(0, path.size() + 2);
        } else if (sentence.starts_with(cannot)) {
            sentence.replace(0, cannot.size(), "the file cannot be read: ");
        }
        lesson.faults = {{0, std::move(sentence)}};
        return lesson;
    }
}

bool is_readable(const Lesson& lesson) {
    const LessonStep& opening = lesson.steps.front();
    return lesson.steps.size() > 1 || !opening.heading.empty() || !opening.parts.empty();
}

std::string fault_text(const Lesson& lesson, const Fault& fault) {
    if (fault.line <= 0) return fmt::format("{}: {}", lesson.path, fault.sentence);
    return fmt::format("{}:{}: {}", lesson.path, fault.line, fault.sentence);
}

int task_count(const Lesson& lesson) {
    return static_cast<int>(lesson.tasks.size() + lesson.puzzles.size());
}

const LessonPrediction* find_prediction(const Lesson& lesson, std::string_view id) {
    for (const LessonPrediction& prediction : lesson.predictions) {
        if (prediction.id == id) return &prediction;
    }
    return nullptr;
}

std::string with_footnotes(const Lesson& lesson, const std::string& text) {
    std::string result = text;
    for (const LessonFootnote& note : lesson.footnotes) {
        const std::string reference = "[^" + note.label + "]";
        if (text.find(reference) == text.npos) continue;
        result.append("\n\n").append(reference).append(": ").append(note.text);
    }
    return result;
}

std::string heading_text(const LessonStep& step) {
    return plain_text(parse_markdown("# " + step.heading).blocks);
}

std::string link_to_lesson(const Lesson& lesson) {
    return "[" + as_markdown(lesson.title) + "](" + lesson.id + ".md)";
}

} // namespace rasterwalk
