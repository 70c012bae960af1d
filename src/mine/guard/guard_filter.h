#pragma once

// The filter of system calls (seccomp) that a guarded program runs under. It cannot be taken off,
// and whatever the program starts inherits it.

#include "mine/guard/guard_system.h"

#ifdef RASTERWALK_HAS_GUARD

#include <cstddef>
#include <vector>

#include <linux/filter.h>

namespace rasterwalk {

struct FilterChoices {
    bool may_start_programs = false; ///< refused calls then fail with EPERM; otherwise they raise
                                     ///< SIGSYS, which a handler may turn into a failure
    int landlock_version = 0;        ///< what it does not cover is refused; 0: there is none
    const char* path = nullptr;      ///< the only address whose text can be executed, unless
                                     ///< programs may be started
};

struct SystemCallFilter {
    std::vector<sock_filter> code;
    std::vector<std::size_t> own_process; ///< in `code`: comparisons with the process's own number
};

SystemCallFilter make_filter(const FilterChoices& choices);

/// Puts the filter on this process. Calls nothing that is forbidden after a fork.
/// @return 0, or an errno
int install_filter(SystemCallFilter& filter) noexcept;

} // namespace rasterwalk

#endif
