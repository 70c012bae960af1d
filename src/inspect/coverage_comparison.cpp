#include "inspect/coverage_comparison.h"

#include <algorithm>
#include <array>
#include <cstdlib>
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
void add_stretches(const Frame& frame, PolygonCorners corners, std::vector<Stretch>& all) {
    for (const InsideSpan& span :
         active_edge_spans(corners, edge_rules(frame.settings, {}), frame.stages))
        all.push_back({span.row, span.left.column, span.right.column});
}

/// The same pixels, each in one stretch only; from top to bottom and from left to right.
std::vector<Stretch> each_once(std::vector<Stretch> written) {
    std::sort(written.begin(), written.end(), [](const Stretch& a, const Stretch& b) {
        return a.row != b.row ? a.row < b.row : a.first < b.first;
    });
    std::vector<Stretch> all;
    for (Stretch stretch : written) {
        if (!all.empty() && all.back().row == stretch.row)
            stretch.first = std::max(stretch.first, all.back().last + 1);
        if (stretch.count() > 0) all.push_back(stretch);
    }
    return all;
}

std::int64_t pixels_of(const std::vector<Stretch>& stretches) {
    std::int64_t pixels = 0;
    for (const Stretch& stretch : stretches)
        pixels += stretch.count();
    return pixels;
}

/// The pixels that two lists have in common; each list has a pixel once, in order.
std::int64_t pixels_in_both(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
    std::int64_t pixels = 0;
    for (auto p = a.begin(), q = b.begin(); p != a.end() && q != b.end();) {
        if (p->row == q->row) {
            const Stretch both{p->row, std::max(p->first, q->first), std::min(p->last, q->last)};
            pixels += std::max<std::int64_t>(both.count(), 0);
        }
        const bool ends_first = p->row != q->row ? p->row < q->row : p->last < q->last;
        ++(ends_first ? p : q);
    }
    return pixels;
}

/// All pixels of every row from its first to its last one: the contents of a table with two ends
/// per row.
std::vector<Stretch> from_end_to_end(const std::vector<Stretch>& inside) {
    std::vector<Stretch> rows;
    for (const Stretch& stretch : inside) {
        if (rows.empty() || rows.back().row != stretch.row)
            rows.push_back(stretch);
        else
            rows.back().last = stretch.last;
    }
    return rows;
}

/// The stretches that the triangles of the polygon's fan cover, one triangle after the other.
std::vector<Stretch> written_by_fan(const Frame& frame, const std::vector<ScreenVertex>& outline) {
    std::vector<Stretch> written;
    for_each_fan_corners(outline.size(), [&](std::size_t a, std::size_t b, std::size_t c) {
        add_stretches(frame, std::array{outline[a], outline[b], outline[c]}, written);
    });
    return written;
}

void count_inside(const std::vector<Stretch>& inside, CoverageComparison& comparison) {
    const std::vector<Stretch> table = from_end_to_end(inside);
    comparison.inside = pixels_of(inside);
    comparison.table = pixels_of(table);
    comparison.rows = static_cast<int>(table.size());
    auto stretch = inside.begin();
    for (const Stretch& row : table) {
        std::int64_t pixels = 0;
        for (; stretch != inside.end() && stretch->row == row.row; ++stretch)
            pixels += stretch->count();
        comparison.wrong_rows += pixels != row.count() ? 1 : 0;
    }
}

/// One side of a box: all of it, or its middle.
std::pair<int, int> shown_side(int low, int high) {
    const int shown = std::min(high - low, polygon_window_side);
    const int first = low + (high - low - shown) / 2;
    return {first, first + shown};
}

/// Changes the pixels of the window that a way covers.
template <class Change>
void for_pixels(const std::vector<Stretch>& stretches, const Rectangle& window, Change change) {
    const int width = window.right - window.left;
    for (const Stretch& stretch : stretches) {
        if (stretch.row < window.top || stretch.row >= window.bottom) continue;
        const int first = std::max(stretch.first, window.left);
        const int last = std::min(stretch.last, window.right - 1);
        for (int column = first; column <= last; ++column)
            change(static_cast<std::size_t>((stretch.row - window.top) * width + column -
                                            window.left));
    }
}

CoverageByMethod by_method(const std::vector<Stretch>& covered, const std::vector<Stretch>& inside,
                           const Rectangle& window) {
    CoverageByMethod method;
    method.covered = pixels_of(covered);
    method.wrong = method.covered + pixels_of(inside) - 2 * pixels_in_both(covered, inside);
    method.pixels.resize(static_cast<std::size_t>(window.right - window.left) *
                         static_cast<std::size_t>(window.bottom - window.top));
    for_pixels(inside, window, [&](std::size_t at) { method.pixels[at] = PolygonPixel::missed; });
    for_pixels(covered, window, [&](std::size_t at) {
        PolygonPixel& pixel = method.pixels[at];
        pixel = pixel == PolygonPixel::missed ? PolygonPixel::inside : PolygonPixel::filled;
    });
    return method;
}

/// Is the triangle drawn, with the corners of the fan?
bool goes_on(const Frame& frame, int triangle, const std::vector<ScreenVertex>& outline) {
    if (!frame.is_drawn(triangle) || frame.is_cut(triangle)) return false;
    if (outline.empty()) return true;
    const PolygonCorners corners = frame.triangle_vertices(triangle);
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
        const PolygonCorners corners = frame.triangle_vertices(t);
        for (std::size_t c = outline.empty() ? 0 : corners.size() - 1; c < corners.size(); ++c)
            outline.push_back(corners[c]);
    }
    return outline;
}

std::optional<CoverageComparison> coverage_comparison(const Frame& frame, int triangle) {
    const std::vector<ScreenVertex> outline = outline_of(frame, triangle);
    if (outline.empty()) return {};
    CoverageComparison comparison;
    comparison.corners = static_cast<int>(outline.size());
    std::vector<Stretch> inside;
    add_stretches(frame, outline, inside);
    count_inside(inside, comparison);
    const std::vector<Stretch> written = written_by_fan(frame, outline);
    comparison.fan_writes = pixels_of(written);
    comparison.fan = pixels_of(each_once(written));
    std::int64_t area = 0, fan_area = 0; // twice
    std::vector<GridPoint> points;
    snap_corners(outline, frame.stages, points);
    for_each_fan_triangle(points, [&](const FanTriangle& fan) {
        area += fan.area;
        fan_area += std::abs(fan.area);
    });
    comparison.area = in_square_pixels(std::abs(area)) / 2.0;
    comparison.fan_area = in_square_pixels(fan_area) / 2.0;
    return comparison;
}

std::optional<PolygonPicture> polygon_picture(const Frame& frame, int triangle) {
    const std::vector<ScreenVertex> corners = outline_of(frame, triangle);
    if (corners.empty()) return {};
    PolygonPicture picture;
    snap_corners(corners, frame.stages, picture.outline);
    const Rectangle box = touched_pixels(picture.outline);
    const auto [left, right] = shown_side(box.left - 1, box.right + 1);
    const auto [top, bottom] = shown_side(box.top - 1, box.bottom + 1);
    picture.window = {left, top, right, bottom};
    std::vector<Stretch> inside;
    add_stretches(frame, corners, inside);
    const auto show = [&](CoverageMethod method, const std::vector<Stretch>& covered) {
        picture.methods[static_cast<std::size_t>(method)] =
            by_method(covered, inside, picture.window);
    };
    show(CoverageMethod::table, from_end_to_end(inside));
    show(CoverageMethod::fan, each_once(written_by_fan(frame, corners)));
    show(CoverageMethod::active_edges, inside);
    return picture;
}

} // namespace rasterwalk
