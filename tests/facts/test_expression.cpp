#include "facts/expression.h"

#include <map>

#include "base/error.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

const std::map<std::string, Value, std::less<>> values{
    {"stage", std::string("depth")},
    {"interpolation", std::string("affine")},
    {"light.power", 14.0},
    {"camera.position.z", -3.001},
    {"row", 9.0},
    {"cursor", Cursor{0, Phase::rows, 4, 0}},
    {"cursor.phase", std::string("rows")},
    {"view", std::string("triangle")},
    {"pixel.uncovered", 1.0},
};

Value look_up(std::string_view name) {
    const auto found = values.find(name);
    return found != values.end() ? found->second : Value();
}

bool holds(const char* text) {
    return rasterwalk::holds(parse_condition(text), look_up);
}

std::string refusal(const std::string& text) {
    try {
        parse_condition(text);
    } catch (const UsageError& fault) {
        return fault.what();
    }
    return {};
}

} // namespace

TEST_CASE("An expression follows the rules of arithmetic") {
    const std::pair<const char*, double> cases[] = {
        {"1 + 2 * 3", 7},
        {"(1 + 2) * 3", 9},
        {"8 / 4 / 2", 1},
        {"2 - 3 - 4", -5},
        {"--3", 3},
        {"-row", -9},
        {"abs(-2.5)", 2.5},
        {"min(row, 3)", 3},
        {"max(row, 3) - 1", 8},
        {"500*2/4.001", 249.93751562109473},
        {"1e3", 1000},
        {"light.power / 2", 7},
    };
    for (const auto& [text, expected] : cases) {
        INFO(text);
        const auto number = number_of(parse_expression(text), look_up);
        REQUIRE(number);
        CHECK(*number == Approx(expected));
    }
}

TEST_CASE("A condition compares numbers, words and moments") {
    for (const char* text : {"stage == depth",
                             "stage != rows",
                             "depth == stage",
                             "row == 9",
                             "row != 8",
                             "cursor == t0/r4",
                             "cursor < end",
                             "cursor > t0/r3",
                             "cursor >= t0/e2/s0",
                             "cursor > t0/p5/s3 and cursor > t0/k",
                             "cursor < t1/p0",
                             "cursor.phase == rows",
                             "cursor.phase != end",
                             "view == triangle",
                             "pixel.uncovered",
                             "not (row > 9)",
                             "row > 8 and row < 10",
                             "row > 100 or stage == depth",
                             "abs(camera.position.z + 3.001) < 0.0001",
                             "camera.position.z == -3.001",
                             "vertex == none",
                             "row != none",
                             "not row == 3",
                             "1",
                             "-row < 0 and not 0"}) {
        INFO(text);
        CHECK(holds(text));
    }
    for (const char* text : {"stage == fill", "row > 9", "cursor == end", "not pixel.uncovered",
                             "row == none", "vertex != none", "0", "row == 9 and row == 8"}) {
        INFO(text);
        CHECK_FALSE(holds(text));
    }
}

TEST_CASE("Missing values make a condition neither true nor false") {
    CHECK_FALSE(holds("vertex == 1"));
    CHECK_FALSE(holds("vertex != 1"));
    CHECK_FALSE(holds("not (vertex == 1)"));
    CHECK_FALSE(holds("vertex == 1 and row == 9"));
    CHECK(holds("vertex == 1 or row == 9"));
    CHECK_FALSE(number_of(parse_expression("vertex + 1"), look_up));
    CHECK_FALSE(number_of(parse_expression("1 / (row - 9)"), look_up));
}

TEST_CASE("An expression that is not understood is answered with a sentence") {
    const std::pair<std::string, std::string> cases[] = {
        {"", "ends too early"},
        {"row >", "ends too early"},
        {"row > 3 )", "it is not clear what ')' means"},
        {"(row > 3", "a ')' is missing"},
        {"rwo > 3", "there is no name 'rwo'. Did you mean 'row'?"},
        {"stage == rowz", "stage is never 'rowz'"},
        {"stage == rowz", "Did you mean 'rows'?"},
        {"stage = rows", "to compare, write '=='"},
        {"stage", "is not a condition"},
        {"cursor", "is not a condition"},
        {"stage > rows", "words are compared using"},
        {"stage == 3", "a word cannot be compared with a number"},
        {"row == t0/r4", "a number cannot be compared with a moment"},
        {"stage + 1 == 3", "a number is needed instead of a word"},
        {"1 < row < 3", "instead of"},
        {"sqrt(4) > 1", "there is no function 'sqrt'"},
        {"min(1) > 1", "takes two numbers"},
        {"none == none", "can only be compared with a name"},
        {"row < none", "can only be compared with a name"},
        {"row == 1e999", "is not a number"},
        {"cursor == t0/x4", "is not a moment"},
        {"row & 3", "it is not clear what '& 3' means"},
        {"viewport.size > 3", "there is no name 'viewport.size'"},
        {"camera.position == 3", "there is no name 'camera.position'"},
        {std::string(2000, '1'), "at most 1000 bytes"},
        {std::string(100, '(') + "1" + std::string(100, ')'), "nested deeper than 32"},
        {std::string(100, '-') + "1 > 0", "nested deeper than 32"},
    };
    for (const auto& [text, answer] : cases) {
        INFO(text.substr(0, 60));
        CHECK_THAT(refusal(text), Catch::Matchers::ContainsSubstring(answer));
    }
    CHECK_THROWS_AS(parse_expression("row > 3"), UsageError);
}

TEST_CASE("A comparison that can never hold is found") {
    const auto count = [](const char* text) {
        return impossible_parts(parse_condition(text)).size();
    };
    for (const char* text :
         {"vertex == 3", "vertex > 2", "row == 2.5", "light.power > 10000", "light.power < 0",
          "pixel.uncovered == 2", "frame.fragments < 0", "1 > 2", "abs(row) < 0",
          "min(vertex, 1) > 1", "row > 3 and vertex == 7", "camera.yaw * 0 == 1",
          "viewport.width == 0", "vertex + 1 == 4", "vertex / 2 > 1", "-vertex > 0"}) {
        INFO(text);
        CHECK(count(text) == 1);
    }
    for (const char* text :
         {"vertex == 2", "light.power >= 10000", "row == 2", "row == -1", "row / 2 == 2.5",
          "stage == rows", "cursor == t0", "row == none", "1 / row < 0", "light.power != 14"}) {
        INFO(text);
        CHECK(count(text) == 0);
    }
    CHECK(impossible_parts(parse_condition("vertex == 3")).front() ==
          "'vertex == 3' can never be true: vertex is a whole number between 0 and 2.");
}

TEST_CASE("A word that has moved to another setting is still compared with that setting") {
    const auto depth_order = [](std::string_view name) {
        return name == "depth_order" ? Value(std::string("before_depth_test")) : Value();
    };
    const auto is_so = [&](const char* text) {
        return rasterwalk::holds(parse_condition(text), depth_order);
    };
    CHECK(is_so("shading == before_depth_test"));
    CHECK(is_so("before_depth_test == shading"));
    CHECK(is_so("shading != after_depth_test"));
    CHECK(refusal("shading == painted").find("shading is never 'painted'") == 0);
}
