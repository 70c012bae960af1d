#pragma once

// The two processes behind a guarded program. This program forks a supervisor, which forks the
// program. The supervisor adopts what the program leaves behind, and ends all of it when the
// program ends, on a command, or when this program dies.
//
// This program has threads, so after the fork nothing is called that may take a lock or memory:
// all of it is prepared before.

#include "mine/guard/guard_system.h"

#ifdef RASTERWALK_HAS_GUARD

#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>

#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

#include "mine/guard/guard_filter.h"

namespace rasterwalk {

struct ResourceLimit {
    int resource = 0; ///< RLIMIT_CPU and so on
    rlimit limit{};
};
using ResourceLimits = std::array<ResourceLimit, 8>;

/// What the supervisor is given.
struct GuardedStart {
    const char* path = nullptr;
    char* const* words = nullptr;
    char* const* environment = nullptr;
    const char* folder = nullptr;
    ResourceLimits limits{};
    SystemCallFilter* filter = nullptr;
    // Descriptors.
    int null = -1;     ///< its standard input
    int output = -1;   ///< its standard output and error
    int given = -1;    ///< GuardedCommand::descriptor
    int rules = -1;    ///< make_file_rules(); -1: none
    int commands = -1; ///< the supervisor reads GuardCommand; its end means `kill`
    int reports = -1;  ///< the supervisor writes GuardReport
    int faults = -1; ///< StartFault is written if it cannot be started; closed when it has started
};

/// A byte.
enum GuardCommand : char {
    guard_warn = 'w', ///< send SIGXCPU to the program
    guard_kill = 'k', ///< kill it, and all that it started
};

/// What went wrong before the program began.
enum class StartStep : int { fork, folder, limits, file_rules, filter, program };
struct StartFault {
    StartStep step{};
    int error = 0; ///< errno
};

/// Sent when the program has a process number, and when all of it has ended.
struct GuardReport {
    pid_t process = 0;
    int has_ended = 0;
    int status = 0;                  ///< as waitpid() gives it
    std::int64_t processor_time = 0; ///< microseconds
};

/// Reads one of these, which was written at once.
/// @return none if nothing was written, or never will be
template <class Message>
std::optional<Message> read_message(int descriptor) {
    Message message{};
    ssize_t count = 0;
    do {
        count = ::read(descriptor, &message, sizeof message);
    } while (count < 0 && errno == EINTR);
    if (count != static_cast<ssize_t>(sizeof message)) return {};
    return message;
}

/// What the supervisor does, as a fork of this program with every signal blocked.
[[noreturn]] void supervise(const GuardedStart& start) noexcept;

} // namespace rasterwalk

#endif
