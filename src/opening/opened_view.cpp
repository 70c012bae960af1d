#include "opening/opened_view.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "facts/facts.h"
#include "laboratory/bug.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "opening/state_file.h"
#include "pipeline/frame.h"
#include "pipeline/timeline.h"
#include "session/content.h"
#include "session/depth_view.h"
#include "session/moments.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "view/situation.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view none = "none";

/// In Situation::lines: this was said by the options, not by a file.
constexpr int said_by_options = -1;

/// What the options start from.
struct Start {
    Session session;
    Situation situation;
    std::string path; ///< of the lesson or the saved view; empty: neither
};

std::string sentence_of(const std::string& path, const Fault& fault) {
    return fault.line > 0 ? path + ":" + std::to_string(fault.line) + ": " + fault.sentence
                          : path + ": " + fault.sentence;
}

/// The first fault of a situation, thrown.
void refuse_faults(const std::string& path, const std::vector<Fault>& faults) {
    if (faults.empty()) return;
    const Fault& first = faults.front();
    if (path.empty() || first.line == said_by_options) throw UsageError(first.sentence);
    throw InputError(sentence_of(path, first));
}

int parse_step(const std::string& text, const Lesson& lesson) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const std::optional<int> step = text.empty() ? 0 : parse_int(text);
    if (step && *step >= 0 && *step <= last) return *step;
    throw UsageError("--step is a number from 0 to " + std::to_string(last) + " in lesson " +
                     in_quotes(lesson.id) + ", not " + in_quotes(text) + ".");
}

Start start_of_lesson(const ViewOptions& options) {
    const Lesson lesson = lesson_named(options.lesson);
    const int step = parse_step(options.step, lesson);
    Start start;
    start.path = lesson.path;
    start.situation = lesson.steps[static_cast<std::size_t>(step)].situation;
    std::string scene;
    try {
        scene = find_lesson_file(lesson.folder,
                                 start.situation.scene.value_or(std::string(usual_scene)));
    } catch (const Error& fault) {
        throw InputError(
            sentence_of(lesson.path, {start.situation.line_of("scene"), fault.what()}));
    }
    start.session = open_session(scene);
    start.session.lesson = lesson.id;
    start.session.step = step;
    if (!lesson.faults.empty()) {
        start.session.notice = fault_text(lesson, lesson.faults.front());
    }
    if (!is_in_lessons_folder(lesson)) start.session.lesson_folder = lesson.folder;
    return start;
}

Start start_of_scene(const ViewOptions& options, const std::optional<Bug>& bug) {
    Start start;
    std::string scene = lessons_folder() + "/" + (bug ? bug->scene : std::string(usual_scene));
    if (!options.scene.empty()) scene = find_scene_file(options.scene);
    start.session = open_session(scene);
    return start;
}

/// The lesson beside a saved view. One that is not there any more keeps nobody from the view.
void take_lesson(const SavedView& saved, Session& session) {
    if (saved.lesson.empty()) return;
    try {
        const bool is_file = saved.lesson.ends_with(".md");
        const Lesson lesson =
            lesson_named(is_file ? find_file(saved, "lesson", saved.lesson) : saved.lesson);
        session.lesson = lesson.id;
        session.step = std::min(saved.step, static_cast<int>(lesson.steps.size()) - 1);
        if (!is_in_lessons_folder(lesson)) session.lesson_folder = lesson.folder;
    } catch (const Error& fault) {
        session.notice = std::string("The lesson of this view is not here: ") + fault.what();
    }
}

Start start_of_saved_view(const std::string& path) {
    const SavedView saved = read_view(path);
    Start start;
    start.path = saved.path;
    start.situation = saved.situation;
    start.session = open_session(find_file(saved, "scene", saved.scene));
    take_lesson(saved, start.session);
    return start;
}

/// Puts the scene that the options name into the place of the lesson's: its rules stay, its places
/// mean nothing there.
void replace_scene(Start& start, const std::string& name) {
    set_scene(start.session, read_scene_file(find_scene_file(name)));
    Situation& s = start.situation;
    s.cursor = std::nullopt;
    s.pixel = std::nullopt;
    s.triangle = s.row = s.vertex = std::nullopt;
    s.zoom = std::nullopt;
    s.centre = std::nullopt;
    s.depth_range = std::nullopt;
    s.vertices.clear();
}

/// Gives the picture another size and the same field of view.
void set_size(Settings& settings, SceneSpace space, const std::string& size) {
    const float old_height = static_cast<float>(settings.viewport.height);
    set_value(settings, *find_setting("viewport.size"), size);
    if (space == SceneSpace::pixels) return;
    const float focal_length =
        settings.camera.focal_length * (static_cast<float>(settings.viewport.height) / old_height);
    set_value(settings, *find_setting("camera.focal_length"), number_text(focal_length));
}

/// The settings that the start's situation asks for.
void set_as_situation_says(Start& start) {
    Settings& settings = start.session.settings;
    settings = default_settings(*start.session.scene);
    for (const std::string& assignment : start.situation.set) {
        try {
            set_from_text(settings, assignment);
        } catch (const Error& fault) {
            throw InputError(
                sentence_of(start.path, {start.situation.line_of("set"), fault.what()}));
        }
    }
}

/// What was set by the options, on top of the start.
void set_as_options_say(const ViewOptions& options, const std::optional<Bug>& bug,
                        Session& session) {
    Settings& settings = session.settings;
    if (!options.size.empty()) set_size(settings, session.scene->space, options.size);
    if (bug) apply_bug(*bug, session);
    // Both runs of a mistake: or else what is set would count as a part of it.
    for (Settings* const run : {&settings, bug ? &*session.other : nullptr}) {
        if (run == nullptr) continue;
        for (const std::string& name : options.presets)
            apply_preset(find_preset(session.presets, name), *run);
        if (!options.stage.empty()) set_value(*run, *find_setting("stage"), options.stage);
        for (const std::string& assignment : options.assignments)
            set_from_text(*run, assignment);
    }
}

/// Do the options draw another picture than the start's?
bool changes_picture(const ViewOptions& o) {
    return !(o.scene.empty() && o.size.empty() && o.stage.empty() && o.bug.empty() &&
             o.presets.empty() && o.assignments.empty() && o.vertices.empty());
}

/// Where the start's cursor, pixel and row do not exist with other settings, they give way.
void fit(const Session& session, Situation& situation) {
    const Frame frame = prepare_frame(*session.scene, session.settings);
    if (situation.cursor) situation.cursor = Timeline(frame).at_or_after(*situation.cursor);
    const Viewport& size = frame.settings.viewport;
    const std::optional<glm::ivec2>& pixel = situation.pixel;
    if (situation.line_of("pixel") != said_by_options && pixel &&
        (pixel->x >= size.width || pixel->y >= size.height)) {
        situation.pixel = std::nullopt;
    }
    if (situation.line_of("row") != said_by_options && situation.row &&
        *situation.row >= size.height) {
        situation.row = std::nullopt;
    }
}

/// Puts the vertices of a bench where they are to lie, so that everything after it finds them.
std::vector<Fault> place_all(Session& session, const Situation& situation) {
    try {
        for (const PlacedTriangle& placed : situation.vertices)
            place_triangle(session, placed);
        return {};
    } catch (const Error& fault) {
        return {{situation.line_of("vertices"), fault.what()}};
    }
}

[[noreturn]] void refuse(const char* option, const char* takes, const std::string& text) {
    throw UsageError(std::string(option).append(takes).append(", not ") + in_quotes(text) + ".");
}

std::size_t word_index(const char* option, std::span<const std::string_view> words,
                       const std::string& text) {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string known;
    for (std::size_t i = 0; i < words.size(); ++i) {
        known.append(i == 0 ? "" : i + 1 == words.size() ? " or " : ", ").append(words[i]);
    }
    throw UsageError(std::string(option).append(" is ").append(known).append(", not ") +
                     in_quotes(text) + "." + did_you_mean(text, words));
}

std::optional<float> parse_number(const std::string& text, float smallest, float largest) {
    float value = 0.0f;
    const std::string_view written = trimmed(text);
    const char* const last = written.data() + written.size();
    const auto [end, fault] = std::from_chars(written.data(), last, value);
    const bool is_good =
        fault == std::errc{} && end == last && value >= smallest && value <= largest;
    return is_good ? std::optional(value) : std::nullopt;
}

/// Puts the options into a situation, on top of what stands there.
class Asked {
  public:
    Asked(const ViewOptions& options, Situation& situation) : o_(options), s_(situation) {}

    void take() {
        take_words();
        take_selection();
        take_canvas();
        if (!o_.vertices.empty()) take_vertices();
        if (!o_.b.empty()) {
            said("compare");
            s_.compare = o_.b;
            if (o_.b.back() == none) s_.compare = std::nullopt;
        }
    }

  private:
    /// What goes wrong with this key is the options' fault, not the file's.
    void said(const char* key) { s_.lines[key] = said_by_options; }

    template <class Take>
    void option(const std::string& text, const char* key, Take take) {
        if (text.empty()) return;
        said(key);
        take(text);
    }

    void take_words() {
        option(o_.tab, "tab", [&](const std::string& text) {
            s_.tab = tab_names()[word_index("--tab", tab_names(), text)];
        });
        option(o_.view, "view", [&](const std::string& text) {
            s_.view = static_cast<View>(word_index("--view", view_names(), text));
        });
        option(o_.compare_view, "compare_view", [&](const std::string& text) {
            s_.compare_view =
                static_cast<CompareView>(word_index("--compare-view", compare_view_names(), text));
        });
        if (o_.overlays.empty()) return;
        OverlaySet overlays;
        for (const std::string& name : o_.overlays) {
            if (name == none) {
                overlays = {};
            } else {
                overlays.set(static_cast<Overlay>(word_index("--overlay", overlay_names(), name)),
                             true);
            }
        }
        s_.overlays = overlays;
    }

    static std::span<const std::string_view> overlay_names() {
        static const auto names = [] {
            std::array<std::string_view, overlay_count> words;
            for (std::size_t i = 0; i < words.size(); ++i)
                words[i] = overlay_list()[i].name;
            return words;
        }();
        return names;
    }

    void number(const std::string& text, const char* option_name, const char* key,
                std::optional<int>& value) {
        option(text, key, [&](const std::string& written) {
            value = std::nullopt;
            if (written == none) return;
            value = parse_int(written);
            if (!value) refuse(option_name, " is a whole number or none", written);
        });
    }

    void take_selection() {
        number(o_.triangle, "--triangle", "triangle", s_.triangle);
        number(o_.row, "--row", "row", s_.row);
        number(o_.vertex, "--vertex", "vertex", s_.vertex);
        option(o_.pixel, "pixel", [&](const std::string& text) {
            s_.pixel = std::nullopt;
            if (text == none) return;
            s_.pixel = parse_pixel(text);
            if (!s_.pixel) refuse("--pixel", " is a column and a row as 250,131 or none", text);
        });
    }

    void take_canvas() {
        option(o_.zoom, "zoom", [&](const std::string& text) {
            s_.zoom = text == "fit" ? 0.0f : parse_number(text, smallest_zoom, largest_zoom);
            if (!s_.zoom) refuse("--zoom", " is a number from 0.25 to 64 or fit", text);
        });
        option(o_.centre, "centre", [&](const std::string& text) {
            s_.centre = parse_place(text);
            if (!s_.centre ||
                std::max(std::abs(s_.centre->x), std::abs(s_.centre->y)) > farthest_centre) {
                refuse("--centre", " is a place in the picture as 250,131.5", text);
            }
        });
        option(o_.grid, "grid", [&](const std::string& text) {
            constexpr std::array<std::string_view, 2> words{"off", "on"};
            s_.grid = word_index("--grid", words, text) == 1;
        });
        option(o_.wipe, "wipe", [&](const std::string& text) {
            s_.wipe = parse_number(text, 0.0f, 1.0f);
            if (!s_.wipe) refuse("--wipe", " is a number from 0 to 1", text);
        });
        option(o_.depth_range, "depth_range", [&](const std::string& text) {
            s_.depth_range = std::nullopt;
            if (text == none) return;
            s_.depth_range = parse_depth_range(text);
            if (!s_.depth_range) {
                refuse("--depth-range", " is a range of 1/z, far and near, as 0.2,0.8 or none",
                       text);
            }
        });
    }

    void take_vertices() {
        said("vertices");
        for (const std::string& text : o_.vertices)
            s_.vertices.push_back(parse_placed_triangle(text));
    }

    const ViewOptions& o_;
    Situation& s_;
};

/// FILE stands for one of the other options, by its ending.
ViewOptions with_file_sorted(ViewOptions options) {
    if (options.file.empty()) return options;
    if (is_view_file(options.file)) {
        if (options.lesson.empty()) return options;
        throw UsageError("a saved view has its own lesson: it does not go with --lesson.");
    }
    const std::string file = std::exchange(options.file, "");
    const bool is_lesson = file.ends_with(".md");
    std::string& place = is_lesson ? options.lesson : options.scene;
    if (!place.empty()) {
        throw UsageError(is_lesson ? "the lesson is named twice: as FILE and by --lesson."
                                   : "the scene is named twice: as FILE and by --scene.");
    }
    // A path, even where it has no folder.
    place = is_lesson && file.find('/') == file.npos ? "./" + file : file;
    return options;
}

} // namespace

Session open_view(const ViewOptions& given) {
    const ViewOptions options = with_file_sorted(given);
    if (!options.step.empty() && options.lesson.empty()) {
        throw UsageError("--step belongs to --lesson.");
    }
    std::optional<Bug> bug;
    if (!options.bug.empty()) bug = find_bug(read_bugs(), options.bug);
    Start start = !options.file.empty()     ? start_of_saved_view(options.file)
                  : !options.lesson.empty() ? start_of_lesson(options)
                                            : start_of_scene(options, bug);
    Session& session = start.session;
    Situation& situation = start.situation;
    if (!start.path.empty()) {
        set_as_situation_says(start);
        if (!options.scene.empty()) replace_scene(start, options.scene);
    }
    set_as_options_say(options, bug, session);

    Asked(options, situation).take();
    const std::optional<Settings> correct = session.other;
    const std::optional<TakenRun> taken = session.taken;
    refuse_faults(start.path, place_all(session, situation));
    if (changes_picture(options)) fit(session, situation);
    refuse_faults(start.path, apply_on_scene(session, situation));
    const Frame frame = prepare_frame(*session.scene, session.settings);
    if (!options.to.empty()) session.cursor = moment_of(frame, options.to);
    if (bug && options.b.empty() && correct) {
        compare_with(session, *correct);
        session.taken = taken; // the laboratory turns it off again
    }
    session.jumps = 0;
    return std::move(start.session);
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
            throw UsageError("there is no lesson " + in_quotes(name) + "." +
                             did_you_mean(name, ids) + " 'rasterwalk lessons' lists them.");
        }
    }
    if (!is_lesson_file(fs::path(path).filename().string())) {
        throw UsageError(in_quotes(path) +
                         " is no lesson: its name is two digits, a hyphen, a name and .md.");
    }
    read_file(path, largest_lesson); // says why it cannot be read
    return read_lesson(path);
}

bool is_view_file(std::string_view path) {
    return path.ends_with(".walk.toml");
}

} // namespace rasterwalk
