#pragma once

#include <algorithm>
#include <optional>

#include <glm/vec2.hpp>

#include "pipeline/cursor.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// Which part of a frame is drawn: the moments from `from` up to, not including, `to`, and of them
/// only the part inside the scissor. Limits what is written and reported, never the numbers.
struct DrawWindow {
    Cursor from = cursor_begin;
    Cursor to = cursor_end;
    std::optional<Rectangle> scissor;
    int only = -1; ///< of squares, only those in which this triangle is drawn; -1: all
};

/// A scissor that leaves one pixel of the picture.
constexpr Rectangle only_pixel(const glm::ivec2& pixel) {
    return {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
}

/// The part [first, last) of `count` pieces of a phase that begin in the window. `piece` is the
/// first piece of the phase; `field` is the member of the cursor that counts its pieces.
struct PieceRange {
    int first, last;
};
inline PieceRange clamp_to_window(const DrawWindow& window, Cursor piece, int Cursor::*field,
                                  int count) {
    // A cursor of this triangle and phase bounds the loop by its own count; any other comes either
    // before or after all pieces.
    const auto begun_before = [&](const Cursor& bound) {
        const bool same_line = bound.pass == piece.pass && bound.square == piece.square &&
                               bound.triangle == piece.triangle && bound.phase == piece.phase &&
                               (field == &Cursor::index || bound.index == piece.index);
        if (!same_line) return bound > piece ? count : 0;
        const int whole = std::clamp(bound.*field, 0, count);
        const bool within_piece = field == &Cursor::index && bound.step > 0;
        return within_piece ? std::min(whole + 1, count) : whole;
    };
    return {begun_before(window.from), begun_before(window.to)};
}

} // namespace rasterwalk
