#include "opening/opened_view.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "laboratory/bug.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "pipeline/frame.h"
#include "pipeline/shadow_pass.h"
#include "pipeline/timeline.h"
#include "scene/applied_texture.h"
#include "scene/model_notice.h"
#include "session/content.h"
#include "session/moments.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "view/state_file.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// In ViewState::lines: this was given by the options, not by a file.
constexpr int set_by_options = -1;

/// What the options start from.
struct Start {
    Session session;
    ViewState state;
    std::string path;    ///< of the lesson or the saved view; empty: neither
    std::string own_tab; ///< of a saved view: the student's, instead of the lesson's; empty: none
    bool covers_tab = false; ///< the settings cover it
};

std::string sentence_of(const std::string& path, const Fault& fault) {
    return fault.line > 0 ? fmt::format("{}:{}: {}", path, fault.line, fault.sentence)
                          : fmt::format("{}: {}", path, fault.sentence);
}

/// Throws the first of these faults.
void refuse_faults(const std::string& path, const std::vector<Fault>& faults) {
    if (faults.empty()) return;
    const Fault& first = faults.front();
    if (path.empty() || first.line == set_by_options) throw UsageError(first.sentence);
    throw InputError(sentence_of(path, first));
}

int parse_step(const std::string& text, const Lesson& lesson) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const std::optional<int> step = text.empty() ? 0 : parse_int(text);
    if (step && *step >= 0 && *step <= last) return *step;
    throw UsageError(fmt::format("--step must be a number from 0 to {} in lesson {}, not {}.", last,
                                 in_quotes(lesson.id), in_quotes(text)));
}

Start start_of_lesson(const ViewOptions& options, const ReadingWatch& watch) {
    const Lesson lesson = lesson_named(options.lesson);
    const int step = parse_step(options.step, lesson);
    Start start;
    start.path = lesson.path;
    start.state = lesson.steps[static_cast<std::size_t>(step)].state;
    std::string scene;
    try {
        scene =
            find_lesson_file(lesson.folder, start.state.scene.value_or(std::string(usual_scene)));
    } catch (const Error& fault) {
        throw InputError(sentence_of(lesson.path, {start.state.line_of("scene"), fault.what()}));
    }
    start.session = open_session(scene, watch);
    start.session.lesson = lesson.id;
    start.session.step = step;
    if (!lesson.faults.empty()) {
        start.session.notice = fault_text(lesson, lesson.faults.front());
    }
    if (!is_in_lessons_folder(lesson)) start.session.lesson_folder = lesson.folder;
    return start;
}

/// A picture in place of a scene: another command was meant.
void refuse_picture(const std::string& path) {
    std::error_code fault;
    // What is not a file, such as a pipe, could not be read a second time.
    if (!fs::is_regular_file(path, fault) || !is_image_file(path)) return;
    throw UsageError(in_quotes(path) +
                     " is a picture, not a scene. 'rasterwalk diagnose FILE' suggests what is "
                     "wrong with it, and so does the window if you drop the picture there.");
}

Start start_of_scene(const ViewOptions& options, const std::optional<Bug>& bug,
                     const ReadingWatch& watch) {
    Start start;
    std::string scene = lessons_folder() + "/" + (bug ? bug->scene : std::string(usual_scene));
    if (!options.scene.empty()) scene = find_scene_file(options.scene);
    start.session = open_session(scene, watch);
    return start;
}

/// The lesson saved with a view. Its step says which panels are shown, and which tab the student
/// can go back to. If it no longer exists, the view opens all the same.
void take_lesson(const SavedView& saved, Start& start) {
    if (saved.lesson.empty()) return;
    Session& session = start.session;
    ViewState& state = start.state;
    try {
        const bool is_file = saved.lesson.ends_with(".md");
        const Lesson lesson =
            lesson_named(is_file ? find_file(saved, "lesson", saved.lesson) : saved.lesson);
        session.lesson = lesson.id;
        session.step = std::min(saved.step, static_cast<int>(lesson.steps.size()) - 1);
        if (!is_in_lessons_folder(lesson)) session.lesson_folder = lesson.folder;
        const ViewState& step = lesson.steps[static_cast<std::size_t>(session.step)].state;
        state.panels = step.panels;
        start.own_tab = saved.own_tab;
        if (!start.own_tab.empty()) state.tab = step.tab;
    } catch (const Error& fault) {
        session.notice = std::string("The lesson of this view is missing: ") + fault.what();
    }
}

/// Lays an image on the scene of a session; settings and selection stay.
void apply_texture(const std::string& path, Session& session) {
    session.scene = std::make_shared<const Scene>(with_texture(*session.scene, path));
}

Start start_of_saved_view(const std::string& path, const ReadingWatch& watch) {
    const SavedView saved = read_view(path);
    Start start;
    start.path = saved.path;
    start.state = saved.state;
    start.session = open_session(find_file(saved, "scene", saved.scene), watch);
    if (!saved.texture.empty())
        apply_texture(find_file(saved, "texture", saved.texture), start.session);
    take_lesson(saved, start);
    start.covers_tab = saved.state.tab == settings_tab;
    return start;
}

/// The student's own tab replaces the lesson's, and the settings cover it.
void show_own_tab(const Start& start, Session& session) {
    choose_tab(session, start.own_tab);
    if (start.covers_tab) choose_tab(session, settings_tab);
}

/// Puts the scene that the options name in place of the lesson's: the lesson's rules stay, but its
/// places mean nothing there.
void replace_scene(Start& start, const std::string& name, const ReadingWatch& watch) {
    set_scene(start.session, read_scene_file(find_scene_file(name), watch));
    for (const ViewField& field : view_table()) {
        if (field.is_of_scene) field.clear(start.state);
    }
}

/// Gives the picture another size with the same field of view.
void set_size(Settings& settings, SceneSpace space, const std::string& size) {
    const float old_height = static_cast<float>(settings.viewport.height);
    set_value(settings, *find_setting("viewport.size"), size);
    if (space == SceneSpace::pixels) return;
    const float focal_length =
        settings.camera.focal_length * (static_cast<float>(settings.viewport.height) / old_height);
    set_value(settings, *find_setting("camera.focal_length"), number_text(focal_length));
}

/// Applies the settings that the start asks for.
void apply_start(Start& start) {
    Settings& settings = start.session.a.settings;
    settings = default_settings(*start.session.scene);
    for (const std::string& assignment : start.state.set) {
        try {
            set_from_text(settings, assignment);
        } catch (const Error& fault) {
            throw InputError(sentence_of(start.path, {start.state.line_of("set"), fault.what()}));
        }
    }
}

/// Applies what the options set, on top of the start.
void apply_options(const ViewOptions& options, const std::optional<Bug>& bug, Session& session) {
    Settings& settings = session.a.settings;
    if (!options.size.empty()) set_size(settings, session.scene->space, options.size);
    if (bug) apply_bug(*bug, session);
    // Both runs of a mistake, or else what is set would count as a part of it.
    for (Settings* const run : {&settings, bug ? &session.b->settings : nullptr}) {
        if (run == nullptr) continue;
        for (const std::string& name : options.presets)
            apply_preset(find_preset(session.presets, name), *run);
        if (!options.stage.empty()) set_value(*run, *find_setting("stage"), options.stage);
        for (const std::string& assignment : options.assignments)
            set_from_text(*run, assignment);
    }
}

/// Do the options draw a picture different from the start's?
bool changes_picture(const ViewOptions& o) {
    return !(o.scene.empty() && o.texture.empty() && o.size.empty() && o.stage.empty() &&
             o.bug.empty() && o.presets.empty() && o.assignments.empty() &&
             o.given.count("vertices") == 0);
}

/// Moves or drops the start's cursor, pixel and row if they do not exist with other settings.
void fit(const Session& session, ViewState& state) {
    if (state.cursor)
        state.cursor = existing_moment(*session.scene, session.a.settings, *state.cursor);
    const Settings& picture = session.a.settings;
    const int pass = pass_of(state.cursor.value_or(cursor_end), picture, session.scene->space);
    const Viewport size = settings_of_pass(picture, pass).viewport;
    const std::optional<glm::ivec2>& pixel = state.pixel;
    if (state.line_of("pixel") != set_by_options && pixel &&
        (pixel->x >= size.width || pixel->y >= size.height)) {
        state.pixel = std::nullopt;
    }
    if (state.line_of("row") != set_by_options && state.row && *state.row >= size.height) {
        state.row = std::nullopt;
    }
}

/// Moves the vertices of a bench, so that everything after it finds them there.
std::vector<Fault> place_vertices(Session& session, const ViewState& state) {
    try {
        view_field("vertices").show(state, session);
        return {};
    } catch (const Error& fault) {
        return {{state.line_of("vertices"), fault.what()}};
    }
}

/// Puts the options on top of the state. Anything wrong with them is then the options' fault, not
/// the file's.
void take_options(const ViewOptions& options, ViewState& state) {
    for (const ViewField& field : view_table()) {
        const auto given = options.given.find(field.key);
        if (!field.parse || given == options.given.end()) continue;
        state.lines[std::string(field.key)] = set_by_options;
        field.parse({option_name(field), given->second}, state);
    }
}

/// FILE stands for one of the other options, depending on its ending.
ViewOptions with_file_sorted(ViewOptions options) {
    if (options.file.empty()) return options;
    if (is_view_file(options.file)) {
        if (options.lesson.empty()) return options;
        throw UsageError("a saved view has its own lesson, so it cannot be combined with "
                         "--lesson.");
    }
    const std::string file = std::exchange(options.file, "");
    const bool is_lesson = file.ends_with(".md");
    std::string& place = is_lesson ? options.lesson : options.scene;
    if (!place.empty()) {
        throw UsageError(is_lesson ? "the lesson is named twice, as FILE and by --lesson."
                                   : "the scene is named twice, as FILE and by --scene.");
    }
    // A path, even if it has no folder.
    place = is_lesson && file.find('/') == file.npos ? "./" + file : file;
    return options;
}

} // namespace

Session open_view(const ViewOptions& given, const ReadingWatch& watch) {
    const ViewOptions options = with_file_sorted(given);
    if (!options.scene.empty()) refuse_picture(find_scene_file(options.scene));
    if (!options.step.empty() && options.lesson.empty()) {
        throw UsageError("--step can only be used with --lesson.");
    }
    std::optional<Bug> bug;
    if (!options.bug.empty()) bug = find_bug(read_bugs(), options.bug);
    Start start = !options.file.empty()     ? start_of_saved_view(options.file, watch)
                  : !options.lesson.empty() ? start_of_lesson(options, watch)
                                            : start_of_scene(options, bug, watch);
    Session& session = start.session;
    ViewState& state = start.state;
    if (!start.path.empty()) {
        apply_start(start);
        if (!options.scene.empty()) replace_scene(start, options.scene, watch);
    }
    if (!options.texture.empty()) apply_texture(find_scene_file(options.texture), session);
    apply_options(options, bug, session);

    take_options(options, state);
    const std::optional<Run> correct = session.b;
    const std::optional<ReplacedRun> replaced = session.replaced;
    refuse_faults(start.path, place_vertices(session, state));
    if (changes_picture(options)) fit(session, state);
    refuse_faults(start.path, show_on_scene(session, state));
    if (!start.own_tab.empty() && options.given.count("tab") == 0) show_own_tab(start, session);
    const auto to = options.given.find("cursor");
    if (to != options.given.end())
        session.cursor = moment_of(*session.scene, session.a.settings, to->second.back());
    if (bug && options.given.count("compare") == 0 && correct) {
        compare_with(session, *correct);
        session.replaced = replaced; // the laboratory turns it off again
    }
    if (session.notice.empty()) session.notice = model_notice(*session.scene);
    session.jumps = 0;
    return std::move(start.session);
}

std::string option_name(const ViewField& field) {
    return "--" + std::string(field.option.name);
}

std::string find_scene_file(const std::string& name) {
    std::error_code fault;
    if (!fs::exists(name, fault) && !fs::path(name).is_absolute()) {
        const fs::path own = fs::path(lessons_folder()) / name;
        if (fs::is_regular_file(own, fault)) return own.string();
    }
    return name;
}

Lesson lesson_named(const std::string& name) {
    std::string path = name;
    if (!name.ends_with(".md") && name.find('/') == name.npos) {
        path = lessons_folder() + "/" + name + ".md";
        std::error_code fault;
        if (!is_lesson_file(fs::path(path).filename().string()) || !fs::exists(path, fault)) {
            LessonList list;
            std::vector<std::string_view> ids;
            for (const Lesson& lesson : list.all())
                ids.push_back(lesson.id);
            throw UsageError(
                fmt::format("there is no lesson {}.{} 'rasterwalk lessons' lists them.",
                            in_quotes(name), did_you_mean(name, ids)));
        }
    }
    if (!is_lesson_file(fs::path(path).filename().string())) {
        throw UsageError(in_quotes(path) +
                         " is not a lesson: the name of a lesson is two digits, a hyphen, a name "
                         "and .md.");
    }
    read_file(path, largest_lesson); // throws with the reason why it cannot be read
    return read_lesson(path);
}

bool is_view_file(std::string_view path) {
    return path.ends_with(".walk.toml");
}

} // namespace rasterwalk
