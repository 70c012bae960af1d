#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// Bytes as text of 64 different characters, as data: addresses have them. Source: RFC 4648,
/// section 4.
std::string base64(std::string_view bytes);

} // namespace rasterwalk
