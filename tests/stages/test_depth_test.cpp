#include <cstdlib>
#include <limits>
#include <utility>

#include "mistakes/depth_test.h"
#include "stages/depth_test.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Fragment fragment_near(float zinv, float z = 1.0f) {
    Fragment fragment;
    fragment.depth = zinv;
    fragment.z = z;
    return fragment;
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

const DepthRules lab{};

} // namespace

TEST_CASE("The depth value of a fragment is its 1/z, or 1 over its linear z") {
    CHECK(depth_test(fragment_near(0.75f, 2.0f), 0.0f, lab).depth == 0.75f);
    CHECK(no_depth_test(fragment_near(0.75f, 2.0f), 0.0f, lab).depth == 0.75f);
    CHECK(depth_test_reversed(fragment_near(0.75f, 2.0f), 0.0f, lab).depth == 0.75f);
    CHECK(depth_test_linear_z(fragment_near(0.75f, 2.0f), 0.0f, lab).depth == 0.5f);
}

TEST_CASE("A fragment is drawn only if its value is larger than what is stored") {
    const auto passes = [](float value, float stored) {
        const bool passed = depth_test(fragment_near(value), stored, lab).passed;
        CHECK(depth_test_linear_z(fragment_near(0.0f, 1.0f / value), stored, lab).passed == passed);
        return passed;
    };
    CHECK(passes(0.5f, 0.25f));
    CHECK(passes(0x1p-99f, 0.0f));
    CHECK_FALSE(passes(0.25f, 0.25f));
    CHECK_FALSE(passes(0.125f, 0.25f));
    CHECK_FALSE(passes(-1.0f, 0.0f));
    CHECK_FALSE(passes(not_a_number, 0.0f));
}

TEST_CASE("Without a depth test the last fragment wins, whatever its value") {
    CHECK(no_depth_test(fragment_near(0.1f), 0.9f, lab).passed);
    CHECK(no_depth_test(fragment_near(-1.0f), 0.9f, lab).passed);
    CHECK(no_depth_test(fragment_near(not_a_number), 0.0f, lab).passed);
}

TEST_CASE("Mistake B102 lets one in eight of what is not nearer pass, of odd number over even") {
    const auto passed = [](float zinv, int triangle, int owner) {
        DepthRules rules = lab;
        rules.triangle = triangle;
        rules.owner = owner;
        int count = 0;
        for (int pixel = 0; pixel < 10'000; ++pixel) {
            Fragment fragment = fragment_near(zinv);
            fragment.column = pixel % 100;
            fragment.row = pixel / 100;
            const DepthResult result = depth_test_raced(fragment, 0.5f, rules);
            if (result.passed) ++count;
        }
        return count;
    };
    // 10 000 / 8, within four standard deviations.
    CHECK(std::abs(passed(0.25f, 7, 4) - 1250) < 133);
    CHECK(std::abs(passed(0.5f, 7, 4) - 1250) < 133);
    CHECK(passed(0.75f, 7, 4) == 10'000);
    for (const auto& [triangle, owner] :
         {std::pair{6, 4}, {6, 3}, {7, 3}, {7, -1}, {-1, 4}, {-1, -1}})
        CHECK(passed(0.25f, triangle, owner) == 0);
    CHECK(passed(not_a_number, 7, 4) == 0);
    CHECK(passed(0.0f, 7, 4) == 0); // infinitely far
}

TEST_CASE("Mistake B17a lets the smaller value win, and B17c swaps the indices") {
    CHECK(depth_test_reversed(fragment_near(0.25f), 0.5f, lab).passed);
    CHECK_FALSE(depth_test_reversed(fragment_near(0.5f), 0.5f, lab).passed);
    CHECK_FALSE(depth_test_reversed(fragment_near(not_a_number), 0.5f, lab).passed);
    CHECK(depth_cell(3, 8) == glm::ivec2(3, 8));
    CHECK(depth_cell_transposed(3, 8) == glm::ivec2(8, 3));
}
