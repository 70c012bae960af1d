#pragma once

#include <string_view>

#include "settings/control_range.h"

namespace rasterwalk {

/// The range of a number, and how far it moves for each screen pixel of a drag.
template <typename Number>
struct DragRange {
    float step;
    Number smallest, largest;
};

/// A number that is dragged, or typed after a double click or Enter; it never leaves its range. It
/// is shown with a true minus sign, and read with either that or a hyphen. Returns true if it was
/// changed.
/// @param id of the ImGui item
bool drag_number(const char* id, float& value, const DragRange<float>& range);

/// The same for a whole number.
/// @param label written before it in the field
bool drag_number(const char* id, int& value, const DragRange<int>& range, std::string_view label);

/// A number on a bar: dragging moves it from stop to stop of the range, and what is typed stays
/// within the range. A value beyond the range is shown unchanged until it is edited. Returns true
/// if it was changed.
bool slide_number(const char* id, float& value, const ControlRange& range);

} // namespace rasterwalk
