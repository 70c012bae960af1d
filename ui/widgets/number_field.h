#pragma once

#include <string_view>

#include "settings/control_range.h"

namespace rasterwalk {

/// What a number may be, and how far it goes for each screen pixel that it is dragged.
template <typename Number>
struct DragRange {
    float step;
    Number smallest, largest;
};

/// A number that is dragged, or typed after a double click or Enter; it never leaves its range. It
/// is shown with a true minus sign, and taken with this one or a hyphen. Returns true if it was
/// changed.
/// @param id of the ImGui item
bool drag_number(const char* id, float& value, const DragRange<float>& range);

/// The same for a whole number.
/// @param label stands before it in the field
bool drag_number(const char* id, int& value, const DragRange<int>& range, std::string_view label);

/// A number on a bar: dragged it goes from stop to stop of the range, and what is typed stays
/// within it. A value beyond the range is shown as it is until it is changed. Returns true if it
/// was.
bool slide_number(const char* id, float& value, const ControlRange& range);

} // namespace rasterwalk
