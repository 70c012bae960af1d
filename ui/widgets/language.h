#pragma once

// The language of the frame that is drawn. As with ImGui's font there is a current one, so that a
// text is measured in the language in which it is drawn.

#include <string>
#include <string_view>

#include "base/language.h"

namespace rasterwalk {

/// From now on texts are in this language, which must outlive the frames that are drawn.
void use_language(const Language& language);
const Language& current_language();

/// The text in the current language.
inline const char* tr(const char* text) {
    return tr(std::string_view(text), current_language()).data();
}
inline std::string tr(std::string_view text) {
    return std::string(tr(text, current_language()));
}
inline std::string tr(const std::string& text) {
    return tr(std::string_view(text));
}

/// The text in the current language, with values in the places of its {}.
template <class... Values>
requires(sizeof...(Values) > 0) std::string
    tr(fmt::format_string<const Values&...> text, const Values&... values) {
    return tr(current_language(), text, values...);
}

} // namespace rasterwalk
