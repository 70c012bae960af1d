#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// The text as HTML shows it, in a paragraph or in an attribute.
std::string in_html(std::string_view text);

} // namespace rasterwalk
