#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "settings/settings.h"

namespace rasterwalk {

/// A named set of settings; data read from lessons/presets.toml.
struct Preset {
    std::string name;  ///< as on the command line: `visible light`
    std::string about; ///< one sentence
    std::vector<std::pair<std::string, std::string>> values; ///< setting name, value text
};

/// Reads presets and tries each value, so that a wrong one is found here. Throws AccessError, or
/// InputError with file:line.
std::vector<Preset> read_presets(const std::string& path);
std::vector<Preset> parse_presets(std::string_view text, const std::string& path);

/// Sets what the preset names and leaves everything else.
void apply_preset(const Preset& preset, Settings& settings);

/// The preset with this name. Throws UsageError that lists the existing names.
const Preset& find_preset(const std::vector<Preset>& presets, std::string_view name);

} // namespace rasterwalk
