#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "stages/rectangle.h"

namespace rasterwalk {

/// What the eye sees of each sample of its picture, row by row from the top.
struct SampleGrid {
    glm::ivec2 size{0, 0};
    std::vector<float> inv_z;          ///< 1/z of the eye's space, larger is nearer; 0: nothing
    std::vector<std::uint32_t> colour; ///< bytes red, green, blue from the lowest; the fourth is
                                       ///< not shown, and free for drawing
    std::vector<std::int32_t> id;      ///< of what is seen; -1: nothing

    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(column);
    }
    Rectangle all() const { return {0, 0, size.x, size.y}; }
};

/// Makes room for this many samples, still without content.
void resize(SampleGrid& grid, glm::ivec2 size);

/// A colour in the form of the samples.
/// @param colour red, green, blue; cut at 0 and 1
std::uint32_t packed_colour(const glm::vec3& colour);

} // namespace rasterwalk
