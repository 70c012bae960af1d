#pragma once

// The one rule of which settings do nothing to the picture because of how pixels are found, and
// because of where the lamp stands.

#include <string>

#include "settings/setting_table.h"

namespace rasterwalk {

/// When a setting has no effect on the picture, if these settings are such a case: "while pixels
/// are found by edge functions", whatever its value; empty where there is no such reason.
std::string idle_reason(const Setting& setting, const Settings& settings);

} // namespace rasterwalk
