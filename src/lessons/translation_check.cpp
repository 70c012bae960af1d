#include "lessons/translation_check.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "base/files.h"
#include "base/language_files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "lessons/lesson_list.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// What a step consists of besides its words, each with where a translation would have it.
std::vector<std::string> bones_of(const Lesson& lesson, std::size_t number) {
    const LessonStep& step = lesson.steps[number];
    std::vector<std::string> bones;
    for (const LessonPart& part : step.parts) {
        const auto index = static_cast<std::size_t>(part.index);
        switch (part.kind) {
        case LessonPart::Kind::text:
            break;
        case LessonPart::Kind::task:
            bones.push_back("the task " + in_quotes(lesson.tasks[index].id));
            break;
        case LessonPart::Kind::prediction:
            bones.push_back("the prediction " + in_quotes(lesson.predictions[index].id));
            break;
        case LessonPart::Kind::control:
            bones.push_back("the control of " + in_quotes(lesson.controls[index].name));
            break;
        case LessonPart::Kind::puzzle:
            bones.push_back("the code to put in order " + in_quotes(lesson.puzzles[index].id));
            break;
        }
    }
    for (const LinkPlace& link : step.links)
        bones.push_back((link.is_picture ? "the picture " : "a link to ") + in_quotes(link.target));
    std::sort(bones.begin(), bones.end());
    return bones;
}

std::vector<std::string> only_in_first(const std::vector<std::string>& first,
                                       const std::vector<std::string>& second) {
    std::vector<std::string> rest;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(rest));
    return rest;
}

/// The program's texts, as a folder of lessons lists them; a translation begins as a copy.
std::set<std::string> listed_texts(const std::string& folder) {
    const std::string path = (fs::path(folder) / "languages" / "texts.toml").string();
    const toml::table root = parse_toml(read_file(path, largest_language), path);
    std::set<std::string> texts;
    if (const toml::table* const table = root["texts"].as_table(); table != nullptr) {
        for (const auto& [key, node] : *table)
            texts.emplace(key.str());
    }
    return texts;
}

} // namespace

TranslationGaps translation_gaps(const std::string& folder, const std::string& code) {
    const Language language = read_language(folder, code);
    TranslationGaps gaps;
    for (const std::string& text : listed_texts(folder)) {
        ++gaps.all_texts;
        if (language.texts.count(text) == 0) gaps.texts.push_back(text);
    }
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const std::string name = entry->path().filename().string();
        if (!is_lesson_file(name)) continue;
        ++gaps.all_lessons;
        std::error_code ignored;
        if (!fs::exists(translated_lesson(folder, code, name), ignored))
            gaps.lessons.push_back(name);
    }
    std::sort(gaps.lessons.begin(), gaps.lessons.end());
    return gaps;
}

std::vector<Fault> text_faults(const std::string& path) {
    constexpr std::size_t most_text_faults = 200;
    const std::string bytes = read_file(path, largest_language);
    parse_language(bytes, path); // or throws
    const toml::table root = parse_toml(bytes, path);
    const std::set<std::string> known = listed_texts(lessons_folder_of(path));
    std::vector<Fault> faults;
    for (const auto& [key, node] : *root["texts"].as_table()) {
        if (faults.size() == most_text_faults) break;
        const std::string text(key.str()), translation = node.value_or(std::string());
        const int line = static_cast<int>(node.source().begin.line);
        if (known.count(text) == 0) {
            faults.push_back({line, "the program has no text " + in_quotes(text) + "."});
        } else if (!translation.empty() && !can_be_drawn(translation, text)) {
            faults.push_back({line, "the translation of " + in_quotes(text) +
                                        " must have letters, and no control characters."});
        } else if (!translation.empty() && places_in(translation) != places_in(text)) {
            const std::string places = places_in(text);
            faults.push_back(
                {line, "the translation of " + in_quotes(text) +
                           (places.empty() ? " must have no braces and no #."
                                           : " needs " + in_quotes(places) +
                                                 ", in this order, and no other braces or #.")});
        }
    }
    std::sort(faults.begin(), faults.end(),
              [](const Fault& a, const Fault& b) { return a.line < b.line; });
    return faults;
}

bool is_translation(const std::string& path) {
    const std::string file = fs::absolute(path).lexically_normal().string();
    return fs::path(file).parent_path().string() != lessons_folder_of(file);
}

std::vector<Fault> differences_from_english(const Lesson& translation) {
    const std::string original_path =
        (fs::path(translation.folder) / (translation.id + ".md")).string();
    std::error_code ignored;
    if (!fs::exists(original_path, ignored))
        return {{1, "there is no English lesson of this name, " + in_quotes(original_path) + "."}};
    const Lesson original = read_lesson(original_path);
    std::vector<Fault> faults;
    if (translation.steps.size() != original.steps.size()) {
        const auto steps_of = [](const Lesson& lesson) {
            return counted(static_cast<std::int64_t>(lesson.steps.size()), "part", "parts");
        };
        faults.push_back({1, fmt::format("the lesson has {}, with its opening; the English one has "
                                         "{}.",
                                         steps_of(translation), steps_of(original))});
        return faults;
    }
    for (std::size_t i = 0; i < original.steps.size(); ++i) {
        const std::vector<std::string> is = bones_of(translation, i);
        const std::vector<std::string> meant = bones_of(original, i);
        const int line = translation.steps[i].line;
        for (const std::string& missing : only_in_first(meant, is))
            faults.push_back({line, "this step lacks " + missing + " of the English one."});
        for (const std::string& extra : only_in_first(is, meant))
            faults.push_back({line, "the English step does not have " + extra + "."});
    }
    return faults;
}

} // namespace rasterwalk
