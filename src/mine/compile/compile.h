#pragma once

// Compiles a student's program unmodified, with the kit in place of the course's headers.
//
// Each source is compiled from a copy whose #line says where it came from, so that messages and
// debug information name the student's file. Three ways are tried, and the first that compiles is
// taken: with the kit and the driver that asks functions; with the kit alone; with the student's
// own helper where the kit's cannot replace it. A sanitized program is not asked, so the first way
// is left out.

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "mine/compile/student_files.h"

namespace rasterwalk {

enum class Instrumented {
    no,
    sanitized, ///< with address and undefined-behaviour sanitizers, optimized as for debugging
};

/// What the compiler says, in its own words.
struct CompileMessage {
    std::string file; ///< of the student; empty: of none
    int line = 0;     ///< from 1; 0: of none
    int column = 0;
    bool is_error = true; ///< or a warning
    std::string text;
    std::string cause; ///< a likely one in a sentence; empty: none is known
};

enum class KitUse {
    with_driver, ///< functions can be asked
    kit_only,    ///< only pictures
    own_helper,  ///< only pictures, through the student's own helper
};

/// A compiled program, or why there is none.
struct Compiled {
    std::string program;                  ///< path; empty: it does not compile
    std::vector<CompileMessage> messages; ///< of the first way tried that failed for a reason of
                                          ///< the student's; warnings if it compiles
    KitUse kit = KitUse::with_driver;
    std::string compiler; ///< "g++ 12.2.0"
    std::chrono::milliseconds time{0};
    bool is_guarded_by_landlock = false; ///< the compiler was, as far as it ran
};

/// A compiler that this machine has.
struct Compiler {
    std::string path;
    std::string version; ///< "g++ 12.2.0"
    bool is_clang = false;
};

/// The compiler of this name or path; without one, g++ and then clang++. Throws AccessError if
/// there is none.
Compiler find_compiler(const std::string& wanted = {});

/// Where copies, precompiled headers and programs are kept: RASTERWALK_CACHE, or rasterwalk in
/// XDG_CACHE_HOME or ~/.cache. Is made if it is not there; throws AccessError.
std::string cache_folder();

/// Compiles it in a folder of the cache. Throws AccessError if that cannot be done, InputError if a
/// source is no text. The compiler reads copies only, never the student's folder.
/// @param is_stopped asked while the compiler runs, by other threads too, but one at a time; if it
/// says so, `program` and messages are empty
Compiled compile_student_program(const StudentFiles& files, const Compiler& compiler,
                                 Instrumented instrumented,
                                 const std::function<bool()>& is_stopped = {});

} // namespace rasterwalk
