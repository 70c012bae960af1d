#include "settings/setting_table.h"

// Reads, writes, compares and copies the value of any setting in the table.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/enumerated.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

/// The word for no box.
constexpr std::string_view no_box = "auto";

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

/// The index of a word; no_word if the choice does not take it.
int find_word(const ChoiceSetting& kind, std::string_view word) {
    const auto found = std::find(kind.words.begin(), kind.words.end(), trimmed(word));
    return found == kind.words.end() ? no_word : static_cast<int>(found - kind.words.begin());
}

/// An assignment that used to have another spelling.
struct OldSpelling {
    std::string_view name, value;
    std::string_view name_now, value_now;
};
constexpr OldSpelling old_spellings[] = {
    {"behind_camera", "left_out", "clip", "leave_out"},
    {"behind_camera", "drawn", "clip", "none"},
    {"behind_camera", "mark_minus_one", "behind_mark", "minus_one"},
};

/// Puts a value into the settings: one function for each kind of setting.
struct Writer {
    Settings& settings;
    const Setting& setting;
    std::string_view text;

    float number(std::string_view part, float smallest, float largest) const {
        const std::optional<float> value = parse_number(part, smallest, largest);
        if (!value) refuse(setting, text);
        return *value;
    }

    void operator()(const ChoiceSetting& kind) const {
        const int word = find_word(kind, text);
        if (word == no_word) refuse(setting, text);
        kind.write(settings, word);
    }
    void operator()(const NumberSetting& kind) const {
        kind.value(settings) = number(text, kind.smallest, kind.largest);
    }
    void operator()(const WholeSetting& kind) const {
        const std::optional<int> value = parse_int(trimmed(text));
        if (!value || allowed_value(kind, *value) != *value) refuse(setting, text);
        kind.value(settings) = *value;
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
            const std::optional<int> pixels = parse_int(part);
            if (!pixels || *pixels < 1 || *pixels > kind.largest) refuse(setting, text);
            return *pixels;
        };
        const Viewport size{side(parts[0]), side(parts[1])};
        kind.value(settings) = size;
    }
    void operator()(const BoxSetting& kind) const {
        if (trimmed(text) == no_box) {
            kind.value(settings) = std::nullopt;
            return;
        }
        const std::vector<std::string_view> parts = split(text, ',');
        if (parts.size() != 4) refuse(setting, text);
        const auto side = [&](std::size_t i) {
            return number(parts[i], kind.smallest, kind.largest);
        };
        const ViewBox box{side(0), side(1), side(2), side(3)};
        if (!is_allowed(box, kind)) refuse(setting, text);
        kind.value(settings) = box;
    }
};

/// The value of a setting as text: one function for each kind of setting.
struct Reader {
    Settings settings;

    std::string operator()(const ChoiceSetting& kind) const {
        const int word = kind.read(settings);
        return word == no_word ? "" : std::string(kind.words[static_cast<std::size_t>(word)]);
    }
    std::string operator()(const NumberSetting& kind) { return number_text(kind.value(settings)); }
    std::string operator()(const WholeSetting& kind) {
        return std::to_string(kind.value(settings));
    }
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
    std::string operator()(const BoxSetting& kind) {
        const std::optional<ViewBox>& box = kind.value(settings);
        if (!box) return std::string(no_box);
        return number_text(box->left) + "," + number_text(box->right) + "," +
               number_text(box->bottom) + "," + number_text(box->top);
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

    void operator()(const ChoiceSetting& kind) {
        const int word = kind.read(from);
        if (word != no_word) kind.write(to, word);
    }
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
        return enumerated({kind.words.begin(), kind.words.end()}, "or");
    }
    std::string operator()(const NumberSetting& kind) const {
        return "a number from " + range_text(kind.smallest, kind.largest);
    }
    std::string operator()(const WholeSetting& kind) const {
        if (kind.largest - kind.smallest == kind.step)
            return std::to_string(kind.smallest) + " or " + std::to_string(kind.largest);
        return "a whole number from " + std::to_string(kind.smallest) + " to " +
               std::to_string(kind.largest);
    }
    std::string operator()(const VectorSetting& kind) const {
        const std::string numbers = kind.is_colour ? "one number or three, " : "three numbers, ";
        return numbers + "each from " + range_text(kind.smallest, kind.largest);
    }
    std::string operator()(const SizeSetting& kind) const {
        return "WIDTHxHEIGHT, each from 1 to " + std::to_string(kind.largest);
    }
    std::string operator()(const BoxSetting& kind) const {
        return std::string(no_box) + " or left,right,bottom,top, each from " +
               range_text(kind.smallest, kind.largest) +
               ", with right more than left and top more than bottom by at least " +
               number_text(kind.least_side);
    }
};

struct RangeClamp {
    Settings& settings;

    static void clamp(float& value, float smallest, float largest) {
        // Written so that it catches NaN too, which fails every comparison.
        if (!(value >= smallest)) value = smallest;
        if (value > largest) value = largest;
    }
    void operator()(const ChoiceSetting&) const {}
    void operator()(const SizeSetting&) const {}
    void operator()(const BoxSetting& kind) const {
        std::optional<ViewBox>& box = kind.value(settings);
        if (box && !is_allowed(*box, kind)) box.reset();
    }
    void operator()(const WholeSetting& kind) const {
        kind.value(settings) = allowed_value(kind, kind.value(settings));
    }
    void operator()(const NumberSetting& kind) const {
        clamp(kind.value(settings), kind.smallest, kind.largest);
    }
    void operator()(const VectorSetting& kind) const {
        for (int i = 0; i < 3; ++i)
            clamp(kind.value(settings)[i], kind.smallest, kind.largest);
    }
};

} // namespace

int allowed_value(const WholeSetting& kind, int number) {
    const int inside = std::clamp(number, kind.smallest, kind.largest);
    return inside - (inside - kind.smallest) % kind.step;
}

bool is_allowed(const ViewBox& box, const BoxSetting& kind) {
    for (const float side : {box.left, box.right, box.bottom, box.top}) {
        if (!(side >= kind.smallest && side <= kind.largest)) return false;
    }
    return box.right - box.left >= kind.least_side && box.top - box.bottom >= kind.least_side;
}

std::string value_text(const Setting& setting, const Settings& settings) {
    return std::visit(Reader{settings}, setting.kind);
}

bool follows_from_whole(const Setting& part, const Settings& settings) {
    if (part.ties.part_of.empty()) return false;
    Settings said = settings;
    copy_value(*find_setting(part.ties.part_of), settings, said);
    return !value_text(*find_setting(part.ties.part_of), settings).empty() &&
           has_same_value(part, settings, said);
}

bool is_word_of_whole(const Setting& part, std::string_view word) {
    const Setting* const whole = find_setting(part.ties.part_of);
    const auto* const choice =
        whole != nullptr ? std::get_if<ChoiceSetting>(&whole->kind) : nullptr;
    return choice != nullptr && find_word(*choice, word) != no_word;
}

bool must_be_listed(const Setting& setting, const Settings& a, const Settings& b) {
    const bool is_same = has_same_value(setting, a, b);
    const Setting* const whole = find_setting(setting.ties.part_of);
    if (whole != nullptr && must_be_listed(*whole, a, b)) {
        return !follows_from_whole(setting, b) || (!is_same && !follows_from_whole(setting, a));
    }
    return !is_same && !value_text(setting, a).empty() && !value_text(setting, b).empty();
}

const Setting& meant_setting(const Setting& setting, std::string_view value) {
    const Setting* const successor = find_setting(setting.ties.words_moved_to);
    const auto* const choice =
        successor != nullptr ? std::get_if<ChoiceSetting>(&successor->kind) : nullptr;
    return choice != nullptr && find_word(*choice, value) != no_word ? *successor : setting;
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
    const Setting& meant = meant_setting(setting, value);
    std::visit(Writer{settings, meant, value}, meant.kind);
}

Assignment read_assignment(std::string_view text) {
    const std::size_t place = text.find('=');
    if (place == std::string_view::npos) {
        throw UsageError(in_quotes(text) + " is not of the form name=value.");
    }
    const std::string_view name = trimmed(text.substr(0, place));
    const std::string_view value = text.substr(place + 1);
    for (const OldSpelling& old : old_spellings) {
        if (name == old.name && trimmed(value) == old.value)
            return {find_setting(old.name_now), old.value_now};
    }
    const Setting* const setting = find_setting(name);
    if (setting == nullptr) {
        throw UsageError("there is no setting " + in_quotes(name) + "." +
                         did_you_mean(name, setting_names()));
    }
    return {&meant_setting(*setting, value), value};
}

void set_from_text(Settings& settings, std::string_view assignment) {
    const Assignment read = read_assignment(assignment);
    set_value(settings, *read.setting, read.value);
}

void clamp_to_ranges(Settings& settings) {
    for (const Setting& setting : setting_table())
        std::visit(RangeClamp{settings}, setting.kind);
}

} // namespace rasterwalk
