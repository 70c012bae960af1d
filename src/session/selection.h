#pragma once

#include <optional>

#include <glm/vec2.hpp>

namespace rasterwalk {

/// What is looked at: the same in every panel. Counts from 0.
struct Selection {
    std::optional<int> triangle;
    std::optional<int> vertex;       ///< of the triangle, 0..2
    std::optional<int> row;          ///< row of the picture
    std::optional<glm::ivec2> pixel; ///< column, row

    friend bool operator==(const Selection&, const Selection&) = default;
};

} // namespace rasterwalk
