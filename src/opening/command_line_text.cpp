#include "opening/command_line_text.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "facts/facts.h"
#include "opening/opened_view.h"
#include "session/canvas_view.h"
#include "session/content.h"
#include "session/depth_view.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "view/shown_situation.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

std::string absolute_path(const std::string& path) {
    std::error_code fault;
    const fs::path absolute = fs::absolute(path, fault);
    return fault ? path : absolute.lexically_normal().string();
}

/// One of the program's own scenes is named from the folder of the lessons, so that the line means
/// the same on every machine.
std::string name_of_scene(const std::string& path) {
    std::error_code fault;
    const fs::path own = fs::canonical(lessons_folder(), fault);
    const fs::path name = fs::canonical(path, fault).lexically_relative(own);
    if (!fault && !name.empty() && *name.begin() != ".." &&
        is_same_file(find_scene_file(name.generic_string()), path)) {
        return name.generic_string();
    }
    return absolute_path(path);
}

/// What the line begins with: lesson and step, or a scene.
ViewOptions start_of(const Session& session) {
    ViewOptions options;
    if (!session.lesson.empty()) {
        options.step = std::to_string(session.step);
        options.lesson = session.lesson;
        if (!session.lesson_folder.empty()) {
            options.lesson = absolute_path(session.lesson_folder + "/" + session.lesson + ".md");
        }
        try {
            if (!is_same_file(open_view(options).scene->path, session.scene->path)) {
                options.scene = name_of_scene(session.scene->path);
                open_view(options);
            }
            return options;
        } catch (const Error&) {
            options = {}; // the lesson is no longer what it was
        }
    }
    const std::string usual = lessons_folder() + "/" + std::string(usual_scene);
    if (!is_same_file(usual, session.scene->path)) {
        options.scene = name_of_scene(session.scene->path);
    }
    return options;
}

std::string text_of(const std::optional<int>& number) {
    return number ? std::to_string(*number) : "none";
}

/// Words after one another, as far as they differ from where the line begins.
class Line {
  public:
    Line(const Session& session, const ViewOptions& start)
        : session_(session), base_(open_view(start)),
          from_(situation_of(base_, scene_in_file(base_))),
          to_(situation_of(session, scene_in_file(session))) {
        say("--lesson", start.lesson);
        say("--step", start.step == "0" ? "" : start.step);
        say("--scene", start.scene);
    }

    std::vector<std::string> words() {
        say_settings();
        say_vertices();
        if (to_.cursor != from_.cursor) say("--to", to_.cursor ? to_text(*to_.cursor) : "end");
        say_selection();
        if (to_.tab != from_.tab) say("--tab", session_.tab);
        if (to_.view != from_.view) {
            say("--view", view_names()[static_cast<std::size_t>(session_.view)]);
        }
        say_overlays();
        if (to_.depth_range != from_.depth_range) {
            say("--depth-range", to_.depth_range ? to_text(*to_.depth_range) : "none");
        }
        say_canvas();
        say_second_run();
        return words_;
    }

  private:
    void say(const char* option, std::string_view value) {
        if (value.empty()) return;
        words_.emplace_back(option);
        words_.emplace_back(value);
    }

    void say_settings() {
        for (const RunDifference& change : run_differences(base_.settings, session_.settings)) {
            if (change.setting == "stage") {
                say("--stage", change.b);
            } else {
                say("--set", std::string(change.setting).append("=").append(change.b));
            }
        }
    }

    void say_vertices() {
        for (const PlacedTriangle& placed : moved_triangles(*session_.scene, *base_.scene))
            say("--vertices", to_text(placed));
    }

    void say_selection() {
        if (to_.triangle != from_.triangle) say("--triangle", text_of(to_.triangle));
        if (to_.row != from_.row) say("--row", text_of(to_.row));
        if (to_.vertex != from_.vertex) say("--vertex", text_of(to_.vertex));
        if (to_.pixel == from_.pixel) return;
        std::string pixel = "none";
        if (to_.pixel) {
            pixel = std::to_string(to_.pixel->x).append(",").append(std::to_string(to_.pixel->y));
        }
        say("--pixel", pixel);
    }

    void say_overlays() {
        if (to_.overlays == from_.overlays) return;
        if (!to_.overlays) say("--overlay", "none");
        for (const OverlayInfo& info : overlay_list()) {
            if (session_.overlays.has(info.overlay)) say("--overlay", info.name);
        }
    }

    void say_canvas() {
        if (to_.grid != from_.grid) say("--grid", session_.canvas.grid ? "on" : "off");
        // Where a lesson names no centre, it follows the pixel or the size of the picture.
        const bool is_same = to_.zoom == from_.zoom && to_.centre == from_.centre &&
                             to_.pixel == from_.pixel &&
                             session_.settings.viewport == base_.settings.viewport;
        if (is_same) return;
        if (to_.zoom) {
            say("--zoom", number_text(*to_.zoom));
            say("--centre", to_text(*to_.centre));
        } else if (from_.zoom) {
            say("--zoom", "fit");
        }
    }

    void say_second_run() {
        const Settings& a = session_.settings;
        const std::optional<Settings>& b = session_.other;
        if (!b && base_.other) say("--b", "none");
        if (b && !(b == base_.other && a == base_.settings)) {
            for (const RunDifference& difference : run_differences(a, *b))
                say("--b", std::string(difference.setting).append("=").append(difference.b));
            if (a == *b) say("--b", "stage=" + value_text(*find_setting("stage"), a));
        }
        if (to_.compare_view != from_.compare_view) {
            say("--compare-view",
                compare_view_names()[static_cast<std::size_t>(session_.compare_view)]);
        }
        if (to_.wipe != from_.wipe) {
            say("--wipe", number_text(std::clamp(session_.wipe, 0.0f, 1.0f)));
        }
    }

    const Session& session_;
    Session base_;
    Situation from_, to_;
    std::vector<std::string> words_{"rasterwalk"};
};

} // namespace

std::vector<std::string> command_line_words(const Session& session) {
    if (hides_settings(session)) {
        throw UsageError("the view cannot be copied while a quiz hides its settings.");
    }
    scene_in_file(session); // says why, if there is none
    return Line(session, start_of(session)).words();
}

std::string command_line_text(const Session& session) {
    std::string line;
    for (const std::string& word : command_line_words(session))
        line.append(line.empty() ? "" : " ").append(shell_quoted(word));
    return line;
}

std::string shell_quoted(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789_./,=:+@%-";
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) {
        if (c == '\'') {
            quoted += "'\\''";
        } else {
            quoted += c;
        }
    }
    return quoted + "'";
}

} // namespace rasterwalk
