#include "settings/setting_faults.h"

#include "base/numbers.h"
#include "scene/look_at.h"

namespace rasterwalk {

std::vector<SettingFault> setting_faults(const Settings& settings, SceneSpace space) {
    std::vector<SettingFault> faults;
    const bool has_camera = space == SceneSpace::world;
    const bool asks_planes = has_camera || clip_depth_rule(settings, space) != ClipDepth::inv_z;
    if (asks_planes && !(settings.near < settings.far)) {
        faults.push_back({"the far plane, at " + number_text(settings.far) +
                              ", is not behind the near plane, at " + number_text(settings.near) +
                              ": nothing lies between them",
                          "far plane not behind the near one"});
    }
    const AimFault fault = has_camera ? aim_fault(settings.camera) : AimFault::none;
    if (fault != AimFault::none) {
        faults.push_back(
            {std::string(words(fault).sentence) + ": " + std::string(words(fault).replacement),
             "the camera has no direction"});
    }
    return faults;
}

} // namespace rasterwalk
