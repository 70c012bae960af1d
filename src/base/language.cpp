#include "base/language.h"

namespace rasterwalk {

const Language& english() {
    static const Language language;
    return language;
}

std::string_view tr(std::string_view text, const Language& language) {
    if (language.asked != nullptr) language.asked->emplace(text);
    const auto found = language.texts.find(text);
    return found == language.texts.end() ? text : std::string_view(found->second);
}

std::string places_in(std::string_view text) {
    std::string places;
    bool is_inside = false;
    for (const char c : text) {
        if (c == '{') is_inside = true;
        if (is_inside || c == '}' || c == '#') places += c;
        if (c == '}') is_inside = false;
    }
    return places;
}

bool can_be_drawn(std::string_view translation, std::string_view english) {
    const bool has_lines = english.find('\n') != std::string_view::npos;
    bool is_visible = false;
    for (const char c : translation) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' && !(c == '\n' && has_lines)) return false;
        is_visible = is_visible || byte > ' ';
    }
    return is_visible;
}

} // namespace rasterwalk
