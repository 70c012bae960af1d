#pragma once

// A checked program as a run to be compared with ours.

#include <memory>

#include "engines/program_drawing.h"
#include "mine/checked_program.h"
#include "scene/scene.h"

namespace rasterwalk {

/// The largest channel of a colour that is kept, either sign; NaN counts as 0. A program may put
/// anything.
inline constexpr float largest_put_channel = 1e6f;

/// What the program has drawn, next to our picture under its rules. Of points and edges, which may
/// have any colour, everything but black is white, as our own are. Null: there is no
/// picture, or which pixels make it is not known.
/// @param room the scene that it was checked against
std::shared_ptr<const ProgramDrawing> drawing_of(const CheckedProgram& checked,
                                                 const std::shared_ptr<const Scene>& room);

} // namespace rasterwalk
