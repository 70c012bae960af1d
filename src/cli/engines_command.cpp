#include "cli/engines_command.h"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/enum_words.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "cli/interrupt.h"
#include "cli/json.h"
#include "cli/machine.h"
#include "cli/whole_number.h"
#include "engines/measure.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// The value of a word, or every value if no word is given.
template <class Enum>
std::vector<Enum> chosen(std::string_view what, const std::string& word,
                         const std::vector<Enum>& all) {
    if (word.empty()) return all;
    const auto value = value_of_word<Enum>(word);
    if (value && std::find(all.begin(), all.end(), *value) != all.end()) return {*value};
    std::vector<std::string_view> names;
    for (const Enum one : all)
        names.push_back(word_of(one));
    throw UsageError(no_such_name(what, word, names));
}

MeasurePlan plan_of(const EnginesOptions& options) {
    MeasurePlan plan;
    std::vector<Workload> workloads;
    for (const WorkloadInfo& info : workload_list)
        workloads.push_back(info.workload);
    plan.workloads = chosen("workload", options.workload, workloads);
    plan.levels = chosen("SIMD level on this machine", options.simd, simd_levels());
    plan.sizes.assign(usual_sizes.begin(), usual_sizes.end());
    if (!options.size.empty()) {
        Settings settings;
        set_value(settings, *find_setting("viewport.size"), options.size);
        plan.sizes = {settings.viewport};
    }
    plan.threads = {1, most_threads};
    if (!options.threads.empty())
        plan.threads = {whole_number("--threads", options.threads, 1, most_threads)};
    if (!options.rounds.empty())
        plan.rounds = whole_number("--rounds", options.rounds, fewest_rounds, most_rounds);
    return plan;
}

/// The command that repeats the measurement.
std::string command_text(const EnginesOptions& options) {
    std::string text = "rasterwalk engines";
    const auto add = [&](std::string_view option, const std::string& value) {
        if (!value.empty()) text += fmt::format(" {} {}", option, value);
    };
    add("--simd", options.simd);
    add("--threads", options.threads);
    add("--size", options.size);
    add("--rounds", options.rounds);
    add("--workload", options.workload);
    if (options.json) text += " --json";
    return text;
}

std::string_view time_word(const Measurement& measurement) {
    return measurement.task.threads == 1 ? "processor" : "wall";
}

std::string size_word(const Measurement& measurement) {
    return fmt::format("{}x{}", measurement.task.size.width, measurement.task.size.height);
}

/// Does it draw something wrong? Some are expected to have different edges.
bool is_wrong(const EngineResult& result) {
    return result.from_peer && !do_agree(*result.from_peer) && !result.has_other_edges;
}

/// The text in place of a ratio, or after it.
std::string remark(const EngineResult& result) {
    if (!result.refusal.empty()) return "cannot draw this: " + result.refusal;
    if (!result.from_peer || result.ratio) return {};
    const std::string difference = difference_text(*result.from_peer);
    return (result.has_other_edges ? "draws different edges: " : "draws something different: ") +
           difference;
}

Json to_json(const std::optional<PictureDifference>& difference) {
    if (!difference) return nullptr;
    return {{"differ", difference->different},
            {"largest", difference->largest},
            {"pixels", difference->pixels}};
}

Json to_json(const EngineResult& result) {
    const bool has_drawn = result.refusal.empty();
    return {{"engine", result.engine},
            {"from_llvmpipe", to_json(result.from_peer)},
            {"from_steps", to_json(result.from_steps)},
            {"milliseconds", has_drawn ? Json(result.milliseconds) : Json()},
            {"ratio", result.ratio ? Json(*result.ratio) : Json()},
            {"remark", remark(result)}};
}

Json to_json(const Measurement& measurement) {
    Json engines = Json::array();
    for (const EngineResult& result : measurement.engines)
        engines.push_back(to_json(result));
    return {{"engines", std::move(engines)},
            {"llvmpipe", measurement.peer},
            {"rounds", measurement.rounds},
            {"size", size_word(measurement)},
            {"threads", measurement.task.threads},
            {"time", time_word(measurement)},
            {"workload", word_of(measurement.task.workload)}};
}

Json to_json(const std::vector<Measurement>& measurements, const EnginesOptions& options) {
    Json levels = Json::array(), list = Json::array();
    for (const SimdLevel level : simd_levels())
        levels.push_back(word_of(level));
    for (const Measurement& measurement : measurements)
        list.push_back(to_json(measurement));
    Json machine = machine_to_json();
    machine["simd"] = std::move(levels);
    return {{"command", command_text(options)},
            {"machine", std::move(machine)},
            {"measurements", std::move(list)}};
}

void print_text(const Measurement& measurement, std::ostream& out) {
    const Workload workload = measurement.task.workload;
    out << fmt::format("\n{}: {}; {}, {}, {} time, {}\n", word_of(workload),
                       workload_list[static_cast<std::size_t>(workload)].title,
                       size_word(measurement),
                       counted(measurement.task.threads, "thread", "threads"),
                       time_word(measurement), counted(measurement.rounds, "round", "rounds"));
    out << fmt::format("{:<14}{:>12}{:>12}\n", "engine", "ms/picture", "x llvmpipe");
    for (const EngineResult& result : measurement.engines) {
        const std::string time =
            result.refusal.empty() ? decimals(result.milliseconds, 3) : std::string();
        const std::string ratio = result.ratio ? decimals(*result.ratio, 2)
                                  : !result.from_peer && result.refusal.empty() ? "1.00"
                                                                                : "";
        std::string line =
            fmt::format("{:<14}{:>12}{:>12}  {}", result.engine, time, ratio, remark(result));
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

void print_text(const std::vector<Measurement>& measurements, std::ostream& out) {
    out << machine_text() << '\n';
    if (measurements.empty()) return;
    out << "against " << measurements.front().peer << '\n';
    for (const Measurement& measurement : measurements)
        print_text(measurement, out);
}

} // namespace

std::string engines_footer() {
    std::string text = "The workloads:";
    for (const WorkloadInfo& info : workload_list)
        text += fmt::format("\n  {}  {}", word_of(info.workload), info.title);
    text +=
        "\nThe engines:"
        "\n  student   the lab's loop as a student writes it; one thread"
        "\n  steps     the stages that this program walks through; one thread"
        "\n  fast ...  the fast engine, with each set of SIMD instructions of this machine"
        "\n  llvmpipe  the peer: Mesa's rasterizer, in the program rasterwalk-llvmpipe"
        "\nThe engines take turns. The output gives the median time per picture (processor time "
        "with one"
        "\nthread, wall time with two) and how many times as fast as llvmpipe that is. If more "
        "than 0.02 % of"
        "\nthe pixels differ from llvmpipe's picture by more than 1/255, the output says what "
        "differs instead."
        "\nThe environment variable RASTERWALK_LLVMPIPE names the peer's program if it is not "
        "where it is"
        "\ninstalled. The exit code is 4 if the peer is missing, breaks off or does not answer for"
        "\n30 seconds, 1 if a picture differs, and 130 after Ctrl+C, which prints what has been "
        "measured.";
    return text;
}

ExitCode engines_command(const EnginesOptions& options, std::ostream& out, ProgressLine& progress) {
    const MeasurePlan plan = plan_of(options);
    const Scene room = read_scene(lessons_folder() + '/' + std::string(usual_scene));
    const Interrupt interrupt;
    const auto is_stopped = [&] { return interrupt.was_interrupted(); };
    const ChildProcess::Patience patience{.is_stopped = is_stopped};
    const std::vector<Measurement> measurements = measure_engines(
        plan, room,
        [&](const PeerTask& task) { return start_llvmpipe(llvmpipe_program(), task, patience); },
        {is_stopped, [&](const std::string& words) { progress.say(words); }});
    progress.clear();
    if (options.json) {
        print_json(to_json(measurements, options), out);
    } else {
        print_text(measurements, out);
    }
    if (interrupt.was_interrupted()) return ExitCode::interrupted;
    const bool has_fault =
        std::any_of(measurements.begin(), measurements.end(), [](const Measurement& measurement) {
            return std::any_of(measurement.engines.begin(), measurement.engines.end(), is_wrong);
        });
    return has_fault ? ExitCode::difference : ExitCode::done;
}

} // namespace rasterwalk
