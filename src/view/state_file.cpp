#include "view/state_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/faults.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "session/bench.h"
#include "session/content.h"
#include "session/tabs.h"
#include "view/view_form.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// The path of `file` relative to `folder`, in this spelling; empty if it is not below it.
std::string name_within(const std::string& folder, const std::string& file) {
    std::error_code fault;
    const fs::path root = fs::canonical(folder, fault);
    if (fault) return {};
    const fs::path place = fs::canonical(file, fault);
    if (fault) return {};
    const fs::path relative = place.lexically_relative(root);
    const bool is_below = !relative.empty() && *relative.begin() != "..";
    return is_below ? relative.generic_string() : std::string();
}

/// The name of another file in the file of a view, by which find_lesson_file() finds it again.
std::string name_from(const std::string& folder, const std::string& file, const char* what) {
    for (const std::string& root : {lessons_folder(), folder}) {
        const std::string name = name_within(root, file);
        if (name.empty()) continue;
        if (!is_utf8(name)) {
            throw UsageError(std::string("the view cannot be saved, because it names its ") + what +
                             ", and " + in_quotes(name) + " is not UTF-8 text; rename the file.");
        }
        try {
            if (is_same_file(find_lesson_file(folder, name), file)) return name;
        } catch (const Error&) {
            // Not by this name.
        }
    }
    std::error_code ignored;
    const std::string home = fs::absolute(folder_of(file), ignored).lexically_normal().string();
    throw UsageError(fmt::format("the view can only be saved in the folder of its {}, {}, or in a "
                                 "folder above it.",
                                 what, home));
}

std::string name_of_lesson(const Session& session, const std::string& folder) {
    if (session.lesson.empty() || session.lesson_folder.empty()) return session.lesson;
    return name_from(folder, session.lesson_folder + "/" + session.lesson + ".md", "lesson");
}

/// A key on its own line, so that a fault can be found by its line.
void add_line(std::string& text, std::string_view key, std::string_view value) {
    text += fmt::format("{} = {}\n", key, value);
}

} // namespace

std::string view_text(const Session& session, const std::string& path) {
    if (hides_settings(session)) {
        throw UsageError("the view cannot be saved while a quiz is hiding its settings.");
    }
    const std::string folder = folder_of(path);
    const Scene original = scene_in_file(session);
    std::string text = "# A view of Rasterwalk, to be opened with it.\n";
    add_line(text, "scene", toml_text(name_from(folder, session.scene->path, "scene")));
    const std::string& texture = session.scene->applied_texture;
    if (!texture.empty())
        add_line(text, "texture", toml_text(name_from(folder, texture, "texture")));
    const std::string lesson = name_of_lesson(session, folder);
    if (!lesson.empty()) {
        add_line(text, "lesson", toml_text(lesson));
        add_line(text, "step", std::to_string(session.step));
        if (session.tab_guide.is_own) add_line(text, "own_tab", toml_text(tab_below(session)));
    }
    const ViewState state = state_of(session, original);
    if (state.vertices && state.vertices->size() > most_placed_triangles) {
        throw UsageError(fmt::format("more than {} triangles were moved, which is too many to be "
                                     "saved.",
                                     most_placed_triangles));
    }
    for (const ViewField& field : view_table()) {
        const std::string value = field.write ? field.write(state) : std::string();
        if (!value.empty()) add_line(text, field.key, value);
    }
    return text;
}

void write_view(const Session& session, const std::string& path) {
    write_file(path, view_text(session, path));
}

SavedView parse_view(std::string_view text, const std::string& path) {
    SavedView view;
    view.path = path;
    if (text.size() > largest_view_file)
        throw InputError(path + ": a view may not be larger than 1 MB.");
    toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the view");
    view.scene = input.text("scene");
    view.texture = input.text_or_empty("texture");
    view.lesson = input.text_or_empty("lesson");
    input.read("step", view.step, 0, most_lesson_steps);
    if (input.find("step") != nullptr && view.lesson.empty()) {
        input.fail(*input.find("step"), "'step' needs a 'lesson', but there is none.");
    }
    view.own_tab = input.text_or_empty("own_tab");
    if (const toml::node* const node = input.find("own_tab")) {
        if (view.lesson.empty()) {
            input.fail(*node, "'own_tab' needs a 'lesson', but there is none.");
        }
        if (find_tab(view.own_tab) == nullptr) {
            input.fail(*node, "there is no tab " + in_quotes(view.own_tab) + ".");
        }
    }
    for (const ViewField& field : view_table()) {
        const toml::node* const node = input.find(field.key);
        if (node != nullptr && field.key != "scene" && !field.write) {
            input.fail(*node, "the view has no '" + std::string(field.key) + "'.");
        }
    }
    std::map<std::string, int, std::less<>> lines;
    for (const char* key : {"scene", "texture", "lesson", "step"}) {
        if (const toml::node* node = input.find(key)) {
            lines[key] = static_cast<int>(node->source().begin.line);
        }
    }
    root.erase("texture");
    root.erase("lesson");
    root.erase("step");
    root.erase("own_tab");
    FaultList faults(path);
    view.state = read_view_state(root, 1, faults, "the view");
    for (const auto& [key, line] : lines)
        view.state.lines[key] = line;
    const std::vector<Fault> found = faults.take();
    if (!found.empty()) throw InputError(path, std::max(found[0].line, 1), found[0].sentence);
    return view;
}

SavedView read_view(const std::string& path) {
    return parse_view(read_file(path, largest_view_file), path);
}

std::string find_file(const SavedView& view, const char* key, const std::string& name) {
    try {
        return find_lesson_file(folder_of(view.path), name);
    } catch (const Error&) {
        throw InputError(view.path, view.state.line_of(key),
                         "there is no file " + in_quotes(name) +
                             " in the folder of this view or among the program's own.");
    }
}

} // namespace rasterwalk
