#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A file of the kit, src/mine/kit, which is part of this program.
struct KitFile {
    std::string_view name; ///< relative to the kit: "SDL.h", "new/skeleton.cpp"
    std::string_view text;
};

/// All of them, sorted by name.
const std::vector<KitFile>& kit_files();

/// A number that changes with any of them: sixteen hexadecimal digits.
const std::string& kit_version();

/// Writes the kit into this folder, unless it is there. Throws AccessError.
void write_kit(const std::string& folder);

} // namespace rasterwalk
