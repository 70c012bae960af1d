#pragma once

#include <glm/vec3.hpp>
#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// A linear colour of the picture as it reaches the screen: encoded, and cut or wrapped.
ImU32 screen_colour(const Ui& ui, const glm::vec3& colour, float opacity = 1.0f);

/// A rectangle of such a colour, as high as a line of text, with a border so that black and white
/// can be seen on any ground.
/// @param border its opacity
void draw_swatch(const Ui& ui, ImVec2 at, float width, const glm::vec3& colour,
                 float opacity = 1.0f, float border = 1.0f);

} // namespace rasterwalk
