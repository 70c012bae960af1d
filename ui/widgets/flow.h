#pragma once

#include <span>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

/// The position of an item in a row that breaks into lines when it gets too narrow.
struct FlowPlace {
    float x = 0.0f; ///< from the left edge of the row
    int line = 0;
};

/// Places items of these widths one after the other, with `gap` between them, in lines of `width`.
std::vector<FlowPlace> flow(std::span<const float> widths, float gap, float width);

/// The number of lines that a flow takes; at least 1.
int line_count(std::span<const FlowPlace> places);

} // namespace rasterwalk
