#pragma once

#include <string>

namespace rasterwalk {

/// The folder of the project's sources, without a slash at the end.
std::string project_root();

} // namespace rasterwalk
