#pragma once

// The numbers of a pixel that edge functions have tested, with their formulas: each E, their sum,
// and the weights of the corners.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "explain/formula.h"
#include "settings/settings.h"
#include "stages/edge_functions.h"

namespace rasterwalk {

/// The edge whose function gives a corner's weight: the opposite one, or by mistake the one that
/// begins at the corner.
/// @param corner 0, 1 or 2
std::size_t edge_of_weight(std::size_t corner, WeightEdge made_of);

/// "e.0", "e.1", "e.2": the edge functions at the pixel's centre. In square pixels; the corners are
/// those on the grid of the snap, in pixels from the left and from the top of the picture.
/// "area": the sum of the three, twice the area of the triangle.
/// "weight.0", "weight.1", "weight.2": the weights of the triangle's corners.
///
/// The stage computes E without error, in whole 65536ths. The expression is worked out in float, so
/// for a triangle of many pixels it can be off in its last digits; the weights have the same bits.
/// @param triangle of the fan, which the pixel was tested for
/// @param corners  the names of its corners: "v0"
/// @param settings the ones it was tested with
std::vector<Formula> test_formulas(const TestedTriangle& triangle, const PixelTest& test,
                                   const std::array<std::string, edge_function_count>& corners,
                                   const Settings& settings);

} // namespace rasterwalk
