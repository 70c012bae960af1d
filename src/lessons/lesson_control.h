#pragma once

#include <toml++/toml.h>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// The block `control` of a lesson. Its setting is null if it cannot be shown; why stands in the
/// faults.
/// @param line where the block begins: faults of the whole block are reported there
LessonControl read_control(const toml::table& table, int line, FaultList& faults);

/// Why the control does not suit the settings with which its step opens: a sentence; empty if it
/// does.
std::string misfit_of(const LessonControl& control, const Settings& settings, const Scene& scene);

} // namespace rasterwalk
