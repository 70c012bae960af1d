#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// The section of a term, a lesson or a stage in words: "lab: Drawing edges"; one beyond the lab
/// unchanged, "Beyond the lab: textures".
std::string section_words(std::string_view section);

} // namespace rasterwalk
