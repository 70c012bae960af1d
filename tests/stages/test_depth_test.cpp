#include <catch2/catch.hpp>

#include <limits>

#include "stages/depth_test.h"

using namespace rasterwalk;

TEST_CASE("The depth value of a fragment is its 1/z, or 1 over its linear z") {
    Fragment fragment;
    fragment.zinv = 0.75f;
    fragment.z = 2.0f;
    CHECK(depth_value(fragment, DepthTest::inverse_z) == 0.75f);
    CHECK(depth_value(fragment, DepthTest::off) == 0.75f);
    CHECK(depth_value(fragment, DepthTest::linear_z) == 0.5f);
}

TEST_CASE("A fragment is drawn only if its value is larger than what is stored") {
    for (const DepthTest rule : {DepthTest::inverse_z, DepthTest::linear_z}) {
        CHECK(depth_test(0.5f, 0.25f, rule));
        CHECK(depth_test(1e-30f, 0.0f, rule));
        CHECK_FALSE(depth_test(0.25f, 0.25f, rule));
        CHECK_FALSE(depth_test(0.2f, 0.25f, rule));
        CHECK_FALSE(depth_test(-1.0f, 0.0f, rule));
        CHECK_FALSE(depth_test(std::numeric_limits<float>::quiet_NaN(), 0.0f, rule));
    }
}

TEST_CASE("Without a depth test the last fragment wins, whatever its value") {
    CHECK(depth_test(0.1f, 0.9f, DepthTest::off));
    CHECK(depth_test(-1.0f, 0.9f, DepthTest::off));
    CHECK(depth_test(std::numeric_limits<float>::quiet_NaN(), 0.0f, DepthTest::off));
}
