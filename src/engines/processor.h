#pragma once

#include <string>

namespace rasterwalk {

/// The name of this machine's processor, "AMD EPYC 9354"; empty if the system does not say.
std::string processor_name();

/// How many threads run at the same time on it.
int processor_count();

} // namespace rasterwalk
