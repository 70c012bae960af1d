#include "compare/divergence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/divergence_text.h"
#include "compare/run_walk.h"
#include "picture/view_image.h"

namespace rasterwalk {

namespace {

/// How far apart two numbers are.
enum class Apart : std::uint8_t { not_at_all, by_rounding, clearly };

/// Rounding errors add up along a row: some hundreds of them, each 6e-8, stay below this fraction
/// of the number, and a colour then differs by a small fraction of a step on the screen.
constexpr float rounding_part = 1e-4f;
constexpr float rounding_of_colour = 1e-4f;

Apart numbers_apart(float a, float b, float by_rounding) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return Apart::not_at_all;
    return std::abs(a - b) <= by_rounding ? Apart::by_rounding : Apart::clearly;
}

Apart lengths_apart(float a, float b) {
    return numbers_apart(a, b, rounding_part * std::max(std::abs(a), std::abs(b)));
}

Apart colours_apart(const glm::vec3& a, const glm::vec3& b) {
    Apart most = Apart::not_at_all;
    for (int i = 0; i < 3; ++i)
        most = std::max(most, numbers_apart(a[i], b[i], rounding_of_colour));
    return most;
}

/// @param compared the varyings that both runs carry
Apart varyings_apart(const VertexEvent& a, const VertexEvent& b, VaryingSet compared) {
    Apart most = Apart::not_at_all;
    for (int v = 0; v < varying_count; ++v) {
        if (!compared.has(v)) continue;
        const VaryingInfo& varying = varying_list[static_cast<std::size_t>(v)];
        for (int i = 0; i < varying.count; ++i) {
            const float p = varying.component(a.varyings, i), q = varying.component(b.varyings, i);
            most = std::max(most, varying.is_light ? numbers_apart(p, q, rounding_of_colour)
                                                   : lengths_apart(p, q));
        }
    }
    return most;
}

Apart vertices_apart(const VertexEvent& a, const VertexEvent& b, VaryingSet compared) {
    if (a.vertex.has_pixel != b.vertex.has_pixel) return Apart::clearly;
    const ScreenVertex &p = a.vertex.pixel, &q = b.vertex.pixel;
    if (p.column != q.column || p.row != q.row) return Apart::clearly;
    return std::max(lengths_apart(p.depth, q.depth), varyings_apart(a, b, compared));
}

/// By what they pass on: how far the corners are from a plane shows only there.
Apart steps_apart(const ClipStep& a, const ClipStep& b) {
    if (a.keeps_from != b.keeps_from || a.is_cut != b.is_cut) return Apart::clearly;
    if (!a.is_cut) return Apart::not_at_all;
    const glm::vec4 &p = a.cut.position_clip, &q = b.cut.position_clip;
    float largest = 0.0f;
    for (int i = 0; i < 4; ++i)
        largest = std::max({largest, std::abs(p[i]), std::abs(q[i])});
    Apart most = numbers_apart(a.t, b.t, rounding_part);
    for (int i = 0; i < 4; ++i)
        most = std::max(most, numbers_apart(p[i], q[i], rounding_part * largest));
    return most;
}

Apart samples_apart(const SampleEvent& a, const SampleEvent& b) {
    const EdgeSample &p = a.sample, &q = b.sample;
    const bool same = p.fragment.column == q.fragment.column && p.fragment.row == q.fragment.row &&
                      p.write.inside == q.write.inside;
    return same ? Apart::not_at_all : Apart::clearly;
}

Apart tests_apart(const PixelTest& a, const PixelTest& b) {
    const bool same = a.column == b.column && a.row == b.row && a.is_inside == b.is_inside;
    return same ? Apart::not_at_all : Apart::clearly;
}

/// The rules that decide whether the runs' pixels and vertices differ.
struct SightRules {
    ScreenRules screen_a, screen_b; ///< how a channel is seen
    bool has_depth_a, has_depth_b;  ///< marks have none: the value in its place means nothing
    bool compares_samples, compares_tests; ///< both runs have them, of the same pixels
    VaryingSet carried;                    ///< the varyings that both runs carry
};

Apart fragments_apart(const FragmentEvent& a, const FragmentEvent& b, const SightRules& rules) {
    const Fragment &p = a.fragment, &q = b.fragment;
    if (p.column != q.column || p.row != q.row || a.fate != b.fate) return Apart::clearly;
    const Apart depth =
        lengths_apart(rules.has_depth_a ? a.depth : 0.0f, rules.has_depth_b ? b.depth : 0.0f);
    // A fragment that fails leaves the pixel unchanged: it has no colour to compare.
    if (a.fate != Fate::written) return depth;
    const bool shown_alike = rules.screen_a == rules.screen_b;
    return std::max(depth, shown_alike ? colours_apart(a.after, b.after)
                                       : colours_apart(shown_colour(a.after, rules.screen_a),
                                                       shown_colour(b.after, rules.screen_b)));
}

struct Difference {
    DivergenceKind kind = DivergenceKind::other;
    bool only_rounding = false;
};

/// How the two runs differ at a moment; nothing if they do not.
std::optional<Difference> difference_at(MomentEvents a, MomentEvents b, const SightRules& rules) {
    // If pixels are found in different ways, only the result counts.
    if (!rules.compares_samples) a.sample = b.sample = nullptr;
    if (!rules.compares_tests) a.test = b.test = nullptr;
    if (a.is_nothing() && b.is_nothing()) return std::nullopt;
    if (b.is_nothing()) return Difference{DivergenceKind::missing, false};
    if (a.is_nothing()) return Difference{DivergenceKind::extra, false};
    // A mark that only one run puts on the picture.
    if (a.fragments.size() > b.fragments.size()) return Difference{DivergenceKind::missing, false};
    if (a.fragments.size() < b.fragments.size()) return Difference{DivergenceKind::extra, false};
    Apart most = Apart::not_at_all;
    if (a.vertex != nullptr && b.vertex != nullptr)
        most = vertices_apart(*a.vertex, *b.vertex, rules.carried);
    if (a.clip != nullptr && b.clip != nullptr)
        most = std::max(most, steps_apart(a.clip->step, b.clip->step));
    if (a.sample != nullptr && b.sample != nullptr) {
        most = std::max(most, samples_apart(*a.sample, *b.sample));
    }
    if (a.test != nullptr && b.test != nullptr)
        most = std::max(most, tests_apart(a.test->test, b.test->test));
    for (std::size_t i = 0; i < a.fragments.size(); ++i)
        most = std::max(most, fragments_apart(a.fragments[i], b.fragments[i], rules));
    if (most == Apart::not_at_all) return std::nullopt;
    return Difference{DivergenceKind::other, most == Apart::by_rounding};
}

SightRules sight_rules(const Frame& a, const Frame& b) {
    return {a.stages.screen,
            b.stages.screen,
            has_fragments(a.settings.stage),
            has_fragments(b.settings.stage),
            walks_edges(a.stages) == walks_edges(b.stages),
            tests_pixels(a.stages) == tests_pixels(b.stages) &&
                a.stages.tested_columns == b.stages.tested_columns,
            carried_varyings(a) & carried_varyings(b)};
}

Divergence divergence_of(const Frame& a, const Frame& b, const PairMoment& moment,
                         const Difference& difference) {
    return {moment.cursor, difference.kind, difference.only_rounding,
            divergence_text(a, b, moment, difference.kind)};
}

} // namespace

std::string kind_text(DivergenceKind kind) {
    switch (kind) {
    case DivergenceKind::missing:
        return "missing from B";
    case DivergenceKind::extra:
        return "extra in B";
    case DivergenceKind::other:
        break;
    }
    return "different value";
}

void DivergenceCollector::add(const Cursor& cursor, DivergenceKind kind) {
    DivergenceGroup& group =
        groups_[static_cast<std::size_t>(cursor.phase)][static_cast<std::size_t>(kind)];
    if (group.count++ == 0) group = {cursor.triangle, cursor.phase, kind, 1, cursor, cursor};
    group.last = cursor;
}

void DivergenceCollector::end_triangle(DivergenceList& list) {
    for (auto& kinds : groups_) {
        for (DivergenceGroup& group : kinds) {
            if (group.count > 0) list.groups.push_back(std::exchange(group, {}));
        }
    }
}

void DivergenceCollector::walk_part(const Frame& a, const Frame& b, RunWalk& walk,
                                    DivergenceList& list) {
    const SightRules rules = sight_rules(a, b);
    const int triangle = walk.triangle();
    walk.walk_part([&](const PairMoment& moment) {
        const std::optional<Difference> difference = difference_at(moment.a, moment.b, rules);
        if (!difference) return true;
        ++list.count;
        add(moment.cursor, difference->kind);
        if (!list.first) list.first = divergence_of(a, b, moment, *difference);
        if (!list.first_beyond_rounding && !difference->only_rounding) {
            list.first_beyond_rounding = divergence_of(a, b, moment, *difference);
        }
        return true;
    });
    if (walk.is_done() || walk.triangle() != triangle) end_triangle(list);
}

std::optional<Divergence> next_divergence(const EventSource& a, const EventSource& b,
                                          const Cursor& from) {
    if (!have_same_moments(*a.frame, *b.frame)) return std::nullopt;
    std::optional<Divergence> found;
    RunWalk walk(a, b, cursor_end);
    walk.skip_to(from.triangle);
    const SightRules rules = sight_rules(*a.frame, *b.frame);
    const PairVisitor visit = [&](const PairMoment& moment) {
        if (moment.cursor < from) return true;
        const std::optional<Difference> difference = difference_at(moment.a, moment.b, rules);
        if (difference) found = divergence_of(*a.frame, *b.frame, moment, *difference);
        return !found;
    };
    while (!walk.is_done() && walk.walk_part(visit)) {
    }
    return found;
}

std::optional<Divergence> previous_divergence(const EventSource& a, const EventSource& b,
                                              const Cursor& to) {
    if (!have_same_moments(*a.frame, *b.frame)) return std::nullopt;
    // Once forward to find where it is, and once more to get there and report it.
    std::optional<Cursor> last;
    RunWalk walk(a, b, to);
    const SightRules rules = sight_rules(*a.frame, *b.frame);
    const PairVisitor note_last = [&](const PairMoment& moment) {
        if (difference_at(moment.a, moment.b, rules)) last = moment.cursor;
        return true;
    };
    while (!walk.is_done())
        walk.walk_part(note_last);
    return last ? next_divergence(a, b, *last) : std::nullopt;
}

std::optional<Divergence> divergence_at(const Frame& a, const Framebuffer& picture_a,
                                        const Frame& b, const Framebuffer& picture_b,
                                        const Cursor& cursor, Framebuffer& scratch) {
    if (!have_same_moments(a, b)) return std::nullopt;
    std::optional<Divergence> found;
    const SightRules rules = sight_rules(a, b);
    visit_moment(a, picture_a, b, picture_b, cursor, scratch, [&](const PairMoment& moment) {
        const std::optional<Difference> difference = difference_at(moment.a, moment.b, rules);
        if (difference) found = divergence_of(a, b, moment, *difference);
        return false;
    });
    return found;
}

} // namespace rasterwalk
