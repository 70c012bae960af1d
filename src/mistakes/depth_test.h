#pragma once

// Mistakes in the slots of stages/depth_test.h.

#include "stages/depth_test.h"

namespace rasterwalk {

/// In the slot depth_test: compares z interpolated as if it changed in equal steps, converted to
/// what the buffer holds. If rays are parallel that is no mistake.
DepthResult depth_test_linear_z(const Fragment& fragment, float stored, const DepthRules& rules);

/// B17a, in the slot depth_test: what is farther wins.
DepthResult depth_test_reversed(const Fragment& fragment, float stored, const DepthRules& rules);

/// B88a, in the slot depth_test: of two that are equally near, the one drawn later wins.
DepthResult depth_test_or_equal(const Fragment& fragment, float stored, const DepthRules& rules);

/// B17c, in the slot depth_cell: [x][y] for [y][x]. If the picture is not square some pixels have
/// no cell; access outside is guarded, see has_depth_cell().
glm::ivec2 depth_cell_transposed(int column, int row);

} // namespace rasterwalk
