#include "base/nearest_name.h"

#include <array>

#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The nearest name is the one with the fewest wrong letters") {
    constexpr std::array<std::string_view, 4> names{"render", "rows", "stats", "light.power"};
    CHECK(nearest_name("rendr", names) == "render");
    CHECK(nearest_name("row", names) == "rows");
    CHECK(nearest_name("tsats", names) == "stats");
    CHECK(nearest_name("power", names) == "light.power");
    CHECK(nearest_name("stats", names) == "stats");
}

TEST_CASE("If no name comes close, none is guessed") {
    constexpr std::array<std::string_view, 2> names{"render", "rows"};
    CHECK(nearest_name("elephant", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name(std::string(1000000, 'r'), names).empty());
    CHECK(did_you_mean("elephant", names).empty());
}
