#pragma once

// What the lab's program is given of a frame, and what it has drawn.

#include <glm/vec3.hpp>

#include "code/code_machine.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// Gives the program the triangles, the camera and the lamp.
void give_frame(CodeMachine& machine, const Frame& frame);

/// Gives it the picture and the depth buffer of a moment, whole and of the frame's size.
void give_planes(CodeMachine& machine, const Framebuffer& planes);

/// The colour it has drawn at a pixel, and the number in its depth buffer; 0 if it has none.
glm::vec3 drawn_colour(CodeMachine& machine, std::size_t pixel);
float drawn_depth(CodeMachine& machine, std::size_t pixel);

} // namespace rasterwalk
