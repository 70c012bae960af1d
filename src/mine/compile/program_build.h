#pragma once

// One way of compiling a student's program: its copies to objects, and these to a program.

#include <functional>
#include <string>
#include <vector>

#include "mine/compile/compile.h"
#include "mine/compile/compile_copies.h"
#include "mine/compile/compile_messages.h"

namespace rasterwalk {

/// How it is compiled.
struct BuildWay {
    KitUse kit = KitUse::with_driver;
    bool is_older = false; ///< as C++14: std had fewer names that meet a student's
};

/// What came of it.
struct BuildOutcome {
    std::string program; ///< path; empty: it does not compile
    std::vector<SaidMessage> said;
    ProgramCopies copies;
    std::string ended;        ///< why the compiler was ended, in a sentence; empty: it was not
    bool is_stopped = false;  ///< because is_stopped said so
    bool has_landlock = true; ///< as far as the compiler ran
};

/// What all ways of a program have in common.
struct BuildPlace {
    std::string work; ///< folder in the cache, made
    Compiler compiler;
    Instrumented instrumented = Instrumented::no;
    std::function<bool()> is_stopped; ///< is asked by several threads at once
};

/// Compiles it this way. What has not changed since the last time is not compiled again. Throws
/// AccessError or InputError.
BuildOutcome build_program(const StudentFiles& files, const BuildPlace& place, BuildWay way);

} // namespace rasterwalk
