#pragma once

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// What it takes to clear a pixel, beside a fragment.
inline constexpr double clear_pixel_work = 0.25;

/// By which rules the planes of a frame are begun and shown.
PictureRules picture_rules(const Frame& frame);

/// Makes some pixels of the planes black and empty again, by the rules that they have.
/// @param pixels of the planes, inside of them
void clear_part(Framebuffer& framebuffer, const Rectangle& pixels);

/// Begins to make the framebuffer ready for a frame, some rows at a time: it has no pixels until
/// clear_rows() has made them, all of them. Costs nothing, and keeps the memory of the planes.
void begin_clearing(Framebuffer& framebuffer, const Frame& frame);

/// Goes on with that from the top as far as the limit allows. False: rows are left.
bool clear_rows(Framebuffer& framebuffer, const WorkLimit& limit);

} // namespace rasterwalk
