#include "session/preview_parts.h"

#include "engines/fast/fast_view.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

/// Can the fast engine stand in for the steps of this run? The panels next to the picture still
/// belong to the frame shown, so triangles and size must be the same.
bool may_preview(const Session& session, const Run& run, const RunResults& results) {
    return results.run && results.scene == session.scene &&
           results.run->settings.viewport == run.settings.viewport &&
           results.run->settings.tessellation == run.settings.tessellation &&
           results.frame.list == nullptr &&
           fast_engine_refuses(*results.frame.scene, run.settings).empty();
}

/// The same for both runs or neither, so that they are seen from the same place.
bool may_preview(const Session& session, const Results& results) {
    if (session.view != View::colour || session.cursor != cursor_end) return false;
    if (!may_preview(session, session.a, results.a)) return false;
    if (!session.b) return true;
    if (session.b->program != nullptr) return false; // no engine of ours draws what it drew
    return session.compare_view != CompareView::difference && results.b &&
           may_preview(session, *session.b, *results.b);
}

/// Calls this with each run and its results.
template <class Visitor>
void for_each_run(const Session& session, Results& results, const Visitor& visit) {
    visit(shown_run(session, session.a), results.a);
    if (session.b && results.b) visit(shown_run(session, *session.b), *results.b);
}

/// Are there steps that have yet to draw what is asked for?
bool are_steps_late(const Session& session, Results& results) {
    bool are_late = false;
    for_each_run(session, results, [&](const Run& run, const RunResults& of) {
        const bool is_late = !is_shown(session.scene, run, of);
        are_late = are_late || is_late || !of.is_complete();
    });
    return are_late;
}

/// The work of drawing the picture by its engine.
double work_of(const RunResults& of) {
    if (of.engine != Engine::rays) return of.replay.work().total();
    const Viewport size = of.frame.settings.viewport;
    return ray_work(of.frame.settings, of.frame.triangle_count()) *
           static_cast<double>(size.width) * static_cast<double>(size.height);
}

/// Is it known that the engines need more than one update for the pictures?
bool is_much_to_draw(const WorkLimit& limit, const Results& results) {
    const auto is_much = [&](const RunResults& of) {
        return of.preview.is_shown || work_of(of) > limit.at_once;
    };
    return is_much(results.a) || (results.b && is_much(*results.b));
}

void show_previews(const Session& session, Results& results) {
    for_each_run(session, results, [&](const Run& run, RunResults& of) {
        show_preview(of.drawn_scene(), run.settings, results.preview_engine, results.numbers,
                     of.preview);
    });
}

void hide_previews(Results& results) {
    results.a.preview.is_shown = false;
    if (results.b) results.b->preview.is_shown = false;
}

} // namespace

bool follow_hand(const Session& session, const WorkLimit& limit, Results& results) {
    const bool steps_wait = results.hand.has_moved() && may_preview(session, results) &&
                            is_much_to_draw(limit, results) && are_steps_late(session, results);
    if (!steps_wait) return false;
    for_each_run(session, results, [&](const Run& run, RunResults& of) {
        of.is_frame_late = !is_shown(session.scene, run, of);
    });
    show_previews(session, results);
    return true;
}

void update_previews(const Session& session, Results& results) {
    const bool are_wanted = results.hand.has_moved() || results.a.preview.is_shown;
    const bool is_deferred = results.a.is_deferred || (results.b && results.b->is_deferred);
    if (are_wanted && !is_deferred && may_preview(session, results) &&
        are_steps_late(session, results)) {
        show_previews(session, results);
    } else {
        hide_previews(results);
    }
}

} // namespace rasterwalk
