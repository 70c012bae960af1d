#include "inspect/clip_diagram.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// Farther away than this, a corner's products with the planes overflow a float.
constexpr float farthest_drawn = 1e30f;

/// The margin around the corners, as a share of their range: enough for their names.
constexpr double diagram_margin = 0.14;

bool is_near_enough(const CutCorner& corner) {
    const glm::vec4& p = corner.vertex.position_clip;
    // NaN is not less either.
    return std::abs(p.x) < farthest_drawn && std::abs(p.y) < farthest_drawn &&
           std::abs(p.z) < farthest_drawn && std::abs(p.w) < farthest_drawn;
}

/// From the smallest to the largest value of a coordinate.
Interval corner_range(const std::vector<CutCorner>& corners, int coordinate) {
    Interval range{HUGE_VAL, -HUGE_VAL};
    for (const CutCorner& corner : corners) {
        const auto value = static_cast<double>(corner.vertex.position_clip[coordinate]);
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    return range;
}

double width_of(const Interval& range) {
    return range.high - range.low;
}

/// The same with a margin around it, extended to 0 if that leaves the corners large enough.
Interval shown_range(const Interval& range) {
    constexpr double most_growth = 4.0, least_share = 1e-3;
    const Interval with_zero{std::min(range.low, 0.0), std::max(range.high, 0.0)};
    const double width = width_of(range), wide = width_of(with_zero);
    const bool is_one_place = width <= least_share * wide;
    return with_margin(wide <= most_growth * width || is_one_place ? with_zero : range,
                       diagram_margin);
}

int side_of_plane(const glm::vec4& plane, const std::vector<CutCorner>& corners) {
    if (plane.x != 0.0f) return 0;
    if (plane.y != 0.0f) return 1;
    if (width_of(corner_range(corners, 2)) > 0.0) return 2;
    return width_of(corner_range(corners, 0)) >= width_of(corner_range(corners, 1)) ? 0 : 1;
}

/// Where a plane meets the edges of a polygon.
class CrossingSink : public ClipSink {
  public:
    void clip_step(const ClipStep& step) override {
        if (step.is_cut) cuts.push_back(step.cut.position_clip);
    }
    std::vector<glm::vec4> cuts;
};

/// Cuts the visible field as the stage cuts a polygon, so the line and the inner side are the
/// stage's.
void cut_field(const ClipPlanes& planes, ClipDiagram& diagram) {
    const Interval& s = diagram.side_range;
    const Interval& w = diagram.w_range;
    std::vector<ClipVertex> field;
    for (const glm::dvec2 corner : {glm::dvec2(s.low, w.low), glm::dvec2(s.high, w.low),
                                    glm::dvec2(s.high, w.high), glm::dvec2(s.low, w.high)}) {
        // The coordinates that are not shown do not count, or are the same at all corners.
        ClipVertex& vertex = field.emplace_back();
        vertex.position_clip = diagram.corners.front().vertex.position_clip;
        vertex.position_clip[diagram.side] = static_cast<float>(corner.x);
        vertex.position_clip.w = static_cast<float>(corner.y);
    }
    std::vector<ClipVertex> inside;
    CrossingSink crossings;
    clip_by_plane(field, planes, diagram.plane, inside, &crossings);
    const auto place = [&](const glm::vec4& p) { return glm::dvec2(p[diagram.side], p.w); };
    for (const ClipVertex& vertex : inside)
        diagram.inside.push_back(place(vertex.position_clip));
    if (crossings.cuts.size() == 2)
        diagram.line = {place(crossings.cuts[0]), place(crossings.cuts[1])};
}

} // namespace

std::optional<ClipDiagram> clip_diagram(const ClipHistory& history, ClipPlane plane) {
    const auto index = static_cast<std::size_t>(plane);
    if (index >= history.codes.plane_count) return std::nullopt;
    const int before = planes_before(history, plane);
    ClipDiagram diagram;
    diagram.plane = plane;
    diagram.corners = corners_before(history, before);
    if (diagram.corners.empty()) return std::nullopt;
    diagram.steps = plane_steps(history, plane);
    for (const ClipStep& step : diagram.steps) {
        if (!step.is_cut) continue;
        if (auto corner = corner_made(history, before, step.from)) diagram.made.push_back(*corner);
    }
    std::vector<CutCorner> all = diagram.corners;
    all.insert(all.end(), diagram.made.begin(), diagram.made.end());
    diagram.is_endless = !std::all_of(all.begin(), all.end(), is_near_enough);
    if (diagram.is_endless) return diagram;
    diagram.side = side_of_plane(history.codes.planes[index], diagram.corners);
    diagram.side_range = shown_range(corner_range(all, diagram.side));
    diagram.w_range = shown_range(corner_range(all, 3));
    cut_field(history.codes.planes, diagram);
    return diagram;
}

std::string inside_condition(const ClipHistory& history, const ClipDiagram& diagram) {
    const glm::vec4& plane = history.codes.planes[static_cast<std::size_t>(diagram.plane)];
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    // If z is not the coordinate to the side, it is the same at all corners.
    const float rest =
        diagram.side == 2 ? 0.0f : plane.z * diagram.corners.front().vertex.position_clip.z;
    const struct {
        float factor;
        std::string_view name;
    } terms[] = {{plane[diagram.side], names[static_cast<std::size_t>(diagram.side)]},
                 {plane.w, "w"},
                 {rest, ""}};
    std::string text;
    // Added terms come first.
    for (const bool is_added : {true, false}) {
        for (const auto& [factor, name] : terms) {
            if (factor == 0.0f || (factor > 0.0f) != is_added) continue;
            const std::string size = significant(std::abs(static_cast<double>(factor)), 4);
            text += is_added ? (text.empty() ? "" : " + ") : (text.empty() ? "−" : " − ");
            if (name.empty())
                text += size;
            else
                text.append(size == "1" ? "" : size + " · ").append(name);
        }
    }
    return (text.empty() ? "0" : text) + " ≥ 0";
}

} // namespace rasterwalk
