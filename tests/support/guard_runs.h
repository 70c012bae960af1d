#pragma once

// Runs the hostile program, and compilers, under guard for the tests of the guard.

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "mine/guard/guard.h"
#include "tests/mine/as_ordinary_user.h"

namespace rasterwalk::test {

/// Which guard, and for whom.
struct GuardWay {
    User user = User::ordinary;
    bool use_landlock = true;
};

/// A guarded run, and what it left behind.
struct GuardSeen {
    GuardedRun run;
    int children = 0;    ///< processes that were started and not waited for
    int descriptors = 0; ///< more are open than before
};

/// Runs a command under guard in a process of its own, as this user. A program that cannot be
/// started is a std::runtime_error.
/// @param stop_after is_stopped says so from then on; 0: never
GuardSeen seen_run(const GuardWay& way, GuardedCommand command,
                   std::chrono::milliseconds stop_after = {});

/// The folder of the hostile program, which is compiled when first asked for.
const std::string& hostile_folder();

/// The command that has the hostile program do something, in its own folder.
GuardedCommand hostile_command(const std::vector<std::string>& deed);

/// The same with a fifth of a second, for what does not end by itself.
GuardedCommand endless_command(const std::vector<std::string>& deed);

/// The hostile program without a guard, as an ordinary user: what it wrote.
std::string unguarded_output(const std::vector<std::string>& deed);

/// The number of processes that were started with this text in a word. Zombies have none.
std::size_t count_processes(const std::string& text);

/// Waits until count_processes() is at least, or at most, this; or half a minute.
bool wait_for_processes(const std::string& text, std::size_t least, std::size_t most);

/// Paths of g++ and clang++, as far as this system has them.
std::vector<std::string> compilers();

} // namespace rasterwalk::test
