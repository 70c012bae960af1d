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

/// B102, in the slot depth_test: a stand-in for a data race that is the same in every run. Two
/// threads share the depth buffer; one draws triangles of even number, the other those of odd
/// number. The first is always in time. The second is sometimes late: what the pixel shows was
/// written between the test of this fragment and its own write, so it is drawn although it is not
/// nearer. That happens to one in eight of the fragments that fall on a triangle of the first
/// thread, chosen by a hash of column, row and triangle. What the pixel held before is not known
/// here: it counts as empty. In a real program each run differs, and both threads can be late.
/// Source: H.-J. Boehm, S. V. Adve, "Foundations of the C++ Concurrency Memory Model", PLDI 2008;
/// of the hash: see Dice.
DepthResult depth_test_raced(const Fragment& fragment, float stored, const DepthRules& rules);

/// B17c, in the slot depth_cell: [x][y] for [y][x]. If the picture is not square some pixels have
/// no cell; access outside is guarded, see has_depth_cell().
glm::ivec2 depth_cell_transposed(int column, int row);

} // namespace rasterwalk
