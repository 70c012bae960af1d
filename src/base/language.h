#pragma once

// The texts of the window in languages other than English, where each is found by the English one,
// as in gettext.

#include <map>
#include <set>
#include <string>
#include <string_view>

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

} // namespace rasterwalk
