#include "session/session.h"

#include <utility>

#include "session/content.h"
#include "session/scene_file.h"

namespace rasterwalk {

Session open_session(const std::string& scene_path, const ReadingWatch& watch) {
    Session session;
    session.presets = read_presets(lessons_folder() + "/presets.toml");
    session.glossary = read_glossary(lessons_folder() + "/glossary.toml");
    set_scene(session, read_scene_file(scene_path, watch));
    guide_to_tab(session, {});
    return session;
}

void set_scene(Session& session, Scene scene) {
    end_quiz(session);
    const Settings fresh = default_settings(scene);
    const auto take_view = [&](Settings& settings) {
        settings.camera = fresh.camera;
        settings.light = fresh.light;
        settings.viewport = fresh.viewport;
    };
    if (session.b) {
        Settings& b = session.b->settings;
        take_view(b);
        const Settings& a = session.a.settings;
        const bool same_step = b.stage == a.stage && b.shading == a.shading;
        if (same_step && !scene.stage.empty()) set_step(b, step_of(fresh));
    }
    if (session.replaced) {
        // It can restore what it set, but neither the scene nor the view of it.
        session.replaced->before_scene = nullptr;
        take_view(session.replaced->before.settings);
        take_view(session.replaced->after.settings);
    }
    take_view(session.a.settings);
    if (!scene.stage.empty()) set_step(session.a.settings, step_of(fresh));
    session.runs_before = std::nullopt;
    // The same scene again is not a change that undo could take back.
    const bool is_same = session.scene != nullptr && *session.scene == scene;
    show_scene(session, is_same ? session.scene : std::make_shared<const Scene>(std::move(scene)));
}

void show_scene(Session& session, std::shared_ptr<const Scene> scene) {
    session.scene = std::move(scene);
    session.cursor = cursor_end;
    session.selection = {};
    session.play.running = false;
    session.play.passed = 0.0;
    session.canvas.zoom = 0.0f;
    session.canvas.outside.distance = 0.0f;
}

void show_info(Session& session, std::string sentence) {
    session.last_info = sentence;
    session.notice = std::move(sentence);
}

bool is_fault(const Session& session) {
    return !session.notice.empty() && session.notice != session.last_info;
}

} // namespace rasterwalk
