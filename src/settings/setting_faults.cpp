#include "settings/setting_faults.h"

#include "base/numbers.h"
#include "scene/look_at.h"

namespace rasterwalk {

std::vector<SettingFault> setting_faults(const Settings& settings, SceneSpace space) {
    std::vector<SettingFault> faults;
    if (space == SceneSpace::pixels) return faults;
    if (!(settings.near < settings.far)) {
        faults.push_back({"the far plane, at " + number_text(settings.far) +
                              ", is not behind the near plane, at " + number_text(settings.near) +
                              ": nothing lies between them",
                          "far plane not behind the near one"});
    }
    if (const AimFault fault = aim_fault(settings.camera); fault != AimFault::none) {
        faults.push_back(
            {std::string(words(fault).sentence) + ": " + std::string(words(fault).replacement),
             "the camera has no direction"});
    }
    return faults;
}

} // namespace rasterwalk
