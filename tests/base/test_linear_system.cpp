#include <cmath>

#include "base/linear_system.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace linear_system {

constexpr std::size_t n = 4;

TEST_CASE("The matrix takes a linear system's solution back to the right-hand side") {
    test::Random random(17);
    for (int round = 0; round < test::rounds(500, 20); ++round) {
        std::array<std::array<double, n>, n> a{};
        std::array<double, n> expected{}, b{};
        for (std::size_t i = 0; i < n; ++i) {
            expected[i] = static_cast<double>(random.number(-5.0f, 5.0f));
            for (std::size_t k = 0; k < n; ++k)
                a[i][k] = static_cast<double>(random.number(-1.0f, 1.0f));
            a[i][(i + 1) % n] += 4.0; // far from singular, and no pivot is on the diagonal
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n; ++k)
                b[i] += a[i][k] * expected[k];
        }
        REQUIRE(solve_linear_system(a, b));
        for (std::size_t i = 0; i < n; ++i)
            CHECK(std::abs(b[i] - expected[i]) < 1e-9);
    }
}

TEST_CASE("A singular matrix has no solution") {
    std::array<double, 2> b{1.0, 2.0};
    CHECK_FALSE(solve_linear_system<2>({{{1.0, 2.0}, {2.0, 4.0}}}, b));
    CHECK_FALSE(solve_linear_system<2>({{{0.0, 0.0}, {0.0, 0.0}}}, b));
}

} // namespace linear_system
} // namespace
