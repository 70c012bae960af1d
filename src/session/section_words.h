#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// A section as it is said of a term, a lesson or a stage: "lab: Drawing edges", and what leads
/// beyond the lab as it is, "Beyond the lab: textures".
std::string section_words(std::string_view section);

} // namespace rasterwalk
