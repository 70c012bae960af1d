#pragma once

// The files that a guarded program may reach (Landlock), where the system has that.

#include "mine/guard/guard_system.h"

#ifdef RASTERWALK_HAS_GUARD

#include "mine/guard/guard.h"

namespace rasterwalk {

/// The version of Landlock in this system; 0: it has none.
int landlock_version();

/// A descriptor of the rules for this command, which the caller closes. Throws AccessError if one
/// of its files cannot be found.
/// @param version of Landlock, at least 1
int make_file_rules(const GuardedCommand& command, int version);

/// Puts the rules on this process, with /proc/self readable. Calls nothing that is forbidden after
/// a fork.
/// @return 0, or an errno
int follow_file_rules(int rules) noexcept;

} // namespace rasterwalk

#endif
