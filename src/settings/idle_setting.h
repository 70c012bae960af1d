#pragma once

// The one rule of which settings do nothing to the picture because of how pixels are found.

#include <string>

#include "settings/setting_table.h"

namespace rasterwalk {

/// Why a setting has no effect on the picture under these settings, whatever its value: "pixels are
/// found by edge functions"; empty where coverage gives no such reason.
std::string idle_reason(const Setting& setting, const Settings& settings);

} // namespace rasterwalk
