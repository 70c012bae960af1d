#include "ui/widgets/flow.h"

namespace rasterwalk {

std::vector<FlowPlace> flow(std::span<const float> widths, float gap, float width) {
    std::vector<FlowPlace> places;
    FlowPlace next;
    for (const float item : widths) {
        if (next.x > 0.0f && next.x + item > width) next = {0.0f, next.line + 1};
        places.push_back(next);
        next.x += item + gap;
    }
    return places;
}

int line_count(std::span<const FlowPlace> places) {
    return places.empty() ? 1 : places.back().line + 1;
}

} // namespace rasterwalk
