#include "settings/setting_faults.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "base/numbers.h"
#include "scene/look_at.h"
#include "scene/tessellation.h"

namespace rasterwalk {

std::vector<SettingFault> setting_faults(const Settings& settings, const Scene& scene) {
    const SceneSpace space = scene.space;
    std::vector<SettingFault> faults;
    const bool has_camera = space == SceneSpace::world;
    const bool asks_planes = has_camera || clip_depth_rule(settings, space) != ClipDepth::inv_z;
    if (asks_planes && !(settings.near < settings.far)) {
        faults.push_back({"the far plane, at " + number_text(settings.far) +
                              ", is not behind the near plane, at " + number_text(settings.near) +
                              ", so nothing lies between them",
                          "far plane not behind the near one"});
    }
    if (has_camera && settings.view_box && !view_box_rule(settings, space)) {
        faults.push_back({"view_box does nothing with transform=lab, which uses the focal length; "
                          "set transform=matrices",
                          "view_box needs matrices"});
    }
    const AimFault fault = has_camera ? aim_fault(settings.camera) : AimFault::none;
    if (fault != AimFault::none) {
        faults.push_back(
            {std::string(words(fault).sentence) + ": " + std::string(words(fault).replacement),
             "the camera has no direction"});
    }
    const int parts = tessellation_of(scene, settings.tessellation);
    if (has_camera && parts != settings.tessellation) {
        faults.push_back(
            {fmt::format("tessellation = {} makes more than {} of this scene, so it is cut into {}",
                         settings.tessellation,
                         counted(most_tessellated_triangles, "triangle", "triangles"),
                         counted(parts, "part per edge", "parts per edge")),
             fmt::format("tessellation {}", parts)});
    }
    const bool asks_samples = settings.samples > 1 || settings.supersample > 1;
    if (asks_samples && settings.coverage == Coverage::rows) {
        faults.push_back({"several samples of a pixel do nothing with coverage=rows: the row table "
                          "holds whole columns, and there is nothing between them; set "
                          "coverage=edge_functions",
                          "samples need another coverage"});
    } else if (asks_samples && hidden_rule(settings) == Hidden::warnock) {
        faults.push_back(
            {"several samples of a pixel do nothing with hidden=warnock, whose squares "
             "are made of whole pixels",
             "no samples in squares"});
    } else if (settings.samples > 1 && settings.supersample > 1) {
        faults.push_back({"samples=4 does nothing with supersample=2, which shades all of its four "
                          "samples",
                          "supersample goes before samples"});
    }
    return faults;
}

} // namespace rasterwalk
