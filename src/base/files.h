#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/limits.h"

namespace rasterwalk {

/// How long the writer of a pipe may be silent.
inline constexpr std::chrono::milliseconds longest_silence = std::chrono::seconds(30);

/// The bytes of a whole file. A pipe is read until its writer ends it. Throws AccessError if it
/// cannot be opened or read, or if it gives nothing for longer than `silence`; InputError if it is
/// larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = largest_text_file,
                      std::chrono::milliseconds silence = longest_silence);

/// The same, with "-" for the standard input, with no limit on the wait. For commands only: a
/// window must not wait.
std::string read_input(const std::string& path, std::size_t limit = largest_text_file);

/// How messages name the standard input.
inline constexpr const char* standard_input_name = "standard input";

/// Throws AccessError for a pipe or a device, which may never end, so a window must not wait for
/// it.
void refuse_endless_file(const std::string& path);

/// Writes a file so that it is either the old one or the new one, never half of one: to a temporary
/// file next to it, which is then renamed. The new file keeps the mode of the old one. Links are
/// followed, even if the file is not there yet; a file with several names is written in place, and
/// so is a device or pipe. Temporary files of interrupted runs are removed. Throws AccessError.
void write_file(const std::string& path, std::string_view bytes);

/// Do two paths lead to the same file? Two paths of the same letters do, even if nothing is there.
bool is_same_file(const std::string& a, const std::string& b);

} // namespace rasterwalk
