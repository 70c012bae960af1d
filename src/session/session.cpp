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
    session.settings.camera = fresh.camera;
    session.settings.light = fresh.light;
    session.settings.viewport = fresh.viewport;
    if (!scene.stage.empty()) session.settings.stage = fresh.stage;
    session.cursor = cursor_end;
    session.selection = {};
    session.play.running = false;
    session.play.owed = 0.0f;
    session.scene = std::make_shared<const Scene>(std::move(scene));
}

} // namespace rasterwalk
