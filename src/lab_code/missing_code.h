#pragma once

#include <string>

#include "lab_code/lab_program.h"

namespace rasterwalk {

/// What the code has no lines for: "Clipping: at the near plane"; empty if the code draws the
/// frame.
std::string missing_code(const LabCode& code, const Frame& frame);

} // namespace rasterwalk
