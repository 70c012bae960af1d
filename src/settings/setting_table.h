#pragma once

// The single table of named settings. It serves the controls on the screen, `--set name=value`,
// links in lessons, presets, state files and tests: whatever one of them can set, all can.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "base/limits.h"
#include "settings/settings.h"

namespace rasterwalk {

/// What is read from a setting whose parts have no word in common.
inline constexpr int no_word = -1;

/// One word out of a few.
struct ChoiceSetting {
    std::span<const std::string_view> words;
    int (*read)(const Settings&); ///< index of the word, or no_word
    void (*write)(Settings&, int index);
};

/// A real number.
struct NumberSetting {
    float& (*value)(Settings&);
    float smallest, largest;
    float drag_step; ///< change per pixel of mouse movement
};

/// A whole number.
struct WholeSetting {
    int& (*value)(Settings&);
    int smallest, largest;
    int step = 1; ///< the values are smallest, smallest + step, ... largest
};

/// The largest value of the setting that is not above a number; the smallest if all are.
int allowed_value(const WholeSetting& kind, int number);

/// Three real numbers: `0,-0.5,-0.7`.
struct VectorSetting {
    glm::vec3& (*value)(Settings&);
    float smallest, largest;
    float drag_step;
    bool is_colour; ///< red green blue; a single number stands for all three
};

/// A size in pixels: `500x500`.
struct SizeSetting {
    Viewport& (*value)(Settings&);
    int largest; ///< of either side; the smallest is 1
};

/// The window on the near plane that fills the picture: `auto`, or left,right,bottom,top.
struct BoxSetting {
    std::optional<ViewBox>& (*value)(Settings&);
    float smallest, largest; ///< of each number
    float least_side;        ///< the smallest width and height
    float drag_step;
};

/// Is every number in range, and the window wide and high enough? False for NaN.
bool is_allowed(const ViewBox& box, const BoxSetting& kind);

/// What ties a setting to others and to the scene; most have no ties.
struct SettingTies {
    /// The whole that sets this one too: `rounding` sets `vertex_rounding` and `line_rounding`. It
    /// comes before its parts. Empty: none does.
    std::string_view part_of{};
    /// The setting that now has words which this one used to take; given here, they set that one.
    /// Empty: no such words.
    std::string_view words_moved_to{};
    /// Of no use in a scene for which this is false; null: of use in all.
    bool (*needs_scene)(const Scene&) = nullptr;
    /// Of no use while this is false for the other settings; null: always of use.
    bool (*needs)(const Settings&) = nullptr;
    /// Chooses an engine, or is one's own: no rule of the steps, whose picture does not depend on
    /// it.
    bool is_of_engine = false;
};

/// One setting: its name, its meaning, its values.
struct Setting {
    std::string_view name;    ///< lower_case with dots: `light.power`
    std::string_view title;   ///< in a student's words: "Lamp power"
    std::string_view group;   ///< its heading on the sheet of settings
    std::string_view help;    ///< one sentence
    std::string_view section; ///< section of the lab
    std::string_view unit;    ///< "pixels", "radians" ...; empty for words
    std::variant<ChoiceSetting, NumberSetting, WholeSetting, VectorSetting, SizeSetting, BoxSetting>
        kind;
    SettingTies ties{};
};

/// Every setting, in the order of the sheet of settings.
std::span<const Setting> setting_table();

/// The setting with this name, or null.
const Setting* find_setting(std::string_view name);

/// Does this setting have a use in the scene?
bool is_of_use(const Setting& setting, const Scene& scene);
/// The same, given the other settings.
bool is_of_use(const Setting& setting, const Scene& scene, const Settings& settings);

/// A setting's value in the text form that set_value reads; the shortest numbers that read back as
/// the same bits. Empty if its parts have no word in common.
std::string value_text(const Setting& setting, const Settings& settings);

/// Does the setting have the same value in both?
bool has_same_value(const Setting& setting, const Settings& a, const Settings& b);

/// Is the setting a part, and does its whole have this word too?
bool is_word_of_whole(const Setting& part, std::string_view word);

/// Is the setting a part, and does it have the value that its whole sets?
bool follows_from_whole(const Setting& part, const Settings& settings);

/// Must a list of what differs in b name this setting? Not if its whole is in the list and sets it
/// too. Setting what is listed, in the order of the table, turns a into b.
bool must_be_listed(const Setting& setting, const Settings& a, const Settings& b);

/// The setting that this one means with a value: a different one if the word has moved.
const Setting& meant_setting(const Setting& setting, std::string_view value);

/// Gives the setting in `to` its value in `from`, if it has one.
void copy_value(const Setting& setting, const Settings& from, Settings& to);

/// Which values the setting takes: "truncate, floor or round", "a number from 1 to 100000".
std::string allowed_text(const Setting& setting);

/// Sets one setting from text. Throws UsageError with a sentence that names the setting, the value
/// and the allowed values: for an unknown word, or a number that is malformed, not finite or out of
/// range.
void set_value(Settings& settings, const Setting& setting, std::string_view value);

/// A setting and its new value.
struct Assignment {
    const Setting* setting = nullptr;
    std::string_view value;
};

/// Reads `name=value`, with or without blanks. Old spellings are read as today's:
/// `behind_camera=left_out` is `clip=leave_out`. For an unknown name, throws UsageError that
/// suggests the nearest known one.
Assignment read_assignment(std::string_view text);

/// Sets one setting from `name=value`.
void set_from_text(Settings& settings, std::string_view assignment);

/// Brings every number and vector back into the range of its setting; NaN becomes the smallest. For
/// drags and held keys, which change settings directly.
void clamp_to_ranges(Settings& settings);

} // namespace rasterwalk
