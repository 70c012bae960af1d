#pragma once

// Keys held down: a student's program is run for some frames with each of the keys that its source
// names, under sanitizers, because many mistakes only show once the camera has moved.

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mine/compile/compile.h"
#include "mine/compile/student_files.h"
#include "mine/program_run.h"

namespace rasterwalk {

/// A key that a program asks for.
struct ProgramKey {
    std::string name; ///< as in SDL, without its prefix: "UP", "w"
    int code = 0;     ///< as SDL 2 numbers it

    friend bool operator==(const ProgramKey&, const ProgramKey&) = default;
};

/// The keys that a source names, as SDLK_... or SDL_SCANCODE_..., each once, in order. Comments and
/// strings do not count.
std::vector<ProgramKey> keys_in(std::string_view source);

/// A fault while a key was held, or in the first frame, when none is.
struct KeyFault {
    ProgramKey key; ///< without a name: no key was held
    int frame = 0;  ///< in which it happened, from 0
    ProgramFault fault;
};

/// How the runs are done.
struct KeyRuns {
    int frames = 8;                        ///< of each run
    std::chrono::milliseconds time{8'000}; ///< for each run
    int most_keys = 16;
    std::function<bool()> is_stopped; ///< asked by other threads too, but one at a time; null:
                                      ///< never
};

/// Runs the sanitized program without a key, and with each, two runs at a time; each place of a
/// fault is reported once, with the first key that has it. Throws AccessError as run_program()
/// does.
std::vector<KeyFault> hold_keys(const StudentFiles& files, const std::string& sanitized_program,
                                const KeyRuns& runs);

} // namespace rasterwalk
