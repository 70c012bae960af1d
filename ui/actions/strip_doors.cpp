#include "ui/actions/strip_doors.h"

#include "pipeline/shadow_pass.h"
#include "session/walk.h"
#include "ui/actions/open_tab.h"
#include "ui/actions/outside.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Within a lesson the tab is the student's own choice, so that the way back to the lesson's tab
/// stays; without one, the next stage brings its tab again.
void show_tab(Ui& ui, std::string_view tab) {
    if (ui.session.lesson.empty()) {
        open_tab_by_link(ui, tab);
    } else {
        open_tab(ui, tab);
    }
}

void show_outside(Ui& ui) {
    if (shown_on_canvas(ui) == CanvasShows::picture) show_on_canvas(ui, CanvasShows::outside);
}

int triangle_to_show(const Ui& ui) {
    return ui.results.a.triangle.value_or(0);
}

/// The one that was drawn last is an earlier one, so this one has to be selected.
void go_to_triangle(Ui& ui, int triangle, const Cursor& moment) {
    go_to(ui.session, Timeline(ui.results.a.frame), moment);
    ui.session.selection.triangle = triangle;
}

/// Where the shown triangle's vertices are transformed.
void go_to_spaces(Ui& ui) {
    const int triangle = triangle_to_show(ui);
    const Timeline timeline(ui.results.a.frame);
    go_to_triangle(ui, triangle, timeline.at_or_after(beginning_of(triangle)));
    show_tab(ui, "vertices");
    show_outside(ui);
}

/// Where the shown triangle is clipped or culled; if it is not, where it begins.
void go_to_clipping(Ui& ui) {
    const Timeline timeline(ui.results.a.frame);
    const int triangle = triangle_to_show(ui);
    Cursor moment = timeline.at_or_after({triangle, Phase::clip, 0, 0});
    const bool is_cut =
        moment.triangle == triangle && (moment.phase == Phase::clip || moment.phase == Phase::cull);
    if (!is_cut) moment = timeline.at_or_after(beginning_of(triangle));
    go_to_triangle(ui, triangle, moment);
    show_tab(ui, "clip");
    show_outside(ui);
}

/// Where the lamp draws its map; without one, where the light asks what is in its way.
void go_to_shadows(Ui& ui) {
    const int first = first_pass(ui.session.a.settings, ui.session.scene->space);
    go_to(ui.session, first < 0 ? in_pass(cursor_begin, first) : cursor_end);
    show_tab(ui, "fragment");
}

/// Where the samples of the first pixel become its colour.
void go_to_resolve(Ui& ui) {
    go_to(ui.session, moment_of_resolve(0, 0));
    show_tab(ui, "history");
}

} // namespace

void open_door(Ui& ui, std::string_view name) {
    if (name == "space") go_to_spaces(ui);
    if (name == "clip") go_to_clipping(ui);
    if (name == "shadow") go_to_shadows(ui);
    if (name == "resolve") go_to_resolve(ui);
}

} // namespace rasterwalk
