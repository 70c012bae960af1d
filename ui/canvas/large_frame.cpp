#include "ui/canvas/large_frame.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "ui/actions/compare.h"
#include "ui/canvas/notice_bar.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

std::optional<Settings> settings_of_b(const Session& session) {
    return session.b ? std::optional(session.b->settings) : std::nullopt;
}

/// The wish for the current frame; a wish for a different one no longer counts.
LargeFrameChoice choice_of(const Ui& ui) {
    const LargeFrame& said = ui.canvas.large_frame;
    const Session& session = ui.session;
    const bool is_same = said.scene == session.scene && said.a == session.a.settings &&
                         said.b == settings_of_b(session);
    return is_same ? said.choice : LargeFrameChoice::none;
}

void say(Ui& ui, LargeFrameChoice choice) {
    const Session& session = ui.session;
    ui.canvas.large_frame = {choice, session.scene, session.a.settings, settings_of_b(session)};
}

bool is_large(const RunResults& run) {
    return run.is_deferred || run.replay.work().fragments().all > many_fragments;
}

/// The run with that many fragments, A before B; null: neither has.
const RunResults* large_run(const Results& results) {
    if (is_large(results.a)) return &results.a;
    return results.b && is_large(*results.b) ? &*results.b : nullptr;
}

/// What is said, from the longest form to the shortest.
std::vector<std::string> forms_of(const RunResults& run, LargeFrameChoice choice) {
    const FragmentEstimate& fragments = run.replay.work().fragments();
    const std::string number =
        grouped(std::llround(fragments.all / 1'000'000.0)) + " million fragments";
    const double outside = 100.0 * fragments.share_outside();
    const std::string share =
        outside >= 1.0 ? fmt::format(", {} % outside the picture", fixed(outside, 1)) : "";
    std::string state;
    if (run.is_deferred)
        state = choice == LargeFrameChoice::stop ? ": stopped" : ": not drawn yet";
    else if (!run.is_drawn())
        state = ": being drawn";
    else if (outside >= 1.0)
        state = ": those are not drawn";
    return {"About " + number + share + state, number + share + state, number + state, number};
}

} // namespace

WorkLimit work_limit(const Ui& ui) {
    WorkLimit limit = frame_limit;
    switch (choice_of(ui)) {
    case LargeFrameChoice::none:
        limit.most = many_fragments;
        break;
    case LargeFrameChoice::draw:
        break;
    case LargeFrameChoice::stop:
        limit.most = 0.0;
        break;
    }
    return limit;
}

bool draw_large_frame_bar(Ui& ui) {
    const RunResults* const run = large_run(ui.results);
    if (run == nullptr) return false;
    const NoticeButton draw{"canvas.draw_it", "draw it",
                            "Draws the frame anyway, a part at a time."};
    const NoticeButton stop{"canvas.stop", "stop", "Stops the drawing; what has been drawn stays."};
    const NoticeButton clip{"canvas.clip_it", "clip it",
                            "Clips all triangles at the six planes of the view (clip=all). Then "
                            "hardly any fragments fall outside the picture."};
    std::vector<NoticeButton> buttons;
    if (run->is_deferred)
        buttons.push_back(draw);
    else if (!run->is_drawn())
        buttons.push_back(stop);
    // In a quiz the question is about the settings.
    const bool helps = run->frame.settings.clip != Clip::all && !hides_settings(ui.session);
    if (helps && run->replay.work().fragments().share_outside() > 0.1) buttons.push_back(clip);

    const std::vector<std::string> forms = forms_of(*run, choice_of(ui));
    const std::string help =
        forms.front() + ".\nEstimated from the areas of the triangles. A program that interpolates "
                        "every fragment of a triangle, whether in the picture or not, seems to "
                        "hang here; see lesson 18.";
    const std::string_view clicked =
        draw_notice_bar(ui, "canvas.fragments", forms, help, true, buttons);
    if (clicked == draw.name) say(ui, LargeFrameChoice::draw);
    if (clicked == stop.name) say(ui, LargeFrameChoice::stop);
    if (clicked == clip.name) ui.session.a.settings.clip = Clip::all;
    return true;
}

} // namespace rasterwalk
