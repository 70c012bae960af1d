#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/limits.h"

namespace rasterwalk {

/// The bytes of a whole file. Throws AccessError if it cannot be opened or read, InputError if it
/// is larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = largest_text_file);

/// Writes a file so that it is either the old one or the new one, never half of one: to a temporary
/// file beside it, then renamed. A link is followed; a device or pipe is written directly.
/// Throws AccessError.
void write_file(const std::string& path, std::string_view bytes);

/// Do two paths lead to the same file? Two paths of the same letters do, even if nothing is there.
bool is_same_file(const std::string& a, const std::string& b);

} // namespace rasterwalk
