#include "stages/depth_test.h"

namespace rasterwalk {

DepthResult depth_test(const Fragment& fragment, float stored) {
    return {fragment.depth, fragment.depth > stored};
}

DepthResult no_depth_test(const Fragment& fragment, float) {
    return {fragment.depth, true};
}

glm::ivec2 depth_cell(int column, int row) {
    return {column, row};
}

} // namespace rasterwalk
