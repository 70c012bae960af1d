#include "engines/engine_picture.h"

#include <algorithm>

#include "pipeline/draw.h"

namespace rasterwalk {

bool is_drawn_fast(const Scene& scene, const Settings& settings, const Cursor& to) {
    return settings.engine == Engine::fast && to == cursor_end &&
           fast_engine_refuses(scene, settings).empty();
}

void copy_picture(const FastPicture& picture, const Frame& frame, Framebuffer& planes) {
    clear(planes, frame);
    constexpr float of_byte = 255.0f;
    for (int row = 0; row < picture.size.height; ++row) {
        const std::size_t from = picture.at(0, row), to = planes.at(0, row);
        for (std::size_t i = 0; i < static_cast<std::size_t>(picture.size.width); ++i) {
            const std::int32_t owner = picture.owner[from + i];
            if (owner < 0) continue;
            const std::uint32_t colour = picture.colour[from + i];
            const auto channel = [&](unsigned shift) {
                return static_cast<float>(colour >> shift & 255u) / of_byte;
            };
            planes.colour[to + i] = {channel(16), channel(8), channel(0)};
            planes.depth[to + i] = picture.inv_z[from + i];
            planes.owner[to + i] = owner;
        }
    }
}

void draw_by_engine(const Frame& frame, const Cursor& to, Framebuffer& planes) {
    if (!is_drawn_fast(*frame.scene, frame.settings, to)) {
        clear(planes, frame);
        draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, planes);
        return;
    }
    FastPicture picture;
    FastEngine(*frame.scene).draw(frame.settings, picture);
    copy_picture(picture, frame, planes);
}

bool FastRun::draw(const std::shared_ptr<const Scene>& scene, const Settings& settings) {
    if (shows(scene, settings)) return false;
    settings_ = std::nullopt;
    if (scene_ != scene) {
        engine_.emplace(*scene);
        scene_ = scene;
    }
    engine_->draw(settings, picture_);
    settings_ = settings;
    return true;
}

} // namespace rasterwalk
