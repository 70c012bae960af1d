#include "outside/label_places.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

namespace rasterwalk {

namespace {

bool meet(const OutsideBox& a, const OutsideBox& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Does the line touch the box?
bool touches(const OutsideLine& line, const OutsideBox& box) {
    const glm::vec2 delta = line.to - line.from;
    float begin = 0.0f, end = 1.0f; // the part of the line that is in the box
    for (int axis = 0; axis < 2; ++axis) {
        const float low = box.low[axis] - line.from[axis], high = box.high[axis] - line.from[axis];
        if (delta[axis] == 0.0f) {
            if (low > 0.0f || high < 0.0f) return false;
            continue;
        }
        const float a = low / delta[axis], b = high / delta[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return begin <= end;
}

/// Places for a text next to its point, the best first: in parts of its size from the point.
constexpr std::array<glm::vec2, 8> label_sides{
    glm::vec2{1.0f, 0.0f},  glm::vec2{-1.0f, 0.0f},  glm::vec2{0.0f, 1.0f}, glm::vec2{0.0f, -1.0f},
    glm::vec2{1.0f, -1.0f}, glm::vec2{-1.0f, -1.0f}, glm::vec2{1.0f, 1.0f}, glm::vec2{-1.0f, 1.0f}};

/// The index in label_sides where the search begins.
std::size_t place_of(LabelSide side) {
    switch (side) {
    case LabelSide::right:
        break;
    case LabelSide::below:
        return 2;
    case LabelSide::above_right:
        return 4;
    }
    return 0;
}

/// A text that is shifted stays this far from the border, in parts of its height.
constexpr float border_part = 0.3f;

/// Above, below or at a side of a point near the border, it is shifted until all of it is seen.
OutsideBox label_box(const OutsideLabel& label, const glm::vec2& side, glm::vec2 size) {
    glm::vec2 low = label.point + side * (0.5f * label.size + label.distance) - 0.5f * label.size;
    // If there is hardly room for it, it is in the middle.
    const glm::vec2 room = glm::max(size - label.size, glm::vec2(0.0f));
    const glm::vec2 border = glm::min(glm::vec2(border_part * label.size.y), 0.5f * room);
    const glm::vec2 most = room - border;
    if (side.x == 0.0f) low.x = std::max(std::min(low.x, most.x), border.x);
    if (side.y == 0.0f) low.y = std::max(std::min(low.y, most.y), border.y);
    return {low, low + label.size};
}

bool is_free(const OutsideBox& box, std::span<const OutsideBox> taken, glm::vec2 size) {
    const bool is_inside =
        box.low.x >= 0.0f && box.low.y >= 0.0f && box.high.x <= size.x && box.high.y <= size.y;
    return is_inside && std::none_of(taken.begin(), taken.end(),
                                     [&](const OutsideBox& other) { return meet(box, other); });
}

bool is_off_lines(const OutsideLabel& label, const OutsideBox& box,
                  std::span<const OutsideLine> lines) {
    const OutsideBox wide{box.low - label.line_distance, box.high + label.line_distance};
    return std::none_of(lines.begin(), lines.end(),
                        [&](const OutsideLine& line) { return touches(line, wide); });
}

} // namespace

std::vector<std::optional<glm::vec2>> label_places(std::span<const OutsideLabel> labels,
                                                   std::vector<OutsideBox> taken,
                                                   std::span<const OutsideLine> lines,
                                                   glm::vec2 size) {
    std::vector<std::optional<glm::vec2>> places;
    for (const OutsideLabel& label : labels) {
        const bool is_seen = label.point.x >= 0.0f && label.point.y >= 0.0f &&
                             label.point.x <= size.x && label.point.y <= size.y;
        std::optional<OutsideBox> best; // and whether it keeps its distance
        bool is_best_off = false;
        for (std::size_t i = 0; is_seen && !is_best_off && i < label_sides.size(); ++i) {
            const std::size_t at = (place_of(label.first) + i) % label_sides.size();
            const OutsideBox box = label_box(label, label_sides[at], size);
            if (!is_free(box, taken, size)) continue;
            is_best_off = is_off_lines(label, box, lines);
            if (is_best_off || (!best && !label.needs_distance)) best = box;
        }
        if (best) taken.push_back(*best);
        places.push_back(best ? std::optional(best->low) : std::nullopt);
    }
    return places;
}

} // namespace rasterwalk
