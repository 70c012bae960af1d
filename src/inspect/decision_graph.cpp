#include "inspect/decision_graph.h"

#include <algorithm>

namespace rasterwalk {

namespace {

glm::ivec2 pixels_of(PixelStep step, const LineFrame& frame) {
    switch (step) {
    case PixelStep::none:
        break;
    case PixelStep::straight:
        return {frame.straight_x, frame.straight_y};
    case PixelStep::diagonal:
        return {frame.diagonal_x, frame.diagonal_y};
    }
    return {0, 0};
}

} // namespace

DecisionGraph decision_graph(const EdgeMicroscope& edge, int samples) {
    DecisionGraph graph;
    graph.is_steep = edge.frame.is_steep;
    if (!edge.has_decision_variable()) return graph;
    const std::size_t count = std::min(edge.decisions.size(), edge.forward.size());
    for (std::size_t i = 0; i < count; ++i) {
        const LineDecision& decision = edge.decisions[i];
        graph.least = std::min(graph.least, decision.before);
        graph.most = std::max(graph.most, decision.before);
        if (static_cast<int>(i) >= samples) continue;
        const EdgeMicroscope::Place& place = edge.forward[i];
        graph.marks.push_back(
            {{place.column, place.row}, decision.before, pixels_of(decision.step, edge.frame)});
    }
    return graph;
}

} // namespace rasterwalk
