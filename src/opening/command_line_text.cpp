#include "opening/command_line_text.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "opening/opened_view.h"
#include "session/content.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

std::string absolute_path(const std::string& path) {
    std::error_code fault;
    const fs::path absolute = fs::absolute(path, fault);
    return fault ? path : absolute.lexically_normal().string();
}

/// A scene of the program is named relative to the folder of the lessons, so that the line means
/// the same on every machine.
std::string name_of_scene(const std::string& path) {
    const std::optional<std::string> name = name_in_lessons_folder(path);
    if (name && is_same_file(find_scene_file(*name), path)) return *name;
    return absolute_path(path);
}

/// Lesson and step, or a scene.
ViewOptions start_without_texture(const Session& session) {
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
            options = {}; // the lesson has changed
        }
    }
    const std::string usual = lessons_folder() + "/" + std::string(usual_scene);
    if (!is_same_file(usual, session.scene->path)) {
        options.scene = name_of_scene(session.scene->path);
    }
    return options;
}

/// The beginning of the line: the same, and the image that is laid on the scene.
ViewOptions start_of(const Session& session) {
    ViewOptions options = start_without_texture(session);
    const std::string& texture = session.scene->applied_texture;
    if (!texture.empty()) options.texture = name_of_scene(texture);
    return options;
}

/// The words of the line for what differs from its beginning.
class Line {
  public:
    Line(const Session& session, const ViewOptions& start)
        : session_(session), base_(open_view(start)), from_(state_of(base_, scene_in_file(base_))),
          to_(state_of(session, scene_in_file(session))) {
        say("--lesson", start.lesson);
        say("--step", start.step == "0" ? "" : start.step);
        say("--scene", start.scene);
        say("--texture", start.texture);
    }

    std::vector<std::string> words() {
        add_settings();
        const ViewChange change{base_, session_, from_, to_};
        for (const ViewField* field : view_table_drawn_first()) {
            if (!field->words) continue;
            for (const std::string& word : field->words(change))
                say(option_name(*field), word);
        }
        return words_;
    }

  private:
    void say(const std::string& option, std::string_view value) {
        if (value.empty()) return;
        words_.push_back(option);
        words_.emplace_back(value);
    }

    void add_settings() {
        for (const RunDifference& change : run_differences(base_.a.settings, session_.a.settings)) {
            if (change.setting == "stage") {
                say("--stage", change.b);
            } else {
                say("--set", fmt::format("{}={}", change.setting, change.b));
            }
        }
    }

    const Session& session_;
    Session base_;
    ViewState from_, to_;
    std::vector<std::string> words_{"rasterwalk"};
};

} // namespace

std::vector<std::string> command_line_words(const Session& session) {
    if (hides_settings(session)) {
        throw UsageError("the view cannot be copied while a quiz is hiding its settings.");
    }
    scene_in_file(session); // throws with a reason if there is none
    return Line(session, start_of(session)).words();
}

std::string command_line_text(const Session& session) {
    std::vector<std::string> words = command_line_words(session);
    for (std::string& word : words)
        word = shell_quoted(word);
    return fmt::format("{}", fmt::join(words, " "));
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
