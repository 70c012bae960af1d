#include "ui/actions/actions.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "picture/view_image.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "ui/actions/compare.h"
#include "ui/actions/keys.h"
#include "ui/actions/lesson_state.h"
#include "ui/actions/view_files.h"
#include "ui/actions/zoom.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

template <StripStep step>
void set_stage(Ui& ui) {
    set_step(ui.session.a.settings, step);
}

template <View view>
void set_view(Ui& ui) {
    ui.session.view = view;
}
template <View view>
bool shows_view(const Ui& ui) {
    return ui.session.view == view;
}

template <CompareView view>
void set_compare_view(Ui& ui) {
    if (!ui.session.b) toggle_compare(ui);
    ui.session.compare_view = view;
}
template <CompareView view>
bool shows_compare_view(const Ui& ui) {
    return ui.session.b && ui.session.compare_view == view;
}

void set_text_scale(Ui& ui, float scale) {
    ui.options.wished_text_scale = std::clamp(scale, smallest_text_scale, largest_text_scale);
}

Timeline timeline_of(const Ui& ui) {
    return Timeline(ui.results.a.frame);
}

void walk_to_change(Ui& ui, bool (*walk)(Session&, const Timeline&, const PixelHistory&),
                    const char* direction) {
    if (!ui.results.history) {
        ui.session.notice = "There is no picked pixel: pick a pixel first, by a click.";
        return;
    }
    const glm::ivec2 pixel = ui.results.history->pixel;
    const bool found = walk(ui.session, timeline_of(ui), *ui.results.history);
    ui.session.notice = found ? ""
                              : "Pixel (" + std::to_string(pixel.x) + ", " +
                                    std::to_string(pixel.y) + ") has no " + direction + " change.";
}

// A triangle is stepped over whole; the other keys take what the transport is set to.
const Action table[] = {
    {"file.open",
     "File",
     "Open ...",
     "Opens a saved view, a scene or a lesson; the view before it can be brought back by undo.",
     {'O', true},
     begin_opening,
     nullptr},
    {"file.save_view",
     "File",
     "Save the view ...",
     "Writes everything that is on show into a file that can be opened again.",
     {'S', true},
     begin_saving,
     nullptr},
    {"file.copy_view",
     "File",
     "Copy the view as a command line",
     "Copies a line that opens the program with exactly this view.",
     {'C', true},
     copy_command_line,
     nullptr},
    {"file.save_picture",
     "File",
     "Save a picture of the window",
     "Writes the window as a PNG into the current folder.",
     {key::f12},
     [](Ui& ui) { ui.wants_picture = true; },
     nullptr},
    {"file.quit",
     "File",
     "Quit",
     "Closes Rasterwalk.",
     {'Q', true},
     [](Ui& ui) { ui.wants_quit = true; },
     nullptr},

    {"edit.undo",
     "Edit",
     "Undo",
     "Takes back the last thing that was set.",
     {'Z', true},
     [](Ui& ui) {
         if (!undo(ui.session)) ui.session.notice = "Nothing to undo.";
     },
     nullptr},
    {"edit.redo",
     "Edit",
     "Redo",
     "Sets again what was taken back.",
     {'Z', true, true},
     [](Ui& ui) {
         if (!redo(ui.session)) ui.session.notice = "Nothing to redo.";
     },
     nullptr},
    {"go.back",
     "Edit",
     "Back",
     "Returns to the moment and selection visited before.",
     {key::left, false, false, true},
     [](Ui& ui) {
         if (!go_back(ui.session)) ui.session.notice = "No place was visited before this one.";
     },
     nullptr},
    {"go.forward",
     "Edit",
     "Forward",
     "Goes on to the place that Back came from.",
     {key::right, false, false, true},
     [](Ui& ui) {
         if (!go_forward(ui.session)) ui.session.notice = "This is the last place visited.";
     },
     nullptr},

    {"view.colour",
     "View",
     "Colour",
     "Shows the colours of the picture.",
     {},
     set_view<View::colour>,
     shows_view<View::colour>},
    {"view.depth",
     "View",
     "Depth buffer",
     "Shows 1/z of every pixel, bright is near.",
     {},
     set_view<View::depth>,
     shows_view<View::depth>},
    {"view.triangle",
     "View",
     "Triangle owner",
     "Shows which triangle every pixel belongs to.",
     {},
     set_view<View::triangle>,
     shows_view<View::triangle>},
    {"view.overdraw",
     "View",
     "Overdraw",
     "Shows how many fragments fell on every pixel.",
     {},
     set_view<View::overdraw>,
     shows_view<View::overdraw>},
    {"view.grid",
     "View",
     "Pixel grid",
     "Draws lines between pixels from 8x on.",
     {'G'},
     [](Ui& ui) { ui.session.canvas.grid = !ui.session.canvas.grid; },
     [](const Ui& ui) { return ui.session.canvas.grid; }},
    {"view.fit",
     "View",
     "Fit the picture",
     "Shows the whole picture.",
     {'F'},
     [](Ui& ui) { ui.session.canvas.zoom = 0.0f; },
     nullptr},
    {"view.zoom_selection",
     "View",
     "Zoom to the triangle",
     "Enlarges the triangle that the inspector shows.",
     {'X'},
     zoom_to_triangle,
     nullptr},
    {"view.larger_text",
     "View",
     "Larger text",
     "Makes all text larger.",
     {key::equal, true},
     [](Ui& ui) { set_text_scale(ui, ui.options.wished_text_scale + text_scale_step); },
     nullptr},
    {"view.smaller_text",
     "View",
     "Smaller text",
     "Makes all text smaller.",
     {key::minus, true},
     [](Ui& ui) { set_text_scale(ui, ui.options.wished_text_scale - text_scale_step); },
     nullptr},
    {"view.normal_text",
     "View",
     "Normal text",
     "Sets the text back to 16 pixels.",
     {key::digit_0, true},
     [](Ui& ui) { set_text_scale(ui, 1.0f); },
     nullptr},
    {"view.theme",
     "View",
     "Light theme",
     "Changes between the dark and the light theme.",
     {},
     [](Ui& ui) {
         ui.options.theme = ui.options.theme == Theme::dark ? Theme::light : Theme::dark;
         ui.style_is_stale = true;
     },
     [](const Ui& ui) { return ui.options.theme == Theme::light; }},

    {"stage.points",
     "Stage",
     "Points",
     "Every vertex, projected to one pixel.",
     {'1'},
     set_stage<StripStep{Stage::points}>,
     nullptr},
    {"stage.edges",
     "Stage",
     "Edges",
     "The outline of every triangle.",
     {'2'},
     set_stage<StripStep{Stage::edges}>,
     nullptr},
    {"stage.rows",
     "Stage",
     "Rows",
     "Where every row of every triangle begins and ends.",
     {'3'},
     set_stage<StripStep{Stage::rows}>,
     nullptr},
    {"stage.fill",
     "Stage",
     "Fill",
     "Every row filled; the last one drawn covers the rest.",
     {'4'},
     set_stage<StripStep{Stage::fill}>,
     nullptr},
    {"stage.depth",
     "Stage",
     "Depth",
     "A fragment is drawn only if it is nearer.",
     {'5'},
     set_stage<StripStep{Stage::depth}>,
     nullptr},
    {"stage.vertex_light",
     "Stage",
     "Vertex light",
     "Light at the vertices, interpolated between them.",
     {'6'},
     set_stage<StripStep::vertex_light>,
     nullptr},
    {"stage.pixel_light",
     "Stage",
     "Pixel light",
     "Light computed anew at every pixel.",
     {'7'},
     set_stage<StripStep::pixel_light>,
     nullptr},
    {"switch.perspective",
     "Stage",
     "Perspective correction",
     "Interpolates q/z and divides by 1/z; off, q itself is interpolated and the light skews.",
     {'P'},
     [](Ui& ui) {
         if (refuses_settings(ui.session)) return;
         Interpolation& i = ui.session.a.settings.interpolation;
         i = i == Interpolation::perspective ? Interpolation::affine : Interpolation::perspective;
     },
     [](const Ui& ui) {
         return ui.session.a.settings.interpolation == Interpolation::perspective;
     }},
    {"switch.depth_test",
     "Stage",
     "Depth test",
     "Draws a fragment only if it is nearer; off, the last one drawn wins.",
     {'Z'},
     [](Ui& ui) {
         if (refuses_settings(ui.session)) return;
         DepthTest& d = ui.session.a.settings.depth_test;
         d = d == DepthTest::off ? DepthTest::inverse_z : DepthTest::off;
     },
     [](const Ui& ui) { return ui.session.a.settings.depth_test != DepthTest::off; }},

    {"switch.compare",
     "Compare",
     "Compare two runs",
     "Shows the picture beside that of other settings: with affine interpolation, with other light "
     "or rounding, as suits the stage. Again: back to one run.",
     {'C'},
     toggle_compare,
     [](const Ui& ui) { return ui.session.b.has_value(); }},
    {"compare.view.side_by_side",
     "Compare",
     "Side by side",
     "Both pictures, one beside the other.",
     {},
     set_compare_view<CompareView::side_by_side>,
     shows_compare_view<CompareView::side_by_side>},
    {"compare.view.wipe",
     "Compare",
     "Wipe",
     "A left of a divider, B right of it.",
     {},
     set_compare_view<CompareView::wipe>,
     shows_compare_view<CompareView::wipe>},
    {"compare.view.blink",
     "Compare",
     "Blink",
     "A and B in turn, once a second.",
     {},
     set_compare_view<CompareView::blink>,
     shows_compare_view<CompareView::blink>},
    {"compare.view.difference",
     "Compare",
     "Difference",
     "B minus A, with a scale.",
     {},
     set_compare_view<CompareView::difference>,
     shows_compare_view<CompareView::difference>},
    {"compare.hold",
     "Compare",
     "Hold the blinking",
     "Stays with the picture on show while two runs blink; again: goes on.",
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
     nullptr},
    {"compare.next",
     "Compare",
     "Next divergence",
     "Goes on to the next moment at which the two runs differ.",
     {'J'},
     go_to_next_divergence,
     nullptr},
    {"compare.previous",
     "Compare",
     "Previous divergence",
     "Goes back to the moment before at which the two runs differ.",
     {'K'},
     go_to_previous_divergence,
     nullptr},

    {"walk.first",
     "Walk",
     "To the beginning",
     "Goes back to the empty picture.",
     {key::home},
     [](Ui& ui) { go_to(ui.session, cursor_begin); },
     nullptr},
    {"walk.back",
     "Walk",
     "Step back",
     "Takes back one piece of the chosen size.",
     {key::comma},
     [](Ui& ui) { step_back(ui.session, timeline_of(ui), ui.session.play.granularity); },
     nullptr},
    {"walk.play",
     "Walk",
     "Play or pause",
     "Lets time run, one piece after the other.",
     {key::space},
     [](Ui& ui) { toggle_play(ui.session, timeline_of(ui)); },
     [](const Ui& ui) { return ui.session.play.running; }},
    {"walk.step",
     "Walk",
     "Step",
     "Draws the next piece of the chosen size.",
     {key::period},
     [](Ui& ui) { step_forward(ui.session, timeline_of(ui), ui.session.play.granularity); },
     nullptr},
    {"walk.last",
     "Walk",
     "To the end",
     "Draws everything.",
     {key::end},
     [](Ui& ui) { go_to(ui.session, cursor_end); },
     nullptr},
    {"walk.previous_triangle",
     "Walk",
     "Previous triangle",
     "Goes back to where a triangle begins.",
     {key::left_bracket},
     [](Ui& ui) { step_back(ui.session, timeline_of(ui), Granularity::triangle); },
     nullptr},
    {"walk.next_triangle",
     "Walk",
     "Next triangle",
     "Goes on to where the next triangle begins.",
     {key::right_bracket},
     [](Ui& ui) { step_forward(ui.session, timeline_of(ui), Granularity::triangle); },
     nullptr},

    {"walk.previous_change",
     "Walk",
     "Previous change of the pixel",
     "Goes back to where the picked pixel was written before.",
     {'B'},
     [](Ui& ui) { walk_to_change(ui, previous_change, "earlier"); },
     nullptr},
    {"walk.next_change",
     "Walk",
     "Next change of the pixel",
     "Goes on to where the picked pixel is written next.",
     {'N'},
     [](Ui& ui) { walk_to_change(ui, next_change, "later"); },
     nullptr},

    {"walk.faster",
     "Walk",
     "Play faster",
     "Doubles the speed of the play.",
     {key::equal},
     [](Ui& ui) { ui.session.play.speed = std::min(2.0f * ui.session.play.speed, fastest_play); },
     nullptr},
    {"walk.slower",
     "Walk",
     "Play slower",
     "Halves the speed of the play.",
     {key::minus},
     [](Ui& ui) { ui.session.play.speed = std::max(0.5f * ui.session.play.speed, slowest_play); },
     nullptr},

    {"lesson.on",
     "Lesson",
     "Next step",
     "Goes on to the next step of the lesson.",
     {key::page_down},
     [](Ui& ui) { open_neighbour_step(ui, 1); },
     nullptr},
    {"lesson.back",
     "Lesson",
     "Step before",
     "Returns to the step before.",
     {key::page_up},
     [](Ui& ui) { open_neighbour_step(ui, -1); },
     nullptr},
    {"lesson.again",
     "Lesson",
     "Set up this step again",
     "Brings back the picture with which the step began.",
     {'R'},
     [](Ui& ui) { open_neighbour_step(ui, 0); },
     nullptr},
    {"lesson.all",
     "Lesson",
     "All lessons",
     "The list of lessons, with a search.",
     {'L'},
     [](Ui& ui) {
         ui.lesson.shows_list = !ui.lesson.shows_list;
         ui.lesson.covers_inspector = true;
     },
     [](const Ui& ui) { return ui.lesson.shows_list; }},

    {"help.glossary",
     "Help",
     "Glossary",
     "What the words of the lab mean.",
     {key::f1 + 1},
     [](Ui& ui) { ui.shows_glossary = !ui.shows_glossary; },
     [](const Ui& ui) { return ui.shows_glossary; }},
    {"help.keys",
     "Help",
     "All keys",
     "Shows what every key does.",
     {key::f1},
     [](Ui& ui) { ui.shows_keys = !ui.shows_keys; },
     [](const Ui& ui) { return ui.shows_keys; }},
};

} // namespace

std::span<const Action> action_table() {
    return table;
}

} // namespace rasterwalk
