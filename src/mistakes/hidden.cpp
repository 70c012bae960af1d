#include "mistakes/hidden.h"

#include <algorithm>

namespace rasterwalk {

float nearest_depth(const CornerDepths& depths) {
    return std::min({depths[0], depths[1], depths[2]});
}

bool is_far_side(float camera_side) {
    return !is_near_side(camera_side);
}

} // namespace rasterwalk
