#include "explain/line_rules.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// "+ 4", "− 6"
std::string added(double value) {
    return fmt::format("{} {}", value < 0.0 ? "−" : "+", decision_number(std::abs(value)));
}

/// "d < 0: straight, d + 2 s = d + 4"
std::string rule_line(const char* condition, const char* step, const char* formula, double value) {
    return fmt::format("{}: {}, d {} = d {}", condition, step, formula, added(value));
}

} // namespace

std::string decision_number(double value) {
    return fmt::format("{}", value);
}

std::string line_summary(LineAlgorithm line, BresenhamRule rule) {
    switch (line) {
    case LineAlgorithm::interpolate:
        break;
    case LineAlgorithm::bresenham:
        if (rule == BresenhamRule::first_octant) return "Bresenham's first octant, for all lines";
        if (rule == BresenhamRule::wrong_term) return "Bresenham with a wrong diagonal step";
        return "Bresenham: the sign of d chooses each step";
    case LineAlgorithm::midpoint:
        return "midpoint: d is f at the next midpoint";
    case LineAlgorithm::dda:
        return "DDA: one float addition per step, then rounded";
    }
    return {};
}

std::vector<std::string> line_rules(const EdgeMicroscope& edge, LineAlgorithm line,
                                    BresenhamRule rule) {
    double l = edge.frame.longer, s = edge.frame.shorter;
    const bool only_right = line == LineAlgorithm::bresenham && rule == BresenhamRule::first_octant;
    if (only_right) {
        l = edge.b.column - edge.a.column;
        s = edge.b.row - edge.a.row;
    }
    const std::string axes = fmt::format("l = {}, s = {}", decision_number(l), decision_number(s));
    switch (line) {
    case LineAlgorithm::interpolate:
        break;
    case LineAlgorithm::bresenham: {
        const bool is_wrong = rule == BresenhamRule::wrong_term;
        return {fmt::format("{}; d starts at 2 s − l = {}", axes, decision_number(2.0 * s - l)),
                rule_line("d < 0", "straight", "+ 2 s", 2.0 * s),
                rule_line("d ≥ 0", "diagonal", is_wrong ? "− 2 l" : "+ 2 s − 2 l",
                          is_wrong ? -2.0 * l : 2.0 * (s - l))};
    }
    case LineAlgorithm::midpoint:
        return {fmt::format("{}; d starts at s − l/2 = {}", axes, decision_number(s - 0.5 * l)),
                rule_line("d ≤ 0", "straight", "+ s", s),
                rule_line("d > 0", "diagonal", "+ s − l", s - l)};
    case LineAlgorithm::dda: {
        const bool steep = edge.frame.is_steep;
        const int rise = steep ? edge.b.column - edge.a.column : edge.b.row - edge.a.row;
        const float slope =
            static_cast<float>(rise) / static_cast<float>(std::max(edge.frame.longer, 1));
        const char axis = steep ? 'x' : 'y';
        return {fmt::format("{} starts at {}", axis, steep ? edge.a.column : edge.a.row),
                fmt::format("each step adds {} = {} in float",
                            to_text(reduced(rise, std::max(edge.frame.longer, 1))),
                            number_text(slope)),
                fmt::format("{}: the nearest whole number", steep ? "column" : "row")};
    }
    }
    return {};
}

std::string decision_words(const EdgeMicroscope& edge, LineAlgorithm line, int sample) {
    if (!edge.decides()) return {};
    const LineDecision& decision = edge.decisions[static_cast<std::size_t>(sample)];
    if (line == LineAlgorithm::dda) {
        const char axis = edge.frame.is_steep ? 'x' : 'y';
        const auto text = [](double value) { return number_text(static_cast<float>(value)); };
        if (decision.step == PixelStep::none)
            return fmt::format("{} = {}: the last sample", axis, text(decision.before));
        return fmt::format("{} = {}; next {}: {}", axis, text(decision.before),
                           text(decision.after), word_of(decision.step));
    }
    const std::string d = decision_number(decision.before);
    if (decision.step == PixelStep::none) return fmt::format("d = {}: the last sample", d);
    const bool is_straight = decision.step == PixelStep::straight;
    const char* const sign =
        line == LineAlgorithm::midpoint ? (is_straight ? "≤" : ">") : (is_straight ? "<" : "≥");
    return fmt::format("d = {} {} 0: {}, then d = {} {} = {}", d, sign, word_of(decision.step), d,
                       added(decision.after - decision.before), decision_number(decision.after));
}

} // namespace rasterwalk
