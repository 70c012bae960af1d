#pragma once

#include <string_view>
#include <vector>

namespace rasterwalk {

/// A piece of a file of the kit: compilers need not take long string literals.
struct KitPart {
    const char* name; ///< of the file, relative to src/mine/kit
    std::string_view text;
};

/// The pieces of all files, those of a file one after the other. Written by embed_kit.cmake.
const std::vector<KitPart>& kit_parts();

} // namespace rasterwalk
