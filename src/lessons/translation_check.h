#pragma once

// Checks a language of the window and its lessons against the English ones: what is wrong in it,
// and what it still lacks.

#include <string>
#include <vector>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// What a language does not have yet.
struct TranslationGaps {
    std::vector<std::string> texts;   ///< in English
    std::vector<std::string> lessons; ///< their files: "04-edges.md"
    int all_texts = 0, all_lessons = 0;
};

/// @param folder of lessons. Throws InputError, AccessError.
TranslationGaps translation_gaps(const std::string& folder, const std::string& code);

/// The texts of a language that the program does not have, or that have other places for values.
/// Throws InputError for what cannot be read.
/// @param path of the file, `languages/sv/texts.toml` in a folder of lessons
std::vector<Fault> text_faults(const std::string& path);

/// Is the file in the folder of a language?
bool is_translation(const std::string& path);

/// Where a lesson differs from the English one of its name in more than its words: in the number of
/// steps, or in the questions, tasks, controls, pictures and links of a step.
std::vector<Fault> differences_from_english(const Lesson& translation);

} // namespace rasterwalk
