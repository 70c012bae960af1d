#include "base/enumerated.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("Names are enumerated as in a sentence") {
    CHECK(enumerated({}).empty());
    CHECK(enumerated({"a"}) == "a");
    CHECK(enumerated({"a", "b"}) == "a and b");
    CHECK(enumerated({"a", "b", "c"}, "or") == "a, b or c");
}
