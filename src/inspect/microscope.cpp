#include "inspect/microscope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// Records the positions of both edges of a polygon with two vertices.
class BothEdges : public SampleSink {
  public:
    explicit BothEdges(EdgeMicroscope& into)
        : edge_(into), decides_(into.stages.line != line_by_interpolate) {}
    void edge_sample(const EdgeSample& sample) override {
        if (decides_ && sample.edge == 0) edge_.decisions.push_back(sample.decision);
        (sample.edge == 0 ? edge_.forward : edge_.reverse)
            .push_back({sample.x, sample.y, sample.fragment.column, sample.fragment.row});
    }

  private:
    EdgeMicroscope& edge_;
    bool decides_;
};

/// (a (n - i) + b i) / n; for an edge of one sample, a.
Fraction exact_place(int a, int b, int i, int n) {
    if (n == 0) return {a, 1};
    return reduced(static_cast<std::int64_t>(a) * n + static_cast<std::int64_t>(b - a) * i, n);
}

/// The pixel that a position should have. If two are equally near: its own, if it is one of them.
int nearest_pixel(int pixel, const Fraction& exact, int other) {
    const std::int64_t apart = 2 * (pixel * exact.denominator - exact.numerator);
    return std::abs(apart) <= exact.denominator ? pixel : other;
}

/// walked - exact. The product has at most 24 + 16 binary digits and is exact in double, so that
/// only the difference and the division round.
double drift_of(float walked, const Fraction& exact) {
    const auto denominator = static_cast<double>(exact.denominator);
    return (static_cast<double>(walked) * denominator - static_cast<double>(exact.numerator)) /
           denominator;
}

MicroscopeCoordinate coordinate(float walked, const Fraction& exact, int pixel, int exact_pixel,
                                int reverse_pixel) {
    return {walked, exact, drift_of(walked, exact), pixel, exact_pixel, reverse_pixel};
}

void summarize(EdgeMicroscope& edge) {
    MicroscopeSummary& summary = edge.summary;
    const auto keep_larger = [](const MicroscopeCoordinate& c, int sample, double& largest,
                                int& at) {
        if (std::abs(c.drift) <= std::abs(largest)) return;
        largest = c.drift;
        at = sample;
    };
    for (int i = 0; i < edge.count; ++i) {
        const MicroscopeSample sample = edge.at(i);
        keep_larger(sample.x, i, summary.largest_drift_x, summary.largest_drift_x_at);
        keep_larger(sample.y, i, summary.largest_drift_y, summary.largest_drift_y_at);
        summary.differ_from_reverse += sample.differs_from_reverse() ? 1 : 0;
        if (sample.differs_from_exact()) edge.differing.push_back(i);
    }
    for (const LineDecision& decision : edge.decisions) {
        if (std::abs(decision.before) > std::abs(summary.largest_decision))
            summary.largest_decision = decision.before;
    }
    const EdgeMicroscope::Place& last = edge.forward.back();
    summary.misses_end = last.column != edge.b.column || last.row != edge.b.row;
}

} // namespace

Fraction reduced(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t divisor = std::gcd(numerator, denominator);
    return {numerator / divisor, denominator / divisor};
}

bool EdgeMicroscope::shows(const ScreenVertex& from, const ScreenVertex& to, const EdgeRules& by,
                           const Stages& with) const {
    const auto same_place = [](const ScreenVertex& p, const ScreenVertex& q) {
        return p.column == q.column && p.row == q.row;
    };
    return count > 0 && same_place(a, from) && same_place(b, to) && rules == by && stages == with;
}

int EdgeMicroscope::opposite(int sample) const {
    const int n = count - 1, m = static_cast<int>(reverse.size()) - 1;
    if (n == m) return n - sample;
    return n > 0 ? m - (2 * sample * m + n) / (2 * n) : m;
}

MicroscopeSample EdgeMicroscope::at(int sample) const {
    const int n = count - 1;
    const Place& walked = forward[static_cast<std::size_t>(sample)];
    const Place& other_way = reverse[static_cast<std::size_t>(opposite(sample))];
    LineSample without_error;
    interpolate_exactly(line_end(a), line_end(b), {}, {count, sample, rules.rounding, {}},
                        {&without_error, 1});
    const Fraction x = exact_place(a.column, b.column, sample, n);
    const Fraction y = exact_place(a.row, b.row, sample, n);
    int column = without_error.fragment.column, row = without_error.fragment.row;
    if (decides()) {
        column = nearest_pixel(walked.column, x, column);
        row = nearest_pixel(walked.row, y, row);
    }
    return {sample, coordinate(walked.x, x, walked.column, column, other_way.column),
            coordinate(walked.y, y, walked.row, row, other_way.row)};
}

int EdgeMicroscope::next_difference(int sample) const {
    if (differing.empty()) return -1;
    const auto next = std::lower_bound(differing.begin(), differing.end(), sample);
    return next != differing.end() ? *next : differing.front();
}

EdgeMicroscope microscope(const ScreenVertex& a, const ScreenVertex& b, const EdgeRules& rules,
                          const Stages& stages) {
    EdgeMicroscope edge;
    edge.a = a;
    edge.b = b;
    edge.rules = rules;
    edge.stages = stages;
    BothEdges both_edges(edge);
    PolygonRows rows;
    // If coverage walks no edges, the edges are those of stage `edges`.
    Stages walking = walking_edges(stages);
    // Samples that are left out of the row table count too.
    walking.entered_samples = entered_samples;
    walking.compute_polygon_rows(std::array{a, b}, rules, walking, rows, &both_edges);
    edge.count = static_cast<int>(edge.forward.size());
    const int steps = std::max(edge.count - 1, 1);
    const LineStep step =
        stages.line_step(line_end(a), line_end(b), {edge.count, 0, rules.rounding, rules.carried});
    edge.step_x = reduced(b.column - a.column, steps);
    edge.step_y = reduced(b.row - a.row, steps);
    edge.float_step_x = step.x;
    edge.float_step_y = step.y;
    edge.frame = line_frame(line_end(a), line_end(b));
    summarize(edge);
    return edge;
}

void look_at(EdgeMicroscope& shown, const Frame& frame, int triangle, int edge) {
    const PolygonCorners v = frame.triangle_vertices(triangle);
    const auto from = static_cast<std::size_t>(edge);
    const ScreenVertex &a = v[from], &b = v[(from + 1) % v.size()];
    const EdgeRules rules = edge_rules(frame.settings);
    if (!shown.shows(a, b, rules, frame.stages)) shown = microscope(a, b, rules, frame.stages);
}

std::string to_text(const Fraction& fraction) {
    if (fraction.denominator == 1) return fmt::format("{}", fraction.numerator);
    return fmt::format("{}/{}", fraction.numerator, fraction.denominator);
}

} // namespace rasterwalk
