#include "session/bench.h"

#include <algorithm>

namespace rasterwalk {

bool is_bench(const Scene& scene) {
    return scene.space == SceneSpace::pixels;
}

void move_bench_vertex(Session& session, int triangle, int vertex, glm::ivec2 pixel) {
    if (!is_bench(*session.scene)) return;
    const int limit = static_cast<int>(max_pixel_distance);
    Scene scene = *session.scene;
    glm::vec3& position = scene.triangles[triangle].vertices[vertex].position;
    position.x = static_cast<float>(std::clamp(pixel.x, -limit, limit));
    position.y = static_cast<float>(std::clamp(pixel.y, -limit, limit));
    session.scene = std::make_shared<const Scene>(std::move(scene));
}

void show_bench_example(Session& session, const BenchExample& example) {
    if (!is_bench(*session.scene) || session.scene->triangles.empty()) return;
    Scene scene = *session.scene;
    for (int v = 0; v < 3; ++v)
        scene.triangles[0].vertices[v].position = example.positions[v];
    session.scene = std::make_shared<const Scene>(std::move(scene));
    session.cursor = cursor_end;
    session.play.running = false;
}

} // namespace rasterwalk
