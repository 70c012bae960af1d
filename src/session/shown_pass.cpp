#include "session/shown_pass.h"

#include "pipeline/shadow_pass.h"

namespace rasterwalk {

int shown_pass(const Session& session, const Run& run) {
    // Run A decides, so that both runs show the same pass.
    const int of_a = pass_of(session.cursor, session.a.settings, session.scene->space);
    return of_a < first_pass(run.settings, session.scene->space) ? 0 : of_a;
}

Run shown_run(const Session& session, const Run& run) {
    const int pass = shown_pass(session, run);
    return {settings_of_pass(run.settings, pass), pass == 0 ? run.program : nullptr};
}

Viewport shown_size(const Session& session) {
    return shown_run(session, session.a).settings.viewport;
}

void leave_missing_pass(Session& session) {
    if (session.cursor.pass >= 0 || shown_pass(session, session.a) < 0) return;
    session.cursor = cursor_end;
    session.selection.pixel = std::nullopt;
    session.selection.row = std::nullopt;
}

Frame shown_frame(const Session& session) {
    return prepare_pass(*session.scene, session.a.settings, shown_pass(session, session.a));
}

} // namespace rasterwalk
