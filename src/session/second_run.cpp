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
        {CompareView::side_by_side, "side_by_side", "Side by side",
         "Both pictures, one beside the other."},
        {CompareView::wipe, "wipe", "Wipe", "A left of the divider, B right of it; drag it."},
        {CompareView::blink, "blink", "Blink", "A and B in turn: what differs seems to move."},
        {CompareView::difference, "difference", "Difference",
         "B minus A: blue where B is darker, orange where it is brighter."},
    }};
    return list;
}

std::span<const std::string_view> compare_view_names() {
    static const auto names = [] {
        std::array<std::string_view, compare_view_count> words;
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = compare_view_list()[i].name;
        return words;
    }();
    return names;
}

std::optional<CompareView> find_compare_view(std::string_view name) {
    for (const CompareViewInfo& info : compare_view_list()) {
        if (info.name == name) return info.view;
    }
    return std::nullopt;
}

void compare_with(Session& session, const Settings& other) {
    if (!session.other) session.taken = std::nullopt;
    session.other = other;
    session.followed = RunPair{session.settings, other};
}

void stop_comparing(Session& session) {
    session.other = std::nullopt;
    session.followed = std::nullopt;
    session.taken = std::nullopt;
}

void end_comparison(Session& session) {
    const std::optional<TakenRun> taken = session.taken;
    stop_comparing(session);
    if (!taken) return;
    if (taken->before_scene != nullptr) {
        show_scene(session, taken->before_scene);
        session.settings = taken->before;
        return;
    }
    Settings& now = session.settings;
    for (const RunDifference& difference : run_differences(taken->after, taken->before)) {
        const Setting* const setting = find_setting(difference.setting);
        if (value_text(*setting, now) == difference.a) set_value(now, *setting, difference.b);
    }
}

void swap_runs(Session& session) {
    if (!session.other) return;
    std::swap(session.settings, *session.other);
    session.followed = RunPair{session.settings, *session.other};
}

void follow_first_run(Session& session) {
    if (!session.other) {
        session.followed = std::nullopt;
        return;
    }
    Settings& other = *session.other;
    if (session.followed && session.followed->second == other) {
        const Settings& before = session.followed->first;
        for (const Setting& setting : setting_table()) {
            const std::string now = value_text(setting, session.settings);
            const std::string then = value_text(setting, before);
            if (now != then && then == value_text(setting, other)) set_value(other, setting, now);
        }
    }
    session.followed = RunPair{session.settings, other};
}

std::vector<RunDifference> run_differences(const Settings& a, const Settings& b) {
    std::vector<RunDifference> differences;
    for (const Setting& setting : setting_table()) {
        std::string in_a = value_text(setting, a), in_b = value_text(setting, b);
        if (in_a == in_b) continue;
        differences.push_back({setting.name, std::move(in_a), std::move(in_b)});
    }
    return differences;
}

std::vector<RunDifference> run_differences(const Session& session) {
    if (!session.other) return {};
    return run_differences(session.settings, *session.other);
}

std::span<const ComparePair> compare_pairs() {
    static constexpr ComparePair pairs[] = {
        {"affine", "affine", "perspective",
         "Values carried straight across the picture, against values divided by z on the way.",
         Stage::vertex_light, Stage::pixel_light, affine, perspective},
        {"light", "per vertex", "per pixel",
         "Light worked out at the corners and spread over the triangle, against light worked out "
         "at every pixel.",
         Stage::vertex_light, Stage::pixel_light, per_vertex, per_pixel},
        {"depth", "no depth", "depth",
         "The last triangle drawn stays on top, against the nearest one.", Stage::depth,
         Stage::pixel_light, no_depth, with_depth},
        {"exact", "handout", "exact",
         "Coordinates cut toward zero and steps added up, against coordinates rounded down and "
         "lines walked without error.",
         Stage::points, Stage::pixel_light, handout, exact},
    };
    return pairs;
}

void start_pair(Session& session, const ComparePair& pair) {
    end_comparison(session);
    Settings& a = session.settings;
    const Settings before = a;
    if (a.stage < pair.first_stage) a.stage = pair.first_stage;
    if (a.stage > pair.last_stage) a.stage = pair.last_stage;
    Settings b = a;
    apply(pair.a, a);
    apply(pair.b, b);
    compare_with(session, b);
    session.taken = TakenRun{before, a, nullptr, {}};
}

} // namespace rasterwalk
