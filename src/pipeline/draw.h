#pragma once

#include <climits>
#include <cstdint>
#include <optional>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/observer.h"

namespace rasterwalk {

/// Which part of a frame is drawn: the moments from `from` up to, not including, `to`, and of them
/// only what falls in the scissor. Limits what is written and who is told; never the numbers.
struct DrawWindow {
    Cursor from = cursor_begin;
    Cursor to = cursor_end;
    std::optional<Rectangle> scissor;
};

/// The end of a window that holds a triangle to its last moment, and nothing of the next.
constexpr Cursor behind_triangle(int triangle) {
    return {triangle, phase_list.back().phase, INT_MAX, 0};
}

/// What draw() did with the triangles that it did not skip. What is told of row tables is told
/// of the triangles that begin in the window, so that tallies of windows that follow each other can
/// be added.
struct DrawTally {
    std::int64_t fragments = 0;         ///< that fell in the framebuffer and the scissor
    std::int64_t fragments_outside = 0; ///< beside the picture, of whole triangles
    std::int64_t samples_outside = 0; ///< edge samples outside their row table, of whole triangles
    int triangles_outside = 0;        ///< triangles with such samples
    int first_outside = -1;           ///< the first of them; -1: there is none
    std::int64_t shaded = 0;          ///< fragments whose colour was worked out, drawn or not
    std::int64_t rows_looked_at = 0;  ///< rows asked by the edge samples of whole triangles
    std::int64_t pixels_tested = 0;   ///< of whole triangles, in the picture, by edge functions
    std::int64_t unset_rows = 0;      ///< rows without a sample that are drawn all the same
    std::int64_t depth_outside = 0;   ///< tested fragments whose pixel has no depth cell

    friend bool operator==(const DrawTally&, const DrawTally&) = default;
};

DrawTally& operator+=(DrawTally& sum, const DrawTally& part);

/// What the row tables of the triangles from `first` on come to, without drawing them.
DrawTally tally_rows(const Frame& frame, int first);

/// Makes the framebuffer ready for a frame: black and empty, of the picture's size, or for a window
/// of it.
void clear(Framebuffer& framebuffer, const Frame& frame);
void clear(Framebuffer& framebuffer, const Frame& frame, Viewport size, glm::ivec2 origin);

/// Draws a window of the frame into a framebuffer that stands at `window.from`. The framebuffer
/// holds the whole picture or a window of it. The driver of the whole pipeline: read it first.
///
/// Where less than the whole picture is drawn, by the framebuffer or the scissor, triangles that
/// cannot reach it are skipped: neither the tally nor the observer hears of them.
DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               Observer* observer = nullptr);

/// The whole frame from a black framebuffer.
Framebuffer draw_frame(const Frame& frame);

/// Colours of the row ends in stage `rows`.
inline constexpr glm::vec3 left_end_colour{0.941f, 0.894f, 0.259f};
inline constexpr glm::vec3 right_end_colour{0.0f, 0.447f, 0.698f};

} // namespace rasterwalk
