#include "session/second_run.h"

#include <algorithm>
#include <utility>

#include "session/session.h"
#include "settings/preset.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

constexpr std::string_view affine[] = {"interpolation=affine"};
constexpr std::string_view perspective[] = {"interpolation=perspective"};
constexpr std::string_view per_vertex[] = {"stage=vertex_light"};
constexpr std::string_view per_pixel[] = {"stage=pixel_light"};
constexpr std::string_view no_depth[] = {"depth_test=off"};
constexpr std::string_view with_depth[] = {"depth_test=inverse_z"};
constexpr std::string_view handout[] = {"rounding=truncate", "line_walk=accumulate"};
constexpr std::string_view exact[] = {"rounding=floor", "line_walk=exact"};

void apply(std::span<const std::string_view> assignments, Settings& settings) {
    for (const std::string_view assignment : assignments)
        set_from_text(settings, assignment);
}

} // namespace

const std::array<CompareViewInfo, compare_view_count>& compare_view_list() {
    static constexpr std::array<CompareViewInfo, compare_view_count> list{{
        {CompareView::side_by_side, "Side by side", "Both pictures, one beside the other.",
         "Both pictures, one beside the other."},
        {CompareView::wipe, "Wipe", "A left of the divider, B right of it; drag it.",
         "A left of a divider, B right of it."},
        {CompareView::blink, "Blink", "A and B in turn: what differs seems to move.",
         "A and B in turn, once a second."},
        {CompareView::difference, "Difference",
         "B minus A: blue where B is darker, orange where it is brighter.",
         "B minus A, with a scale."},
    }};
    static_assert(is_indexed_by(list, &CompareViewInfo::view));
    return list;
}

void compare_with(Session& session, const Run& b) {
    if (!session.b) session.replaced = std::nullopt;
    session.b = b;
    session.runs_before = RunPair{session.a, b};
}

void compare_with(Session& session, const Settings& settings) {
    compare_with(session, Run{session.a.engine, settings});
}

void stop_comparing(Session& session) {
    session.b = std::nullopt;
    session.runs_before = std::nullopt;
    session.replaced = std::nullopt;
}

void end_comparison(Session& session) {
    const std::optional<ReplacedRun> replaced = session.replaced;
    stop_comparing(session);
    if (!replaced) return;
    if (replaced->before_scene != nullptr) {
        show_scene(session, replaced->before_scene);
        session.a = replaced->before;
        return;
    }
    Settings& now = session.a.settings;
    const Settings still = now; // a stage sets a shading too
    for (const RunDifference& difference :
         run_differences(replaced->after.settings, replaced->before.settings)) {
        const Setting* const setting = find_setting(difference.setting);
        if (value_text(*setting, still) == difference.a) set_value(now, *setting, difference.b);
    }
}

void swap_runs(Session& session) {
    if (!session.b) return;
    std::swap(session.a, *session.b);
    session.runs_before = RunPair{session.a, *session.b};
}

void carry_changes_to_b(Session& session) {
    if (!session.b) {
        session.runs_before = std::nullopt;
        return;
    }
    if (session.runs_before && *session.runs_before == RunPair{session.a, *session.b}) return;
    if (session.runs_before && session.runs_before->b == *session.b) {
        const Settings& before = session.runs_before->a.settings;
        const Settings b_was = session.b->settings;
        Settings& b = session.b->settings;
        for (const Setting& setting : setting_table()) {
            // A whole sets its parts too; they come after it, and keep what is B's own.
            if (!has_same_value(setting, before, b_was)) {
                copy_value(setting, b_was, b);
            } else if (!has_same_value(setting, before, session.a.settings)) {
                copy_value(setting, session.a.settings, b);
            }
        }
    }
    session.runs_before = RunPair{session.a, *session.b};
}

std::vector<RunDifference> run_differences(const Settings& a, const Settings& b) {
    std::vector<RunDifference> differences;
    for (const Setting& setting : setting_table()) {
        if (!must_be_said(setting, a, b)) continue;
        differences.push_back({setting.name, value_text(setting, a), value_text(setting, b)});
    }
    return differences;
}

std::vector<RunDifference> run_differences(const Session& session) {
    if (!session.b) return {};
    return run_differences(session.a.settings, session.b->settings);
}

std::span<const ComparePair> compare_pairs() {
    static constexpr ComparePair pairs[] = {
        {"affine", "affine", "perspective",
         "Values carried straight across the picture, against values divided by z on the way.",
         StripStep::vertex_light, StripStep::pixel_light, affine, perspective},
        {"light", "per vertex", "per pixel",
         "Light worked out at the corners and spread over the triangle, against light worked out "
         "at every pixel.",
         StripStep::vertex_light, StripStep::pixel_light, per_vertex, per_pixel},
        {"depth",
         "no depth",
         "depth",
         "The last triangle drawn stays on top, against the nearest one.",
         {Stage::depth},
         StripStep::pixel_light,
         no_depth,
         with_depth},
        {"exact",
         "handout",
         "exact",
         "Coordinates cut toward zero and steps added up, against coordinates rounded down and "
         "lines walked without error.",
         {Stage::points},
         StripStep::pixel_light,
         handout,
         exact},
    };
    return pairs;
}

void start_pair(Session& session, const ComparePair& pair) {
    end_comparison(session);
    Settings& a = session.a.settings;
    const Run before = session.a;
    if (step_of(a) < pair.first_step) set_step(a, pair.first_step);
    if (step_of(a) > pair.last_step) set_step(a, pair.last_step);
    Run b = session.a;
    apply(pair.a, a);
    apply(pair.b, b.settings);
    compare_with(session, b);
    session.replaced = ReplacedRun{before, session.a, nullptr, {}};
}

} // namespace rasterwalk
