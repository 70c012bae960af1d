#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/observer.h"

namespace rasterwalk {

/// Pixels from (left, top) up to, not including, (right, bottom).
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;

    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// Which part of a frame is drawn: the moments from `from` up to, not including, `to`, and of them
/// only what falls in the scissor. Limits what is written and who is told; never the numbers.
struct DrawWindow {
    Cursor from = cursor_begin;
    Cursor to = cursor_end;
    std::optional<Rectangle> scissor;
};

/// What draw() did with the triangles that it did not pass over.
struct DrawTally {
    std::int64_t fragments = 0;       ///< that fell in the framebuffer and the scissor
    std::int64_t samples_outside = 0; ///< edge samples outside their row table, of whole triangles
    int triangles_outside = 0;        ///< triangles with such samples
};

/// Draws a window of the frame into a framebuffer that stands at `window.from`. The framebuffer
/// holds the whole picture or a window of it. The driver of the whole pipeline: read it first.
///
/// Where less than the whole picture is drawn, by the framebuffer or the scissor, triangles that
/// cannot reach it are passed over: neither the tally nor the observer hears of them.
DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               Observer* observer = nullptr);

/// The whole frame from a black framebuffer.
Framebuffer draw_frame(const Frame& frame);

/// Colours of the row ends in stage `rows`.
inline constexpr glm::vec3 left_end_colour{0.941f, 0.894f, 0.259f};
inline constexpr glm::vec3 right_end_colour{0.0f, 0.447f, 0.698f};

} // namespace rasterwalk
