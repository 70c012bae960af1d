#include "stages/depth_test.h"

namespace rasterwalk {

float depth_value(const Fragment& fragment, DepthTest rule) {
    return rule == DepthTest::linear_z ? 1.0f / fragment.z : fragment.zinv;
}

bool depth_test(float value, float stored, DepthTest rule) {
    if (rule == DepthTest::reversed) return value < stored;
    return rule == DepthTest::off || value > stored;
}

} // namespace rasterwalk
