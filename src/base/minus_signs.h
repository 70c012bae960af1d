#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// The text of a number with minus signs for hyphens: "−2.5e−05".
std::string with_minus_signs(std::string_view text);

} // namespace rasterwalk
