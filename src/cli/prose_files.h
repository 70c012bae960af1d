#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// The files at these paths that hold prose (text/prose.h), sorted by name in each folder. Folders
/// include the folders below them, but not `build`, hidden folders or links, nor the list of
/// phrases itself; a file given by its path counts whatever its name. Throws AccessError for a path
/// that is not there.
std::vector<std::string> prose_files(const std::vector<std::string>& paths);

} // namespace rasterwalk
