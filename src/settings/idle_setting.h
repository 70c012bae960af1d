#pragma once

// The one rule for which settings have no effect on the picture because of how pixels are found or
// where the lamp is.

#include <string>

#include "settings/setting_table.h"

namespace rasterwalk {

/// Why a setting has no effect on the picture under these settings, whatever its value: "while
/// pixels are found by edge functions"; empty if there is no such reason.
std::string idle_reason(const Setting& setting, const Settings& settings);

} // namespace rasterwalk
