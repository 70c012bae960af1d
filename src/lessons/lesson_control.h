#pragma once

#include <toml++/toml.h>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// Reads the `control` block of a lesson. Its setting is null if it cannot be shown; the faults say
/// why.
/// @param line where the block begins: faults of the whole block are reported there
LessonControl read_control(const toml::table& table, int line, FaultList& faults);

/// Why the control does not suit the settings that its step opens with, a sentence; empty if it
/// does.
std::string misfit_of(const LessonControl& control, const Settings& settings, const Scene& scene);

} // namespace rasterwalk
