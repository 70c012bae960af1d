#include "session/preview.h"

#include <algorithm>

namespace rasterwalk {

void show_preview(const std::shared_ptr<const Scene>& scene, const Settings& settings,
                  FastRun& engine, std::uint64_t& numbers, Preview& preview) {
    preview.is_shown = false;
    if (preview.scene != scene || preview.settings != settings) {
        preview.settings = std::nullopt; // after an exception there is no picture
        engine.draw(scene, settings);
        copy_image(engine.picture(), preview.picture);
        preview.scene = scene;
        preview.settings = settings;
        preview.number = ++numbers;
    }
    preview.is_shown = true;
}

void HandWatch::watch(const Session& session) {
    const bool is_same = scene_ == session.scene && a_ == session.a && b_ == session.b;
    if (is_same || scene_ == nullptr) {
        updates_at_rest_ = std::min(updates_at_rest_ + 1, updates_of_rest);
    } else {
        updates_at_rest_ = 0;
    }
    scene_ = session.scene;
    a_ = session.a;
    b_ = session.b;
}

} // namespace rasterwalk
