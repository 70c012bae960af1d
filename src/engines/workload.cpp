#include "engines/workload.h"

#include <cmath>

#include "engines/knot.h"
#include "stages/stages.h"

namespace rasterwalk {

Scene workload_scene(Workload workload, const Scene& room) {
    if (workload != Workload::w1) return knot_scene();
    Scene scene = room;
    scene.light.power = glm::vec3(14.0f);
    return scene;
}

Settings workload_settings(Workload workload, const Scene& scene, Viewport size) {
    Settings settings = default_settings(scene);
    set_step(settings, workload == Workload::w3 ? StripStep::vertex_light : StripStep::pixel_light);
    settings.coverage = Coverage::scan_conversion;
    settings.fill_rule = FillRule::top_left;
    settings.snap = Snap::subpixel;
    settings.viewport = size;
    settings.camera.focal_length = static_cast<float>(size.height);
    return settings;
}

glm::vec3 lamp_in_picture(const glm::vec3& at, int number) {
    constexpr float reach = 0.02f, radians_a_picture = 0.1f;
    const float x = at.x + reach * std::sin(radians_a_picture * static_cast<float>(number));
    return {x, at.y, at.z};
}

} // namespace rasterwalk
