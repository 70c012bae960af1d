#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// The files at these paths that hold prose (text/prose.h), each folder's by name. Of a folder
/// those in the folders below it too, but not in `build`, hidden folders or links, nor the list of
/// phrases itself; a file that is named is taken whatever its name. Throws AccessError for a path
/// that is not there.
std::vector<std::string> prose_files(const std::vector<std::string>& paths);

} // namespace rasterwalk
