#include "opening/state_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/faults.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "facts/facts.h"
#include "lessons/lesson_blocks.h"
#include "session/bench.h"
#include "session/canvas_view.h"
#include "session/content.h"
#include "session/depth_view.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "view/shown_situation.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Where `file` lies below `folder`, in this spelling; empty if it does not.
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

/// How the file of a view names another file: such that find_lesson_file() finds it again.
std::string name_from(const std::string& folder, const std::string& file, const char* what) {
    for (const std::string& root : {lessons_folder(), folder}) {
        const std::string name = name_within(root, file);
        if (name.empty()) continue;
        if (!is_utf8(name)) {
            throw UsageError(std::string("the view cannot be saved: it names its ") + what +
                             ", and " + in_quotes(name) +
                             " is not UTF-8 text; give the file another name.");
        }
        try {
            if (is_same_file(find_lesson_file(folder, name), file)) return name;
        } catch (const Error&) {
            // Not by this name.
        }
    }
    std::error_code ignored;
    const std::string home = fs::absolute(folder_of(file), ignored).lexically_normal().string();
    throw UsageError(std::string("the view can only be saved beside its ") + what + ", in " + home +
                     ", or in a folder above.");
}

std::string name_of_lesson(const Session& session, const std::string& folder) {
    if (session.lesson.empty() || session.lesson_folder.empty()) return session.lesson;
    return name_from(folder, session.lesson_folder + "/" + session.lesson + ".md", "lesson");
}

/// A key in its own line, so that a fault can be found by its line.
class Lines {
  public:
    void add(const char* key, const toml::node& value) {
        out_ << key << " = " << toml::node_view<const toml::node>(value) << '\n';
    }
    void text(const char* key, std::string_view value) {
        add(key, toml::value<std::string>(std::string(value)));
    }
    void number(const char* key, std::optional<int> value) {
        if (value) add(key, toml::value<std::int64_t>(*value));
    }
    void texts(const char* key, const std::vector<std::string>& values) {
        if (values.empty()) {
            out_ << key << " = []\n";
            return;
        }
        out_ << key << " = [\n";
        for (const std::string& value : values)
            out_ << "    " << toml::node_view<const toml::node>(toml::value<std::string>(value))
                 << ",\n";
        out_ << "]\n";
    }
    void comment(std::string_view words) { out_ << "# " << words << '\n'; }
    void plain(const char* key, std::string_view value) { out_ << key << " = " << value << '\n'; }
    std::string str() const { return out_.str(); }

  private:
    std::ostringstream out_;
};

void add_situation(const Situation& s, Lines& lines) {
    if (!s.set.empty()) lines.texts("set", s.set);
    if (s.cursor) lines.text("cursor", to_text(*s.cursor));
    if (s.pixel) {
        lines.text("pixel",
                   std::to_string(s.pixel->x).append(",").append(std::to_string(s.pixel->y)));
    }
    lines.number("triangle", s.triangle);
    lines.number("row", s.row);
    lines.number("vertex", s.vertex);
    if (s.tab) lines.text("tab", *s.tab);
    if (s.view) lines.text("view", view_names()[static_cast<std::size_t>(*s.view)]);
    if (s.overlays) {
        std::vector<std::string> names;
        for (const OverlayInfo& info : overlay_list()) {
            if (s.overlays->has(info.overlay)) names.emplace_back(info.name);
        }
        lines.texts("overlays", names);
    }
    if (s.zoom) lines.plain("zoom", number_text(*s.zoom));
    if (s.centre) lines.text("centre", to_text(*s.centre));
    if (s.grid) lines.plain("grid", *s.grid ? "true" : "false");
    if (s.compare) lines.texts("compare", *s.compare);
    if (s.compare_view) {
        lines.text("compare_view", compare_view_names()[static_cast<std::size_t>(*s.compare_view)]);
    }
    if (s.wipe) lines.plain("wipe", number_text(*s.wipe));
    if (s.depth_range) lines.text("depth_range", to_text(*s.depth_range));
    std::vector<std::string> placed;
    for (const PlacedTriangle& triangle : s.vertices)
        placed.push_back(to_text(triangle));
    if (!placed.empty()) lines.texts("vertices", placed);
}

} // namespace

std::string view_text(const Session& session, const std::string& path) {
    if (hides_settings(session)) {
        throw UsageError("the view cannot be saved while a quiz hides its settings.");
    }
    const std::string folder = folder_of(path);
    const Scene original = scene_in_file(session);
    Lines lines;
    lines.comment("A view of Rasterwalk, to be opened with it.");
    lines.text("scene", name_from(folder, session.scene->path, "scene"));
    const std::string lesson = name_of_lesson(session, folder);
    if (!lesson.empty()) {
        lines.text("lesson", lesson);
        lines.number("step", session.step);
    }
    const Situation situation = situation_of(session, original);
    if (situation.vertices.size() > most_placed_triangles) {
        throw UsageError("more than " + std::to_string(most_placed_triangles) +
                         " triangles were moved: too many to be saved.");
    }
    add_situation(situation, lines);
    return lines.str();
}

void write_view(const Session& session, const std::string& path) {
    write_file(path, view_text(session, path));
}

SavedView parse_view(std::string_view text, const std::string& path) {
    SavedView view;
    view.path = path;
    if (text.size() > largest_view_file)
        throw InputError(path + ": a view is no larger than 1 MB.");
    toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the view");
    view.scene = input.text("scene");
    view.lesson = input.text_or_empty("lesson");
    input.read("step", view.step, 0, most_lesson_steps);
    if (input.find("step") != nullptr && view.lesson.empty()) {
        input.fail(*input.find("step"), "'step' belongs to a 'lesson', and there is none.");
    }
    if (input.find("point_at") != nullptr) {
        input.fail(*input.find("point_at"), "the view has no 'point_at'.");
    }
    std::map<std::string, int, std::less<>> lines;
    for (const char* key : {"scene", "lesson", "step"}) {
        if (const toml::node* node = input.find(key)) {
            lines[key] = static_cast<int>(node->source().begin.line);
        }
    }
    root.erase("lesson");
    root.erase("step");
    FaultList faults(path);
    view.situation = read_situation(root, 1, faults, "the view");
    for (const auto& [key, line] : lines)
        view.situation.lines[key] = line;
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
        throw InputError(view.path, view.situation.line_of(key),
                         "there is no file " + in_quotes(name) +
                             " in the folder of this view, nor is it one of the program's own.");
    }
}

} // namespace rasterwalk
