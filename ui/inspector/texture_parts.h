#pragma once

#include <string>

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
