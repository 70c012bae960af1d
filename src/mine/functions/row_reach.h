#pragma once

// What rounding can do to a row table: the bounds within which every right one stays.

#include <string>
#include <vector>

#include "mine/kit/recording.h"

namespace rasterwalk {

/// How far rounding can move a coordinate, pixels: int(x + 0.5) moves a negative one by up to 1.5,
/// all others by at most 1.
inline constexpr double farthest_rounding = 1.5;

/// Can a right table have these ends of a row? The sample of an edge may be rounded to the row
/// above or below, and to the column before or after. The first and the last row may be empty.
bool can_reach(const std::vector<rasterwalk_kit::PixelValues>& corners, int row, double left,
               double right);

/// What is wrong with 1/z, the position or the light at the end of a row, a sentence; empty:
/// nothing. They must lie between those of the samples less than two pixels away, in equal steps or
/// with perspective.
std::string value_fault(const std::vector<rasterwalk_kit::PixelValues>& corners,
                        const rasterwalk_kit::PixelValues& end);

} // namespace rasterwalk
