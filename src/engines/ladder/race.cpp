#include "engines/ladder/race.h"

#include <cstddef>

#include "engines/ladder/ladder.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk {

namespace {

EnginePicture drawn_by(int threads, const Scene& scene, const Settings& settings) {
    WorkerPool pool(threads);
    LadderPicture picture;
    rungs::two_threads_one_buffer::draw(scene, settings, picture, pool);
    return {picture.size, picture.colour};
}

} // namespace

Scene race_scene() {
    Scene scene;
    scene.name = "Sheets";
    scene.camera = {.position = glm::vec3(0.0f, 0.0f, -2.0f), .focal_length = 500.0f};
    scene.light = {.position = glm::vec3(0.0f, 0.0f, -1.0f)};
    const auto add = [&](float x, float y, float size, float z, const glm::vec3& colour) {
        const auto corner = [&](float right, float down) {
            return Vertex{.position = glm::vec3(x + right * size, y + down * size, z),
                          .normal = glm::vec3(0.0f, 0.0f, -1.0f),
                          .reflectance = colour};
        };
        scene.mesh.add_triangle_of({corner(0.0f, 0.0f), corner(1.0f, 0.0f), corner(0.0f, 1.0f)});
    };
    constexpr int tiles = 40;
    for (int i = 0; i < tiles * tiles; ++i) {
        const int column = i % tiles, row = i / tiles;
        const float x = -1.0f + 0.05f * static_cast<float>(column);
        const float y = -1.0f + 0.05f * static_cast<float>(row);
        add(x, y, 0.08f, 0.0f, glm::vec3(0.9f, 0.2f, 0.1f));
        add(1.1f * x, 1.1f * y, 0.08f, 0.2f, glm::vec3(0.1f, 0.4f, 0.9f));
    }
    return scene;
}

Settings race_settings(const Scene& scene) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    return settings;
}

std::vector<std::int64_t> race_pictures(const Scene& scene, const Settings& settings, int runs,
                                        const std::function<bool()>& is_stopped) {
    std::vector<std::int64_t> wrong;
    if (ladder_threads() == 1) return wrong;
    const EnginePicture right = drawn_by(1, scene, settings);
    for (int run = 0; run < runs && !(is_stopped && is_stopped()); ++run)
        wrong.push_back(
            difference_of(drawn_by(ladder_threads(), scene, settings), right).different);
    return wrong;
}

} // namespace rasterwalk
