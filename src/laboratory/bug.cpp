#include "laboratory/bug.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/letter_case.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

Assignments read_named_assignments(const TomlInput& input, std::string_view key) {
    Assignments values;
    for (const toml::node& node : input.list(key)) {
        const auto* text = node.as_string();
        if (text == nullptr) {
            input.fail(node,
                       fmt::format("each entry of '{}' must be text, like \"name=value\".", key));
        }
        const std::string& assignment = text->get();
        try {
            Settings tried;
            set_from_text(tried, assignment);
        } catch (const UsageError& error) {
            input.fail(node, error.what());
        }
        // By its name in the table, whatever blanks are around it.
        const Assignment read = read_assignment(assignment);
        values.emplace_back(read.setting->name, read.value);
    }
    return values;
}

/// B, a number, and a letter if there are variants.
bool is_id(std::string_view id) {
    constexpr std::size_t longest = 5;
    if (id.size() < 2 || id.size() > longest || id.front() != 'B') return false;
    std::string_view number = id.substr(1);
    if (number.size() > 1 && number.back() >= 'a' && number.back() <= 'z') number.remove_suffix(1);
    return std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Is it a file in the folder of scenes and nowhere else?
bool is_scene_path(std::string_view path) {
    return path.starts_with("scenes/") && path.ends_with(".toml") &&
           path.find("..") == std::string_view::npos &&
           std::count(path.begin(), path.end(), '/') == 1;
}

Bug read_bug(const TomlInput& input) {
    input.allow_only({"id", "name", "sentence", "symptom", "look", "cure", "section", "lesson",
                      "code", "scene", "set", "against"});
    Bug bug;
    bug.id = input.text("id");
    if (!is_id(bug.id)) {
        input.fail(*input.find("id"), "'id' must be B and a number, with a letter for variants, "
                                      "like \"B9\".");
    }
    bug.name = input.text("name");
    bug.sentence = input.text("sentence");
    bug.symptom = input.text("symptom");
    bug.look = input.text("look");
    bug.cure = input.text("cure");
    bug.section = input.text("section");
    bug.lesson = input.text_or_empty("lesson");
    bug.code = input.text_or_empty("code");
    bug.scene = input.text("scene");
    if (!is_scene_path(bug.scene)) {
        input.fail(*input.find("scene"), "'scene' must be a file in this folder, like "
                                         "\"scenes/name.toml\".");
    }
    bug.set = read_named_assignments(input, "set");
    if (bug.set.empty()) input.fail(*input.find("set"), "'set' must change something.");
    if (input.find("against") != nullptr) bug.against = read_named_assignments(input, "against");
    return bug;
}

void assign(const Assignments& values, Settings& settings) {
    for (const auto& [name, value] : values) {
        if (const Setting* setting = find_setting(name)) set_value(settings, *setting, value);
    }
}

} // namespace

std::vector<Bug> parse_bugs(std::string_view text, const std::string& path) {
    const auto read = [](const TomlInput& table, const std::vector<Bug>& before) {
        Bug bug = read_bug(table);
        for (const Bug& other : before) {
            if (other.id == bug.id) table.fail("there are two bugs with the id '" + bug.id + "'.");
        }
        return bug;
    };
    return parse_tables<Bug>(text, path, "bug", "the file of bugs", read);
}

std::vector<Bug> read_bugs(const std::string& path) {
    return parse_bugs(read_file(path), path);
}

std::vector<Bug> read_bugs() {
    return read_bugs(lessons_folder() + "/bugs.toml");
}

const Bug& find_bug(const std::vector<Bug>& bugs, std::string_view id) {
    std::vector<std::string_view> ids;
    for (const Bug& bug : bugs) {
        if (in_small_letters(bug.id) == in_small_letters(id)) return bug;
        ids.push_back(bug.id);
    }
    constexpr std::size_t longest = 20;
    throw UsageError("there is no bug '" + std::string(id.substr(0, longest)) +
                     "'; 'rasterwalk bugs' lists them." + did_you_mean(id, ids));
}

const Bug* bug_of_id(const std::vector<Bug>& bugs, std::string_view id) {
    const auto found =
        std::find_if(bugs.begin(), bugs.end(), [&](const Bug& bug) { return bug.id == id; });
    return found == bugs.end() ? nullptr : &*found;
}

Settings correct_run(const Bug& bug, const Settings& base) {
    Settings settings = base;
    assign(bug.against, settings);
    // The stage is not a mistake: both runs must get that far.
    for (const auto& [name, value] : bug.set) {
        if (name == "stage") assign({{name, value}}, settings);
    }
    return settings;
}

Settings wrong_run(const Bug& bug, const Settings& base) {
    Settings settings = correct_run(bug, base);
    assign(bug.set, settings);
    return settings;
}

Settings with_handout_rules(const Settings& settings) {
    Settings rules;
    set_step(rules, step_of(settings));
    rules.camera = settings.camera;
    rules.light = settings.light;
    rules.viewport = settings.viewport;
    return rules;
}

void apply_bug(const Bug& bug, Session& session) {
    end_comparison(session);
    const Settings base = with_handout_rules(session.a.settings);
    show_bug(bug.id, wrong_run(bug, base), correct_run(bug, base), session);
}

void show_bug(const std::string& id, const Settings& wrong, const Settings& correct,
              Session& session) {
    end_comparison(session);
    const Run before = session.a;
    session.a.settings = wrong;
    compare_with(session, correct);
    session.replaced = ReplacedRun{before, session.a, nullptr, id};
}

void open_bug(const Bug& bug, Session& session) {
    Scene scene = read_scene_file(lessons_folder() + "/" + bug.scene);
    end_comparison(session);
    const Run before = session.a;
    const std::shared_ptr<const Scene> before_scene = session.scene;
    set_scene(session, std::move(scene));
    apply_bug(bug, session);
    session.replaced->before = before;
    if (session.scene != before_scene) session.replaced->before_scene = before_scene;
}

bool is_on(const Session& session, std::string_view bug) {
    return session.b.has_value() && session.replaced && session.replaced->bug == bug;
}

} // namespace rasterwalk
