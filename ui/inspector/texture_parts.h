#pragma once

#include <array>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <imgui.h>

#include "explain/map_reading.h"

namespace rasterwalk {

struct Ui;

// The parts of the Texture tab; see texture_panel.cpp. There must be a fragment.

/// Sides of the drawings, design pixels.
inline constexpr float map_side = 132.0f, texel_side = 56.0f;

/// How far the ring on the map reaches beyond it when its middle is at the border, design pixels.
inline constexpr float map_gap = 6.0f;

/// "normal map"
std::string map_words(SurfaceMap use);

/// The id of the formula that a map leads to first.
const char* first_number(SurfaceMap use);

/// As the screen shows a texture; the colours of other maps are numbers, which nothing encodes.
ImU32 colour_in_map(const Ui& ui, SurfaceMap use, const glm::vec3& colour);

/// Three numbers, each with its name and what the names of its formula and its widget begin with.
struct NumberLinks {
    std::string_view label; ///< in front of them; may be empty
    std::array<const char*, 3> names;
    glm::vec3 values;
    std::string formula, widget; ///< "bump.arrow.", to which a name is added
    std::string help;            ///< what comes after a name in the tooltip
};

/// Draws them in a line. Clicking one that has a formula asks about it.
void draw_number_links(Ui& ui, const NumberLinks& numbers);

/// The whole map, and the footprint of the pixel on it.
void draw_map(Ui& ui, const MapReading& reading);

/// The texels that were taken, in their places side by side, each with its weight.
void draw_sampled_texels(Ui& ui, const MapReading& reading);

/// The height of the taken texels one below another, with the gap between two levels, screen
/// pixels.
float height_of_sampled(const Ui& ui, const MapReading& reading);

/// The numbers of a normal map as an arrow, from above and from the side, and in writing.
void draw_map_arrow(Ui& ui, const BumpReport& bump);

} // namespace rasterwalk
