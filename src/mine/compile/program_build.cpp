#include "mine/compile/program_build.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "mine/compile/compiler_run.h"
#include "mine/compile/fingerprint.h"
#include "mine/compile/kit_build.h"
#include "mine/compile/kit_files.h"
#include "mine/compile/two_at_a_time.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t objects_kept = 32;
constexpr std::size_t programs_kept = 8;

using Words = std::vector<std::string>;

void append(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}

/// What a precompiled header must have been compiled with as well.
Words code_flags(const BuildPlace& place, BuildWay way) {
    Words flags{way.is_older ? "-std=gnu++14" : "-std=gnu++20", "-g1", "-fPIE"};
    if (place.instrumented == Instrumented::sanitized) {
        // The first fault ends the program, so that the report is of what caused the others. Keys
        // are held for many frames, which take three times as long with -O0; compiling takes a
        // tenth more.
        append(flags, {"-Og", "-fsanitize=address,undefined,float-cast-overflow",
                       "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"});
    } else {
        append(flags, {"-O1"});
    }
    return flags;
}

/// Counts the calls of the student's functions.
Words counting_flags(const BuildPlace& place, const std::string& kit_folder) {
    if (place.compiler.is_clang || place.instrumented != Instrumented::no) return {};
    return {"-finstrument-functions",
            "-finstrument-functions-exclude-file-list=/usr/,driver," + kit_folder};
}

Words message_flags(const Compiler& compiler) {
    // Warnings about what beginners do without knowing it.
    Words flags{"-Wparentheses", "-Wreturn-type", "-Wvexing-parse"};
    if (compiler.is_clang) {
        append(flags, {"-fno-caret-diagnostics", "-fno-color-diagnostics", "-ferror-limit=40"});
    } else {
        append(flags, {"-fno-diagnostics-show-caret", "-fdiagnostics-color=never",
                       "-fmessage-length=0", "-fmax-errors=40"});
    }
    return flags;
}

/// Why the guard ended the compiler; empty: it ended by itself, or is_stopped said so.
std::string reason_of_end(const GuardedRun& run) {
    if (run.end == GuardedEnd::exited || run.end == GuardedEnd::stopped) return {};
    if (run.end == GuardedEnd::signalled) {
        return fmt::format("The compiler crashed (signal {}).", run.signal);
    }
    if (run.end == GuardedEnd::out_of_time) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(longest_compilation);
        return fmt::format("The compiler was stopped, because it was still working after {}.",
                           counted(seconds.count(), "second", "seconds"));
    }
    if (run.end == GuardedEnd::out_of_memory) {
        return fmt::format("The compiler was stopped, because it needed more than {} GB of memory.",
                           most_compiler_memory >> 30);
    }
    return "The compiler was stopped, because it wrote too much or started too many programs.";
}

class Build {
  public:
    Build(const StudentFiles& files, const BuildPlace& place, BuildWay way)
        : files_(files), place_(place), way_(way) {}

    BuildOutcome run();

  private:
    /// What came of one run of the compiler.
    struct Step {
        std::string object; ///< path; empty: it failed
        std::vector<SaidMessage> said;
        std::string ended;
        bool is_stopped = false;
        bool has_landlock = true;
    };

    Words kit_words();
    Step compile(const ProgramCopies::Source& source, const Words& flags,
                 const std::string& key) const;
    Step step_of(const Words& arguments, const std::string& object) const;
    bool compile_all(Words& objects, const Words& flags);
    void take(Step&& step);
    void link(const Words& objects);

    const StudentFiles& files_;
    const BuildPlace& place_;
    BuildWay way_;
    ReadyKit kit_;
    BuildOutcome outcome_;
};

/// Makes the kit ready; the arguments that include it.
Words Build::kit_words() {
    kit_ = make_kit_ready(place_.compiler, code_flags(place_, {}), place_.is_stopped);
    outcome_.has_landlock = kit_.has_landlock;
    outcome_.is_stopped = kit_.is_stopped;
    Words words = kit_.including;
    if (way_.is_older || way_.kit == KitUse::own_helper) {
        // Rare: it is not worth another precompiled header.
        words = {"-include", kit_.folder + "/claims.h"};
        if (way_.kit == KitUse::own_helper) words.emplace_back("-DRASTERWALK_OWN_HELPER");
    }
    words.push_back("-I" + kit_.folder);
    return words;
}

/// Runs the compiler for one file, which appears only if it is whole.
Build::Step Build::step_of(const Words& arguments, const std::string& object) const {
    Step step;
    const std::string unfinished = unfinished_name(object);
    Words words = arguments;
    append(words, {"-o", unfinished});
    // Only what was copied is compiled, so the student's own folder need not be readable.
    const GuardedRun run = run_compiler(
        place_.compiler.path, words, {place_.work, {kit_.folder, kit_.ready}}, place_.is_stopped);
    step.has_landlock = run.has_landlock;
    step.is_stopped = run.end == GuardedEnd::stopped;
    step.ended = reason_of_end(run);
    step.said = read_compile_messages(run.output);
    std::error_code fault;
    if (is_done(run)) {
        finish_file(unfinished, object);
        write_file(object + ".txt", run.output);
        step.object = object;
        return step;
    }
    fs::remove(unfinished, fault);
    if (step.said.empty() && step.ended.empty() && !step.is_stopped) {
        SaidMessage message;
        message.message.text = visible_line(run.output.substr(0, 300));
        step.said.push_back(message);
    }
    return step;
}

Build::Step Build::compile(const ProgramCopies::Source& source, const Words& flags,
                           const std::string& key) const {
    const std::string object = fmt::format("{}/objects/{}.o", place_.work, key);
    std::error_code fault;
    if (fs::is_regular_file(object, fault) && fs::is_regular_file(object + ".txt", fault)) {
        Step step;
        step.object = object;
        step.said = read_compile_messages(read_file(object + ".txt"));
        for (const std::string& used : {object, object + ".txt"})
            mark_used(used);
        return step;
    }
    Words arguments = flags;
    append(arguments, {"-c", source.copy});
    return step_of(arguments, object);
}

void Build::take(Step&& step) {
    outcome_.is_stopped = outcome_.is_stopped || step.is_stopped;
    outcome_.has_landlock = outcome_.has_landlock && step.has_landlock;
    if (outcome_.ended.empty()) outcome_.ended = step.ended;
    for (SaidMessage& said : step.said)
        outcome_.said.push_back(std::move(said));
}

/// Compiles the sources; are all objects there?
bool Build::compile_all(Words& objects, const Words& flags) {
    const std::vector<ProgramCopies::Source>& sources = outcome_.copies.sources;
    std::vector<Step> steps(sources.size());
    objects.resize(sources.size());
    do_two_at_a_time(sources.size(), [&](std::size_t i) {
        Fingerprint key;
        key.add(sources[i].fingerprint).add(kit_.ready);
        for (const std::string& flag : flags)
            key.add(flag);
        steps[i] = compile(sources[i], flags, key.text());
    });
    bool is_complete = true;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        objects[i] = steps[i].object;
        is_complete = is_complete && !objects[i].empty();
        take(std::move(steps[i]));
    }
    return is_complete;
}

void Build::link(const Words& objects) {
    Fingerprint key;
    for (const std::string& object : objects)
        key.add(object);
    const std::string program = fmt::format("{}/programs/{}", place_.work, key.text());
    std::error_code fault;
    if (fs::is_regular_file(program, fault)) {
        mark_used(program);
        outcome_.program = program;
        return;
    }
    Words arguments = code_flags(place_, way_);
    append(arguments, message_flags(place_.compiler));
    append(arguments, objects);
    append(arguments, kit_.objects);
    append(arguments, {"-pie", "-pthread"});
    Step step = step_of(arguments, program);
    outcome_.program = step.object;
    take(std::move(step));
}

BuildOutcome Build::run() {
    const std::string kit_folder = written_kit();
    const bool is_asked = way_.kit == KitUse::with_driver;
    const char* folder = way_.kit == KitUse::own_helper ? "/own-copies" : "/copies";
    outcome_.copies = copy_program(files_, place_.work + folder, way_.kit,
                                   is_asked ? kit_folder + "/driver.h" : std::string());
    Words flags = code_flags(place_, way_);
    append(flags, kit_words());
    if (outcome_.is_stopped) return outcome_;
    append(flags, counting_flags(place_, kit_folder));
    append(flags, message_flags(place_.compiler));
    for (const char* made : {"/objects", "/programs"})
        make_folder(place_.work + made);
    Words objects;
    if (compile_all(objects, flags)) link(objects);
    // Each object has its messages next to it.
    keep_newest(place_.work + "/objects", 2 * objects_kept);
    keep_newest(place_.work + "/programs", 2 * programs_kept);
    return outcome_;
}

} // namespace

BuildOutcome build_program(const StudentFiles& files, const BuildPlace& place, BuildWay way) {
    return Build(files, place, way).run();
}

} // namespace rasterwalk
