#include "session/shown_pass.h"

#include "pipeline/shadow_pass.h"

namespace rasterwalk {

int shown_pass(const Session& session, const Run& run) {
    // Run A decides, so that both runs show the same pass.
    const int of_a = pass_of(session.cursor, session.a.settings, session.scene->space);
    return of_a < first_pass(run.settings, session.scene->space) ? 0 : of_a;
}

Run shown_run(const Session& session, const Run& run) {
    return {settings_of_pass(run.settings, shown_pass(session, run))};
}

Frame shown_frame(const Session& session) {
    return prepare_pass(*session.scene, session.a.settings, shown_pass(session, session.a));
}

} // namespace rasterwalk
