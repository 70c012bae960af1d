#include <cmath>

#include "base/sine.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace rounded_sine {

/// Hundredths of a radian, as students choose them. A long double has more digits than the double
/// that the functions round.
TEST_CASE("Sine and cosine are the floats nearest to the true values") {
    for (int hundredths = -700; hundredths <= 700; ++hundredths) {
        const float angle = static_cast<float>(hundredths) / 100.0f;
        CAPTURE(angle);
        const auto exact = static_cast<long double>(angle);
        REQUIRE(sine(angle) == static_cast<float>(std::sin(exact)));
        REQUIRE(cosine(angle) == static_cast<float>(std::cos(exact)));
    }
}

TEST_CASE("The cosine of 0.85 is rounded as on all systems") {
    // It is 0.65998312797: hardly nearer to this float than to the next, which some libraries give.
    CHECK(cosine(0.85f) == 0.659983099f);
}

} // namespace rounded_sine
} // namespace
