#pragma once

// A compiled program of a student, run under the guard: it draws, and its functions are asked.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mine/compile/compile.h"
#include "mine/guard/guard.h"
#include "mine/program_places.h"
#include "mine/recording.h"

namespace rasterwalk {

/// How a run ended that did not end as it should.
struct ProgramFault {
    std::string sentence; ///< "It was stopped by a segmentation fault ..."
    ProgramPlace place;   ///< in the student's own files; line 0: not known
    rasterwalk_kit::Part part = rasterwalk_kit::part_picture; ///< what it was asked
    std::uint64_t question = 0;                               ///< of that part
    bool is_hang = false;                                     ///< it did not end in time
};

/// Something that the guard refused to a program.
struct RefusedCall {
    std::string what; ///< "to start a program", "to open a network connection"
    std::uint32_t count = 0;
    ProgramPlace place; ///< line 0: not known
};

/// A function of the program, and how often the first frame called it.
struct FunctionCalls {
    std::string function; ///< "PixelShader"
    std::uint64_t count = 0;
};

/// What a program did in one or more runs: a run that dies while a function is asked is repeated
/// for the functions after it.
struct ProgramRun {
    Recording recording;                      ///< of the first run
    std::vector<std::vector<double>> answers; ///< of each run
    std::vector<ProgramFault> faults;         ///< in order; empty: all went well
    std::vector<RefusedCall> refused;
    std::vector<FunctionCalls> calls; ///< of the student's own functions, in the first frame
    std::string output;               ///< of the first run, as it came
    bool is_output_cut = false;
    bool has_landlock = false;
    std::chrono::milliseconds time{0}; ///< of the first run

    /// Did it draw its first frame to the end?
    bool has_frame() const { return recording.progress.frames > 0; }
};

/// Did it draw a frame without a single pixel, by PutPixelSDL or by itself?
bool draws_nothing(const ProgramRun& run);

/// Is each pixel of the first frame known, and in which order they were put? Not if the program
/// writes some by itself, or more than are kept.
bool has_known_order(const ProgramRun& run);

/// What is asked of a program, and how long it may take.
struct ProgramOrder {
    ProgramTask task;
    QuestionStream questions;
    std::chrono::milliseconds time{10'000}; ///< for each run
    bool is_sanitized = false;
    std::function<bool()> is_stopped; ///< null: never
};

/// Runs it. Throws AccessError if it cannot be started or guarded.
/// @param files of the program: it runs in their folder, which it can read
ProgramRun run_program(const StudentFiles& files, const std::string& program,
                       const ProgramOrder& order);

/// What went wrong in a run, or none. `recording` says where it was.
/// @param is_sanitized what sanitizers print counts; otherwise it is the program's own output
std::optional<ProgramFault> fault_of(const StudentFiles& files, const std::string& program,
                                     const GuardedRun& run, const Recording& recording,
                                     bool is_sanitized);

} // namespace rasterwalk
