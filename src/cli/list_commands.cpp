#include "cli/commands.h"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "cli/json.h"
#include "laboratory/bug.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// A heading for each group, and under it each setting with its value and meaning.
void print_settings(const Settings& settings, const Settings& defaults, std::ostream& out) {
    std::string_view group;
    for (const Setting& setting : setting_table()) {
        if (setting.group != group) {
            out << (group.empty() ? "" : "\n") << setting.group << '\n';
            group = setting.group;
        }
        const std::string value = value_text(setting, settings);
        const std::string usual = value_text(setting, defaults);
        if (value.empty()) continue; // its parts follow
        out << "  " << setting.name << '=' << value;
        if (value != usual) out << "   (default: " << usual << ')';
        out << "\n      " << setting.help << "\n      Takes " << allowed_text(setting);
        if (!setting.unit.empty()) out << "; in " << setting.unit;
        out << ".\n";
    }
}

Json to_json(const Settings& settings, const Settings& defaults) {
    Json list = Json::array();
    for (const Setting& setting : setting_table()) {
        if (value_text(setting, settings).empty()) continue; // its parts follow
        list.push_back({{"default", value_text(setting, defaults)},
                        {"group", setting.group},
                        {"help", setting.help},
                        {"name", setting.name},
                        {"section", setting.section},
                        {"takes", allowed_text(setting)},
                        {"unit", setting.unit},
                        {"value", value_text(setting, settings)}});
    }
    return {{"settings", std::move(list)}};
}

/// "name=value" for each.
std::vector<std::string> assignment_texts(const Assignments& values) {
    std::vector<std::string> texts;
    for (const auto& [name, value] : values)
        texts.push_back(fmt::format("{}={}", name, value));
    return texts;
}

} // namespace

void settings_command(const SettingsOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Settings defaults = default_settings(*session.scene);
    if (options.json) {
        print_json(to_json(session.a.settings, defaults), out);
    } else {
        print_settings(session.a.settings, defaults, out);
    }
}

void presets_command(const PresetsOptions& options, std::ostream& out) {
    const std::vector<Preset> presets = read_presets(lessons_folder() + "/presets.toml");
    Json list = Json::array();
    for (const Preset& preset : presets) {
        const std::vector<std::string> values = assignment_texts(preset.values);
        if (!options.json) {
            out << preset.name << "\n    " << preset.about << '\n';
            for (const std::string& value : values)
                out << "    " << value << '\n';
        }
        list.push_back(
            {{"about", preset.about}, {"name", preset.name}, {"set", texts_to_json(values)}});
    }
    if (options.json) print_json({{"presets", std::move(list)}}, out);
}

namespace {

/// Continues after line breaks below the text's start.
std::string indented(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c;
        if (c == '\n') result += "             ";
    }
    return result;
}

} // namespace

void bugs_command(const BugsOptions& options, std::ostream& out) {
    Json list = Json::array();
    for (const Bug& bug : read_bugs()) {
        if (!options.json) {
            out << (list.empty() ? "" : "\n") << bug.id << "  " << bug.name << "\n    "
                << bug.sentence << "\n    Symptom: " << bug.symptom << "\n    Cure:    " << bug.cure
                << '\n';
            if (!bug.code.empty())
                out << "    Code:   "
                    << " " << indented(bug.code) << '\n';
            out << "    Set:    ";
            for (const auto& [name, value] : bug.set)
                out << ' ' << name << '=' << value;
            if (!bug.against.empty()) out << "\n    Against:";
            for (const auto& [name, value] : bug.against)
                out << ' ' << name << '=' << value;
            out << "\n    Scene:   " << bug.scene << '\n';
            if (!bug.lesson.empty()) out << "    Lesson:  " << bug.lesson << '\n';
        }
        list.push_back({{"against", texts_to_json(assignment_texts(bug.against))},
                        {"code", bug.code},
                        {"cure", bug.cure},
                        {"id", bug.id},
                        {"lesson", bug.lesson},
                        {"look", bug.look},
                        {"name", bug.name},
                        {"scene", bug.scene},
                        {"section", bug.section},
                        {"sentence", bug.sentence},
                        {"set", texts_to_json(assignment_texts(bug.set))},
                        {"symptom", bug.symptom}});
    }
    if (options.json) print_json({{"bugs", std::move(list)}}, out);
}

} // namespace rasterwalk
