#include "session/session.h"

#include <array>
#include <utility>

#include "scene/read_scene.h"
#include "session/content.h"

namespace rasterwalk {

Session open_session(const std::string& scene_path) {
    std::array<std::string_view, stage_count> stages;
    for (std::size_t i = 0; i < stages.size(); ++i)
        stages[i] = stage_list()[i].name;
    Session session;
    session.presets = read_presets(lessons_folder() + "/presets.toml");
    session.glossary = read_glossary(lessons_folder() + "/glossary.toml");
    set_scene(session, read_scene(scene_path, stages));
    return session;
}

void set_scene(Session& session, Scene scene) {
    const Settings fresh = default_settings(scene);
    const auto take_view = [&](Settings& settings) {
        settings.camera = fresh.camera;
        settings.light = fresh.light;
        settings.viewport = fresh.viewport;
    };
    if (session.other) {
        Settings other = *session.other;
        take_view(other);
        const bool same_stage = other.stage == session.settings.stage;
        if (same_stage && !scene.stage.empty()) other.stage = fresh.stage;
        session.other = other;
    }
    take_view(session.settings);
    if (!scene.stage.empty()) session.settings.stage = fresh.stage;
    session.followed = std::nullopt;
    session.cursor = cursor_end;
    session.selection = {};
    session.play.running = false;
    session.play.owed = 0.0f;
    session.scene = std::make_shared<const Scene>(std::move(scene));
}

} // namespace rasterwalk
