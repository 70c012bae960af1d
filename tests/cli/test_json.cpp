#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("JSON is laid out exactly as existing scripts read it") {
    const std::string rows = run({"rows", "--json", "0,2", "3,1"}).out;
    const std::string begin = R"({
    "outside" : [
        {
            "column" : 3,
            "edge" : 0,
            "row" : 0,
            "sample" : 3,
            "x" : 3.0,
            "y" : 0.99999988079071045
        }
    ],
    "rows" : [
        {
            "left" : 1,
            "left_by" : {
                "edge" : 0,
                "replaced" : 0,
                "sample" : 1
            },
)";
    CHECK(rows.substr(0, begin.size()) == begin);
    const std::string end = R"(
            "row" : 2
        }
    ]
}
)";
    CHECK(rows.ends_with(end));
    CHECK(run({"compare", "--json"}).out == R"({
    "a" : [],
    "b" : [],
    "different_pixels" : 0,
    "different_rows" : 0,
    "divergence_count" : 0,
    "divergences" : [],
    "largest_difference" : 0.0,
    "mean_difference" : 0.0,
    "pixels" : 250000,
    "shown_pixels" : 0,
    "first_divergence" : null,
    "cause" : null,
    "first_beyond_rounding" : null,
    "cause_beyond_rounding" : null
}
)");
}

TEST_CASE("JSON escapes every character that needs it, and no other") {
    const TemporaryFolder folder;
    const std::string path = folder.write("scene.toml", R"(
name = "escapes"
space = "pixels"
[viewport]
width = 8
height = 8
[points.one]
A = [1, 1]
B = [6, 1]
C = [1, 6]
[[part]]
name = "a\u001b\u000b\"\\\u007f\u0085\u2028é\t\n\b\f\r𝄞"
points = "one"
reflectance = [1, 1, 1]
triangles = ["A B C"]
)");
    const CliRun result = run({"triangle", "0", "--scene", path, "--json"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, Catch::Matchers::ContainsSubstring(
                               "    \"name\" : "
                               R"("a\u001B\u000B\"\\\u007F\u0085\u2028é\t\n\b\f\r𝄞")"
                               ",\n"));
}
