#pragma once

// The one table of named settings. It serves the controls on the screen, `--set name=value`, links
// in lessons, presets, state files and tests: whatever one of them can set, all can.

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

/// Read from a setting whose parts have no word in common.
inline constexpr int no_word = -1;

/// One of a few words.
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
};

/// Three real numbers: `0,-0.5,-0.7`.
struct VectorSetting {
    glm::vec3& (*value)(Settings&);
    float smallest, largest;
    float drag_step;
    bool is_colour; ///< red green blue; one number stands for all three
};

/// A size in pixels: `500x500`.
struct SizeSetting {
    Viewport& (*value)(Settings&);
    int largest; ///< of either side; the smallest is 1
};

/// The window on the near plane, which fills the picture: `auto`, or left,right,bottom,top.
struct BoxSetting {
    std::optional<ViewBox>& (*value)(Settings&);
    float smallest, largest; ///< of each number
    float least_side;        ///< width and height at least
    float drag_step;
};

/// Is every number in range, and the window as wide and high as it must be? Not with NaN.
bool is_allowed(const ViewBox& box, const BoxSetting& kind);

/// One setting: what it is called, what it means, which values it takes.
struct Setting {
    std::string_view name;    ///< lower_case with dots: `light.power`
    std::string_view title;   ///< in the words of a student: "Lamp power"
    std::string_view group;   ///< heading it stands under on the sheet of settings
    std::string_view help;    ///< one sentence
    std::string_view section; ///< section of the lab
    std::string_view unit;    ///< "pixels", "radians" ...; empty for words
    std::variant<ChoiceSetting, NumberSetting, WholeSetting, VectorSetting, SizeSetting, BoxSetting>
        kind;
    /// The setting that says this one as well: `rounding` says `vertex_rounding` and
    /// `line_rounding`. It stands before its parts. Empty: none does.
    std::string_view part_of{};
    /// The setting that has the words which this one took once; given here, they set it. Empty: no
    /// such words.
    std::string_view words_moved_to{};
    bool needs_texture = false;    ///< of no use to a scene without textures
    bool needs_world = false;      ///< of no use to a scene in pixels
    bool needs_alpha = false;      ///< of no use to a scene without anything half transparent
    bool needs_normal_map = false; ///< of no use to a scene without normal maps
    /// Of no use while other settings are so that this is false; null: always of use.
    bool (*needs)(const Settings&) = nullptr;
    bool needs_texture_alpha = false; ///< of no use to a scene whose textures are all opaque
};

/// Every setting, in the order of the sheet of settings.
std::span<const Setting> setting_table();

/// The setting of this name, or null.
const Setting* find_setting(std::string_view name);

/// Can the scene use this setting?
bool is_of_use(const Setting& setting, const Scene& scene);
/// The same, with the other settings as they are.
bool is_of_use(const Setting& setting, const Scene& scene, const Settings& settings);

/// A setting's value in the text form that set_value reads; numbers as short as they can be and
/// still be read back as the same bits. Empty if its parts have no word in common.
std::string value_text(const Setting& setting, const Settings& settings);

/// Does the setting have the same value in both?
bool has_same_value(const Setting& setting, const Settings& a, const Settings& b);

/// Is the setting a part, and has its whole this word too?
bool is_word_of_whole(const Setting& part, std::string_view word);

/// Is the setting a part, and does it have the value that its whole says?
bool is_said_by_whole(const Setting& part, const Settings& settings);

/// Must a list of what is different in b name this setting? Not if its whole is in the list and
/// says it too. Setting what is listed, in the order of the table, turns a into b.
bool must_be_said(const Setting& setting, const Settings& a, const Settings& b);

/// The setting that is meant by this one and a value: another one where the word has moved.
const Setting& meant_setting(const Setting& setting, std::string_view value);

/// Gives the setting in `to` the value that it has in `from`, if it has one.
void copy_value(const Setting& setting, const Settings& from, Settings& to);

/// Which values the setting takes: "truncate, floor or round", "a number from 1 to 100000".
std::string allowed_text(const Setting& setting);

/// Sets one setting from text. Throws UsageError with a sentence that names the setting, the value
/// and what it would take: unknown word, no number, not finite, out of range.
void set_value(Settings& settings, const Setting& setting, std::string_view value);

/// A setting and the value that it is to be given.
struct Assignment {
    const Setting* setting = nullptr;
    std::string_view value;
};

/// Reads `name=value`, with blanks or without. What was once spelled otherwise is read as it is
/// spelled today: `behind_camera=left_out` is `clip=leave_out`. An unknown name is answered with
/// the nearest known one, by a UsageError.
Assignment read_assignment(std::string_view text);

/// Sets one setting from `name=value`.
void set_from_text(Settings& settings, std::string_view assignment);

/// Brings every number and vector back into the range that its setting takes; what is no number
/// becomes the smallest. For whatever moves settings by itself: drags, held keys.
void clamp_to_ranges(Settings& settings);

} // namespace rasterwalk
