#pragma once

// The folder `languages/sv` of the lessons has what is in Swedish: `texts.toml`, the texts of the
// window, and lessons under the names of the English ones.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/language.h"

namespace rasterwalk {

/// Reads the texts of a language. A text without a translation, or with one that has other places
/// for values or that cannot be drawn, is left out. Throws InputError, AccessError.
/// @param folder of the lessons
/// @param code see is_language_code()
Language read_language(const std::string& folder, const std::string& code);

/// @param path is used in messages
Language parse_language(std::string_view text, const std::string& path);

/// "sv", "pt-br": small letters and hyphens, at most eight.
bool is_language_code(std::string_view code);

/// The codes of the languages that a folder of lessons has, in alphabetical order.
std::vector<std::string> language_codes(const std::string& folder);

/// The file of a language's texts, and that of a lesson in it, "05-row-table.md"; they need not
/// exist.
std::string texts_file(const std::string& folder, std::string_view code);
std::string translated_lesson(const std::string& folder, std::string_view code,
                              std::string_view lesson);

/// The folder of lessons that a file belongs to: the one it is in, or, if that is
/// `languages/CODE` and there are texts in one of these two, the one above.
std::string lessons_folder_of(const std::string& file);

/// Is it `languages/texts.toml`, which lists the texts of the program?
bool is_list_of_texts(const std::string& file);

inline constexpr std::size_t largest_language = std::size_t{1} << 20; ///< bytes

} // namespace rasterwalk
