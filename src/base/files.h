#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
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

/// Makes the folder that a file will be written to, and those above it, if they are not there.
/// Throws AccessError, which says why the file cannot be written.
void make_folder_of(const std::string& path);

/// Do two paths lead to the same file? Two paths of the same letters do, even if nothing is there.
bool is_same_file(const std::string& a, const std::string& b);

/// When a file was last written, and its size in bytes: together they show whether it changed.
struct FileState {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;

    friend bool operator==(const FileState&, const FileState&) = default;
};

/// The current state of a file; FileState{} if there is none or its state cannot be read. Never
/// throws.
FileState file_state(const std::string& path);

/// Keeps other processes, and other locks of this one, away from a file while it is read and
/// rewritten. The lock is held on a file next to it, NAME.lock, which stays there.
class FileLock {
  public:
    /// Waits for at most about half a second. If the file system has no locks, or nothing can be
    /// written, there is no lock. Throws AccessError if another lock holds it for longer.
    explicit FileLock(const std::string& path);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

  private:
    int descriptor_;
};

} // namespace rasterwalk
