#pragma once

#include <vector>

#include "settings/setting_table.h"

namespace rasterwalk {

/// What a control offers of a setting where it does not offer all of it: a stretch of one number,
/// which is a slider, or some of its words.
struct ControlRange {
    int part = -1; ///< of a vector, 0 to 2; -1: all three, which have the same value then
    double smallest = 0.0, largest = 0.0; ///< in the setting's unit
    double step = 0.0;      ///< a slider stops at the smallest value and every so much beyond it
    std::vector<int> words; ///< indices in ChoiceSetting::words; empty: all
};

/// Least and largest value that a setting of numbers takes; both 0 for one of words or of a size.
struct NumberBounds {
    float smallest = 0.0f, largest = 0.0f;
};
NumberBounds bounds_of(const Setting& setting);

/// Can it be set by a slider: is it a number, or three?
bool is_slider(const Setting& setting);

/// The number that a slider shows; of three at once the largest. The setting must be one of
/// numbers.
float slider_value(const Setting& setting, const ControlRange& range, const Settings& settings);
void set_slider_value(const Setting& setting, const ControlRange& range, float value,
                      Settings& settings);

/// The stop of the slider that is nearest to a value, `more` stops on from there.
float slider_stop(const ControlRange& range, double value, int more = 0);

} // namespace rasterwalk
