#include "settings/setting_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

constexpr std::string_view rounding_words[] = {"truncate", "floor", "round"};
constexpr std::string_view line_walk_words[] = {"accumulate", "multiply", "exact", "integer_step"};
constexpr std::string_view edge_samples_words[] = {"longest_axis", "rows", "shifted"};
constexpr std::string_view row_start_words[] = {"extreme", "window"};
constexpr std::string_view row_search_words[] = {"indexed", "all_rows"};
constexpr std::string_view empty_rows_words[] = {"skipped", "overflow"};
constexpr std::string_view spans_words[] = {"inclusive", "single_skipped", "last_dropped"};
constexpr std::string_view bounds_words[] = {"inside", "excludes_zero"};
constexpr std::string_view depth_test_words[] = {"inverse_z", "linear_z", "off", "reversed"};
constexpr std::string_view depth_index_words[] = {"row_major", "transposed"};
constexpr std::string_view interpolation_words[] = {"perspective", "affine", "zinv_twice"};
constexpr std::string_view shading_words[] = {"after_depth_test", "before_depth_test"};
constexpr std::string_view rotation_words[] = {"row_vector", "transposed"};
constexpr std::string_view image_axes_words[] = {"right_way", "mirrored"};
constexpr std::string_view behind_camera_words[] = {"left_out", "drawn", "mark_minus_one"};
constexpr std::string_view outside_picture_words[] = {"kept", "clamped"};
constexpr std::string_view light_direction_words[] = {"to_light", "from_light", "not_normalized"};
constexpr std::string_view light_falloff_words[] = {"sphere", "no_4pi", "cubed"};
constexpr std::string_view light_sum_words[] = {"reflectance_times", "reflectance_plus"};
constexpr std::string_view colour_over_one_words[] = {"clamp", "wrap"};

/// 1/z of the nearest thing that a depth buffer may be made to start with, and of the farthest.
constexpr float largest_depth_clear = 1e6f;

std::span<const std::string_view> stage_words() {
    static const auto words = [] {
        std::array<std::string_view, stage_count> names;
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = stage_list()[i].name;
        return names;
    }();
    return words;
}

/// A choice whose words stand in the order of the enumerators of one member of Settings.
template <auto member>
ChoiceSetting choice(std::span<const std::string_view> words) {
    return {words, [](const Settings& settings) { return static_cast<int>(settings.*member); },
            [](Settings& settings, int index) {
                using Enum = std::remove_reference_t<decltype(settings.*member)>;
                settings.*member = static_cast<Enum>(index);
            }};
}

/// The same for a member of the rules of light.
template <auto member>
ChoiceSetting light_choice(std::span<const std::string_view> words) {
    return {words,
            [](const Settings& settings) { return static_cast<int>(settings.light_rules.*member); },
            [](Settings& settings, int index) {
                using Enum = std::remove_reference_t<decltype(settings.light_rules.*member)>;
                settings.light_rules.*member = static_cast<Enum>(index);
            }};
}

std::vector<Setting> make_table() {
    return {
        {"stage", "Stage", "How far along the pipeline the picture is drawn.", "All sections", "",
         choice<&Settings::stage>(stage_words())},
        {"rounding", "Rows and edges",
         "How a real coordinate becomes a whole pixel: int() cuts toward zero.", "Drawing edges",
         "", choice<&Settings::rounding>(rounding_words)},
        {"line_walk", "Rows and edges",
         "How the samples of a line are found: by adding up steps, by multiplying, without error, "
         "or with a step that was divided as int by int.",
         "Drawing edges", "", choice<&Settings::line_walk>(line_walk_words)},
        {"edge_samples", "Rows and edges",
         "How many samples an edge has: as many as its longer axis, one in each row, or "
         "|a − b + 1| where |a − b| + 1 was meant.",
         "Filled triangles", "", choice<&Settings::edge_samples>(edge_samples_words)},
        {"row_start", "Rows and edges",
         "Where the ends of a row stand before its first sample: at ±INT_MAX, or left at the "
         "picture's width and right at 0.",
         "Filled triangles", "", choice<&Settings::row_start>(row_start_words)},
        {"row_search", "Rows and edges",
         "How a sample finds its row in the table: by its number, or by asking every row.",
         "Filled triangles", "", choice<&Settings::row_search>(row_search_words)},
        {"empty_rows", "Rows and edges",
         "What becomes of a row that no sample reached: nothing, or right − left + 1 fragments, "
         "which overflows; carried out under guard.",
         "Filled triangles", "", choice<&Settings::empty_rows>(empty_rows_words)},
        {"spans", "Rows and edges",
         "Which fragments of a row are drawn: both ends too, none in a row of one pixel, or all "
         "but the last.",
         "Filled triangles", "", choice<&Settings::spans>(spans_words)},
        {"depth_test", "Depth and interpolation",
         "What decides which fragment is nearer: 1/z, z interpolated in a straight line, nothing, "
         "or 1/z the wrong way round.",
         "Depth buffer", "", choice<&Settings::depth_test>(depth_test_words)},
        {"depth_clear", "Depth and interpolation",
         "What the depth buffer starts with: 0 is infinitely far, 1 is one unit away.",
         "Depth buffer", "1/z",
         NumberSetting{[](Settings& s) -> float& { return s.depth_clear; }, -largest_depth_clear,
                       largest_depth_clear, 0.01f}},
        {"depth_index", "Depth and interpolation",
         "Which cell of the depth buffer belongs to a pixel: [y][x], or by mistake [x][y].",
         "Depth buffer", "", choice<&Settings::depth_index>(depth_index_words)},
        {"shading", "Depth and interpolation",
         "When a fragment's colour is worked out: only if it is drawn, or always.", "Depth buffer",
         "", choice<&Settings::shading>(shading_words)},
        {"interpolation", "Depth and interpolation",
         "How values between the vertices are found: divided by z on the way, straight across the "
         "picture, or divided by z twice and multiplied once.",
         "Light per pixel", "", choice<&Settings::interpolation>(interpolation_words)},
        {"camera.position", "Camera", "Where the camera stands: x right, y down, z forward.",
         "Moving the camera", "world units",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.camera.position; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"camera.yaw", "Camera", "Turn of the camera about the y axis.", "Moving the camera",
         "radians",
         NumberSetting{[](Settings& s) -> float& { return s.camera.yaw; }, -largest_yaw,
                       largest_yaw, 0.005f}},
        {"camera.pitch", "Camera", "Turn of the camera about the x axis, after the yaw.",
         "Moving the camera", "radians",
         NumberSetting{[](Settings& s) -> float& { return s.camera.pitch; }, -largest_pitch,
                       largest_pitch, 0.005f}},
        {"camera.focal_length", "Camera",
         "Distance from the camera to the picture; twice as long shows everything twice as large.",
         "Drawing points", "pixels",
         NumberSetting{[](Settings& s) -> float& { return s.camera.focal_length; },
                       smallest_focal_length, largest_focal_length, 1.0f}},
        {"rotation", "Camera", "How the camera's rotation R is applied: v R, or by mistake R v.",
         "Moving the camera", "", choice<&Settings::rotation>(rotation_words)},
        {"image_axes", "Camera",
         "The sign of the focal length; a negative one turns the picture by half a turn.",
         "Drawing points", "", choice<&Settings::image_axes>(image_axes_words)},
        {"behind_camera", "Camera",
         "What becomes of vertices on or behind the camera plane: their triangles are left out, "
         "drawn all the same, or marked by the column −1.",
         "Drawing points", "", choice<&Settings::behind_camera>(behind_camera_words)},
        {"outside_picture", "Camera",
         "What becomes of vertices beside the picture: they stay there, or are moved to its "
         "border.",
         "Drawing points", "", choice<&Settings::outside_picture>(outside_picture_words)},
        {"light.position", "Light", "Where the lamp is: x right, y down, z into the picture.",
         "Illumination", "world units",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.position; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"light.power", "Light", "Power of the lamp, which spreads over a sphere of 4 pi r^2.",
         "Illumination", "",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.power; }, 0.0f, largest_power,
                       0.05f, true}},
        {"light.indirect", "Light", "Light that comes from everywhere, the same at every point.",
         "Illumination", "",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.indirect; }, 0.0f,
                       largest_indirect, 0.005f, true}},
        {"light.direction", "Light",
         "The vector whose slant counts: to the lamp at unit length, from the lamp, or as long as "
         "the way.",
         "Illumination", "", light_choice<&LightRules::direction>(light_direction_words)},
        {"light.falloff", "Light", "Over what the power is spread: 4 pi r^2, r^2, or 4 pi r^3.",
         "Illumination", "", light_choice<&LightRules::falloff>(light_falloff_words)},
        {"light.sum", "Light",
         "How the light is put together: reflectance times (D + N), or D plus reflectance.",
         "Illumination", "", light_choice<&LightRules::sum>(light_sum_words)},
        {"viewport.size", "Picture", "Width and height of the picture.", "Drawing points", "pixels",
         SizeSetting{[](Settings& s) -> Viewport& { return s.viewport; }, largest_viewport}},
        {"bounds", "Picture",
         "Which places lie in the picture: those from 0 on, or by mistake only those above 0.",
         "Drawing points", "", choice<&Settings::bounds>(bounds_words)},
        {"colour_over_one", "Picture",
         "What a channel above 1 is shown as: 1, or what is left of it in 8 bits.", "Illumination",
         "", choice<&Settings::colour_over_one>(colour_over_one_words)},
    };
}

std::vector<std::string_view> setting_names() {
    std::vector<std::string_view> names;
    for (const Setting& setting : setting_table())
        names.push_back(setting.name);
    return names;
}

[[noreturn]] void refuse(const Setting& setting, std::string_view value) {
    throw UsageError(std::string(setting.name)
                         .append(" cannot be ")
                         .append(in_quotes(trimmed(value)))
                         .append(": it takes ")
                         .append(allowed_text(setting))
                         .append("."));
}

/// The whole text as a finite number.
std::optional<float> parse_number(std::string_view text) {
    text = trimmed(text);
    float value = 0.0f;
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data(), last, value);
    if (fault != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<int> parse_count(std::string_view text) {
    text = trimmed(text);
    int value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data(), last, value);
    if (fault != std::errc{} || end != last) return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t place = text.find(separator);
        parts.push_back(text.substr(0, place));
        if (place == std::string_view::npos) return parts;
        text.remove_prefix(place + 1);
    }
}

/// Puts a value into the settings: one function for each kind of setting.
struct Writer {
    Settings& settings;
    const Setting& setting;
    std::string_view text;

    float number(std::string_view part, float smallest, float largest) const {
        const std::optional<float> value = parse_number(part);
        if (!value || *value < smallest || *value > largest) refuse(setting, text);
        return *value;
    }

    void operator()(const ChoiceSetting& kind) const {
        const auto found = std::find(kind.words.begin(), kind.words.end(), trimmed(text));
        if (found == kind.words.end()) refuse(setting, text);
        kind.write(settings, static_cast<int>(found - kind.words.begin()));
    }
    void operator()(const NumberSetting& kind) const {
        kind.value(settings) = number(text, kind.smallest, kind.largest);
    }
    void operator()(const VectorSetting& kind) const {
        const std::vector<std::string_view> parts = split(text, ',');
        const bool one_for_all = kind.is_colour && parts.size() == 1;
        if (parts.size() != 3 && !one_for_all) refuse(setting, text);
        glm::vec3 value;
        for (int i = 0; i < 3; ++i) {
            value[i] = number(parts[one_for_all ? 0 : static_cast<std::size_t>(i)], kind.smallest,
                              kind.largest);
        }
        kind.value(settings) = value;
    }
    void operator()(const SizeSetting& kind) const {
        const std::vector<std::string_view> parts = split(text, 'x');
        if (parts.size() != 2) refuse(setting, text);
        const auto side = [&](std::string_view part) {
            const std::optional<int> pixels = parse_count(part);
            if (!pixels || *pixels < 1 || *pixels > kind.largest) refuse(setting, text);
            return *pixels;
        };
        const Viewport size{side(parts[0]), side(parts[1])};
        kind.value(settings) = size;
    }
};

/// The value of a setting as text: one function for each kind of setting.
struct Reader {
    Settings settings;

    std::string operator()(const ChoiceSetting& kind) const {
        return std::string(kind.words[static_cast<std::size_t>(kind.read(settings))]);
    }
    std::string operator()(const NumberSetting& kind) { return number_text(kind.value(settings)); }
    std::string operator()(const VectorSetting& kind) {
        const glm::vec3& value = kind.value(settings);
        if (kind.is_colour && value.x == value.y && value.y == value.z) {
            return number_text(value.x);
        }
        return number_text(value.x) + "," + number_text(value.y) + "," + number_text(value.z);
    }
    std::string operator()(const SizeSetting& kind) {
        const Viewport& size = kind.value(settings);
        return std::to_string(size.width).append("x").append(std::to_string(size.height));
    }
};

/// Compares one setting of two sets of settings: one function for each kind of setting.
struct SameValue {
    Settings a, b;

    bool operator()(const ChoiceSetting& kind) { return kind.read(a) == kind.read(b); }
    template <class Kind>
    bool operator()(const Kind& kind) {
        return kind.value(a) == kind.value(b);
    }
};

/// Copies one setting: one function for each kind of setting.
struct ValueCopy {
    Settings from;
    Settings& to;

    void operator()(const ChoiceSetting& kind) { kind.write(to, kind.read(from)); }
    template <class Kind>
    void operator()(const Kind& kind) {
        kind.value(to) = kind.value(from);
    }
};

std::string range_text(float smallest, float largest) {
    return number_text(smallest).append(" to ").append(number_text(largest));
}

struct AllowedText {
    std::string operator()(const ChoiceSetting& kind) const {
        std::string text;
        for (std::size_t i = 0; i < kind.words.size(); ++i) {
            if (i > 0) text += i + 1 == kind.words.size() ? " or " : ", ";
            text += kind.words[i];
        }
        return text;
    }
    std::string operator()(const NumberSetting& kind) const {
        return "a number from " + range_text(kind.smallest, kind.largest);
    }
    std::string operator()(const VectorSetting& kind) const {
        const std::string numbers = kind.is_colour ? "one number or three, " : "three numbers, ";
        return numbers + "each from " + range_text(kind.smallest, kind.largest);
    }
    std::string operator()(const SizeSetting& kind) const {
        return "WIDTHxHEIGHT, each from 1 to " + std::to_string(kind.largest);
    }
};

struct RangeClamp {
    Settings& settings;

    static void clamp(float& value, float smallest, float largest) {
        // Written so that NaN, which no comparison admits, is caught as well.
        if (!(value >= smallest)) value = smallest;
        if (value > largest) value = largest;
    }
    void operator()(const ChoiceSetting&) const {}
    void operator()(const SizeSetting&) const {}
    void operator()(const NumberSetting& kind) const {
        clamp(kind.value(settings), kind.smallest, kind.largest);
    }
    void operator()(const VectorSetting& kind) const {
        for (int i = 0; i < 3; ++i)
            clamp(kind.value(settings)[i], kind.smallest, kind.largest);
    }
};

} // namespace

std::span<const Setting> setting_table() {
    static const std::vector<Setting> table = make_table();
    return table;
}

const Setting* find_setting(std::string_view name) {
    for (const Setting& setting : setting_table()) {
        if (setting.name == name) return &setting;
    }
    return nullptr;
}

std::string value_text(const Setting& setting, const Settings& settings) {
    return std::visit(Reader{settings}, setting.kind);
}

bool has_same_value(const Setting& setting, const Settings& a, const Settings& b) {
    return std::visit(SameValue{a, b}, setting.kind);
}

void copy_value(const Setting& setting, const Settings& from, Settings& to) {
    std::visit(ValueCopy{from, to}, setting.kind);
}

std::string allowed_text(const Setting& setting) {
    return std::visit(AllowedText{}, setting.kind);
}

void set_value(Settings& settings, const Setting& setting, std::string_view value) {
    std::visit(Writer{settings, setting, value}, setting.kind);
}

void set_from_text(Settings& settings, std::string_view assignment) {
    const std::size_t place = assignment.find('=');
    if (place == std::string_view::npos) {
        throw UsageError(in_quotes(assignment) + " is not of the form name=value.");
    }
    const std::string_view name = trimmed(assignment.substr(0, place));
    const Setting* setting = find_setting(name);
    if (setting == nullptr) {
        throw UsageError("there is no setting " + in_quotes(name) + "." +
                         did_you_mean(name, setting_names()));
    }
    set_value(settings, *setting, assignment.substr(place + 1));
}

void clamp_to_ranges(Settings& settings) {
    for (const Setting& setting : setting_table())
        std::visit(RangeClamp{settings}, setting.kind);
}

} // namespace rasterwalk
