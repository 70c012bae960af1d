#include "cli/commands.h"

#include <algorithm>
#include <ostream>

#include "cli/json.h"
#include "laboratory/bug.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// A heading for each group, and under it each setting with its value and what it means.
void print_settings(const Settings& settings, const Settings& defaults, std::ostream& out) {
    std::string_view group;
    for (const Setting& setting : setting_table()) {
        if (setting.group != group) {
            out << (group.empty() ? "" : "\n") << setting.group << '\n';
            group = setting.group;
        }
        const std::string value = value_text(setting, settings);
        const std::string usual = value_text(setting, defaults);
        out << "  " << setting.name << '=' << value;
        if (value != usual) out << "   (default: " << usual << ')';
        out << "\n      " << setting.help << "\n      Takes " << allowed_text(setting);
        if (!setting.unit.empty()) out << "; in " << setting.unit;
        out << ".\n";
    }
}

toml::table to_json(const Settings& settings, const Settings& defaults) {
    toml::array list;
    for (const Setting& setting : setting_table()) {
        list.push_back(toml::table{{"name", setting.name},
                                   {"value", value_text(setting, settings)},
                                   {"default", value_text(setting, defaults)},
                                   {"takes", allowed_text(setting)},
                                   {"group", setting.group},
                                   {"help", setting.help},
                                   {"section", setting.section},
                                   {"unit", setting.unit}});
    }
    return toml::table{{"settings", std::move(list)}};
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
    toml::array list;
    for (const Preset& preset : presets) {
        toml::array values;
        for (const auto& [name, value] : preset.values)
            values.push_back(name + "=" + value);
        if (!options.json) {
            out << preset.name << "\n    " << preset.about << '\n';
            for (const toml::node& value : values) {
                out << "    " << value.value_or(std::string()) << '\n';
            }
        }
        list.push_back(toml::table{
            {"name", preset.name}, {"about", preset.about}, {"set", std::move(values)}});
    }
    if (options.json) print_json(toml::table{{"presets", std::move(list)}}, out);
}

namespace {

toml::array to_json(const Assignments& values) {
    toml::array list;
    for (const auto& [name, value] : values)
        list.push_back(name + "=" + value);
    return list;
}

/// Continues after line breaks under the text's beginning.
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
    toml::array list;
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
        }
        list.push_back(toml::table{{"id", bug.id},
                                   {"name", bug.name},
                                   {"sentence", bug.sentence},
                                   {"symptom", bug.symptom},
                                   {"look", bug.look},
                                   {"cure", bug.cure},
                                   {"section", bug.section},
                                   {"code", bug.code},
                                   {"scene", bug.scene},
                                   {"set", to_json(bug.set)},
                                   {"against", to_json(bug.against)}});
    }
    if (options.json) print_json(toml::table{{"bugs", std::move(list)}}, out);
}

} // namespace rasterwalk
