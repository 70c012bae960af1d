#pragma once

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The work of clearing a pixel, relative to a fragment.
inline constexpr double clear_pixel_work = 0.25;

/// The rules by which the planes of a frame are begun and shown.
PictureRules picture_rules(const Frame& frame);

/// Makes some pixels of the planes black and empty again, by their rules.
/// @param pixels of the planes, inside them
void clear_part(Framebuffer& framebuffer, const Rectangle& pixels);

/// Begins to make the framebuffer ready for a frame, some rows at a time: it has no pixels until
/// clear_rows() has made all of them. Costs nothing, and keeps the memory of the planes.
void begin_clearing(Framebuffer& framebuffer, const Frame& frame);

/// Continues that from the top as far as the limit allows. False: rows are left.
bool clear_rows(Framebuffer& framebuffer, const WorkLimit& limit);

} // namespace rasterwalk
