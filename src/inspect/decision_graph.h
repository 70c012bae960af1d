#pragma once

// The decision variable of a line along the cells that it has taken: each value over or next to the
// pixel where it decided, as a graph on the picture shows it.

#include <vector>

#include <glm/vec2.hpp>

#include "inspect/microscope.h"

namespace rasterwalk {

/// What a line decides at one of its pixels.
struct DecisionMark {
    glm::ivec2 pixel{0}; ///< column, row
    double before = 0.0; ///< d, which decides there
    glm::ivec2 step{0};  ///< to the next pixel; 0, 0 at the last one

    friend bool operator==(const DecisionMark&, const DecisionMark&) = default;
};

struct DecisionGraph {
    bool is_steep = false; ///< one value a row; if not, one a column
    double least = 0.0,
           most = 0.0; ///< of all values along the edge, and 0: the graph does not jump
    std::vector<DecisionMark> marks; ///< in the order in which the pixels are taken
};

/// The graph of the first samples of an edge; without marks if no variable decides there.
/// @param samples so many are taken
DecisionGraph decision_graph(const EdgeMicroscope& edge, int samples);

} // namespace rasterwalk
