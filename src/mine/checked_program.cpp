#include "mine/checked_program.h"

#include <algorithm>
#include <array>
#include <utility>

#include "laboratory/image_variant.h"
#include "laboratory/picture_findings.h"
#include "mine/compile/source_text.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// Whose examples the functions are asked about.
constexpr std::string_view bench_scene = "scenes/one-triangle.toml";

constexpr std::uint32_t bit(rasterwalk_kit::Part part) {
    return std::uint32_t{1} << part;
}

constexpr std::uint32_t every_function =
    bit(rasterwalk_kit::part_vertex_shader) | bit(rasterwalk_kit::part_interpolate) |
    bit(rasterwalk_kit::part_polygon_rows) | bit(rasterwalk_kit::part_draw_rows) |
    bit(rasterwalk_kit::part_depth_test) | bit(rasterwalk_kit::part_pixel_shader);

void say(const CheckProgramOptions& options, std::string_view what) {
    if (options.say) options.say(what);
}

bool is_stopped(const CheckProgramOptions& options) {
    return options.is_stopped && options.is_stopped();
}

void report(const CheckedProgram& checked, const CheckProgramOptions& options) {
    if (options.report && !is_stopped(options)) options.report(checked);
}

/// For each part, the answers of the run that was asked for it.
Answers read_all(const std::vector<std::vector<double>>& streams, const Questions& questions) {
    Answers all;
    const auto take = [](auto& into, auto&& from) {
        if (into.end == PartEnd::not_asked) into = std::forward<decltype(from)>(from);
    };
    for (const std::vector<double>& stream : streams) {
        Answers one = read_answers(stream, questions);
        take(all.globals, std::move(one.globals));
        take(all.vertices, std::move(one.vertices));
        take(all.lines, std::move(one.lines));
        take(all.polygons, std::move(one.polygons));
        take(all.rows, std::move(one.rows));
        take(all.depths, std::move(one.depths));
        take(all.points, std::move(one.points));
    }
    return all;
}

KnownProgram known_of(const ProgramRun& run, const Scene& room) {
    const Questions none;
    const Answers answers = read_all(run.answers, none);
    ProgramGlobals globals;
    if (answers.globals.end == PartEnd::complete) globals = answers.globals.answers.front();
    // What it has opened is the picture's size, whatever its constants say.
    if (run.recording.window.width > 0) globals.screen = run.recording.window;
    return known_program(globals, {room.camera, room.light, room.viewport});
}

/// The settings that draw the room by the rules of this program, as far as its functions show them.
/// @param known receives the names of those that they have shown
Settings settings_of(const CheckedProgram& checked, const Scene& room,
                     std::vector<std::string>& known) {
    Settings settings = with_handout_rules(default_settings(room));
    settings.camera = checked.known.camera;
    settings.light = checked.known.light;
    settings.viewport = checked.known.viewport;
    for (const FunctionCheck& check : checked.functions) {
        if (check.state != CheckState::right) continue;
        for (const auto& [name, value] : check.rules)
            if (const Setting* setting = find_setting(name)) {
                set_value(settings, *setting, value);
                known.push_back(name);
            }
    }
    return settings;
}

void ask_functions(CheckedProgram& checked, const LabScenes& lab,
                   const CheckProgramOptions& options) {
    const Questions questions = make_questions(lab.room, lab.bench, checked.known);
    ProgramOrder order;
    order.task.parts = every_function;
    order.task.before_main = !checked.run->has_frame();
    order.questions = to_stream(questions);
    order.is_stopped = options.is_stopped;
    const ProgramRun run = run_program(checked.files, checked.compiled.program, order);
    checked.functions = check_functions(questions, read_all(run.answers, questions));
    for (const ProgramFault& fault : run.faults)
        if (fault.part != rasterwalk_kit::part_picture) checked.run->faults.push_back(fault);
}

bool has_wrong_function(const CheckedProgram& checked) {
    return std::any_of(
        checked.functions.begin(), checked.functions.end(), [](const FunctionCheck& check) {
            return check.state == CheckState::wrong || check.state == CheckState::died;
        });
}

/// The function in which each of these settings would show.
constexpr std::array<std::pair<std::string_view, rasterwalk_kit::Part>, 10> settings_seen_in{{
    {"camera_move", rasterwalk_kit::part_vertex_shader},
    {"image_axes", rasterwalk_kit::part_vertex_shader},
    {"divided_by", rasterwalk_kit::part_vertex_shader},
    {"line_walk", rasterwalk_kit::part_interpolate},
    {"edge_samples", rasterwalk_kit::part_polygon_rows},
    {"row_start", rasterwalk_kit::part_polygon_rows},
    {"spans", rasterwalk_kit::part_draw_rows},
    {"bounds", rasterwalk_kit::part_draw_rows},
    {"depth_test", rasterwalk_kit::part_depth_test},
    {"depth_epsilon", rasterwalk_kit::part_depth_test},
}};

/// Has the program a right function in which this setting would show?
bool is_seen_right(const CheckedProgram& checked, std::string_view setting) {
    return std::any_of(
        checked.functions.begin(), checked.functions.end(), [&](const FunctionCheck& check) {
            return check.state == CheckState::right &&
                   std::find(settings_seen_in.begin(), settings_seen_in.end(),
                             std::pair{setting, check.part}) != settings_seen_in.end();
        });
}

/// Light may change by some steps of 255 from one pixel to the next.
bool shows_same_surface(const std::uint8_t* a, const std::uint8_t* b) {
    return is_same_pixel(a, b) || has_same_hue(a, b);
}

/// A program whose functions are right may still walk an edge by a rule that no setting has, and so
/// have the other of two surfaces in some pixels along it.
void accept_rounding(const CheckedProgram& checked, const Scene& room, PictureCheck& picture) {
    if (picture.is_right || has_wrong_function(checked)) return;
    if (likely_candidate(picture.diagnosis) == nullptr)
        picture.is_right = is_rounding(picture.right, picture.theirs, shows_same_surface);
    // If the depth test is known to be right, triangles in another order explain the rest.
    if (!picture.is_right && is_seen_right(checked, "depth_test"))
        picture.is_right =
            is_rounding(with_their_ties(picture, room), picture.theirs, shows_same_surface);
}

/// Do the functions contradict what the picture suggests? Triangles in another order, for example,
/// look like >= in the depth test.
bool is_contradicted(const CheckedProgram& checked, const Candidate& candidate,
                     const std::vector<Bug>& bugs) {
    const std::vector<std::string> ids = candidate.ids();
    return std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
        const Bug* const bug = bug_of_id(bugs, id);
        if (bug == nullptr) return false;
        return std::any_of(bug->set.begin(), bug->set.end(), [&](const auto& assignment) {
            return is_seen_right(checked, assignment.first);
        });
    });
}

/// How long a mistake is searched for before the sanitizers: theirs is the surer answer, and a
/// picture's may take much longer.
constexpr std::chrono::milliseconds first_search{500};

/// Is there enough to call a picture wrong that differs? Its vertices must be known to be where
/// they belong, and if it is lit, its lamp must be known.
bool is_known_enough(const CheckedProgram& checked, const Settings& reference) {
    const bool has_vertices =
        std::any_of(checked.functions.begin(), checked.functions.end(), [](const FunctionCheck& c) {
            return c.part == rasterwalk_kit::part_vertex_shader && c.state == CheckState::right;
        });
    return has_vertices && (reference.stage != Stage::shade || checked.known.knows_light);
}

/// @param search for what explains a wrong picture
void compare_pictures(CheckedProgram& checked, const Scene& room, const std::vector<Bug>& bugs,
                      std::chrono::milliseconds search, const CheckProgramOptions& options) {
    const Recording& recording = checked.run->recording;
    if (!recording.has_picture() || draws_nothing(*checked.run)) return;
    std::vector<std::string> known;
    const Settings settings = settings_of(checked, room, known);
    checked.picture =
        check_picture(recording, room, settings, known, bugs, search, options.is_stopped);
    PictureCheck& picture = *checked.picture;
    accept_rounding(checked, room, picture);
    const Candidate* const likely = likely_candidate(picture.diagnosis);
    picture.is_judged =
        picture.is_right || (likely == nullptr ? is_known_enough(checked, picture.reference)
                                               : !is_contradicted(checked, *likely, bugs));
    // Black is what many causes have in common, and what a lamp of no power makes of anything.
    if (picture.has_black_picture()) picture.is_right = picture.is_judged = false;
    if (!picture.is_right || !has_known_order(*checked.run)) return;
    const std::vector<OurPut> ours = our_puts(room, checked.picture->reference);
    checked.sequence = SequenceCheck{static_cast<std::int64_t>(recording.puts.size()),
                                     sequence_parting(recording.puts, ours, settings.viewport)};
}

/// The names of all functions that the sources of a program define.
std::vector<std::string> defined_functions(const StudentFiles& files) {
    std::vector<std::string> names = function_names(read_source(files.main)).defined;
    for (const std::string& source : files.sources) {
        const std::vector<std::string> more = function_names(read_source(source)).defined;
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

void run_sanitized(CheckedProgram& checked, const Compiler& compiler,
                   const CheckProgramOptions& options) {
    say(options, "Compiling it with sanitizers");
    const Compiled sanitized = compile_student_program(checked.files, compiler,
                                                       Instrumented::sanitized, options.is_stopped);
    if (sanitized.program.empty()) {
        checked.sanitizer_messages = sanitized.messages;
        return;
    }
    say(options, "Holding its keys down");
    KeyRuns runs;
    runs.is_stopped = options.is_stopped;
    checked.key_faults = hold_keys(checked.files, sanitized.program, runs);
    checked.is_key_tested = true;
}

} // namespace

bool CheckedProgram::is_right() const {
    return compiles() && run && run->faults.empty() && !has_wrong_function(*this) && picture &&
           picture->is_right && key_faults.empty();
}

LabScenes read_lab_scenes() {
    const std::string folder = lessons_folder() + '/';
    LabScenes lab{read_scene(folder + std::string(usual_scene)), {}};
    for (const BenchExample& example : read_scene(folder + std::string(bench_scene)).examples)
        lab.bench.push_back(example.positions);
    return lab;
}

CheckedProgram check_program(const StudentFiles& files, const LabScenes& lab,
                             const std::vector<Bug>& bugs, const CheckProgramOptions& options) {
    CheckedProgram checked;
    checked.files = files;
    checked.defined = defined_functions(files);
    say(options, "Compiling it");
    const Compiler compiler = find_compiler(options.compiler);
    checked.compiled =
        compile_student_program(files, compiler, Instrumented::no, options.is_stopped);
    if (!checked.compiles() || is_stopped(options)) return checked;
    say(options, "Running it");
    ProgramOrder order;
    order.task.parts = bit(rasterwalk_kit::part_globals);
    order.is_stopped = options.is_stopped;
    checked.run = run_program(files, checked.compiled.program, order);
    checked.known = known_of(*checked.run, lab.room);
    report(checked, options);
    if (checked.compiled.kit == KitUse::with_driver && !is_stopped(options)) {
        say(options, "Asking its functions");
        ask_functions(checked, lab, options);
        report(checked, options);
    }
    if (!is_stopped(options)) {
        say(options, "Comparing its picture");
        compare_pictures(checked, lab.room, bugs, std::min(options.search, first_search), options);
        checked.mistakes = likely_mistakes(checked);
        report(checked, options);
    }
    if (options.hold_keys && !is_stopped(options)) {
        run_sanitized(checked, compiler, options);
        report(checked, options);
    }
    if (checked.picture && !checked.picture->diagnosis.is_complete &&
        options.search > first_search && !is_stopped(options)) {
        say(options, "Searching for its mistake");
        compare_pictures(checked, lab.room, bugs, options.search, options);
    }
    checked.mistakes = likely_mistakes(checked);
    return checked;
}

} // namespace rasterwalk
