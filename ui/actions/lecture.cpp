#include "ui/actions/lecture.h"

#include <utility>

#include "session/walk.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

bool walks_through_time(const Ui& ui) {
    return ui.options.is_lecture && ui.session.lesson.empty();
}

/// Going to another page leaves the frame behind: the arrows move the camera again, and Tab brings
/// the frame back.
void read(Ui& ui, void (*turn)(Ui&)) {
    const auto page = [&] { return std::pair(ui.session.step, ui.lesson.strip.card); };
    const auto before = page();
    turn(ui);
    if (page() != before) ui.focus.is_shown = false;
}

} // namespace

void toggle_lecture(Ui& ui) {
    UiOptions& options = ui.options;
    options.is_lecture = !options.is_lecture;
    ui.style_is_stale = true;
    // The drawer does not carry over to the other mode, even if the settings lie over it.
    ui.lesson.drawer_is_open |= std::exchange(ui.inspector.settings_over_drawer, false);
    std::swap(ui.lesson.drawer_is_open, ui.lesson.drawer_of_other_mode);
}

void walk_on(Ui& ui) {
    if (walks_through_time(ui)) {
        step_forward(ui.session, Timeline(ui.results.a.frame), ui.session.play.granularity);
    } else {
        read(ui, read_on);
    }
}

void walk_back(Ui& ui) {
    if (walks_through_time(ui)) {
        step_back(ui.session, Timeline(ui.results.a.frame), ui.session.play.granularity);
    } else {
        read(ui, read_back);
    }
}

} // namespace rasterwalk
