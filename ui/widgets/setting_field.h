#pragma once

#include <string>

#include "settings/control_range.h"
#include "settings/setting_table.h"

namespace rasterwalk {

struct Ui;

/// The field in which a setting of one of the runs is changed, as wide as ImGui's next item, under
/// a name for tests.
void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name);

/// The same where only a part of what the setting takes is offered: numbers are a slider then.
void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name,
                  const ControlRange& range);

} // namespace rasterwalk
