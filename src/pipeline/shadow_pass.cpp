#include "pipeline/shadow_pass.h"

#include <algorithm>
#include <utility>

#include "pipeline/draw.h"

namespace rasterwalk {

Settings shadow_face_settings(const glm::vec3& lamp, int face, int resolution) {
    const glm::vec3& direction = shadow_face_directions[static_cast<std::size_t>(face)];
    Settings settings;
    settings.stage = Stage::depth;
    settings.coverage = Coverage::edge_functions;
    settings.fill_rule = FillRule::top_left;
    settings.snap = Snap::subpixel;
    // All planes: things close to the lamp would otherwise fall millions of texels away.
    settings.clip = Clip::all;
    settings.near = shadow_near;
    settings.far = 1e7f;
    settings.viewport = {resolution, resolution};
    settings.camera.position = lamp;
    settings.camera.focal_length = 0.5f * static_cast<float>(resolution);
    settings.camera.aim = CameraAim::look_at;
    settings.camera.target = lamp + direction;
    settings.camera.up =
        direction.y == 0.0f ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
    return settings;
}

int first_pass(const Settings& settings, SceneSpace space) {
    return shadow_rule(settings, space) == Shadows::map ? pass_of_face(0) : 0;
}

int pass_of(const Cursor& cursor, const Settings& settings, SceneSpace space) {
    return cursor.pass < first_pass(settings, space) ? 0 : std::min(cursor.pass, 0);
}

std::string pass_name(int pass, const Language& language) {
    return tr(language, "shadow map, face {}",
              shadow_face_names[static_cast<std::size_t>(face_of_pass(pass))]);
}

Settings settings_of_pass(const Settings& settings, int pass) {
    if (pass == 0) return settings;
    Settings of_face = shadow_face_settings(light_rule(settings).position, face_of_pass(pass),
                                            settings.shadow_resolution);
    of_face.tessellation = settings.tessellation;
    return of_face;
}

Frame prepare_pass(const Scene& scene, const Settings& settings, int pass) {
    Frame frame = prepare_frame(scene, settings_of_pass(settings, pass));
    frame.pass = pass;
    return frame;
}

ShadowMap draw_shadow_map(const Scene& scene, const glm::vec3& lamp, int resolution) {
    ShadowMap map;
    map.lamp = lamp;
    map.resolution = resolution;
    Frame frame;
    for (int face = 0; face < shadow_face_count; ++face) {
        const Settings settings = shadow_face_settings(lamp, face, resolution);
        prepare_frame(scene, settings, nullptr, frame);
        ShadowFace& drawn = map.faces[static_cast<std::size_t>(face)];
        drawn.axes = camera_rotation(settings.camera);
        drawn.inv_depth = std::move(draw_frame(frame).depth);
    }
    return map;
}

void take_occluders(Frame& frame) {
    const Shadows shadows = shadow_rule(frame.settings, frame.scene->space);
    Occluders& known = frame.occluders;
    if (shadows == Shadows::off) {
        known = {};
        return;
    }
    known.rules = frame.settings.shadow_rules;
    // What casts shadows is the same in every order, and uncut.
    const Mesh& mesh = frame.in_order->mesh;
    if (known.triangles == nullptr || !known.triangles->is_of(mesh)) {
        known.triangles = std::make_shared<const TriangleTree>(mesh);
        known.map = nullptr;
    }
    if (shadows != Shadows::map) {
        known.map = nullptr;
        return;
    }
    const glm::vec3 lamp = light_rule(frame.settings).position;
    const int resolution = frame.settings.shadow_resolution;
    if (known.map == nullptr || known.map->lamp != lamp || known.map->resolution != resolution)
        known.map =
            std::make_shared<const ShadowMap>(draw_shadow_map(*frame.in_order, lamp, resolution));
}

} // namespace rasterwalk
