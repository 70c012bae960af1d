#include "mistakes/depth_test.h"

#include "stages/orthographic.h"

namespace rasterwalk {

DepthResult depth_test_linear_z(const Fragment& fragment, float stored, const DepthRules& rules) {
    const float depth = depth_in_buffer(depth_at(fragment.z, rules), rules);
    return {depth, is_nearer(depth, stored, rules.projection.clip_depth)};
}

DepthResult depth_test_reversed(const Fragment& fragment, float stored, const DepthRules& rules) {
    const float depth = depth_in_buffer(fragment.depth, rules);
    return {depth, is_nearer(stored, depth, rules.projection.clip_depth)};
}

DepthResult depth_test_or_equal(const Fragment& fragment, float stored, const DepthRules& rules) {
    const float depth = depth_in_buffer(fragment.depth, rules);
    return {depth, depth == stored || is_nearer(depth, stored, rules.projection.clip_depth)};
}

glm::ivec2 depth_cell_transposed(int column, int row) {
    return {row, column};
}

} // namespace rasterwalk
