#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "outside/sample_grid.h"

namespace rasterwalk {

/// The part of a line in the space of the eye beyond the near distance, in pixels.
struct EyeLine {
    glm::dvec2 from{0.0}, to{0.0};
    double inv_z_from = 0.0, inv_z_to = 0.0;
    bool is_seen = false;
};
EyeLine eye_line(const OutsideEye& eye, glm::dvec3 from, glm::dvec3 to);

/// The part of the line inside a rectangle, pixels; not seen if there is none.
EyeLine clipped_to(const EyeLine& line, glm::dvec2 low, glm::dvec2 high);

/// Draws a line, `width` samples wide, over whatever is not nearer.
/// @param from, to in the space of the eye
void draw_line(const OutsideEye& eye, const glm::dvec3& from, const glm::dvec3& to,
               std::uint32_t colour, int width, SampleGrid& grid);

} // namespace rasterwalk
