#pragma once

// Starting the compiler, guarded: what it reads was written by a student.

#include <functional>
#include <string>
#include <vector>

#include "mine/compile/compile.h"
#include "mine/guard/guard.h"

namespace rasterwalk {

/// The compiler's limits: a program of the lab takes it a second or two, and 300 MB.
inline constexpr std::chrono::milliseconds longest_compilation = std::chrono::seconds(60);
inline constexpr std::size_t most_compiler_memory = std::size_t{2} << 30;

/// Where a compiler may read and write.
struct CompilerFolders {
    std::string work;                  ///< it starts and writes here; must exist
    std::vector<std::string> readable; ///< besides `work` and the system's
};

/// Runs a compiler with these arguments, with its messages in English. Throws AccessError.
GuardedRun run_compiler(const std::string& path, const std::vector<std::string>& arguments,
                        const CompilerFolders& folders, const std::function<bool()>& is_stopped);

/// Did it end without an error?
bool is_done(const GuardedRun& run);

/// Makes a folder for this user only, and those above it. Throws AccessError.
void make_folder(const std::string& path);

/// Deletes all but the newest files of a folder.
void keep_newest(const std::string& folder, std::size_t count);

/// Says that a file or folder of the cache was used now.
void mark_used(const std::string& path);

/// Deletes what is in a folder of the cache and was not used for 30 days.
void forget_unused(const std::string& folder);

/// A name next to `path` that no other process or thread uses: what is written there is whole when
/// it is renamed to `path`.
std::string unfinished_name(const std::string& path);

/// Renames what was written under an unfinished name. Throws AccessError.
void finish_file(const std::string& unfinished, const std::string& path);

} // namespace rasterwalk
