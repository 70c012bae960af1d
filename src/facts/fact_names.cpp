#include <algorithm>
#include <array>

#include "explain/clip_report.h"
#include "explain/order_formulas.h"
#include "facts/fact_values.h"
#include "facts/facts.h"

namespace rasterwalk {

namespace {

struct NumberPart {
    std::string_view name;
    int index;
};
constexpr std::array<NumberPart, 3> axis_parts{{{"x", 0}, {"y", 1}, {"z", 2}}};
constexpr std::array<NumberPart, 3> colour_parts{{{"red", 0}, {"green", 1}, {"blue", 2}}};
constexpr std::array<NumberPart, 4> box_parts{
    {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}}};
constexpr std::array<NumberPart, 2> size_parts{{{"width", 0}, {"height", 1}}};

/// The parts of a setting with several numbers.
std::span<const NumberPart> parts_of(const Setting& setting) {
    if (std::holds_alternative<SizeSetting>(setting.kind)) return size_parts;
    if (std::holds_alternative<BoxSetting>(setting.kind)) return box_parts;
    const auto* const vector = std::get_if<VectorSetting>(&setting.kind);
    if (vector == nullptr) return {};
    return vector->is_colour ? std::span<const NumberPart>(colour_parts) : axis_parts;
}

/// The picture's size is written without the word size: `viewport.width`.
std::string part_name(const Setting& setting, const NumberPart& part) {
    const bool is_size = std::holds_alternative<SizeSetting>(setting.kind);
    const std::string_view name = setting.name;
    const std::string_view start = is_size ? name.substr(0, name.rfind('.')) : name;
    return std::string(start).append(".").append(part.name);
}

struct SettingRange {
    ValueRange operator()(const ChoiceSetting& kind) const { return words(kind.words); }
    ValueRange operator()(const NumberSetting& kind) const {
        return real(number_as_double(kind.smallest), number_as_double(kind.largest));
    }
    ValueRange operator()(const WholeSetting& kind) const {
        return whole(kind.smallest, kind.largest);
    }
    ValueRange operator()(const VectorSetting& kind) const {
        return real(number_as_double(kind.smallest), number_as_double(kind.largest));
    }
    ValueRange operator()(const SizeSetting& kind) const { return whole(1, kind.largest); }
    ValueRange operator()(const BoxSetting& kind) const {
        return real(number_as_double(kind.smallest), number_as_double(kind.largest));
    }

    static double number_as_double(float value) { return std::get<double>(number(value)); }
};

struct SettingValue {
    Settings settings; // the table only hands out writable settings
    int part;

    Value operator()(const ChoiceSetting& kind) {
        const int word = kind.read(settings);
        if (word == no_word) return {};
        return std::string(kind.words[static_cast<std::size_t>(word)]);
    }
    Value operator()(const NumberSetting& kind) { return number(kind.value(settings)); }
    Value operator()(const WholeSetting& kind) { return number(kind.value(settings)); }
    Value operator()(const VectorSetting& kind) {
        const glm::vec3& value = kind.value(settings);
        if (part < 0) return number(std::max({value.x, value.y, value.z}));
        return number(value[part]);
    }
    Value operator()(const SizeSetting& kind) {
        const Viewport& size = kind.value(settings);
        return number(part == 0 ? size.width : size.height);
    }
    Value operator()(const BoxSetting& kind) {
        const std::optional<ViewBox>& box = kind.value(settings);
        if (!box) return {};
        return number(std::array{box->left, box->right, box->bottom,
                                 box->top}[static_cast<std::size_t>(part)]);
    }
};

const Fact* find_fact(std::string_view name) {
    for (const Fact& fact : fact_table()) {
        if (fact.name == name) return &fact;
    }
    return nullptr;
}

/// The id of the formula that a name stands for, and what it belongs to; empty
/// if for none.
struct FormulaName {
    std::string_view owner, id;
};

FormulaName find_formula_name(std::string_view name) {
    const std::string_view owner = first_part(name);
    if (owner.size() == name.size()) return {};
    const std::string_view id = name.substr(owner.size() + 1);
    const bool exists = (owner == "pixel" && is_fragment_formula(id)) ||
                        (owner == "vertex" && is_vertex_formula(id)) ||
                        (owner == "triangle" && (is_clip_formula(id) || is_order_formula(id)));
    return exists ? FormulaName{owner, id} : FormulaName{};
}

/// The number of the formula; none if it does not exist at the moment.
Value formula_value(const Facts& facts, const FormulaName& name) {
    const Formula* formula = nullptr;
    std::optional<Formula> of_triangle;
    if (name.owner == "pixel" && facts.fragment() != nullptr)
        formula = find_formula(facts.fragment()->formulas, name.id);
    if (name.owner == "vertex" && facts.vertex() != nullptr)
        formula = find_formula(facts.vertex()->formulas, name.id);
    const RunResults& run = facts.results().a;
    std::vector<Formula> of_order;
    if (name.owner == "triangle" && run.triangle && is_order_formula(name.id)) {
        of_order = order_formulas(run.frame, *run.triangle);
        formula = find_formula(of_order, name.id);
    } else if (name.owner == "triangle" && facts.clip() != nullptr) {
        of_triangle = clip_formula(run.frame, *facts.clip(), name.id);
        if (of_triangle) formula = &*of_triangle;
    }
    return formula != nullptr ? number(formula->result.value) : Value();
}

} // namespace

SettingName find_setting_name(std::string_view name) {
    for (const Setting& setting : setting_table()) {
        if (!name.starts_with(setting.name.substr(0, setting.name.rfind('.')))) continue;
        const auto* const vector = std::get_if<VectorSetting>(&setting.kind);
        const bool has_value =
            parts_of(setting).empty() || (vector != nullptr && vector->is_colour);
        if (has_value && setting.name == name) return {&setting, -1};
        for (const NumberPart& part : parts_of(setting)) {
            if (part_name(setting, part) == name) return {&setting, part.index};
        }
    }
    return {};
}

bool is_formula_name(std::string_view name) {
    return find_fact(name) == nullptr && find_setting_name(name).setting == nullptr &&
           !find_formula_name(name).id.empty();
}

std::vector<std::string> formula_names(const Facts& facts) {
    std::vector<std::string> names;
    const auto append = [&](const std::string& owner, const std::vector<Formula>& formulas) {
        for (const Formula& formula : formulas)
            names.push_back(owner + formula.id);
    };
    if (facts.fragment() != nullptr) append("pixel.", facts.fragment()->formulas);
    if (facts.vertex() != nullptr) append("vertex.", facts.vertex()->formulas);
    return names;
}

std::optional<ValueRange> find_name(std::string_view name) {
    if (const Fact* fact = find_fact(name)) return fact->range;
    const SettingName found = find_setting_name(name);
    if (found.setting != nullptr) return std::visit(SettingRange{}, found.setting->kind);
    if (!find_formula_name(name).id.empty()) return real();
    return std::nullopt;
}

std::string meant_name(std::string_view name, std::string_view word) {
    const Setting* const setting = find_setting(name);
    return std::string(setting == nullptr ? name : meant_setting(*setting, word).name);
}

Value Facts::operator()(std::string_view name) const {
    if (const Fact* fact = find_fact(name)) return fact->read(*this, fact->number);
    const SettingName found = find_setting_name(name);
    if (found.setting == nullptr) return formula_value(*this, find_formula_name(name));
    return std::visit(SettingValue{session_->a.settings, found.part}, found.setting->kind);
}

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    for (const Fact& fact : fact_table())
        names.push_back(fact.name);
    const std::vector<std::string> settings = all_setting_names();
    names.insert(names.end(), settings.begin(), settings.end());
    return names;
}

std::vector<std::string> all_setting_names() {
    std::vector<std::string> names;
    for (const Setting& setting : setting_table()) {
        const auto* const vector = std::get_if<VectorSetting>(&setting.kind);
        if (parts_of(setting).empty() || (vector != nullptr && vector->is_colour)) {
            names.emplace_back(setting.name);
        }
        for (const NumberPart& part : parts_of(setting))
            names.push_back(part_name(setting, part));
    }
    return names;
}

} // namespace rasterwalk
