#pragma once

#include <vector>

#include "scene/scene.h"
#include "settings/settings.h"
#include "stages/stages.h"

namespace rasterwalk {

/// A frame ready to be drawn: what is O(vertices) is worked out and kept; what is O(pixels) is left
/// to draw(). Refers to its scene, which must live as long.
struct Frame {
    const Scene* scene = nullptr;
    const Stages* stages = &standard_stages();
    Settings settings;
    std::vector<Fragment> vertices; ///< projected; three for each triangle, in order
    std::vector<VertexFault>
        left_out; ///< for each triangle the reason why it is not drawn, or none

    int triangle_count() const { return static_cast<int>(left_out.size()); }
    bool is_drawn(int triangle) const { return left_out[triangle] == VertexFault::none; }
    std::span<const Fragment> triangle_vertices(int triangle) const {
        return {vertices.data() + 3 * static_cast<std::size_t>(triangle), 3};
    }
};

/// Runs the vertex shader over the scene. A triangle with one faulty vertex is left out whole.
Frame prepare_frame(const Scene& scene, const Settings& settings,
                    const Stages& stages = standard_stages());

} // namespace rasterwalk
