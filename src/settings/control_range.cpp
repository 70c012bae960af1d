#include "settings/control_range.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

namespace {

struct BoundsOf {
    NumberBounds operator()(const NumberSetting& kind) const {
        return {kind.smallest, kind.largest};
    }
    NumberBounds operator()(const WholeSetting& kind) const {
        return {static_cast<float>(kind.smallest), static_cast<float>(kind.largest)};
    }
    NumberBounds operator()(const VectorSetting& kind) const {
        return {kind.smallest, kind.largest};
    }
    NumberBounds operator()(const ChoiceSetting&) const { return {}; }
    NumberBounds operator()(const SizeSetting&) const { return {}; }
    NumberBounds operator()(const BoxSetting&) const { return {}; }
};

} // namespace

NumberBounds bounds_of(const Setting& setting) {
    return std::visit(BoundsOf{}, setting.kind);
}

bool is_slider(const Setting& setting) {
    return std::holds_alternative<NumberSetting>(setting.kind) ||
           std::holds_alternative<WholeSetting>(setting.kind) ||
           std::holds_alternative<VectorSetting>(setting.kind);
}

float slider_value(const Setting& setting, const ControlRange& range, const Settings& settings) {
    Settings copy = settings; // the table only gives out what can be written
    if (const auto* const number = std::get_if<NumberSetting>(&setting.kind))
        return number->value(copy);
    if (const auto* const whole = std::get_if<WholeSetting>(&setting.kind))
        return static_cast<float>(whole->value(copy));
    const glm::vec3& vector = std::get<VectorSetting>(setting.kind).value(copy);
    return range.part < 0 ? std::max({vector.x, vector.y, vector.z}) : vector[range.part];
}

void set_slider_value(const Setting& setting, const ControlRange& range, float value,
                      Settings& settings) {
    if (const auto* const number = std::get_if<NumberSetting>(&setting.kind)) {
        number->value(settings) = value;
        return;
    }
    if (const auto* const whole = std::get_if<WholeSetting>(&setting.kind)) {
        whole->value(settings) = allowed_value(*whole, static_cast<int>(std::lround(value)));
        return;
    }
    glm::vec3& vector = std::get<VectorSetting>(setting.kind).value(settings);
    if (range.part < 0) {
        vector = glm::vec3(value);
    } else {
        vector[range.part] = value;
    }
}

float slider_stop(const ControlRange& range, double value, int more) {
    const double stop = std::round((value - range.smallest) / range.step) + more;
    const double at = std::clamp(range.smallest + stop * range.step, range.smallest, range.largest);
    // Sums of decimal fractions miss 0 by a hair, and the text would show that.
    return std::abs(at) < 1e-6 * range.step ? 0.0f : static_cast<float>(at);
}

} // namespace rasterwalk
