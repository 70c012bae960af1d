#include "inspect/shared_edge.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <glm/geometric.hpp>

#include "stages/samples.h"

namespace rasterwalk {

namespace {

using SnappedCorners = std::array<GridPoint, triangle_corners>;

constexpr std::size_t next_corner(std::size_t corner) {
    return (corner + 1) % triangle_corners;
}

SnappedCorners snapped_corners(const Frame& frame, int triangle) {
    const PolygonCorners vertices = frame.triangle_vertices(triangle);
    SnappedCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = frame.stages.snap(vertices[i]);
    return corners;
}

std::array<SnappedCorners, 2> snapped_outlines(const Frame& frame, const SharedEdge& shared) {
    return {snapped_corners(frame, shared.triangle), snapped_corners(frame, shared.neighbour)};
}

/// Are its corners the scene's?
bool is_whole(const Frame& frame, int triangle) {
    return frame.is_drawn(triangle) && !frame.is_cut(triangle);
}

/// The edge of a triangle between two points of the scene, in either direction; -1: it has no such
/// edge.
int edge_between(const Frame& frame, int triangle, const glm::vec3& a, const glm::vec3& b) {
    std::array<glm::vec3, triangle_corners> places;
    for (int i = 0; i < triangle_corners; ++i)
        places[static_cast<std::size_t>(i)] = frame.scene->corner(triangle, i).position;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::vec3 &from = places[i], &to = places[next_corner(i)];
        if ((from == a && to == b) || (from == b && to == a)) return static_cast<int>(i);
    }
    return -1;
}

/// The side of its edge on which the rest of a triangle lies, seen from `a` to `b`.
int side_of_rest(const SnappedCorners& corners, int edge, const GridPoint& a, const GridPoint& b) {
    const GridPoint& rest = corners[next_corner(next_corner(static_cast<std::size_t>(edge)))];
    const std::int64_t area = double_area(a, b, rest);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Columns of a row, from the first to the last; none if the first is the larger.
struct Columns {
    std::int64_t first = 0, last = -1;

    std::int64_t count() const { return std::max<std::int64_t>(last - first + 1, 0); }
    bool has(std::int64_t column) const { return first <= column && column <= last; }
};

Columns in_both(const Columns& a, const Columns& b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

/// The pixels of a row whose centres lie on the edge from a to b, without its ends.
Columns centres_on_edge(const GridPoint& a, const GridPoint& b, int row) {
    const std::int64_t y = pixel_centre(row);
    if (a.y == b.y) {
        if (y != a.y) return {};
        // pixel_at() of half a pixel to the left is the last pixel whose centre is at or before x.
        const auto last_up_to = [](std::int64_t x) { return pixel_at(x - grid_parts / 2); };
        return {std::int64_t{last_up_to(std::min(a.x, b.x))} + 1,
                last_up_to(std::max(a.x, b.x) - 1)};
    }
    if (y <= std::min(a.y, b.y) || y >= std::max(a.y, b.y)) return {};
    const std::int64_t run = (y - a.y) * (b.x - a.x), rise = b.y - a.y;
    if (run % rise != 0) return {};
    const std::int64_t x = a.x + run / rise;
    const int column = pixel_at(x);
    if (pixel_centre(column) != x) return {};
    return {column, column};
}

/// The pixels of both triangles that a table of stages draws.
class DrawnPair {
  public:
    DrawnPair(const Frame& frame, const SharedEdge& shared, FillRule rule)
        : edge_(snapped_corners(frame, shared.triangle)),
          from_(static_cast<std::size_t>(shared.edge)) {
        Settings settings = frame.settings;
        settings.fill_rule = rule;
        stages_ = stages_for(settings, *frame.scene, frame.replace);
        const EdgeRules rules = edge_rules(settings, {});
        for (const auto& [triangle, rows] :
             {std::pair(shared.triangle, &rows_[0]), std::pair(shared.neighbour, &rows_[1])})
            stages_.compute_polygon_rows(frame.triangle_vertices(triangle), rules, stages_, *rows,
                                         nullptr);
    }

    /// The columns that one of the two draws in a row of the picture.
    Columns drawn(std::size_t which, int row) const {
        const PolygonRows& rows = rows_[which];
        const int index = row - rows.first_row;
        if (index < 0 || index >= rows.size() || rows.is_empty_row(index)) return {};
        const RowSpan span = row_span(stages_, rows, index);
        return {span.left, std::int64_t{span.left} + span.drawn - 1};
    }

    /// The pixels of a row whose centres lie on the edge between its ends.
    Columns on_edge(int row) const {
        return centres_on_edge(edge_[from_], edge_[next_corner(from_)], row);
    }

    EdgePixel pixel(int column, int row) const {
        const SampleMask a = samples(0, column, row), b = samples(1, column, row);
        if ((a & b) != 0) return EdgePixel::twice;
        if (a == 0 && b == 0)
            return on_edge(row).has(column) ? EdgePixel::hole : EdgePixel::neither;
        return count_samples(a) >= count_samples(b) ? EdgePixel::triangle : EdgePixel::neighbour;
    }

    EdgeByRule count(FillRule rule) const {
        EdgeByRule result{rule};
        const int top = std::min(rows_[0].first_row, rows_[1].first_row);
        const int bottom =
            std::max(rows_[0].first_row + rows_[0].size(), rows_[1].first_row + rows_[1].size());
        for (int row = top; row < bottom; ++row) {
            const Columns a = drawn(0, row), b = drawn(1, row), centres = on_edge(row);
            const Columns both = in_both(a, b);
            if (has_samples(stages_)) {
                result.twice += count_pixels(both, EdgePixel::twice, row);
                result.holes += count_pixels(centres, EdgePixel::hole, row);
                continue;
            }
            result.twice += both.count();
            result.holes += centres.count() - in_both(centres, a).count() -
                            in_both(centres, b).count() + in_both(centres, both).count();
        }
        return result;
    }

  private:
    /// The samples of a pixel that one of the two draws; of a pixel without several, all or none.
    SampleMask samples(std::size_t which, int column, int row) const {
        if (!drawn(which, row).has(column)) return 0;
        if (!has_samples(stages_)) return mask_of(0);
        return covered_samples(rows_[which], row - rows_[which].first_row, column);
    }

    /// How many of the columns of a row have such a pixel.
    std::int64_t count_pixels(const Columns& columns, EdgePixel wanted, int row) const {
        std::int64_t count = 0;
        for (std::int64_t column = columns.first; column <= columns.last; ++column)
            count += pixel(static_cast<int>(column), row) == wanted ? 1 : 0;
        return count;
    }

    Stages stages_;
    std::array<PolygonRows, 2> rows_;
    SnappedCorners edge_;
    std::size_t from_; ///< the corner at which the edge begins
};

/// The square of the distance from a pixel's centre to an edge of the triangle, square pixels.
double distance_to_edge(const SnappedCorners& corners, int edge, const glm::ivec2& pixel) {
    const auto place = [](const GridPoint& p) {
        return glm::dvec2(p.x, p.y) / static_cast<double>(grid_parts);
    };
    const auto i = static_cast<std::size_t>(edge);
    const glm::dvec2 a = place(corners[i]), edge_vector = place(corners[next_corner(i)]) - a;
    const glm::dvec2 to = glm::dvec2(pixel) + 0.5 - a;
    const double length2 = glm::dot(edge_vector, edge_vector);
    const double t =
        length2 > 0.0 ? std::clamp(glm::dot(to, edge_vector) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 off = to - t * edge_vector;
    return glm::dot(off, off);
}

/// A stretch of pixels, limited to what the window may have, around the middle if it has more.
std::pair<int, int> window_side(int low, int high, int middle) {
    if (high - low <= edge_window_side) return {low, high};
    const int first = std::clamp(middle - edge_window_side / 2, low, high - edge_window_side);
    return {first, first + edge_window_side};
}

/// The middle of the part of the edge from a to b shown for a pixel.
glm::ivec2 middle_of_part(const GridPoint& a, const GridPoint& b,
                          const std::optional<glm::ivec2>& pixel) {
    const bool is_wide = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const auto along = [&](const GridPoint& p) { return is_wide ? p.x : p.y; };
    const std::int64_t from = along(a), length = along(b) - from;
    const std::int64_t low = std::min(from, along(b)), high = std::max(from, along(b));
    std::int64_t at = low + (high - low) / 2;
    if (pixel) {
        constexpr std::int64_t part = grid_parts * edge_window_side;
        const std::int64_t wanted =
            std::clamp(pixel_centre(is_wide ? pixel->x : pixel->y), low, high);
        at = std::min(low + (wanted - low) / part * part + part / 2, high);
    }
    if (length == 0) return {pixel_at(a.x), pixel_at(a.y)};
    const std::int64_t across_from = is_wide ? a.y : a.x,
                       across_length = (is_wide ? b.y : b.x) - across_from;
    const int main = pixel_at(at);
    const int across = pixel_at(across_from + across_length * (at - from) / length);
    return is_wide ? glm::ivec2(main, across) : glm::ivec2(across, main);
}

} // namespace

std::vector<SharedEdge> shared_edges(const Frame& frame, int triangle) {
    std::vector<SharedEdge> found;
    if (walks_edges(frame.stages) || !is_whole(frame, triangle)) return found;
    const SnappedCorners corners = snapped_corners(frame, triangle);
    std::array<bool, triangle_corners> is_known{};
    for (int other = 0; other < frame.triangle_count(); ++other) {
        if (other == triangle || !is_whole(frame, other)) continue;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (is_known[i]) continue;
            const int edge = static_cast<int>(i);
            const auto place = [&](std::size_t corner) {
                return frame.scene->corner(triangle, static_cast<int>(corner)).position;
            };
            const int its = edge_between(frame, other, place(i), place(next_corner(i)));
            if (its < 0) continue;
            const GridPoint &a = corners[i], &b = corners[next_corner(i)];
            const int side = side_of_rest(corners, edge, a, b);
            if (side * side_of_rest(snapped_corners(frame, other), its, a, b) >= 0) continue;
            found.push_back({triangle, edge, other, its});
            is_known[i] = true;
        }
    }
    std::sort(found.begin(), found.end(),
              [](const SharedEdge& a, const SharedEdge& b) { return a.edge < b.edge; });
    return found;
}

EdgeByRules count_by_rules(const Frame& frame, const SharedEdge& shared) {
    EdgeByRules counts;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const FillRule rule = compared_fill_rules[i];
        counts[i] = DrawnPair(frame, shared, rule).count(rule);
    }
    return counts;
}

std::optional<SharedEdge> shared_edge_at(const Frame& frame, int triangle,
                                         const std::optional<glm::ivec2>& pixel) {
    const std::vector<SharedEdge> all = shared_edges(frame, triangle);
    if (all.empty()) return std::nullopt;
    const SnappedCorners corners = snapped_corners(frame, triangle);
    std::vector<double> ranks; // the smallest is shown
    for (const SharedEdge& shared : all) {
        constexpr FillRule rule = FillRule::inclusive;
        ranks.push_back(
            pixel ? distance_to_edge(corners, shared.edge, *pixel)
                  : -static_cast<double>(DrawnPair(frame, shared, rule).count(rule).twice));
    }
    return all[static_cast<std::size_t>(std::min_element(ranks.begin(), ranks.end()) -
                                        ranks.begin())];
}

EdgePicture edge_picture(const Frame& frame, const SharedEdge& shared, const Rectangle& window) {
    EdgePicture picture;
    picture.shared = shared;
    picture.window = window;
    picture.outlines = snapped_outlines(frame, shared);
    for (std::size_t i = 0; i < compared_fill_rules.size(); ++i) {
        const FillRule rule = compared_fill_rules[i];
        const DrawnPair drawn(frame, shared, rule);
        picture.rules[i] = drawn.count(rule);
        for (int row = window.top; row < window.bottom; ++row) {
            for (int column = window.left; column < window.right; ++column)
                picture.pixels[i].push_back(drawn.pixel(column, row));
        }
    }
    return picture;
}

Rectangle edge_window(const Frame& frame, const SharedEdge& shared,
                      const std::optional<glm::ivec2>& pixel) {
    const std::array<SnappedCorners, 2> outlines = snapped_outlines(frame, shared);
    const auto from = static_cast<std::size_t>(shared.edge);
    std::vector<GridPoint> all;
    for (const SnappedCorners& outline : outlines)
        all.insert(all.end(), outline.begin(), outline.end());
    const Rectangle box = touched_pixels(all);
    const glm::ivec2 middle =
        middle_of_part(outlines[0][from], outlines[0][next_corner(from)], pixel);
    const auto [left, right] = window_side(box.left - 1, box.right + 1, middle.x);
    const auto [top, bottom] = window_side(box.top - 1, box.bottom + 1, middle.y);
    return {left, top, right, bottom};
}

} // namespace rasterwalk
