#pragma once

#include <string>

#include "settings/control_range.h"
#include "settings/setting_table.h"

namespace rasterwalk {

struct Ui;

/// The field for changing a setting of one of the runs, as wide as ImGui's next item, under a name
/// for tests.
void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name);

/// The same if only part of the setting's range is offered: numbers are then a slider.
void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name,
                  const ControlRange& range);

} // namespace rasterwalk
