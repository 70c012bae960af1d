#include "mistakes/depth_test.h"

#include <cstdint>

#include "base/dice.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// Does the fragment belong to the thread that is late, and the pixel to the other one?
bool races_other_thread(const DepthRules& rules) {
    return rules.triangle >= 0 && rules.triangle % 2 == 1 && rules.owner >= 0 &&
           rules.owner % 2 == 0;
}

/// One in eight, the same ones in every run.
bool is_late(const Fragment& fragment, int triangle) {
    // Odd factors, so that neighbours have different seeds; unsigned, so that they may overflow.
    const std::uint32_t seed = static_cast<std::uint32_t>(fragment.column) * 0x9e3779b1u +
                               static_cast<std::uint32_t>(fragment.row) * 0x85ebca77u +
                               static_cast<std::uint32_t>(triangle) * 0xc2b2ae3du;
    return Dice(seed).below(8) == 0;
}

} // namespace

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

DepthResult depth_test_raced(const Fragment& fragment, float stored, const DepthRules& rules) {
    const DepthResult alone = depth_test_in_buffer(fragment, stored, rules);
    if (alone.passed || !races_other_thread(rules)) return alone;
    const ClipDepth kind = rules.projection.clip_depth;
    return {alone.depth, is_nearer(alone.depth, farthest_depth(kind), kind) &&
                             is_late(fragment, rules.triangle)};
}

glm::ivec2 depth_cell_transposed(int column, int row) {
    return {row, column};
}

} // namespace rasterwalk
