#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "engines/fast/fast_view.h"
#include "engines/ladder/ladder.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What the rungs do not have; empty: they have all of it.
std::string_view missing(const Scene& scene, const Settings& settings) {
    if (shading_rule(settings) == Shading::unlit) return "pictures without light";
    if (settings.light.place != LampPlace::fixed) return "a lamp that goes with the camera";
    if (has_texture(scene) && settings.texture == TextureUse::on)
        return "textures (texture=off does without them)";
    if (scene.mesh.is_shiny() && settings.light.model != LightModel::lambert)
        return "highlights (light.model=lambert does without them)";
    if (scene.mesh.differences().colours) return "triangles whose corners differ in colour";
    if (camera_rotation(settings.camera) != glm::mat3(1.0f)) return "a camera that is turned";
    if (settings.cull != Cull::none) return "culling";
    return {};
}

/// What is wrong with where the triangles are; empty: nothing.
std::string misplaced(const Scene& scene, const Settings& settings) {
    double pixels = 0.0;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        glm::dvec2 low(ladder_guard), high(-ladder_guard);
        for (const Vertex& corner : corners_of(scene, t)) {
            if (!is_finite(corner.position) || !is_finite(corner.normal) ||
                !is_finite(corner.reflectance))
                return "a corner has a number that is not finite";
            const glm::dvec3 seen(corner.position - settings.camera.position);
            if (seen.z <= settings.near)
                return "the ladder does not cut: all corners must be farther than the near plane";
            const double scale = settings.camera.focal_length / seen.z;
            const glm::ivec2 middle{settings.viewport.width / 2, settings.viewport.height / 2};
            const glm::dvec2 place(scale * seen.x + middle.x, scale * seen.y + middle.y);
            if (!(std::abs(place.x) < ladder_guard - 1.0f) ||
                !(std::abs(place.y) < ladder_guard - 1.0f))
                return fmt::format("the ladder does not cut: all corners must be less than {} "
                                   "pixels from the picture's corner",
                                   ladder_guard);
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        pixels += (high.x - low.x + 1.0) * (high.y - low.y + 1.0);
    }
    if (pixels > most_ladder_pixels)
        return "the triangles are so many or so large that the lab's loop would take too long";
    return {};
}

} // namespace

std::string ladder_refuses(const Scene& scene, const Settings& settings) {
    if (std::string refusal = fast_engine_refuses(scene, settings); !refusal.empty())
        return refusal;
    if (std::int64_t{settings.viewport.width} * settings.viewport.height > most_ladder_picture)
        return fmt::format("a picture of more than {} million pixels takes too much memory, as "
                           "each rung keeps its own",
                           most_ladder_picture / 1'000'000);
    if (const std::string_view what = missing(scene, settings); !what.empty())
        return "the ladder does not draw " + std::string(what);
    return misplaced(scene, settings);
}

} // namespace rasterwalk
