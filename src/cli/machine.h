#pragma once

#include <string>

#include "cli/json.h"

namespace rasterwalk {

/// The machine that something is timed on: "AMD EPYC 9354, 2 processors"; without the name if the
/// system does not say.
std::string machine_text();

/// The same for --json; the name is null if the system does not say.
Json machine_to_json();

} // namespace rasterwalk
