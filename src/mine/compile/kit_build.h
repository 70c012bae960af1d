#pragma once

// The kit, ready for a compiler: written to the cache, its headers precompiled, its sources
// compiled. This is done once for each compiler and set of flags.

#include <functional>
#include <string>
#include <vector>

#include "mine/compile/compile.h"

namespace rasterwalk {

struct ReadyKit {
    std::string folder;                 ///< of the kit
    std::string ready;                  ///< of what was compiled
    std::vector<std::string> including; ///< arguments that include claims.h before a source
    std::vector<std::string> objects;   ///< of its sources, to be linked to each program
    bool is_stopped = false;            ///< then it is not ready
    bool has_landlock = true;           ///< as far as the compiler ran
};

/// Throws AccessError if this compiler cannot compile the kit.
ReadyKit make_kit_ready(const Compiler& compiler, const std::vector<std::string>& flags,
                        const std::function<bool()>& is_stopped);

/// The folder of the kit in the cache; it is written if it is not there. Throws AccessError.
std::string written_kit();

} // namespace rasterwalk
