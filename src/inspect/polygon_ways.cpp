#include "inspect/polygon_ways.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

#include "stages/active_edges.h"
#include "stages/fan.h"

namespace rasterwalk {

namespace {

/// Columns of a row, from the first to the last.
struct Stretch {
    int row = 0, first = 0, last = 0;

    std::int64_t count() const { return std::int64_t{last} - first + 1; }
};

/// From top to bottom.
void add_stretches(const Frame& frame, std::span<const ScreenVertex> corners,
                   std::vector<Stretch>& all) {
    for (const InsideSpan& span :
         active_edge_spans(corners, edge_rules(frame.settings, {}), frame.stages))
        all.push_back({span.row, span.left.column, span.right.column});
}

void count_inside(const std::vector<Stretch>& inside, PolygonWays& ways) {
    for (auto row = inside.begin(); row != inside.end();) {
        const auto next = std::find_if(
            row, inside.end(), [&](const Stretch& stretch) { return stretch.row != row->row; });
        std::int64_t pixels = 0;
        for (auto stretch = row; stretch != next; ++stretch)
            pixels += stretch->count();
        const std::int64_t from_end_to_end = Stretch{0, row->first, (next - 1)->last}.count();
        ways.inside += pixels;
        ways.table += from_end_to_end;
        ++ways.rows;
        ways.wrong_rows += from_end_to_end != pixels ? 1 : 0;
        row = next;
    }
}

void count_fan(std::vector<Stretch> laid, PolygonWays& ways) {
    std::sort(laid.begin(), laid.end(), [](const Stretch& a, const Stretch& b) {
        return a.row != b.row ? a.row < b.row : a.first < b.first;
    });
    int row = 0, covered_to = 0; // of that row, up to this column
    for (const Stretch& stretch : laid) {
        ways.fan_laid += stretch.count();
        const bool begins_row = &stretch == laid.data() || stretch.row != row;
        row = stretch.row;
        const int first = begins_row ? stretch.first : std::max(stretch.first, covered_to + 1);
        ways.fan += std::max<std::int64_t>(Stretch{row, first, stretch.last}.count(), 0);
        covered_to = begins_row ? stretch.last : std::max(covered_to, stretch.last);
    }
}

/// Is the triangle drawn, with the corners of the fan?
bool goes_on(const Frame& frame, int triangle, const std::vector<ScreenVertex>& outline) {
    if (!frame.is_drawn(triangle) || frame.is_cut(triangle)) return false;
    if (outline.empty()) return true;
    const std::span<const ScreenVertex> corners = frame.triangle_vertices(triangle);
    return corners[0].position == outline.front().position &&
           corners[1].position == outline.back().position;
}

} // namespace

std::vector<ScreenVertex> outline_of(const Frame& frame, int triangle) {
    const std::vector<ScenePolygon>& all = frame.scene->polygons;
    const auto found = std::find_if(all.begin(), all.end(), [&](const ScenePolygon& polygon) {
        return triangle >= polygon.first_triangle &&
               triangle < polygon.first_triangle + polygon.triangle_count;
    });
    std::vector<ScreenVertex> outline;
    if (found == all.end()) return outline;
    for (int i = 0; i < found->triangle_count; ++i) {
        const int t = found->first_triangle + i;
        if (!goes_on(frame, t, outline)) return {};
        const std::span<const ScreenVertex> corners = frame.triangle_vertices(t);
        const auto known = outline.empty() ? corners.begin() : corners.end() - 1;
        outline.insert(outline.end(), known, corners.end());
    }
    return outline;
}

std::optional<PolygonWays> polygon_ways(const Frame& frame, int triangle) {
    const std::vector<ScreenVertex> outline = outline_of(frame, triangle);
    if (outline.empty()) return {};
    PolygonWays ways;
    ways.corners = static_cast<int>(outline.size());
    std::vector<Stretch> inside, laid;
    add_stretches(frame, outline, inside);
    count_inside(inside, ways);
    std::int64_t area = 0, fan_area = 0; // twice
    for_each_fan_triangle(outline, frame.stages.snap, [&](const FanTriangle& fan) {
        std::vector<ScreenVertex> corners;
        for (const int corner : fan.corners)
            corners.push_back(outline[static_cast<std::size_t>(corner)]);
        add_stretches(frame, corners, laid);
        area += fan.area;
        fan_area += std::abs(fan.area);
    });
    count_fan(std::move(laid), ways);
    ways.area = in_square_pixels(std::abs(area)) / 2.0;
    ways.fan_area = in_square_pixels(fan_area) / 2.0;
    return ways;
}

} // namespace rasterwalk
