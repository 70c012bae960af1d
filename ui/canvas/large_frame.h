#pragma once

// A frame of very many fragments: how many there are is said before they are drawn, and the drawing
// can be stopped.

#include "pipeline/work.h"

namespace rasterwalk {

struct Ui;

/// A frame with more fragments than this is announced. At about 20 nanoseconds each they take a
/// second.
inline constexpr double many_fragments = 50'000'000.0;

/// How much one update may draw: frame_limit, and of a frame with more than many_fragments in the
/// picture nothing until the student wants it.
WorkLimit work_limit(const Ui& ui);

/// A line above the picture with the number, and buttons to draw it, to stop and to clip; nothing
/// for frames of fewer fragments.
/// @return was there anything to say?
bool draw_large_frame_bar(Ui& ui);

} // namespace rasterwalk
