#include "session/second_run.h"

#include <algorithm>
#include <utility>

#include "engines/program_drawing.h"
#include "session/quiz_state.h"
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

std::string_view name_of(std::string_view assignment) {
    return assignment.substr(0, assignment.find('='));
}

/// Do the settings already have all these values?
bool has_all(const Settings& settings, std::span<const std::string_view> assignments) {
    Settings set = settings;
    apply(assignments, set);
    return std::all_of(assignments.begin(), assignments.end(), [&](std::string_view assignment) {
        return has_same_value(*find_setting(name_of(assignment)), settings, set);
    });
}

bool names(std::span<const std::string_view> assignments, std::string_view setting) {
    return std::any_of(assignments.begin(), assignments.end(),
                       [&](std::string_view assignment) { return name_of(assignment) == setting; });
}

} // namespace

const std::array<CompareViewInfo, compare_view_count>& compare_view_list() {
    static constexpr std::array<CompareViewInfo, compare_view_count> list{{
        {CompareView::run_a, "A", "Run A alone",
         "Only the picture of run A, large. The switches and the settings change this run."},
        {CompareView::run_b, "B", "Run B alone", "Only the picture of run B, large."},
        {CompareView::difference, "Difference", "The difference, B minus A",
         "B minus A, with a scale; blue where B is less, orange where it is more."},
        {CompareView::side_by_side, "Side by side", "Side by side",
         "Both pictures, side by side or one above the other, whichever makes them larger."},
        {CompareView::wipe, "Divider", "A divider to drag",
         "A on the left of a divider, B on the right; drag the divider."},
        {CompareView::blink, "In turn", "A and B in turn",
         "A and B in turn, once a second, so that differences seem to move. H pauses on one of "
         "them."},
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
    compare_with(session, Run{settings});
}

void compare_with_program(Session& session, std::shared_ptr<const ProgramDrawing> drawing) {
    end_quiz(session);
    end_comparison(session);
    const Run before = session.a;
    const std::shared_ptr<const Scene> before_scene = session.scene;
    const bool is_other_scene = before_scene != drawing->scene;
    if (is_other_scene) show_scene(session, drawing->scene);
    session.a = Run{drawing->settings};
    compare_with(session, Run{drawing->settings, std::move(drawing)});
    session.replaced = ReplacedRun{before, session.a, is_other_scene ? before_scene : nullptr, {}};
    if (session.compare_view == CompareView::run_a || session.compare_view == CompareView::run_b)
        session.compare_view = CompareView::wipe;
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
    if (session.b->program != nullptr) {
        session.notice = "Your program is always run B: only our own run has the numbers that the "
                         "panels show.";
        return;
    }
    std::swap(session.a, *session.b);
    session.runs_before = RunPair{session.a, *session.b};
}

void mirror_changes_to_b(Session& session) {
    if (!session.b) {
        session.runs_before = std::nullopt;
        return;
    }
    if (session.b->program != nullptr) {
        session.b->settings = session.b->program->settings;
        session.runs_before = RunPair{session.a, *session.b};
        return;
    }
    if (session.runs_before && *session.runs_before == RunPair{session.a, *session.b}) return;
    if (session.runs_before && session.runs_before->b == *session.b) {
        const Settings& before = session.runs_before->a.settings;
        const Settings b_was = session.b->settings;
        Settings& b = session.b->settings;
        for (const Setting& setting : setting_table()) {
            // A whole sets its parts too; they come after it, and keep B's own values.
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
        if (!must_be_listed(setting, a, b)) continue;
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
        {"affine",
         {"affine interpolation", "Values are interpolated linearly across the picture.", affine},
         {"perspective correction", "Values are divided by z on the way.", perspective},
         StripStep::vertex_light,
         StripStep::pixel_light},
        {"light",
         {"light per vertex", "Light is computed at the corners and interpolated between them.",
          per_vertex},
         {"light per pixel", "Light is computed at every pixel.", per_pixel},
         StripStep::vertex_light,
         StripStep::pixel_light},
        {"depth",
         {"no depth test", "The last triangle drawn stays on top.", no_depth},
         {"a depth test", "The nearest triangle stays on top.", with_depth},
         {Stage::depth},
         StripStep::pixel_light},
        {"exact",
         {"the handout's edges", "Coordinates are cut toward zero, and steps are added up.",
          handout},
         {"exact edges", "Coordinates are rounded down, and lines walked without error.", exact},
         {Stage::points},
         StripStep::pixel_light},
    };
    return pairs;
}

const PairMethod& offer_of(const ComparePair& pair, const Settings& a) {
    return has_all(a, pair.right.sets) ? pair.left : pair.right;
}

Settings offered_settings(const ComparePair& pair, const Settings& a) {
    Settings b = a;
    apply(offer_of(pair, a).sets, b);
    return b;
}

Settings at_step_of(const ComparePair& pair, const Settings& settings) {
    Settings moved = settings;
    if (step_of(settings) < pair.first_step) set_step(moved, pair.first_step);
    if (step_of(settings) > pair.last_step) set_step(moved, pair.last_step);
    return moved;
}

const ComparePair* pair_of_runs(const Session& session) {
    const std::vector<RunDifference> differences = run_differences(session);
    if (differences.empty()) return nullptr;
    for (const ComparePair& pair : compare_pairs()) {
        const PairMethod& method = offer_of(pair, session.a.settings);
        const bool is_all =
            std::all_of(differences.begin(), differences.end(),
                        [&](const RunDifference& d) { return names(method.sets, d.setting); });
        if (is_all && has_all(session.b->settings, method.sets)) return &pair;
    }
    return nullptr;
}

void start_pair(Session& session, const ComparePair& pair) {
    end_comparison(session);
    const Run before = session.a;
    session.a.settings = at_step_of(pair, session.a.settings);
    compare_with(session, offered_settings(pair, session.a.settings));
    session.replaced = ReplacedRun{before, session.a, nullptr, {}};
}

} // namespace rasterwalk
