#include "session/second_run.h"
#include "ui/actions/action_menus.h"
#include "ui/actions/compare.h"
#include "ui/actions/measure.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A row for each view of a comparison.
std::vector<Action> compare_view_choices() {
    std::vector<Action> actions;
    for (const CompareViewInfo& info : compare_view_list()) {
        const CompareView view = info.view;
        actions.push_back(
            {std::string("compare.view.").append(info.name),
             "Compare",
             std::string(info.menu_title),
             std::string(info.help),
             {},
             [view](Ui& ui) {
                 if (!ui.session.b) toggle_compare(ui);
                 ui.session.compare_view = view;
             },
             [view](const Ui& ui) { return ui.session.b && ui.session.compare_view == view; }});
    }
    return actions;
}

} // namespace

std::vector<Action> compare_actions() {
    std::vector<Action> actions{
        {"switch.compare",
         "Compare",
         "Compare two runs",
         "Compares the picture as it is (run A) with one that is drawn differently (run B): with a "
         "different interpolation, lighting, depth test or edge rule, depending on the stage. "
         "Repeat to go back to one run.",
         {'C'},
         toggle_compare,
         [](const Ui& ui) { return ui.session.b.has_value(); }},
    };
    std::vector<Action> views = compare_view_choices();
    views.front().begins_group = true;
    actions.insert(actions.end(), views.begin(), views.end());
    const std::vector<Action> others{
        {"compare.hold",
         "Compare",
         "Pause blinking",
         "Keeps the current picture while two runs blink; repeat to go on.",
         {'H'},
         [](Ui& ui) { ui.compare.blink_is_held = !ui.compare.blink_is_held; },
         [](const Ui& ui) { return ui.compare.blink_is_held; }},
        {"compare.swap",
         "Compare",
         "Swap A and B",
         "Run A becomes B, and B becomes A.",
         {},
         [](Ui& ui) {
             if (!refuses_settings(ui.session)) swap_runs(ui.session);
         },
         nullptr,
         true},
        {"compare.next",
         "Compare",
         "Next difference",
         "Goes to the next moment at which the two runs differ.",
         {'J'},
         go_to_next_divergence},
        {"compare.previous",
         "Compare",
         "Previous difference",
         "Goes back to the previous moment at which the two runs differ.",
         {'K'},
         go_to_previous_divergence},
        {"speed.measure",
         "Compare",
         "Measure the ladder",
         "Opens the Speed tab, and measures how fast each rung of the ladder draws the picture. "
         "Repeat to stop.",
         {},
         [](Ui& ui) {
             open_tab(ui, "speed");
             if (is_measuring(ui)) {
                 stop_measuring(ui);
             } else {
                 measure_ladder(ui);
             }
         },
         is_measuring,
         true},
    };
    actions.insert(actions.end(), others.begin(), others.end());
    return actions;
}

} // namespace rasterwalk
