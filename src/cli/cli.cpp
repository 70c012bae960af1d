#include "cli/cli.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <ostream>
#include <utility>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/image_format.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "cli/commands.h"
#include "cli/compare_command.h"
#include "cli/diagnose_command.h"
#include "cli/engines_command.h"
#include "cli/ladder_command.h"
#include "cli/mine_command.h"
#include "cli/package_option.h"
#include "cli/progress_line.h"
#include "cli/visible_output.h"
#include "mine/compile/project_folder.h"
#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "opening/view_options.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

/// The command line with a place for everything that can be on it.
struct CommandLine {
    CLI::App app{"Walk through a software rasterizer, stage by stage.", "rasterwalk"};
    ViewOptions view;
    RenderOptions render;
    StatsOptions stats;
    RowsOptions rows;
    TriangleOptions triangle;
    PixelOptions pixel;
    CodeOptions code_walk;
    CompareOptions compare;
    DiagnoseOptions diagnose;
    MineOptions mine;
    SettingsOptions settings;
    PresetsOptions presets;
    BugsOptions bugs;
    CheckOptions check;
    FactsOptions facts;
    EnginesOptions engines;
    LadderOptions ladder;
    LessonsOptions lessons;
    std::string code; ///< to be checked in the window; empty: none
    /// What to do once everything is understood; empty: open the window.
    std::function<void()> command;
    ExitCode exit_code = ExitCode::done; ///< of a successful command
};

CLI::App& add_command(CommandLine& line, const char* name, const char* about,
                      std::function<void()> command) {
    CLI::App& added = *line.app.add_subcommand(name, about);
    added.callback([&line, command = std::move(command)] { line.command = command; });
    return added;
}

void add_json(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Print JSON");
}

void describe(CommandLine& line, const Clock& clock, std::ostream& out, std::ostream& err,
              ProgressLine& progress) {
    line.app.set_version_flag("--version", "rasterwalk " + version_text());
    line.app.require_subcommand(0, 1);
    line.app
        .add_option("FILE", line.view.file,
                    "Scene (.toml), model (.obj), lesson (.md), saved view (.walk.toml), your own "
                    "program (.cpp), or link of the page to open in the window")
        ->type_name("");
    line.app
        .add_option("--code", line.code,
                    "Your own program (.cpp, or its folder): check it in the window, again each "
                    "time it is saved")
        ->type_name("FILE");
    add_view_options(line.app, line.view);
    add_look_options(line.app, line.view);
    add_package_option(line.app);

    CLI::App& render = add_command(line, "render", "Write the picture as a PNG",
                                   [&] { render_command(line.render, err); });
    render.add_option("-o,--output", line.render.output, "PNG file to write")
        ->type_name("FILE")
        ->required();
    add_view_options(render, line.render.view);
    add_plane_options(render, line.render.view);

    CLI::App& stats = add_command(line, "stats", "Count triangles, fragments, overdraw ...",
                                  [&] { stats_command(line.stats, clock, out, err); });
    stats.add_option("FILE", line.stats.view.file, "Scene, model, lesson or saved view")
        ->type_name("");
    add_json(stats, line.stats.json);
    stats.add_flag("--time", line.stats.time,
                   "Also measure what culling, the order of drawing, a depth pre-pass ... save on "
                   "this machine");
    stats.add_flag("--hidden", line.stats.hidden,
                   "Compare the ways to remove hidden surfaces, whichever is set");
    stats.footer(stats_footer());
    add_view_options(stats, line.stats.view);

    CLI::App& rows = add_command(line, "rows", "Print the row table of a polygon",
                                 [&] { rows_command(line.rows, out, err); });
    rows.add_option("POINTS", line.rows.points, "Vertices in pixels, in order")
        ->type_name("X,Y")
        ->required();
    add_json(rows, line.rows.json);
    rows.add_option("--preset", line.rows.presets, "Named set of settings; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false);
    rows.add_option("--set", line.rows.assignments,
                    "rounding, line, line_walk, edge_samples, row_start or row_search: name=value; "
                    "repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);

    CLI::App& triangle = add_command(line, "triangle",
                                     "Print a triangle's vertices, edges and "
                                     "rows",
                                     [&] { triangle_command(line.triangle, out); });
    triangle.add_option("N", line.triangle.triangle, "Number of the triangle, from 0")
        ->type_name("")
        ->required();
    triangle.add_flag("--formulas", line.triangle.formulas,
                      "Add each number of its vertices with its formula");
    add_json(triangle, line.triangle.json);
    add_view_options(triangle, line.triangle.view);

    CLI::App& pixel = add_command(line, "pixel", "List everything that fell on a pixel, and why",
                                  [&] { pixel_command(line.pixel, out); });
    pixel.add_option("PIXEL", line.pixel.pixel, "Column and row of the picture")
        ->type_name("X,Y")
        ->required();
    pixel.add_flag("--formulas", line.pixel.formulas,
                   "Add each number of the fragment that stays with its formula");
    add_json(pixel, line.pixel.json);
    add_view_options(pixel, line.pixel.view);

    CLI::App& code = add_command(line, "code", "Show the line of the lab's code at a moment",
                                 [&] { code_command(line.code_walk, out); });
    code.add_option("--lines", line.code_walk.lines, "So many lines after the moment began")
        ->check(CLI::Range(0, 1'000'000))
        ->type_name("N");
    add_json(code, line.code_walk.json);
    add_view_options(code, line.code_walk.view);

    CLI::App& compare =
        add_command(line, "compare", "Show how two runs differ, and where they first diverge",
                    [&] { line.exit_code = compare_command(line.compare, out); });
    compare.add_option("--a", line.compare.a, "One setting of run A: name=value; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    compare.add_option("--b", line.compare.b, "One setting of run B: name=value; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    compare
        .add_option("-o,--output", line.compare.output, "PNG file for the difference, B minus A")
        ->type_name("FILE");
    add_json(compare, line.compare.json);
    add_view_options(compare, line.compare.view);

    CLI::App& diagnose =
        add_command(line, "diagnose", "Suggest what is wrong with a picture or a printed row table",
                    [&] { line.exit_code = diagnose_command(line.diagnose, out, err, progress); });
    diagnose
        .add_option(
            "FILE", line.diagnose.file,
            fmt::format("{}, or lines like 'Start: (10,5). End: (10,5).'; - reads standard input",
                        exact_image_formats))
        ->type_name("")
        ->required();
    diagnose
        .add_option("--polygon", line.diagnose.polygon,
                    "A vertex of the polygon whose rows were printed; repeatable; if not given, "
                    "the nearest triangle")
        ->type_name("X,Y")
        ->allow_extra_args(false);
    diagnose
        .add_option("--seconds", line.diagnose.seconds,
                    "Search at most this long for what may be wrong with a picture, then examine "
                    "what was found")
        ->type_name("SECONDS")
        ->capture_default_str();
    add_json(diagnose, line.diagnose.json);
    add_view_options(diagnose, line.diagnose.view);

    CLI::App& mine =
        add_command(line, "mine", "Check your own program of the lab, function by function",
                    [&] { line.exit_code = mine_command(line.mine, out, err, progress); });
    mine.add_option("PATH", line.mine.paths,
                    "A .cpp file, the folder of a program, or a folder of hand-ins; with --merge, "
                    "tables that --json has printed")
        ->type_name("");
    mine.add_option("--new", line.mine.new_folder, "Write a program to begin with")
        ->type_name("FOLDER");
    mine.add_option("--compiler", line.mine.compiler,
                    "The C++ compiler; if not given, g++ or clang++")
        ->type_name("NAME");
    mine.add_flag("--no-keys", line.mine.skip_keys,
                  "Skip the run with sanitizers, in which its keys are held down");
    mine.add_option("--seconds", line.mine.seconds,
                    "Search at most this long for what may be wrong with a picture")
        ->type_name("SECONDS")
        ->capture_default_str();
    mine.add_option("--html", line.mine.html, "Also write the table as a page")->type_name("FILE");
    mine.add_flag("--merge", line.mine.merge, "Put tables of several runs together");
    add_json(mine, line.mine.json);

    CLI::App& settings = add_command(line, "settings", "List all settings with their values",
                                     [&] { settings_command(line.settings, out); });
    add_json(settings, line.settings.json);
    add_view_options(settings, line.settings.view);

    CLI::App& presets = add_command(line, "presets", "List the named sets of settings",
                                    [&] { presets_command(line.presets, out); });
    add_json(presets, line.presets.json);

    CLI::App& bugs = add_command(line, "bugs", "List the mistakes in the bug laboratory",
                                 [&] { bugs_command(line.bugs, out); });
    add_json(bugs, line.bugs.json);

    CLI::App& lessons = add_command(line, "lessons", "List the lessons and your progress",
                                    [&] { lessons_command(line.lessons, out, err); });
    add_json(lessons, line.lessons.json);

    CLI::App& check =
        add_command(line, "check", "Check lessons, scenes and presets for faults",
                    [&] { line.exit_code = check_command(line.check, out, err, progress); });
    check
        .add_option("PATH", line.check.paths,
                    "Folders, lessons (.md), scenes (.toml) and models (.obj)")
        ->type_name("")
        ->required();
    CLI::Option* const luck = check.add_flag(
        "--luck", line.check.luck,
        "Also try each task of the lessons at random and print how often it is solved "
        "by luck");
    CLI::Option* const advice = check.add_flag(
        "--advice", line.check.advice,
        "Also give advice on the length of lessons and on words that are not explained");
    check
        .add_flag("--style", line.check.style,
                  "Only look for phrases that read as if translated, in text, strings and "
                  "comments")
        ->excludes(luck)
        ->excludes(advice);

    CLI::App& facts = add_command(line, "facts", "List the names that lessons can use",
                                  [&] { facts_command(line.facts, out); });
    add_json(facts, line.facts.json);

    CLI::App& engines =
        add_command(line, "engines", "Time this program's engines against llvmpipe",
                    [&] { line.exit_code = engines_command(line.engines, out, progress); });
    const auto add_text = [&](const char* name, std::string& value, const char* help,
                              const char* type) {
        engines.add_option(name, value, help)->type_name(type);
    };
    add_text("--workload", line.engines.workload, "w1, w2 or w3; if not given, all", "NAME");
    add_text("--size", line.engines.size,
             "Size of the pictures; if not given, 500x500 and 1920x1080", "WIDTHxHEIGHT");
    add_text("--threads", line.engines.threads, "1 or 2; if not given, both", "N");
    add_text(
        "--simd", line.engines.simd,
        "Fast engine with scalar, sse2, avx2 or avx512; if not given, all that this machine has",
        "NAME");
    add_text("--rounds", line.engines.rounds, "Number of turns of each engine, 5 to 1000", "N");
    add_json(engines, line.engines.json);
    engines.footer(engines_footer());

    CLI::App& ladder =
        add_command(line, "ladder", "Time the rungs from the lab's loop to the fast engine",
                    [&] { line.exit_code = ladder_command(line.ladder, out, progress); });
    ladder.add_option("FILE", line.ladder.view.file, "Scene, model, lesson or saved view")
        ->type_name("");
    ladder.add_option("--rounds", line.ladder.rounds, "Number of turns of each rung, 1 to 1000")
        ->type_name("N");
    ladder
        .add_option("--rung", line.ladder.rung, "Print only this rung, with what changed and why")
        ->type_name("NAME");
    ladder
        .add_option("--race", line.ladder.race,
                    "Instead, let two threads share one depth buffer in N runs, 1 to 1000, and "
                    "print how many pixels are wrong in each")
        ->type_name("N");
    add_json(ladder, line.ladder.json);
    ladder.footer(ladder_footer());
    add_view_options(ladder, line.ladder.view);
    // Last, because commands inherit the footer that is set when they are added.
    line.app.footer("Without a command, the window opens.\n"
                    "Exit codes: 0 done, 1 a check found a difference, 2 wrong usage, 3 bad "
                    "input,\n"
                    "4 could not read or write, 5 no display, 130 stopped by Ctrl+C.");
}

/// The word is not a file: perhaps a command was meant.
void check_file(const CommandLine& line) {
    std::error_code ignored;
    const std::string& file = line.view.file;
    if (file.empty() || file == "-" || file.find_first_of("./") != std::string::npos ||
        std::filesystem::exists(file, ignored)) {
        return;
    }
    std::vector<std::string_view> names;
    for (const CLI::App* command : line.app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    throw UsageError(fmt::format("there is neither a command nor a file named '{}'.{}", file,
                                 did_you_mean(file, names)));
}

/// Reads the arguments. Prints help or version if they ask for it, and then returns false.
bool parse(CommandLine& line, std::vector<std::string> arguments, std::ostream& out,
           std::ostream& err) {
    restore_arguments(line.app);
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
    try {
        line.app.parse(std::move(arguments));
        return true;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            line.app.exit(error, out, err);
            return false;
        }
        std::string sentence = error.what();
        if (!sentence.ends_with('.')) sentence += '.';
        throw UsageError(sentence + " See rasterwalk --help.");
    }
}

/// Takes over the view of a link: "https://example.edu/cg/#lesson=05-row-table", or only what
/// begins at its #.
void take_link(ViewOptions& view) {
    const std::string link = std::exchange(view.file, {});
    if (!(view == ViewOptions{})) throw UsageError("a link and options cannot be given together.");
    view = parse_view_link(std::string_view(link).substr(link.find('#')));
}

bool is_link(const std::string& file) {
    const std::size_t hash = file.find('#');
    std::error_code ignored;
    return hash != file.npos && (hash == 0 || file.find("://") < hash) &&
           !std::filesystem::exists(file, ignored);
}

void open_window_on(const ViewOptions& view, CliRequest& request) {
    const std::string& name = !view.file.empty()     ? view.file
                              : !view.lesson.empty() ? view.lesson
                                                     : view.scene;
    std::error_code fault;
    // A pipe may be silent for long, and cannot be stopped.
    if (!std::filesystem::is_regular_file(name, fault)) {
        request.session = open_view(view);
        return;
    }
    auto reading = std::make_unique<FileReading>(
        name, [view](const ReadingWatch& watch) -> Opened { return open_view(view, watch); });
    if (reading->is_done(request.patience)) {
        request.session = std::get<Session>(reading->take());
    } else {
        request.session = open_view({});
        request.reading = std::move(reading);
    }
}

void run(CommandLine& line, CliRequest& request) {
    if (!line.command) {
        if (is_link(line.view.file)) take_link(line.view);
        if (line.code.empty() && is_source_name(line.view.file))
            std::swap(line.code, line.view.file);
        request.code = line.code;
        request.is_plain = line.view == ViewOptions{} && line.code.empty();
        check_file(line);
        open_window_on(line.view, request);
        request.open_window = true;
        return;
    }
    if (!(line.view == ViewOptions{}) || !line.code.empty()) {
        throw UsageError("the options of a command go after its name.");
    }
    line.command();
}

int to_int(ExitCode code) {
    return static_cast<int>(code);
}

} // namespace

int run_cli(int argc, const char* const* argv, std::ostream& data, std::ostream& messages,
            CliRequest& request, const Clock& clock, std::ostream* terminal) {
    VisibleOutput out(data), err(messages);
    ProgressLine progress(terminal);
    const auto complain = [&](const std::string& sentence, ExitCode code) {
        progress.clear();
        err << "rasterwalk: " << visible_line(sentence) << '\n';
        return to_int(code);
    };
    try {
        CommandLine line;
        describe(line, clock, out, err, progress);
        if (parse(line, command_arguments(argc, argv), out, err)) run(line, request);
        out.flush();
        if (!out) return complain("the output could not be written.", ExitCode::no_access);
        return to_int(line.exit_code);
    } catch (const Error& error) {
        return complain(error.what(), error.code);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this.", ExitCode::no_access);
    }
}

} // namespace rasterwalk
