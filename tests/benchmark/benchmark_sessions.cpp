#include "benchmark_sessions.h"

#include "engines/knot.h"
#include "session/content.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "support/made_scene.h"

namespace rasterwalk {

namespace {

constexpr int made_triangles = 200'000;

} // namespace

Session room() {
    return open_session(lessons_folder() + "/scenes/lab-room.toml");
}

Session made() {
    Session session = room();
    set_scene(session, test::made_scene(made_triangles));
    return session;
}

Session knot() {
    Session session = room();
    set_scene(session, knot_scene());
    return session;
}

Session wide() {
    Session session = room();
    set_from_text(session.a.settings, "viewport.size=4096x4096");
    set_from_text(session.a.settings, "camera.focal_length=4096");
    return session;
}

void compare_with_setting(Session& session, const char* assignment) {
    Settings other = session.a.settings;
    set_from_text(other, assignment);
    compare_with(session, other);
}

void compare_with_affine(Session& session) {
    compare_with_setting(session, "interpolation=affine");
}

} // namespace rasterwalk
