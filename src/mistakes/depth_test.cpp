#include "mistakes/depth_test.h"

namespace rasterwalk {

DepthResult depth_test_linear_z(const Fragment& fragment, float stored) {
    const float depth = 1.0f / fragment.z;
    return {depth, depth > stored};
}

DepthResult depth_test_reversed(const Fragment& fragment, float stored) {
    return {fragment.depth, fragment.depth < stored};
}

glm::ivec2 depth_cell_transposed(int column, int row) {
    return {row, column};
}

} // namespace rasterwalk
