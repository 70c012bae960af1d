#pragma once

#include "pipeline/draw_window.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/observer.h"
#include "pipeline/tally.h"

namespace rasterwalk {

/// Makes the framebuffer ready for a frame: black and empty, of the picture's size, or for a window
/// of it.
void clear(Framebuffer& framebuffer, const Frame& frame);
void clear(Framebuffer& framebuffer, const Frame& frame, Viewport size, glm::ivec2 origin);

/// Draws a window of the frame into a framebuffer that is at `window.from`. The framebuffer holds
/// the whole picture or a window of it. The driver of the whole pipeline: read it first.
///
/// If the framebuffer or the scissor leaves less than the whole picture, triangles that cannot
/// reach it are skipped: neither the tally nor the observer hears of them. Only a framebuffer
/// without pixels skips none: the observer then hears what happens to triangles before the pixels.
DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               const Observer* observer = nullptr);

/// The whole frame from a black framebuffer.
Framebuffer draw_frame(const Frame& frame);

/// Colours of the row ends in stage `rows`.
inline constexpr glm::vec3 left_end_colour{0.941f, 0.894f, 0.259f};
inline constexpr glm::vec3 right_end_colour{0.0f, 0.447f, 0.698f};

} // namespace rasterwalk
