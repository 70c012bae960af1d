#include "mine/program_run.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "mine/guard/guard_system.h"
#include "mine/sanitizer_report.h"

#ifdef RASTERWALK_HAS_GUARD
#include <sys/syscall.h>
#endif

namespace rasterwalk {

namespace {

std::string_view signal_words(int signal) {
    switch (signal) {
    case SIGSEGV:
        return "a segmentation fault: it used memory that it does not have";
    case SIGBUS:
        return "a bus error: it used memory that is not there";
    case SIGFPE:
        return "an arithmetic fault: usually an int divided by zero";
    case SIGILL:
        return "an illegal instruction: often a function that should return a value and does not";
    case SIGABRT:
        return "an abort: an exception that nothing catches, or a failed assert";
    case SIGSYS:
        return "the guard: it asked the system for something that it may not do";
    case SIGKILL:
        return "the system";
    case SIGXFSZ:
        return "the guard: it wrote a file that is too large";
    default:
        return "a signal";
    }
}

/// What is asked in this part, as in "while ComputePolygonRows was given our input".
std::string_view asked_words(std::uint32_t part) {
    switch (part) {
    case rasterwalk_kit::part_vertex_shader:
        return "VertexShader was given our input";
    case rasterwalk_kit::part_interpolate:
        return "Interpolate was given our input";
    case rasterwalk_kit::part_polygon_rows:
        return "ComputePolygonRows was given our input";
    case rasterwalk_kit::part_draw_rows:
    case rasterwalk_kit::part_depth_test:
        return "DrawPolygonRows was given our input";
    case rasterwalk_kit::part_pixel_shader:
        return "PixelShader was given our input";
    default:
        return "its variables were being read";
    }
}

/// What a program was doing, as the end of a sentence.
std::string doing(const rasterwalk_kit::Progress& progress) {
    switch (progress.moment) {
    case rasterwalk_kit::moment_none:
        return "before it began";
    case rasterwalk_kit::moment_started:
        return "before it opened its window";
    case rasterwalk_kit::moment_asked:
        return fmt::format("while {}", asked_words(progress.part));
    case rasterwalk_kit::moment_window:
        return "after it had opened its window";
    case rasterwalk_kit::moment_put:
        return fmt::format("after it had put {}",
                           counted(static_cast<std::int64_t>(progress.puts), "pixel", "pixels"));
    case rasterwalk_kit::moment_shown:
        return fmt::format("after it had shown {}", counted(progress.frames, "frame", "frames"));
    default:
        return "in main()";
    }
}

std::string_view refused_words(std::uint32_t call) {
    switch (call) {
#ifdef RASTERWALK_HAS_GUARD
#ifdef SYS_fork
    case SYS_fork:
    case SYS_vfork:
#endif
    case SYS_clone:
    case SYS_execve:
    case SYS_execveat:
        return "to start a program";
    case SYS_socket:
    case SYS_connect:
    case SYS_bind:
    case SYS_listen:
        return "to use the network";
    case SYS_kill:
    case SYS_tkill:
    case SYS_tgkill:
        return "to send a signal to another program";
    case SYS_setsid:
    case SYS_setpgid:
        return "to leave the guard";
    case SYS_ptrace:
        return "to look into another program";
#ifdef SYS_open
    case SYS_open:
    case SYS_creat:
#endif
    case SYS_openat:
    case SYS_truncate:
        return "to write a file";
#ifdef SYS_unlink
    case SYS_unlink:
    case SYS_rmdir:
#endif
    case SYS_unlinkat:
        return "to delete a file";
#ifdef SYS_rename
    case SYS_rename:
#endif
    case SYS_renameat:
    case SYS_renameat2:
        return "to rename a file";
#ifdef SYS_chmod
    case SYS_chmod:
#endif
    case SYS_fchmod:
    case SYS_fchmodat:
        return "to change the rights of a file";
#endif
    default:
        return "something of the system that a rasterizer does not need";
    }
}

/// The place in the student's files of each of these addresses.
std::vector<ProgramPlace> student_places(const StudentFiles& files, const std::string& program,
                                         std::span<const std::uint64_t> addresses) {
    std::vector<ProgramPlace> found(addresses.size());
    const auto places = places_of(program, addresses);
    for (std::size_t i = 0; i < std::min(places.size(), found.size()); ++i)
        if (const ProgramPlace* place = innermost_in({&places[i], 1}, files.folder))
            found[i] = *place;
    return found;
}

std::vector<RefusedCall> calls_refused(const StudentFiles& files, const std::string& program,
                                       const rasterwalk_kit::Progress& progress) {
    std::vector<std::uint64_t> addresses;
    std::vector<RefusedCall> refused;
    for (const rasterwalk_kit::Refused& one : progress.refused) {
        if (one.count == 0) break;
        refused.push_back({std::string(refused_words(one.call)), one.count, {}});
        addresses.push_back(one.place);
    }
    const std::vector<ProgramPlace> places = student_places(files, program, addresses);
    for (std::size_t i = 0; i < refused.size(); ++i)
        refused[i].place = places[i];
    return refused;
}

/// "DrawPolygonRows" of "(anonymous namespace)::DrawPolygonRows(std::vector<...> const&)".
std::string name_of(std::string_view function) {
    constexpr std::string_view unnamed = "(anonymous namespace)::";
    std::string name;
    for (std::size_t at = 0; at < function.size(); ++at) {
        if (function.substr(at).starts_with(unnamed)) {
            at += unnamed.size() - 1;
        } else if (function[at] == '(' || function[at] == '<') {
            break;
        } else {
            name += function[at];
        }
    }
    // The result type of a template is in front of its name.
    if (const std::size_t blank = name.rfind(' '); blank != std::string::npos)
        name.erase(0, blank + 1);
    return name;
}

std::vector<FunctionCalls> function_calls(const StudentFiles& files, const std::string& program,
                                          const rasterwalk_kit::Progress& progress) {
    std::vector<std::uint64_t> addresses;
    std::vector<std::uint64_t> counts;
    for (const rasterwalk_kit::Calls& one : progress.calls) {
        if (one.count == 0) continue;
        addresses.push_back(one.place);
        counts.push_back(one.count);
    }
    std::vector<FunctionCalls> calls;
    const std::vector<ProgramPlace> places = student_places(files, program, addresses);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].line == 0) continue;
        const std::string name = name_of(places[i].function);
        const auto same = std::find_if(calls.begin(), calls.end(), [&](const FunctionCalls& one) {
            return one.function == name;
        });
        if (same == calls.end()) {
            calls.push_back({name, counts[i]});
        } else {
            same->count += counts[i];
        }
    }
    return calls;
}

GuardedCommand command_for(const StudentFiles& files, const std::string& program,
                           const ProgramOrder& order, int descriptor) {
    GuardedCommand command;
    command.words = {program};
    command.environment = {"LC_ALL=C", "HOME=/nonexistent", "PATH=/usr/bin:/bin"};
    command.folder = files.folder;
    command.readable = {program, files.folder};
    command.descriptor = descriptor;
    command.limits.time = order.time;
    command.is_stopped = order.is_stopped;
    if (order.is_sanitized) {
        // Sanitizers reserve terabytes of addresses, so only what is really used is watched.
        command.limits.memory = 0;
        command.environment.emplace_back("ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:"
                                         "handle_segv=1:color=never");
        command.environment.emplace_back(
            "UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1:color=never");
    }
    return command;
}

/// One run. The memory then has what it did.
GuardedRun run_once(const StudentFiles& files, const std::string& program,
                    const ProgramOrder& order, const ProgramTask& task, RecordingMemory& memory) {
    memory.write(task, order.questions);
    return run_guarded(command_for(files, program, order, memory.descriptor()));
}

/// Bits of the parts after this one.
std::uint32_t parts_after(std::uint32_t parts, std::uint32_t part) {
    return part + 1 < rasterwalk_kit::part_count ? parts & (~std::uint32_t{0} << (part + 1)) : 0;
}

} // namespace

bool draws_nothing(const ProgramRun& run) {
    const rasterwalk_kit::Progress& progress = run.recording.progress;
    return run.has_frame() && progress.puts == 0 && progress.direct == 0;
}

bool has_known_order(const ProgramRun& run) {
    const rasterwalk_kit::Progress& progress = run.recording.progress;
    return progress.puts > 0 && progress.direct == 0 && progress.puts == run.recording.puts.size();
}

std::optional<ProgramFault> fault_of(const StudentFiles& files, const std::string& program,
                                     const GuardedRun& run, const Recording& recording,
                                     bool is_sanitized) {
    const rasterwalk_kit::Progress& progress = recording.progress;
    ProgramFault fault;
    if (progress.moment == rasterwalk_kit::moment_asked) {
        fault.part = static_cast<rasterwalk_kit::Part>(
            std::min<std::uint32_t>(progress.part, rasterwalk_kit::part_count - 1));
        fault.question = progress.question;
    }
    const auto sanitizer =
        is_sanitized ? parse_sanitizer_report(run.output, files.folder) : std::nullopt;
    if (sanitizer) {
        fault.sentence =
            fmt::format("{} (The sanitizer says: {}.)", sanitizer->sentence, sanitizer->kind);
        fault.place = sanitizer->place;
        return fault;
    }
    const std::vector<std::uint64_t> stack(progress.stack, progress.stack + progress.depth);
    const auto places = places_of(program, stack);
    if (const ProgramPlace* place = innermost_in(places, files.folder)) fault.place = *place;
    switch (run.end) {
    case GuardedEnd::out_of_time:
        fault.is_hang = true;
        fault.sentence = fmt::format("It was still running after {} s, {}.",
                                     significant(static_cast<double>(run.time.count()) / 1000.0, 2),
                                     doing(progress));
        return fault;
    case GuardedEnd::out_of_memory:
        fault.sentence =
            fmt::format("It wanted more memory than it may have, {}.", doing(progress));
        return fault;
    case GuardedEnd::signalled:
        fault.is_hang = run.signal == SIGXCPU;
        fault.sentence =
            fault.is_hang
                ? fmt::format("It was still working when its time was over, {}.", doing(progress))
                : fmt::format("It was ended by {}, {}.", signal_words(run.signal), doing(progress));
        return fault;
    case GuardedEnd::too_much_output:
        fault.sentence = fmt::format("It printed more than it may, {}.", doing(progress));
        return fault;
    case GuardedEnd::too_many_threads:
        fault.sentence = fmt::format("It started more threads than it may, {}.", doing(progress));
        return fault;
    case GuardedEnd::stopped:
        return std::nullopt;
    case GuardedEnd::exited:
        break;
    }
    if (progress.moment == rasterwalk_kit::moment_ended) return std::nullopt;
    fault.sentence =
        fmt::format("It ended by itself with exit code {}, {}.", run.exit_code, doing(progress));
    return fault;
}

ProgramRun run_program(const StudentFiles& files, const std::string& program,
                       const ProgramOrder& order) {
    RecordingMemory memory;
    ProgramRun result;
    ProgramTask task = order.task;
    for (bool is_first = true;; is_first = false) {
        const GuardedRun run = run_once(files, program, order, task, memory);
        Recording recording = memory.read();
        const std::optional<ProgramFault> fault =
            fault_of(files, program, run, recording, order.is_sanitized);
        result.answers.push_back(std::move(recording.answers));
        if (fault) result.faults.push_back(*fault);
        if (is_first) {
            result.refused = calls_refused(files, program, recording.progress);
            result.calls = function_calls(files, program, recording.progress);
            result.output = run.output;
            result.is_output_cut = run.is_output_cut;
            result.has_landlock = run.has_landlock;
            result.time = run.time;
        }
        const rasterwalk_kit::Progress progress = recording.progress;
        if (is_first) result.recording = std::move(recording);
        if (!fault || run.end == GuardedEnd::stopped) break;
        if (progress.moment == rasterwalk_kit::moment_asked) {
            task.parts = parts_after(task.parts, progress.part);
        } else if (progress.frames == 0 && !task.before_main) {
            task.before_main = true; // its first frame never ends, but its functions may
        } else {
            break;
        }
        if (task.parts == 0) break;
    }
    return result;
}

} // namespace rasterwalk
