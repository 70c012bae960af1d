#include "inspect/seen_hints.h"

#include <fmt/format.h>

#include "base/numbers.h"
#include "pipeline/draw.h"
#include "settings/settings.h"
#include "stages/cull.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

bool is_back(const Frame& frame, int triangle, const SightRays& rays) {
    return away_from_camera(as_one_face(frame.given_clip_vertices(triangle)), rays) > 0.0f;
}

/// What would be seen under other settings.
SeenPixels seen_under(const Settings& settings, const Frame& frame) {
    const Frame other = prepare_frame(*frame.given, settings, frame.replace);
    return count_seen(other, draw_frame(other));
}

std::string hint_of_backs(const Frame& frame, const SeenPixels& seen) {
    if (frame.settings.cull != Cull::none || 2 * seen.backs <= seen.surface) return {};
    Settings culled = frame.settings;
    culled.cull = Cull::face_normal;
    // Of a sheet or of a model that is inside out next to nothing would be left.
    if (2 * seen_under(culled, frame).surface <= seen.surface) return {};
    return fmt::format("Most of what you see are backs, {} of {}: cull=face_normal, the setting "
                       "'Backs left out', shows what is behind them.",
                       seen.backs, counted(seen.surface, "pixel", "pixels"));
}

std::string hint_of_black(const Frame& frame, const SeenPixels& seen) {
    if (seen.lit > 0 || shading_rule(frame.settings) == Shading::unlit) return {};
    Settings two_sided = frame.settings, at_camera = frame.settings;
    two_sided.light_rules.sides = LightSides::two;
    at_camera.light.place = LampPlace::camera;
    const std::int64_t by_sides = seen_under(two_sided, frame).lit;
    const std::int64_t by_lamp = seen_under(at_camera, frame).lit;
    if (by_sides == 0 && by_lamp == 0) return {};
    const bool is_by_sides = by_sides >= by_lamp;
    return fmt::format("All that you see is black: {} would light {} of {}.",
                       is_by_sides ? "light.sides=two, the setting 'Lit sides',"
                                   : "light.place=camera, the setting 'Lamp stands',",
                       is_by_sides ? by_sides : by_lamp, counted(seen.surface, "pixel", "pixels"));
}

} // namespace

SeenPixels count_seen(const Frame& frame, const Framebuffer& picture) {
    const SightRays rays = sight_rays(vertex_rules(frame.settings, frame.scene->space));
    SeenPixels seen;
    int known = -1;
    bool known_is_back = false;
    for (std::size_t i = 0; i < picture.owner.size(); ++i) {
        const int triangle = picture.owner[i];
        if (triangle < 0) continue;
        if (triangle != known) {
            known = triangle;
            known_is_back = is_back(frame, triangle, rays);
        }
        const glm::vec3& colour = picture.colour[i];
        ++seen.surface;
        seen.backs += known_is_back ? 1 : 0;
        seen.lit += colour.r > 0.0f || colour.g > 0.0f || colour.b > 0.0f ? 1 : 0;
    }
    return seen;
}

std::vector<std::string> seen_hints(const Frame& frame, const Framebuffer& picture) {
    std::vector<std::string> hints;
    if (!frame.scene->model_report || !has_fragments(frame.settings.stage)) return hints;
    const SeenPixels seen = count_seen(frame, picture);
    if (seen.surface == 0) return hints;
    for (const std::string& hint : {hint_of_backs(frame, seen), hint_of_black(frame, seen)}) {
        if (!hint.empty()) hints.push_back(hint);
    }
    return hints;
}

} // namespace rasterwalk
