#pragma once

// What a guarded program uses while it runs, as /proc has it.

#include "mine/guard/guard_system.h"

#ifdef RASTERWALK_HAS_GUARD

#include <cstddef>

#include <sys/types.h>

namespace rasterwalk {

struct ProcessUse {
    std::size_t memory = 0; ///< bytes, in memory or swapped out
    int threads = 0;
};

/// Of one process; nothing if it has ended.
ProcessUse use_of_process(pid_t process);

/// Of all processes of a group together.
/// @param enough threads: the count stops there, because more of them would take long to count
ProcessUse use_of_group(pid_t group, int enough);

/// Of all processes of this user that /proc says to be theirs.
ProcessUse use_of_this_user();

} // namespace rasterwalk

#endif
