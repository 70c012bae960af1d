#include "lessons/lesson_control.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/toml_block.h"
#include "facts/facts.h"
#include "lessons/lesson_run.h"

namespace rasterwalk {

namespace {

/// A setting with a wider range than this has no slider over all of it, because its steps would be
/// too coarse.
constexpr float widest_own_range = 10.0f;

/// The usual slider has this many steps.
constexpr double usual_steps = 100.0;

/// A number with its place in the file.
struct GivenNumber {
    double value = 0.0;
    int line = 0;
};

/// The range that the block gives.
struct GivenRange {
    std::optional<GivenNumber> from, to, step;
    const toml::node* words = nullptr;
};

GivenNumber given_number(const TomlBlock& block, const toml::node& node) {
    const std::optional<double> value = node.value<double>();
    if (!value || !std::isfinite(*value)) block.input().fail(node, "a number is needed here.");
    return {*value, line_of(node)};
}

SettingName given_setting(const std::string& name) {
    const SettingName found = find_setting_name(name);
    if (found.setting != nullptr) return found;
    const std::vector<std::string> known = all_setting_names();
    const std::vector<std::string_view> views(known.begin(), known.end());
    throw UsageError("there is no setting " + in_quotes(name) +
                     " whose value is one number or "
                     "word." +
                     did_you_mean(name, views));
}

std::string range_words(double smallest, double largest) {
    return significant(smallest, 7) + " to " + significant(largest, 7);
}

/// The ends of a slider; none if they are missing or wrong.
std::optional<ControlRange> slider_range(const LessonControl& control, const GivenRange& given,
                                         FaultList& faults) {
    const NumberBounds own = bounds_of(*control.setting);
    const auto smallest = static_cast<double>(own.smallest);
    const auto largest = static_cast<double>(own.largest);
    const bool is_narrow = own.largest - own.smallest <= widest_own_range;
    if (!is_narrow && (!given.from || !given.to)) {
        faults.add(control.line, fmt::format("the control needs 'from' and 'to': {} takes numbers "
                                             "from {}, too many for a slider.",
                                             control.name, range_words(smallest, largest)));
        return std::nullopt;
    }
    const GivenNumber from = given.from.value_or(GivenNumber{smallest, control.line});
    const GivenNumber to = given.to.value_or(GivenNumber{largest, control.line});
    for (const GivenNumber& end : {from, to}) {
        // The bounds are floats, so one that is written with fewer digits may be a hair outside.
        const auto rounded = static_cast<float>(std::clamp(end.value, -1e30, 1e30));
        if (rounded >= own.smallest && rounded <= own.largest) continue;
        faults.add(end.line, fmt::format("{} takes numbers from {}.", control.name,
                                         range_words(smallest, largest)));
        return std::nullopt;
    }
    if (!(static_cast<float>(from.value) < static_cast<float>(to.value))) {
        faults.add(from.line, "'from' must be less than 'to'.");
        return std::nullopt;
    }
    ControlRange range = control.range;
    range.smallest = std::clamp(from.value, smallest, largest);
    range.largest = std::clamp(to.value, smallest, largest);
    const double length = range.largest - range.smallest;
    range.step = given.step ? given.step->value : length / usual_steps;
    if (range.step <= 0.0 || range.step > length || length / range.step > most_slider_steps) {
        faults.add(given.step ? given.step->line : control.line,
                   fmt::format("a slider has 1 to {} steps, so 'step' is a number from {}.",
                               most_slider_steps, range_words(length / most_slider_steps, length)));
        return std::nullopt;
    }
    return range;
}

/// The words of a choice that are offered.
std::optional<ControlRange> word_range(const LessonControl& control, const TomlBlock& block,
                                       const ChoiceSetting& choice, const GivenRange& given) {
    ControlRange range = control.range;
    if (given.words == nullptr) return range;
    const std::size_t most = choice.words.size();
    block.for_each_text(*given.words, most, [&](const std::string& word) {
        const auto found = std::find(choice.words.begin(), choice.words.end(), word);
        if (found == choice.words.end())
            throw UsageError(no_such_name("word of " + control.name, word, choice.words));
        range.words.push_back(static_cast<int>(found - choice.words.begin()));
    });
    const toml::array* const list = given.words->as_array();
    // A word that does not exist has already been reported.
    if (list == nullptr || list->size() != range.words.size()) return std::nullopt;
    if (range.words.size() < 2) {
        block.faults().add(line_of(*given.words), "there must be at least two words to choose "
                                                  "from.");
        return std::nullopt;
    }
    return range;
}

/// Reports a key that belongs to settings of another kind. Returns true if there is none.
bool has_no_key_of(const LessonControl& control, const TomlBlock& block,
                   std::initializer_list<std::string_view> keys, std::string_view kind) {
    for (const std::string_view key : keys) {
        const toml::node* const node = block.input().find(key);
        if (node == nullptr) continue;
        block.faults().add(line_of(*node),
                           fmt::format("'{}' belongs to a setting that takes {}; "
                                       "{} takes {}.",
                                       key, kind, control.name, allowed_text(*control.setting)));
        return false;
    }
    return true;
}

std::optional<ControlRange> range_of(const LessonControl& control, const TomlBlock& block,
                                     const GivenRange& given) {
    if (const auto* const choice = std::get_if<ChoiceSetting>(&control.setting->kind)) {
        if (!has_no_key_of(control, block, {"from", "to", "step"}, "numbers")) return std::nullopt;
        return word_range(control, block, *choice, given);
    }
    if (!has_no_key_of(control, block, {"words"}, "words")) return std::nullopt;
    if (is_slider(*control.setting)) return slider_range(control, given, block.faults());
    block.faults().add(control.line, "the size of the picture cannot have a control in a lesson.");
    return std::nullopt;
}

/// Checks a read-out. Throws UsageError for one that has no numbers, or cannot be read.
std::string given_read_out(const TomlBlock& block, const toml::node& node) {
    std::string text = block.text(node);
    if (text.size() > longest_read_out)
        throw UsageError(fmt::format("a read-out may have at most {} bytes.", longest_read_out));
    if (!needs_numbers(text))
        throw UsageError("a read-out must show a number that may change: {EXPRESSION}.");
    if (text.find("{answer") != text.npos)
        throw UsageError("a control has no {answer}; only predictions do.");
    return text;
}

} // namespace

LessonControl read_control(const toml::table& table, int line, FaultList& faults) {
    TomlBlock block(table, line, "the block 'control'", faults);
    LessonControl control;
    control.line = control.read_out_line = line;
    SettingName named;
    GivenRange given;
    TomlKeys keys;
    keys["setting"] = [&](const toml::node& n) {
        control.name = block.text(n);
        named = given_setting(control.name);
    };
    keys["from"] = [&](const toml::node& n) { given.from = given_number(block, n); };
    keys["to"] = [&](const toml::node& n) { given.to = given_number(block, n); };
    keys["step"] = [&](const toml::node& n) { given.step = given_number(block, n); };
    keys["words"] = [&](const toml::node& n) { given.words = &n; };
    keys["read_out"] = [&](const toml::node& n) {
        control.read_out_line = line_of(n);
        control.read_out = given_read_out(block, n);
    };
    block.read(keys);
    block.require("setting");
    const auto is_read = [&](std::string_view key, const std::optional<GivenNumber>& value) {
        return value || block.input().find(key) == nullptr;
    };
    const bool is_good =
        is_read("from", given.from) && is_read("to", given.to) && is_read("step", given.step);
    if (named.setting == nullptr || !is_good) return control;
    control.setting = named.setting;
    control.range.part = named.part;
    std::optional<ControlRange> range;
    faults.attempt(line, [&] { range = range_of(control, block, given); });
    if (range) {
        control.range = std::move(*range);
    } else {
        control.setting = nullptr;
    }
    return control;
}

std::string misfit_of(const LessonControl& control, const Settings& settings, const Scene& scene) {
    const Setting& setting = *control.setting;
    if (!is_of_use(setting, scene)) return control.name + " does nothing in this scene.";
    if (const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind)) {
        const std::vector<int>& words = control.range.words;
        const int now = choice->read(settings);
        const bool is_offered =
            words.empty() || std::find(words.begin(), words.end(), now) != words.end();
        return is_offered ? std::string()
                          : fmt::format("the step opens with {}={}, which the control does not "
                                        "offer.",
                                        control.name, value_text(setting, settings));
    }
    const float now = slider_value(setting, control.range, settings);
    const bool is_reached = now >= static_cast<float>(control.range.smallest) &&
                            now <= static_cast<float>(control.range.largest);
    if (is_reached) return {};
    return fmt::format("the step opens with {}={}, but the slider goes from {}.", control.name,
                       number_text(now),
                       range_words(control.range.smallest, control.range.largest));
}

} // namespace rasterwalk
