#pragma once

// The texts of the window in languages other than English. The folder `languages/sv` of the lessons
// has those of Swedish: `texts.toml`, where each text is found by the English one, as in gettext,
// and lessons under the names of the English ones.

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace rasterwalk {

struct Language {
    std::string code;                                      ///< "sv"; empty: English
    std::string name = "English";                          ///< in the language itself: "Svenska"
    std::map<std::string, std::string, std::less<>> texts; ///< by the English text
    std::set<std::string>* asked = nullptr; ///< collects what is asked for; null: nothing does
};

const Language& english();

/// The text in a language; one that is missing is in English. Ends with a zero if `english` does.
std::string_view tr(std::string_view text, const Language& language);

/// The text in a language, with values in the places of its {}.
template <class... Values>
std::string tr(const Language& language, fmt::format_string<const Values&...> text,
               const Values&... values) {
    const fmt::string_view form = text;
    return fmt::vformat(tr({form.data(), form.size()}, language), fmt::make_format_args(values...));
}

/// The places for values, and every other brace or #, in their order: "{}{:.3f}", or "#" of
/// "edge #". A translation has the same ones as the English text.
std::string places_in(std::string_view text);

/// Does a translation have something to see, and no control characters but the ends of lines that
/// the English text has, too?
bool can_be_drawn(std::string_view translation, std::string_view english);

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
