#pragma once

#include <vector>

#include "settings/setting_table.h"

namespace rasterwalk {

/// The part of a setting that a control offers: a range of one number (a slider), or some of its
/// words.
struct ControlRange {
    int part = -1;                        ///< of a vector, 0 to 2; -1: all three, with one value
    double smallest = 0.0, largest = 0.0; ///< in the setting's unit
    double step = 0.0;                    ///< between a slider's stops, from the smallest value up
    std::vector<int> words;               ///< indices in ChoiceSetting::words; empty: all
};

/// Smallest and largest value of a numeric setting; both 0 for one of words or of a size.
struct NumberBounds {
    float smallest = 0.0f, largest = 0.0f;
};
NumberBounds bounds_of(const Setting& setting);

/// Can a slider set it: is it a number, or three?
bool is_slider(const Setting& setting);

/// The number that a slider shows; for three together, the largest. The setting must be numeric.
float slider_value(const Setting& setting, const ControlRange& range, const Settings& settings);
void set_slider_value(const Setting& setting, const ControlRange& range, float value,
                      Settings& settings);

/// The slider's stop that is nearest to a value, moved on by `more` stops.
float slider_stop(const ControlRange& range, double value, int more = 0);

} // namespace rasterwalk
