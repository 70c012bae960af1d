#pragma once

// Settings that contradict each other. Each alone is allowed, and there is no telling which of them
// should change, so they are reported, and something is drawn all the same.

#include <string>
#include <vector>

#include "settings/settings.h"

namespace rasterwalk {

struct SettingFault {
    std::string sentence; ///< without a full stop: "the far plane, at 1, is not behind ..."
    std::string in_short; ///< the same where there is little room

    friend bool operator==(const SettingFault&, const SettingFault&) = default;
};

/// A far plane that is not behind the near one, a camera without a direction, a tessellation that
/// makes too many triangles, and samples of a pixel where there are none. A scene in pixel space
/// has no camera; its planes matter if the depth is measured between them, see ClipDepth.
std::vector<SettingFault> setting_faults(const Settings& settings, const Scene& scene);

} // namespace rasterwalk
