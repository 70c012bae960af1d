#include "explain/line_rules.h"

#include <string>
#include <vector>

#include "settings/choose_stages.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

using Texts = std::vector<std::string>;

Settings with_line(LineAlgorithm line, BresenhamRule rule = BresenhamRule::right) {
    Settings settings;
    settings.line = line;
    settings.bresenham_rule = rule;
    return settings;
}

/// The edge from (1, 2) to (6, 4), or the other way round.
EdgeMicroscope gentle_edge(const Settings& settings, bool back = false) {
    ScreenVertex a, b;
    a.column = back ? 6 : 1, a.row = back ? 4 : 2;
    b.column = back ? 1 : 6, b.row = back ? 2 : 4;
    return microscope(a, b, edge_rules(settings), choose_stages(settings));
}

Texts rules_of(const Settings& settings, bool back = false) {
    return line_rules(gentle_edge(settings, back), settings.line, settings.bresenham_rule);
}

} // namespace

TEST_CASE("The rule of a line has the numbers of its edge") {
    CHECK(rules_of(with_line(LineAlgorithm::bresenham)) ==
          Texts{"l = 5, s = 2; d starts at 2 s − l = -1", "d < 0: straight, d + 2 s = d + 4",
                "d ≥ 0: diagonal, d + 2 s − 2 l = d − 6"});
    CHECK(rules_of(with_line(LineAlgorithm::midpoint)) ==
          Texts{"l = 5, s = 2; d starts at s − l/2 = -0.5", "d ≤ 0: straight, d + s = d + 2",
                "d > 0: diagonal, d + s − l = d − 3"});
    CHECK(rules_of(with_line(LineAlgorithm::dda)) == Texts{"y starts at 2",
                                                           "each step adds 2/5 = 0.4 in float",
                                                           "row: the nearest whole number"});
    CHECK(rules_of(with_line(LineAlgorithm::interpolate)).empty());
}

TEST_CASE("A mistaken line shows the rule that it follows") {
    CHECK(rules_of(with_line(LineAlgorithm::bresenham, BresenhamRule::wrong_term)).back() ==
          "d ≥ 0: diagonal, d − 2 l = d − 10");
    CHECK(
        rules_of(with_line(LineAlgorithm::bresenham, BresenhamRule::first_octant), true).front() ==
        "l = -5, s = -2; d starts at 2 s − l = 1");
}

TEST_CASE("Each decision is shown with its sign, its step and its sum") {
    const EdgeMicroscope edge = gentle_edge(with_line(LineAlgorithm::bresenham));
    CHECK(decision_words(edge, LineAlgorithm::bresenham, 0) ==
          "d = -1 < 0: straight, then d = -1 + 4 = 3");
    CHECK(decision_words(edge, LineAlgorithm::bresenham, 1) ==
          "d = 3 ≥ 0: diagonal, then d = 3 − 6 = -3");
    CHECK(decision_words(edge, LineAlgorithm::bresenham, 5) == "d = -1: the last sample");
    const EdgeMicroscope middle = gentle_edge(with_line(LineAlgorithm::midpoint));
    CHECK(decision_words(middle, LineAlgorithm::midpoint, 1) ==
          "d = 1.5 > 0: diagonal, then d = 1.5 − 3 = -1.5");
    const EdgeMicroscope floats = gentle_edge(with_line(LineAlgorithm::dda));
    CHECK(decision_words(floats, LineAlgorithm::dda, 1) == "y = 2.4; next 2.8000002: diagonal");
    CHECK(decision_words(gentle_edge(Settings{}), LineAlgorithm::interpolate, 1).empty());
}
