#include "settings/preset.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"
#include "base/toml_input.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

Preset read_preset(const TomlInput& input) {
    input.allow_only({"name", "about", "set"});
    Preset preset{input.text("name"), input.text("about"), {}};
    for (const toml::node& node : input.list("set")) {
        const auto* text = node.as_string();
        if (text == nullptr)
            input.fail(node, "each entry of 'set' must be text, like "
                             "\"name=value\".");
        const std::string& assignment = text->get();
        try {
            Settings tried;
            set_from_text(tried, assignment);
        } catch (const UsageError& error) {
            input.fail(node, error.what());
        }
        const std::size_t place = assignment.find('=');
        std::string name = assignment.substr(0, place);
        name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
        preset.values.emplace_back(std::move(name), assignment.substr(place + 1));
    }
    return preset;
}

std::vector<std::string_view> preset_names(const std::vector<Preset>& presets) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets)
        names.push_back(preset.name);
    return names;
}

} // namespace

std::vector<Preset> parse_presets(std::string_view text, const std::string& path) {
    const auto read = [](const TomlInput& table, const std::vector<Preset>& before) {
        Preset preset = read_preset(table);
        for (const Preset& other : before) {
            if (other.name == preset.name) {
                table.fail("there are two presets named '" + preset.name + "'.");
            }
        }
        return preset;
    };
    return parse_tables<Preset>(text, path, "preset", "the file of presets", read);
}

std::vector<Preset> read_presets(const std::string& path) {
    return parse_presets(read_file(path), path);
}

void apply_preset(const Preset& preset, Settings& settings) {
    for (const auto& [name, value] : preset.values) {
        if (const Setting* setting = find_setting(name)) set_value(settings, *setting, value);
    }
}

const Preset& find_preset(const std::vector<Preset>& presets, std::string_view name) {
    for (const Preset& preset : presets) {
        if (preset.name == name) return preset;
    }
    const std::vector<std::string_view> names = preset_names(presets);
    std::string known;
    for (const std::string_view one : names)
        known.append(known.empty() ? "" : ", ").append(one);
    throw UsageError("there is no preset '" + std::string(name) + "'; the presets are: " + known +
                     "." + did_you_mean(name, names));
}

} // namespace rasterwalk
