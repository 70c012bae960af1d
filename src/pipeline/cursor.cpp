#include "pipeline/cursor.h"

#include <algorithm>
#include <charconv>

namespace rasterwalk {

namespace {

bool take(std::string_view& text, char letter) {
    if (text.empty() || text.front() != letter) return false;
    text.remove_prefix(1);
    return true;
}

/// Takes a letter and a number from the front of the text.
std::optional<int> take_numbered(std::string_view& text, char letter) {
    if (!take(text, letter) || text.empty() || text.front() == '-') return std::nullopt;
    int value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data(), last, value);
    if (fault != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

const PhaseInfo* find_phase(char letter) {
    const auto found = std::find_if(phase_list.begin(), phase_list.end(),
                                    [&](const PhaseInfo& info) { return info.letter == letter; });
    return found == phase_list.end() ? nullptr : &*found;
}

std::string numbered(char letter, int number) {
    return std::string(1, letter).append(std::to_string(number));
}

} // namespace

std::string to_text(const Cursor& cursor) {
    if (cursor == cursor_end) return "end";
    const PhaseInfo& phase = phase_info(cursor.phase);
    std::string text = cursor.pass == 0 ? "" : numbered('p', pass_number(cursor.pass)) + ":";
    if (cursor == in_pass(cursor_end, cursor.pass)) return text + "end";
    if (cursor.square >= 0) text += numbered('w', cursor.square);
    if (is_square(cursor)) return text;
    if (cursor.square >= 0) text += "/";
    if (!is_resolve(cursor)) text.append(numbered('t', cursor.triangle)).append("/");
    if (!phase.is_numbered) return text + phase.letter;
    text += numbered(phase.letter, cursor.index);
    if (phase.step_letter != 0) text.append("/").append(numbered(phase.step_letter, cursor.step));
    return text;
}

std::string short_place(const Cursor& cursor) {
    if (is_square(cursor)) return numbered('w', cursor.square);
    const PhaseInfo& phase = phase_info(cursor.phase);
    if (!phase.is_numbered) return std::string(1, phase.letter);
    std::string text = numbered(phase.letter, cursor.index);
    if (phase.step_letter != 0) text.append(" [").append(std::to_string(cursor.step)).append("]");
    return text;
}

namespace {

/// Reads a phase with its piece and its step, to the end of the text.
bool read_piece(std::string_view text, Cursor& cursor) {
    const PhaseInfo* const phase = text.empty() ? nullptr : find_phase(text.front());
    if (phase == nullptr) return false;
    cursor.phase = phase->phase;
    if (phase->is_numbered) {
        const auto index = take_numbered(text, phase->letter);
        if (!index) return false;
        cursor.index = *index;
    } else {
        take(text, phase->letter);
    }
    if (text.empty()) return true;
    if (phase->step_letter == 0 || !take(text, '/')) return false;
    const auto step = take_numbered(text, phase->step_letter);
    if (!step || !text.empty()) return false;
    cursor.step = *step;
    return true;
}

} // namespace

std::optional<Cursor> parse_cursor(std::string_view text) {
    if (text == "end") return cursor_end;
    Cursor cursor;
    if (text.starts_with('p')) {
        const auto pass = take_numbered(text, 'p');
        if (!pass || *pass < 1 || *pass > early_pass_count || !take(text, ':')) return std::nullopt;
        cursor.pass = *pass - pass_number(0);
        if (text == "end") return in_pass(cursor_end, cursor.pass);
    }
    if (text.starts_with('w')) {
        const auto square = take_numbered(text, 'w');
        if (!square) return std::nullopt;
        cursor.square = *square;
        cursor.triangle = -1;
        if (text.empty()) return cursor;
        if (!take(text, '/')) return std::nullopt;
    }
    if (cursor.square < 0 && text.starts_with(phase_info(Phase::resolve).letter)) {
        cursor.triangle = resolve_triangle;
        return read_piece(text, cursor) ? std::optional(cursor) : std::nullopt;
    }
    const auto triangle = take_numbered(text, 't');
    if (!triangle) return std::nullopt;
    cursor.triangle = *triangle;
    if (text.empty()) return cursor;
    const bool is_read = take(text, '/') && read_piece(text, cursor);
    // Pixels are resolved after all triangles, by none of them.
    return is_read && cursor.phase != Phase::resolve ? std::optional(cursor) : std::nullopt;
}

} // namespace rasterwalk
