#include "picture/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/work.h"

namespace rasterwalk {

namespace {

/// The cost of clearing and showing a pixel, relative to the work of a fragment.
constexpr double work_of_pixel = 0.5;

/// A picture of a few pixels is not enlarged.
float scale_to(const Scene& scene, const Settings& settings, int side) {
    const Viewport whole = settings.viewport;
    const float scale =
        static_cast<float>(side) / static_cast<float>(std::max(whole.width, whole.height));
    return scene.space == SceneSpace::pixels ? std::min(scale, 1.0f) : scale;
}

/// The frame of a small picture, and the scene it refers to.
struct SmallFrame {
    Scene scene; ///< one in pixels, made smaller; otherwise without triangles
    Frame frame;
};

/// The middle of each pixel that has a vertex moves to its place in the smaller picture.
Mesh downsampled(const Mesh& mesh, float scale) {
    Mesh small;
    for (Vertex vertex : mesh.vertices()) {
        vertex.position.x = (vertex.position.x + 0.5f) * scale;
        vertex.position.y = (vertex.position.y + 0.5f) * scale;
        small.add_vertex(vertex);
    }
    for (const TriangleIndices& triangle : mesh.triangles())
        small.add_triangle(triangle);
    return small;
}

void prepare_small_frame(const Scene& scene, const Settings& settings, int side,
                         SmallFrame& small) {
    const float scale = scale_to(scene, settings, side);
    const bool is_downsampled = scene.space == SceneSpace::pixels && scale < 1.0f;
    if (is_downsampled) {
        small.scene.space = scene.space;
        small.scene.mesh = downsampled(scene.mesh, scale);
        if (!scene.textures.empty()) {
            small.scene.parts = scene.parts;
            small.scene.textures = scene.textures;
        }
    }
    prepare_frame(is_downsampled ? small.scene : scene, scaled_to(scene, settings, side), nullptr,
                  small.frame);
}

} // namespace

Settings scaled_to(const Scene& scene, const Settings& settings, int side) {
    const float scale = scale_to(scene, settings, side);
    const auto scaled = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
    };
    Settings small = settings;
    small.viewport = {scaled(settings.viewport.width), scaled(settings.viewport.height)};
    small.camera.focal_length *= scale;
    return small;
}

Image thumbnail(const Scene& scene, const Settings& settings, int side) {
    SmallFrame small;
    prepare_small_frame(scene, settings, side, small);
    return view_image(draw_frame(small.frame), View::colour);
}

double thumbnail_work(const Scene& scene, const Settings& settings, int side) {
    SmallFrame small;
    prepare_small_frame(scene, settings, side, small);
    FrameWork work;
    work.begin(small.frame);
    const Viewport size = small.frame.settings.viewport;
    return work.total() + work_of_pixel * static_cast<double>(size.width) * size.height;
}

} // namespace rasterwalk
