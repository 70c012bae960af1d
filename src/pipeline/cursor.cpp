#include "pipeline/cursor.h"

#include <charconv>

namespace rasterwalk {

namespace {

/// Takes a letter and a number from the front of the text.
std::optional<int> take_numbered(std::string_view& text, char letter) {
    if (text.empty() || text.front() != letter) return std::nullopt;
    int value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data() + 1, last, value);
    if (fault != std::errc{} || value < 0 || text[1] == '-') return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool take_slash(std::string_view& text) {
    if (text.empty() || text.front() != '/') return false;
    text.remove_prefix(1);
    return true;
}

} // namespace

std::string to_text(const Cursor& cursor) {
    if (cursor == cursor_end) return "end";
    const auto numbered = [](const char* letter, int number) {
        return std::string(letter).append(std::to_string(number));
    };
    const std::string triangle = numbered("t", cursor.triangle);
    switch (cursor.phase) {
    case Phase::vertices:
        return triangle + numbered("/v", cursor.index);
    case Phase::edges:
        return triangle + numbered("/e", cursor.index) + numbered("/s", cursor.step);
    case Phase::rows:
        return triangle + numbered("/r", cursor.index) + numbered("/c", cursor.step);
    }
    return triangle;
}

std::optional<Cursor> parse_cursor(std::string_view text) {
    if (text == "end") return cursor_end;
    Cursor cursor;
    const auto triangle = take_numbered(text, 't');
    if (!triangle) return std::nullopt;
    cursor.triangle = *triangle;
    if (text.empty()) return cursor;
    if (!take_slash(text) || text.empty()) return std::nullopt;
    const char kind = text.front();
    const auto index = take_numbered(text, kind);
    if (!index) return std::nullopt;
    cursor.index = *index;
    if (kind == 'v') return text.empty() ? std::optional(cursor) : std::nullopt;
    if (kind != 'e' && kind != 'r') return std::nullopt;
    cursor.phase = kind == 'e' ? Phase::edges : Phase::rows;
    if (text.empty()) return cursor;
    if (!take_slash(text)) return std::nullopt;
    const auto step = take_numbered(text, kind == 'e' ? 's' : 'c');
    if (!step || !text.empty()) return std::nullopt;
    cursor.step = *step;
    return cursor;
}

} // namespace rasterwalk
