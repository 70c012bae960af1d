#pragma once

#include "ui/bars/time_lines.h"

namespace rasterwalk {

/// The whole frame as a line, with the differences of two runs above it; drags and clicks on it.
/// @param has_window whether the enlarged part is shown
void draw_frame_line(const TimeLines& s, bool has_window);

} // namespace rasterwalk
