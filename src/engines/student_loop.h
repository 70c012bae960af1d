#pragma once

// The lab's loop as a student writes it: a std::vector for every polygon, edge and row, and one
// pixel at a time. It is the baseline for the engines, and it is written to be read, not to be
// fast.
//
// In:  triangles, a camera, a lamp.
// Out: a picture with 8 bits per channel, and its depth buffer.
// Picture: interpolate() walks the edges of each polygon; they fill the row table, left_pixels and
//          right_pixels; each row is then walked in the same way, and its pixels are shaded.
//
// It is slow because memory is allocated at every edge and row, a pixel carries all of its values
// through every step, and light, roots and divisions are worked out one pixel at a time.
//
// Its edges are those of the lab: vertices and samples are rounded to whole pixels.

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

struct StudentPicture {
    Viewport size;
    std::vector<std::uint32_t> colour; ///< 0x00RRGGBB, row by row from the top; black: nothing
    std::vector<float> depth;          ///< 1/z; 0: nothing
};

/// Draws the scene from a black picture, with light at each pixel, or at the vertices if
/// `settings.shading` is gouraud. Only the shading, camera, light and viewport settings count. All
/// of the scene must lie in front of the camera, which looks along +z.
void draw_as_student(const Scene& scene, const Settings& settings, StudentPicture& picture);

} // namespace rasterwalk
