#pragma once

// The stages of lines, edges and rows under given words of the settings, one sample at a time.

#include <array>
#include <climits>
#include <span>
#include <vector>

#include "inspect/microscope.h"
#include "inspect/row_history.h"
#include "pipeline/observer.h"
#include "settings/choose_stages.h"
#include "stages/polygon_corners.h"

namespace rasterwalk::test {

/// How a line is walked.
struct LineRules {
    LineWalk walk = LineWalk::accumulate;
    Rounding rounding = Rounding::truncate;
};

/// How the edges of a polygon are walked.
struct WalkRules {
    LineRules line;
    EdgeSamples samples = EdgeSamples::longest_axis;
};

inline Settings settings_of(const WalkRules& rules) {
    Settings settings;
    settings.line_walk = rules.line.walk;
    set_rounding(settings, rules.line.rounding);
    settings.edge_samples = rules.samples;
    return settings;
}

/// Goes to one sample of a line after the other; asks the stage for each separately.
class LineWalker {
  public:
    LineWalker(const ScreenVertex& a, const ScreenVertex& b, int count, const LineRules& rules)
        : a_(line_end(a)), b_(line_end(b)), count_(count), rounding_(rules.rounding),
          stages_(choose_stages(settings_of({rules, {}}))) {
        advance_to(0);
    }
    const Fragment& sample() const { return sample_.fragment; }
    float x() const { return sample_.x; }
    float y() const { return sample_.y; }
    int index() const { return index_; }
    bool done() const { return index_ >= count_; }
    void advance() { advance_to(index_ + 1); }
    void advance_to(int index) {
        index_ = index;
        const LinePart part{count_, index, rounding_, VaryingSet::all()};
        stages_.interpolate(a_, b_, stages_.line_step(a_, b_, part), part, {&sample_, 1});
    }

  private:
    LineEnd a_, b_;
    int count_;
    int index_ = 0;
    Rounding rounding_;
    Stages stages_;
    LineSample sample_;
};

inline void interpolate(const ScreenVertex& a, const ScreenVertex& b, const LineRules& rules,
                        std::span<Fragment> result) {
    const Stages stages = choose_stages(settings_of({rules, {}}));
    const int count = static_cast<int>(result.size());
    std::vector<LineSample> samples(result.size());
    const LinePart part{count, 0, rules.rounding, VaryingSet::all()};
    const LineEnd from = line_end(a), to = line_end(b);
    stages.interpolate(from, to, stages.line_step(from, to, part), part, samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
        result[i] = samples[i].fragment;
}

inline int edge_sample_count(const ScreenVertex& a, const ScreenVertex& b, EdgeSamples samples) {
    return choose_stages(settings_of({{}, samples})).edge_sample_count(a, b);
}

inline LineWalker walk_edge(const ScreenVertex& a, const ScreenVertex& b, const WalkRules& rules) {
    return {a, b, edge_sample_count(a, b, rules.samples), rules.line};
}

inline RowWrite add_edge_sample(const Fragment& sample, PolygonRows& rows) {
    return rasterwalk::add_edge_sample(sample, VaryingSet::all(), Stages{}, rows);
}

inline void compute_polygon_rows(PolygonCorners vertices, const Settings& settings,
                                 PolygonRows& rows) {
    const Stages stages = choose_stages(settings);
    stages.compute_polygon_rows(vertices, edge_rules(settings), stages, rows, nullptr);
}
inline void compute_polygon_rows(PolygonCorners vertices, const WalkRules& rules,
                                 PolygonRows& rows) {
    compute_polygon_rows(vertices, settings_of(rules), rows);
}

inline RowHistory row_history(PolygonCorners vertices, const WalkRules& rules,
                              int samples = INT_MAX) {
    const Settings settings = settings_of(rules);
    return rasterwalk::row_history(vertices, edge_rules(settings), choose_stages(settings),
                                   samples);
}

inline EdgeMicroscope microscope(const ScreenVertex& a, const ScreenVertex& b,
                                 const WalkRules& rules) {
    const Settings settings = settings_of(rules);
    return rasterwalk::microscope(a, b, edge_rules(settings), choose_stages(settings));
}

inline bool shows(const EdgeMicroscope& edge, const ScreenVertex& a, const ScreenVertex& b,
                  const WalkRules& rules) {
    const Settings settings = settings_of(rules);
    return edge.shows(a, b, edge_rules(settings), choose_stages(settings));
}

/// The table of stages under this interpolation.
inline Stages stages_under(Interpolation interpolation) {
    Settings settings;
    settings.interpolation = interpolation;
    return choose_stages(settings);
}

inline Varyings recover_varyings(const Fragment& fragment, Interpolation interpolation) {
    return rasterwalk::recover_varyings(fragment, stages_under(interpolation));
}

/// The light under these rules.
inline LightTerms reflected_light(const glm::vec3& place, const glm::vec3& normal,
                                  const glm::vec3& reflectance, const Light& light,
                                  const LightRules& rules) {
    Settings settings;
    settings.light_rules = rules;
    return choose_stages(settings).reflected_light(place, normal, reflectance, light);
}

} // namespace rasterwalk::test
