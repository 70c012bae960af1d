#pragma once

// The rows of changed_formats(), by subject, and what their readers share.

#include <string>
#include <vector>

#include "base/error.h"
#include "support/changed_files.h"
#include "support/sound_model.h"

namespace rasterwalk::test {

std::vector<ChangedFormat> picture_formats(); ///< PNG first
std::vector<ChangedFormat> model_formats();   ///< models, materials, scenes and figures
std::vector<ChangedFormat> course_formats();  ///< what teachers write
std::vector<ChangedFormat> view_formats();    ///< what shows a view, or is kept between runs
std::vector<ChangedFormat> program_formats(); ///< what comes from a student's program

/// The file that models of these formats name for their materials.
extern const std::string changed_materials;

/// Pieces that trip up a reader of TOML.
extern const std::vector<std::string> toml_words;

/// What is wrong with a refusal; empty: nothing.
/// @param has_beginning if it begins with what it should
std::string problem_of_refusal(const std::string& sentence, bool has_beginning);

/// Calls a reader of a file that may name another one: a refusal begins with one of the two and a
/// line.
/// @param read returns what is wrong with what it has read
template <class Read>
FileOutcome text_outcome(const std::string& path, const std::string& other_path, const Read& read) {
    try {
        return {true, read()};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false,
                problem_of_refusal(said, has_line(said, path) || has_line(said, other_path))};
    }
}

/// Calls a reader of the file `x`.
template <class Read>
FileOutcome text_outcome(const Read& read) {
    return text_outcome("x", "x", read);
}

/// Calls a reader of words that are in no file.
template <class Read>
FileOutcome word_outcome(const Read& read) {
    try {
        return {true, read()};
    } catch (const Error& fault) {
        return {false, problem_of_refusal(fault.what(), true)};
    }
}

/// For a reader that has a writer: the text that it makes, and that text read and written again.
inline std::string problem_of_copy(const std::string& written, const std::string& again) {
    return written == again ? "" : "written and read again, it is different: " + written;
}

} // namespace rasterwalk::test
