#include "mine_benchmark.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>

#include "base/error.h"
#include "base/files.h"
#include "engines/measure.h"
#include "laboratory/bug.h"
#include "mine/checked_program.h"
#include "support/project_root.h"
#include "support/temporary_folder.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// A program, and what a student edits in it.
struct EditedProgram {
    std::string_view name;
    std::string_view path; ///< a file or folder of the project
    std::string_view file; ///< that is edited; empty: the program is one file
    std::string_view before;
    std::string_view after; ///< in which {} is a number, different in each edit
};

constexpr std::array<EditedProgram, 5> programs{{
    {"skeleton", "src/mine/kit/new", "skeleton.cpp", "p = ivec2(0, 0);", "p = ivec2({}, 0);"},
    {"small", "tests/mine/styles/over_z_inside.cpp", "", "int main(", "int edit{};\nint main("},
    {"several", "tests/mine/styles/several_files", "rasteriser.cpp",
     "if (ToCameraSpace(corners[i]).z <= 0.2f)", "if (ToCameraSpace(corners[i]).z <= 0.2{}f)"},
    {"usual", "tests/mine/styles/classic.cpp", "", "if( p.z < 0.3f )", "if( p.z < 0.3{}f )"},
    {"wrong", "tests/mine/styles/classic.cpp", "", "p.y = int( focalLength * pos.y * p.zinv )",
     "p.y = {} + int( focalLength * pos.y * p.zinv )"},
}};

/// What the end of a step of check_program() means to a student.
struct StepTarget {
    std::string_view step; ///< as check_program() says it
    double seconds;        ///< after the save
};

constexpr std::array<StepTarget, 3> targets{{
    {"Running it", 1.0},
    {"Asking its functions", 2.0},
    {"Holding its keys down", 5.0},
}};

std::optional<double> target_of(std::string_view step) {
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [step](const StepTarget& one) { return one.step == step; });
    return found == targets.end() ? std::nullopt : std::optional(found->seconds);
}

/// Of this process, and of all that it has started and that has ended.
double processor_seconds_now() {
    double seconds = 0.0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage use{};
        ::getrusage(who, &use);
        for (const timeval& time : {use.ru_utime, use.ru_stime})
            seconds +=
                static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1'000'000.0;
    }
    return seconds;
}

double seconds_now() {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now().time_since_epoch();
    return time.count();
}

/// When a step ended.
struct StepTime {
    std::string step;
    double end = 0.0;       ///< seconds after the save
    double processor = 0.0; ///< seconds, of this step alone
};

/// Checks the program once, from what is saved to everything that is known.
std::vector<StepTime> time_check(const std::string& path, const LabScenes& lab,
                                 const std::vector<Bug>& bugs) {
    std::vector<StepTime> times;
    const double save = seconds_now();
    double processor = processor_seconds_now();
    const auto end_step = [&] {
        if (times.empty()) return;
        times.back().end = seconds_now() - save;
        times.back().processor = processor_seconds_now() - processor;
    };
    CheckProgramOptions options;
    options.say = [&](std::string_view what) {
        end_step();
        if (!times.empty()) processor = processor_seconds_now();
        times.push_back({std::string(what), 0.0, 0.0});
    };
    const CheckedProgram checked = check_program(find_student_files(path), lab, bugs, options);
    end_step();
    if (!checked.compiles()) throw InputError(path + " does not compile.");
    return times;
}

/// The medians of several checks of a program: of each step that all of them had.
std::vector<StepTime> median_of(const std::vector<std::vector<StepTime>>& checks) {
    std::vector<StepTime> medians;
    for (std::size_t step = 0; step < checks.front().size(); ++step) {
        std::vector<double> ends, processor;
        for (const std::vector<StepTime>& times : checks) {
            if (step >= times.size() || times[step].step != checks.front()[step].step)
                return medians;
            ends.push_back(times[step].end);
            processor.push_back(times[step].processor);
        }
        medians.push_back(
            {checks.front()[step].step, rasterwalk::median(ends), rasterwalk::median(processor)});
    }
    return medians;
}

void print_steps(const std::string& title, const std::vector<StepTime>& times) {
    std::printf("%-32s %10s %10s %10s %10s\n", title.c_str(), "after save", "target", "ratio",
                "processor");
    for (const StepTime& time : times) {
        std::printf("  %-30s %10.2f", time.step.c_str(), time.end);
        if (const std::optional<double> target = target_of(time.step)) {
            std::printf(" %10.0f %10.2f", *target, time.end / *target);
        } else {
            std::printf(" %10s %10s", "", "");
        }
        std::printf(" %10.2f\n", time.processor);
    }
    std::printf("\n");
    std::fflush(stdout);
}

/// @param is_first with an empty cache: its first check is printed too
void print_program(const EditedProgram& program, bool is_first, int rounds,
                   const std::string& folder, const LabScenes& lab, const std::vector<Bug>& bugs) {
    const std::string original = fmt::format("{}/{}", project_root(), program.path);
    // A folder of its own: the cache keeps what was compiled for each path.
    std::string path = fmt::format("{}{}", folder, program.name);
    fs::create_directory(path);
    if (program.file.empty()) path += "/skeleton.cpp";
    fs::copy(original, path, fs::copy_options::recursive);
    const std::string edited =
        program.file.empty() ? path : fmt::format("{}/{}", path, program.file);
    const std::string text = read_file(edited);
    const std::size_t at = text.find(program.before);
    if (at == std::string::npos)
        throw InputError(fmt::format("'{}' is not in {}.", program.before, edited));
    const std::vector<StepTime> first = time_check(path, lab, bugs);
    if (is_first) print_steps(fmt::format("{}, first use", program.name), first);
    std::vector<std::vector<StepTime>> checks;
    for (int edit = 1; edit <= rounds; ++edit) {
        std::string changed = text;
        changed.replace(at, program.before.size(), fmt::format(fmt::runtime(program.after), edit));
        write_file(edited, changed);
        checks.push_back(time_check(path, lab, bugs));
    }
    print_steps(fmt::format("{}, median of {} edits", program.name, rounds), median_of(checks));
}

} // namespace

void print_mine_times(const MineBenchmark& options) {
    const auto is_wanted = [&](std::string_view name) {
        return options.names.empty() ||
               std::find(options.names.begin(), options.names.end(), name) != options.names.end();
    };
    for (const std::string& name : options.names)
        if (std::none_of(programs.begin(), programs.end(),
                         [&](const EditedProgram& program) { return program.name == name; }))
            throw UsageError(fmt::format("There is no program '{}' to time.", name));
    const LabScenes lab = read_lab_scenes();
    const std::vector<Bug> bugs = read_bugs();
    const test::TemporaryFolder folder;
    ::setenv("RASTERWALK_CACHE", folder.file("cache").c_str(), 1);
    std::printf("%s, seconds\n\n", find_compiler().version.c_str());
    bool is_first = true;
    for (const EditedProgram& program : programs) {
        if (!is_wanted(program.name)) continue;
        print_program(program, is_first, options.rounds, folder.file(""), lab, bugs);
        is_first = false;
    }
}

} // namespace rasterwalk
