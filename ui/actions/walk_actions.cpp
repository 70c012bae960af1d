#include "session/walk.h"
#include "ui/actions/action_menus.h"
#include "ui/actions/code.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

Timeline timeline_of(const Ui& ui) {
    return Timeline(ui.results.a.frame);
}

void walk_to_change(Ui& ui, bool (*walk)(Session&, const Timeline&, const PixelHistory&),
                    const char* direction) {
    if (ui.results.history_work) {
        ui.session.notice = "The program is still looking for what fell on the pixel.";
        return;
    }
    if (!ui.results.history) {
        ui.session.notice = "No pixel is picked. Click one first.";
        return;
    }
    const glm::ivec2 pixel = ui.results.history->pixel;
    const bool found = walk(ui.session, timeline_of(ui), *ui.results.history);
    ui.session.notice = found ? ""
                              : "Pixel (" + std::to_string(pixel.x) + ", " +
                                    std::to_string(pixel.y) + ") has no " + direction + " change.";
}

} // namespace

// A triangle is stepped over whole; the other keys use the size set on the transport.
std::vector<Action> walk_actions() {
    return {
        {"walk.first",
         "Walk",
         "To the beginning",
         "Goes back to the empty picture; from there, to the first face of the shadow map, if the "
         "picture has one.",
         {key::home},
         [](Ui& ui) { go_to_beginning(ui.session, timeline_of(ui)); }},
        {"walk.back",
         "Walk",
         "Step back",
         "Goes back one piece of the chosen size.",
         {key::comma},
         [](Ui& ui) {
             if (steps_code(ui)) {
                 step_code_back(ui);
             } else {
                 step_back(ui.session, timeline_of(ui), ui.session.play.granularity);
             }
         }},
        {"walk.play",
         "Walk",
         "Play or pause",
         "Runs time at the speed of the dial; at the end, it starts again from the beginning.",
         {key::space},
         [](Ui& ui) { toggle_play(ui.session, timeline_of(ui)); },
         [](const Ui& ui) { return ui.session.play.running; }},
        {"walk.step",
         "Walk",
         "Step",
         "Draws the next piece of the chosen size.",
         {key::period},
         [](Ui& ui) {
             if (steps_code(ui)) {
                 step_code(ui, CodeGoal::line);
             } else {
                 step_forward(ui.session, timeline_of(ui), ui.session.play.granularity);
             }
         }},
        {"walk.last",
         "Walk",
         "To the end",
         "Draws everything. While a face of the shadow map is shown, goes to its end first.",
         {key::end},
         [](Ui& ui) { go_to_end(ui.session, timeline_of(ui)); }},
        {"walk.previous_triangle",
         "Walk",
         "Previous triangle",
         "Goes back to where a triangle begins.",
         {key::left_bracket},
         [](Ui& ui) { step_back(ui.session, timeline_of(ui), Granularity::triangle); },
         nullptr,
         true},
        {"walk.next_triangle",
         "Walk",
         "Next triangle",
         "Goes on to where the next triangle begins.",
         {key::right_bracket},
         [](Ui& ui) { step_forward(ui.session, timeline_of(ui), Granularity::triangle); }},
        {"walk.previous_change",
         "Walk",
         "Previous change of the pixel",
         "Goes back to the previous time the picked pixel was written.",
         {'B'},
         [](Ui& ui) { walk_to_change(ui, previous_change, "earlier"); }},
        {"walk.next_change",
         "Walk",
         "Next change of the pixel",
         "Goes on to the next time the picked pixel is written.",
         {'N'},
         [](Ui& ui) { walk_to_change(ui, next_change, "later"); }},
        {"walk.events",
         "Walk",
         "List of moments",
         "Lists what the triangle does moment by moment, as text to search and copy.",
         {},
         [](Ui& ui) { ui.sheets.toggle(Sheet::events); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::events); },
         true},
        {"walk.faster",
         "Walk",
         "Play faster",
         "Makes time run about twice as fast.",
         {key::equal},
         [](Ui& ui) {
             Play& play = ui.session.play;
             play.speed = faster(play.speed, ui.results.length.of(play.granularity));
         },
         nullptr,
         true},
        {"walk.slower",
         "Walk",
         "Play slower",
         "Makes time run about half as fast.",
         {key::minus},
         [](Ui& ui) {
             Play& play = ui.session.play;
             play.speed = slower(play.speed, ui.results.length.of(play.granularity));
         }},
    };
}

} // namespace rasterwalk
