#pragma once

namespace rasterwalk {

struct Marks;

/// The squares into which the picture has been divided so far, as thin lines where they are wide
/// enough to be told apart, and the square that was looked at last. Nothing if the picture is not
/// divided, or is finished.
void draw_squares(const Marks& m);

} // namespace rasterwalk
