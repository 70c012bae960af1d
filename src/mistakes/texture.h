#pragma once

// Mistakes in the slot texel_place of stages/texture_lookup.h.

#include "stages/texture_lookup.h"

namespace rasterwalk {

/// B65: v goes from the bottom up, as in OBJ files, and the rows of the image from the top down.
float texel_place_upside_down(float coordinate, int count, TexelLine line);

/// B66: the centre of texel i is taken to be at i instead of at i + 1/2.
float texel_place_half_off(float coordinate, int count, TexelLine line);

/// B67: what is left of u or v without its whole part. With wrap_clamp, which then keeps the
/// texels inside, the last texel of a texture does not mix with the first of the next copy.
float texel_place_wrapped(float coordinate, int count, TexelLine line);

} // namespace rasterwalk
