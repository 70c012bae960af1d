#pragma once

#include <climits>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rasterwalk {

/// What kind of work a moment is, in the order in which a triangle goes through them.
enum class Phase : std::uint8_t { vertices, edges, rows };

/// A moment in the drawing of a frame: the next piece of work to be done. Everything before it is
/// done, nothing from it on. Totally ordered; counts from 0.
struct Cursor {
    int triangle = 0;
    Phase phase = Phase::vertices;
    int index = 0; ///< which vertex, edge, or row of the row table
    int step = 0;  ///< which sample of the edge, or which column of the row from its left end

    friend auto operator<=>(const Cursor&, const Cursor&) = default;
};

/// The first moment of every frame.
inline constexpr Cursor cursor_begin{};

/// The moment after the last, of every frame.
inline constexpr Cursor cursor_end{INT_MAX, Phase::vertices, 0, 0};

/// The text form: `t12/v1`, `t12/e2/s14`, `t12/r37/c5`, `end`.
std::string to_text(const Cursor& cursor);

/// Reads the text form; what is left away is 0: `t12` is `t12/v0`, `t12/r37` is `t12/r37/c0`.
std::optional<Cursor> parse_cursor(std::string_view text);

} // namespace rasterwalk
