#pragma once

// Runs a program that is not trusted: a student's, and the compiler that reads what a student
// wrote.
//
// The program gets a process group of its own, limits of time, memory, file sizes, open files and
// output, no network, no other process to signal, and only the files that it was given. It dies
// with this program. What the system lacks is made up for as far as possible, and reported.

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rasterwalk {

struct GuardLimits {
    std::chrono::milliseconds time{10'000};        ///< by the clock
    std::size_t memory = std::size_t{2} << 30;     ///< bytes of address space; 0: not limited
    std::size_t resident = std::size_t{2} << 30;   ///< bytes in memory of it and all that it
                                                   ///< started, watched; 0: not limited
    std::size_t file_size = std::size_t{64} << 20; ///< bytes of the largest file that it writes
    std::size_t output = std::size_t{1} << 18;     ///< bytes of its output that are kept
    int open_files = 64;
    int threads = 256;               ///< of it and all that it started together, watched
    bool may_start_programs = false; ///< a compiler does
    bool use_landlock = true;        ///< false: as on a system without it
};

/// Bytes of output after which a program is killed.
inline constexpr std::size_t most_output = std::size_t{64} << 20;
/// A program whose time is up is sent SIGXCPU, so that it can say where it is. If it has not ended
/// after this time, it is killed.
inline constexpr std::chrono::milliseconds last_words{300};

/// A program to run.
struct GuardedCommand {
    std::vector<std::string> words;       ///< its absolute path, and its arguments
    std::vector<std::string> environment; ///< NAME=VALUE, all of them
    std::string folder;                   ///< where it starts; readable only if it is listed below
    std::vector<std::string> readable;    ///< files and folders besides those of the system
    std::vector<std::string> writable;    ///< folders, which are readable too
    int descriptor = -1;                  ///< is given to it as recording_descriptor; -1: none.
                                          ///< The size of a memory file is sealed first, so that
                                          ///< the program cannot take the memory away
    GuardLimits limits;
    std::function<bool()> is_stopped; ///< asked at least ten times a second; null: never
};

enum class GuardedEnd {
    exited,           ///< by itself: exit_code
    signalled,        ///< by a signal: signal. SIGSYS: it asked for what is refused to it
    out_of_time,      ///< killed, by the clock or by the time of the processor
    out_of_memory,    ///< killed, or its limit ended it
    too_much_output,  ///< killed, after most_output
    too_many_threads, ///< killed
    stopped,          ///< killed, because is_stopped said so
};

/// How it went.
struct GuardedRun {
    GuardedEnd end = GuardedEnd::exited;
    int exit_code = 0;          ///< if it left by itself, whatever `end` says
    int signal = 0;             ///< that ended it; 0: none
    std::string output;         ///< standard output and error, as they came
    bool is_output_cut = false; ///< it wrote more than is kept
    std::chrono::milliseconds time{0};
    bool has_landlock = false; ///< the system kept it to its files. Otherwise it could read
                               ///< whatever this user can; a filter refused to open for writing
                               ///< and to change names, except to a compiler, which must do both
};

/// Runs it until it ends. Nothing that it started lives on, even if this program is killed. Files
/// that it makes belong to this user alone. May be called by several threads. Throws AccessError if
/// it cannot be started, or if this system cannot guard it (not Linux, no seccomp), and whatever
/// is_stopped throws.
GuardedRun run_guarded(const GuardedCommand& command);

} // namespace rasterwalk
