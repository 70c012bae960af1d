#pragma once

// Mistakes in the slots of stages/texture_lookup.h and stages/texture_level.h.

#include "stages/texture_lookup.h"

namespace rasterwalk {

/// B65, in the slot texel_place: v runs up, as in model files, but the rows are read from the top.
float texel_place_upside_down(float coordinate, TextureDirection direction, int count);

/// B66, in the slot texel_place: the centre of texel i is taken to be at i, so every position is
/// half a texel further on.
float texel_place_of_whole_centres(float coordinate, TextureDirection direction, int count);

/// B97, in the slot texture_level: only how far the pixel reaches to the next column counts. If it
/// reaches further to the next row the level is too fine.
float texture_level_along_x(const Footprint& footprint, const Texture& texture);

/// B67, in the slot wrap_texel: the result of %, which is below 0 for a texel below 0.
int wrap_by_remainder(int texel, int count);

/// B67, in the slot read_texel: column -1 is the last of the row above, as the texels lie in
/// memory. Guarded: anything before the first texel or after the last is black.
glm::vec3 read_texel_in_memory(const TextureLevel& level, int column, int row);

} // namespace rasterwalk
