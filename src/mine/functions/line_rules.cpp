#include "mine/functions/line_rules.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mistakes/interpolate.h"

namespace rasterwalk {

namespace {

/// to_pixel() for a double, which a float would round first.
int pixel_of(double value, Rounding rounding) {
    switch (rounding) {
    case Rounding::truncate:
        return static_cast<int>(value);
    case Rounding::floor:
        return static_cast<int>(std::floor(value));
    case Rounding::round:
        return static_cast<int>(std::floor(value + 0.5));
    }
    return 0;
}

void put_position(double x, double y, Rounding rounding, LineSample& sample) {
    sample.x = static_cast<float>(x);
    sample.y = static_cast<float>(y);
    sample.fragment.column = pixel_of(x, rounding);
    sample.fragment.row = pixel_of(y, rounding);
}

// In the slot `interpolate`: the lab's samples, with positions found in another way.

/// a (1 - t) + b t in float.
void walk_by_mixing(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                    std::span<LineSample> result) {
    mix_ends(a, b, part, result);
}

/// A running value in double.
void walk_in_double(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                    std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const double steps = std::max(part.count - 1, 1);
    const double step_x = (double{b.x} - double{a.x}) / steps;
    const double step_y = (double{b.y} - double{a.y}) / steps;
    double x = double{a.x}, y = double{a.y};
    for (LineSample& sample : result) {
        put_position(x, y, part.rounding, sample);
        x += step_x;
        y += step_y;
    }
}

/// a + i * step in double.
void multiply_in_double(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                        std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const double steps = std::max(part.count - 1, 1);
    const double step_x = (double{b.x} - double{a.x}) / steps;
    const double step_y = (double{b.y} - double{a.y}) / steps;
    double i = 0.0;
    for (LineSample& sample : result) {
        put_position(double{a.x} + i * step_x, double{a.y} + i * step_y, part.rounding, sample);
        ++i;
    }
}

/// a + t (b - a) in float, with t = i / n.
void walk_by_shares(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                    std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const float steps = static_cast<float>(std::max(part.count - 1, 1));
    float i = 0.0f;
    for (LineSample& sample : result) {
        const float t = i / steps;
        const float x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
        sample.x = x;
        sample.y = y;
        sample.fragment.column = to_pixel(x, part.rounding);
        sample.fragment.row = to_pixel(y, part.rounding);
        ++i;
    }
}

/// a + t (b - a) in double, with t = i / n.
void walk_by_double_shares(const LineEnd& a, const LineEnd& b, const LineStep&,
                           const LinePart& part, std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const double steps = std::max(part.count - 1, 1);
    const double dx = double{b.x} - double{a.x}, dy = double{b.y} - double{a.y};
    double i = 0.0;
    for (LineSample& sample : result) {
        const double t = i / steps;
        put_position(double{a.x} + t * dx, double{a.y} + t * dy, part.rounding, sample);
        ++i;
    }
}

/// a (1 - t) + b t in double.
void mix_in_double(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                   std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const double steps = std::max(part.count - 1, 1);
    double i = 0.0;
    for (LineSample& sample : result) {
        const double t = i / steps;
        put_position(double{a.x} * (1.0 - t) + double{b.x} * t,
                     double{a.y} * (1.0 - t) + double{b.y} * t, part.rounding, sample);
        ++i;
    }
}

/// a + (b - a) i / n in whole numbers: the distance from a is rounded, and not the position.
void walk_by_distance(const LineEnd& a, const LineEnd& b, const LineStep& step,
                      const LinePart& part, std::span<LineSample> result) {
    LineEnd from = a, to = b;
    from.x = from.y = 0.0f;
    to.x = b.x - a.x;
    to.y = b.y - a.y;
    interpolate_exactly(from, to, step, part, result);
    for (LineSample& sample : result) {
        sample.x += a.x;
        sample.y += a.y;
        sample.fragment.column += static_cast<int>(a.x);
        sample.fragment.row += static_cast<int>(a.y);
    }
}

/// Mistake: sample i has the value of sample i - 1.
template <auto walk>
void walk_lagging(const LineEnd& a, const LineEnd& b, const LineStep& step, const LinePart& part,
                  std::span<LineSample> result) {
    walk(a, b, step, part, result);
    for (std::size_t i = result.size(); i > 1; --i)
        result[i - 1] = result[i - 2];
}

/// Mistake: sample i has the value of sample i + 1.
template <auto walk>
void walk_leading(const LineEnd& a, const LineEnd& b, const LineStep& step, const LinePart& part,
                  std::span<LineSample> result) {
    LinePart later = part;
    ++later.first;
    walk(a, b, step, later, result);
}

/// B92 for a walk that does not use the step: t = i / N.
template <auto walk>
void walk_short(const LineEnd& a, const LineEnd& b, const LineStep& step, const LinePart& part,
                std::span<LineSample> result) {
    LinePart longer = part;
    ++longer.count;
    walk(a, b, step, longer, result);
}

/// Mistake: t = i / (N - 1) is divided as int by int, so it is 0 up to the last sample.
void walk_by_whole_shares(const LineEnd& a, const LineEnd& b, const LineStep& step,
                          const LinePart& part, std::span<LineSample> result) {
    interpolate_exactly(a, b, step, part, result);
    if (result.size() < 2) return;
    for (std::size_t i = 1; i + 1 < result.size(); ++i)
        result[i] = result[0];
}

/// In the slot `line`: a line algorithm that begins at the end which `order` says.
template <auto line, EdgeOrder order>
void line_from(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages& stages,
               std::span<LineSample> result, std::span<LineDecision> decisions) {
    const bool turn = order == EdgeOrder::down ? a.y > b.y : a.x > b.x;
    if (turn)
        line(b, a, part, stages, result, decisions);
    else
        line(a, b, part, stages, result, decisions);
}

template <auto line>
bool put_order(EdgeOrder order, Stages& stages) {
    if (stages.line != line) return false;
    if (order == EdgeOrder::down) stages.line = line_from<line, EdgeOrder::down>;
    if (order == EdgeOrder::left_first) stages.line = line_from<line, EdgeOrder::left_first>;
    return true;
}

struct Walk {
    std::string_view words;
    std::string_view setting; ///< of line_walk
    decltype(Stages::interpolate) interpolate;
};

constexpr Walk right_walks[] = {
    {"each step is added to the previous sample, in float", "accumulate", interpolate},
    {"sample i is a + i * step, in float", "multiply", interpolate_by_multiplying},
    {"sample i is a (1 - t) + b t, in float", "multiply", walk_by_mixing},
    {"sample i is a + t (b - a), in float", "multiply", walk_by_shares},
    {"each step is added to the previous sample, in double", "exact", walk_in_double},
    {"sample i is a + i * step, in double", "exact", multiply_in_double},
    {"sample i is a + t (b - a), in double", "exact", walk_by_double_shares},
    {"sample i is a (1 - t) + b t, in double", "exact", mix_in_double},
    {"sample i is computed without an error", "exact", interpolate_exactly},
    {"the distance from the first end is divided in whole numbers", "exact", walk_by_distance},
};

struct NamedRounding {
    Rounding rounding;
    std::string_view name, words;
};

constexpr NamedRounding roundings[] = {
    {Rounding::truncate, "truncate", "int() cuts the fraction"},
    {Rounding::floor, "floor", "floor() rounds down"},
    {Rounding::round, "round", "it is rounded to the nearest"},
};

LineRule rule_of(const Walk& walk, const NamedRounding& rounding) {
    LineRule rule;
    rule.words = std::string(walk.words) + ", and " + std::string(rounding.words);
    rule.settings = {{"line_walk", std::string(walk.setting)},
                     {"line_rounding", std::string(rounding.name)}};
    rule.stages.interpolate = walk.interpolate;
    rule.rounding = rounding.rounding;
    return rule;
}

LineRule rule_of(std::string_view name, decltype(Stages::line) line) {
    LineRule rule;
    rule.words = "the line is walked by the " + std::string(name) + " algorithm";
    rule.settings = {{"line", std::string(name)}};
    rule.stages.line = line;
    rule.needs_full_count = true;
    return rule;
}

std::vector<LineRule> make_right_rules() {
    std::vector<LineRule> rules;
    for (const Walk& walk : right_walks) {
        for (const NamedRounding& rounding : roundings)
            rules.push_back(rule_of(walk, rounding));
    }
    rules.push_back(rule_of("bresenham", line_by_bresenham));
    rules.push_back(rule_of("midpoint", line_by_midpoint));
    rules.push_back(rule_of("dda", line_by_dda));
    return rules;
}

/// A walk with a mistake in it.
struct MistakenWalk {
    decltype(Stages::interpolate) interpolate;
    decltype(Stages::line_step) line_step;
    std::string_view setting, bug, cause;
};

constexpr std::string_view lags =
    "Interpolate lags one sample behind: sample i has the value that belongs to sample i - 1, and "
    "the last sample is not the end.";
constexpr std::string_view leads =
    "Interpolate is one sample ahead: sample i has the value that belongs to sample i + 1, and the "
    "first sample is not the start.";
constexpr std::string_view divides_as_int =
    "i / (N - 1) is an int divided by an int, so it is 0 up to the last sample.";

constexpr MistakenWalk mistaken_walks[] = {
    {interpolate, line_step_of_integers, "integer_step", "B11", {}},
    {interpolate_by_multiplying, line_step_of_integers, "integer_step", "B11", {}},
    {interpolate, line_step_by_samples, "short_step", "B92", {}},
    {interpolate_by_multiplying, line_step_by_samples, "short_step", "B92", {}},
    {walk_short<walk_by_mixing>, line_step, "short_step", "B92", {}},
    {walk_short<walk_by_shares>, line_step, "short_step", "B92", {}},
    {walk_short<walk_in_double>, line_step, "short_step", "B92", {}},
    {walk_short<multiply_in_double>, line_step, "short_step", "B92", {}},
    {walk_short<walk_by_double_shares>, line_step, "short_step", "B92", {}},
    {walk_short<mix_in_double>, line_step, "short_step", "B92", {}},
    {walk_short<interpolate_exactly>, line_step, "short_step", "B92", {}},
    {walk_short<walk_by_distance>, line_step, "short_step", "B92", {}},
    {walk_lagging<interpolate>, line_step, "accumulate", {}, lags},
    {walk_lagging<interpolate_by_multiplying>, line_step, "multiply", {}, lags},
    {walk_lagging<walk_in_double>, line_step, "exact", {}, lags},
    {walk_leading<interpolate>, line_step, "accumulate", {}, leads},
    {walk_leading<interpolate_by_multiplying>, line_step, "multiply", {}, leads},
    {walk_leading<walk_in_double>, line_step, "exact", {}, leads},
    {walk_by_whole_shares, line_step, "exact", {}, divides_as_int},
};

std::vector<LineRule> make_mistaken_rules() {
    std::vector<LineRule> rules;
    for (const MistakenWalk& walk : mistaken_walks) {
        for (const NamedRounding& rounding : roundings) {
            LineRule& rule =
                rules.emplace_back(rule_of({{}, walk.setting, walk.interpolate}, rounding));
            rule.words = rounding.words;
            rule.stages.line_step = walk.line_step;
            rule.bug = walk.bug;
            rule.cause = walk.cause;
        }
    }
    return rules;
}

} // namespace

const std::vector<LineRule>& right_line_rules() {
    static const std::vector<LineRule> rules = make_right_rules();
    return rules;
}

const std::vector<LineRule>& mistaken_line_rules() {
    static const std::vector<LineRule> rules = make_mistaken_rules();
    return rules;
}

Stages with_edge_order(const Stages& stages, EdgeOrder order) {
    Stages ordered = stages;
    if (order == EdgeOrder::as_given) return ordered;
    static_cast<void>(put_order<line_by_interpolate>(order, ordered) ||
                      put_order<line_by_bresenham>(order, ordered) ||
                      put_order<line_by_midpoint>(order, ordered) ||
                      put_order<line_by_dda>(order, ordered));
    return ordered;
}

std::vector<LineSample> samples_by(const LineRule& rule, const LineEnd& a, const LineEnd& b,
                                   int count) {
    std::vector<LineSample> samples(static_cast<std::size_t>(count));
    const LinePart part{count, 0, rule.rounding, VaryingSet{}};
    rule.stages.line(a, b, part, rule.stages, samples, {});
    return samples;
}

LineEnd to_line_end(const rasterwalk_kit::PixelValues& values) {
    LineEnd end;
    end.x = static_cast<float>(values.x);
    end.y = static_cast<float>(values.y);
    end.depth = end.inv_w = static_cast<float>(values.zinv);
    for (int i = 0; i < 3; ++i) {
        end.varyings.position_world[i] = static_cast<float>(values.place[i]);
        end.varyings.illumination[i] = static_cast<float>(values.light[i]);
    }
    return end;
}

ScreenVertex to_screen_vertex(const rasterwalk_kit::PixelValues& values) {
    const LineEnd end = to_line_end(values);
    ScreenVertex vertex;
    vertex.column = static_cast<int>(values.x);
    vertex.row = static_cast<int>(values.y);
    vertex.depth = end.depth;
    vertex.inv_w = end.inv_w;
    vertex.varyings = end.varyings;
    return vertex;
}

} // namespace rasterwalk
