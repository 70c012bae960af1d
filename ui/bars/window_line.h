#pragma once

#include "ui/bars/time_lines.h"

namespace rasterwalk {

/// The bracket on the line of the frame, and below it what it encloses, enlarged: the pieces of a
/// triangle, in the colours of its edges; drags and clicks on both.
void draw_window_line(const TimeLines& s);

} // namespace rasterwalk
