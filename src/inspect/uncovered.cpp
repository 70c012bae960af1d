#include "inspect/uncovered.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// The rules that decide which pixels a triangle covers.
struct CoverageRule {
    std::string_view text;
    void (*apply)(Settings&);
};

constexpr std::array<CoverageRule, 18> coverage_rules{{
    {"rounding=truncate", [](Settings& s) { set_rounding(s, Rounding::truncate); }},
    {"rounding=floor", [](Settings& s) { set_rounding(s, Rounding::floor); }},
    {"rounding=round", [](Settings& s) { set_rounding(s, Rounding::round); }},
    {"line_walk=accumulate", [](Settings& s) { s.line_walk = LineWalk::accumulate; }},
    {"line_walk=multiply", [](Settings& s) { s.line_walk = LineWalk::multiply; }},
    {"line_walk=exact", [](Settings& s) { s.line_walk = LineWalk::exact; }},
    {"edge_samples=longest_axis", [](Settings& s) { s.edge_samples = EdgeSamples::longest_axis; }},
    {"edge_samples=rows", [](Settings& s) { s.edge_samples = EdgeSamples::rows; }},
    {"fill_rule=inclusive", [](Settings& s) { s.fill_rule = FillRule::inclusive; }},
    {"fill_rule=top_left", [](Settings& s) { s.fill_rule = FillRule::top_left; }},
    {"snap=pixel", [](Settings& s) { s.snap = Snap::pixel; }},
    {"snap=sixteenth", [](Settings& s) { s.snap = Snap::sixteenth; }},
    {"snap=subpixel", [](Settings& s) { s.snap = Snap::subpixel; }},
    // If the other values can only be mistakes, just the right one is worth a try.
    {"row_start=extreme", [](Settings& s) { s.row_start = RowStart::extreme; }},
    {"pixel_sample=centre", [](Settings& s) { s.pixel_sample = PixelSample::centre; }},
    {"spans=inclusive", [](Settings& s) { s.spans = Spans::inclusive; }},
    {"outside_picture=kept", [](Settings& s) { s.outside_picture = OutsidePicture::kept; }},
    {"rotation=row_vector", [](Settings& s) { s.rotation = Rotation::row_vector; }},
}};

/// How far a number lies outside first..last; negative before it.
int beyond(int number, int first, int last) {
    return number < first ? number - first : number > last ? number - last : 0;
}

std::int64_t squared_distance(int columns, int rows) {
    return std::int64_t{columns} * columns + std::int64_t{rows} * rows;
}
std::int64_t squared_distance(const NearTriangle& near) {
    return squared_distance(near.columns_away, near.rows_away);
}

/// From the pixel to the box of the triangle's vertices, which none of its rows leaves: right and
/// down are positive.
glm::ivec2 offset_to_box(const Frame& frame, int triangle, const glm::ivec2& pixel) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    return {-beyond(pixel.x, box.left, box.right - 1), -beyond(pixel.y, box.top, box.bottom - 1)};
}

NearTriangle look_at(const Frame& frame, int triangle, const glm::ivec2& pixel, PolygonRows& rows) {
    compute_rows(frame, triangle, rows, nullptr, {});
    NearTriangle near;
    near.triangle = triangle;
    near.first_row = rows.first_row;
    near.last_row = rows.first_row + rows.size() - 1;
    near.row = std::clamp(pixel.y, near.first_row, near.last_row);
    near.rows_away = near.row - pixel.y;
    const int index = near.row - rows.first_row;
    // If no sample has reached a row, nothing of it is in the picture, drawn or not.
    const bool is_row_empty = rows.is_empty_row(index);
    const int drawn = is_row_empty ? 0 : row_span(frame.stages, rows, index).drawn;
    near.is_empty = drawn == 0;
    near.is_by_samples = walks_edges(frame.stages);
    near.has_samples = frame.has_samples();
    near.is_left_out = drawn == 0 && !is_row_empty;
    if (near.is_empty) {
        near.columns_away = offset_to_box(frame, triangle, pixel).x;
        return near;
    }
    near.left = rows.left[index].column;
    near.right = near.left + drawn - 1;
    near.columns_away = -beyond(pixel.x, near.left, near.right);
    return near;
}

bool covers_pixel(const NearTriangle& near) {
    return !near.is_empty && near.rows_away == 0 && near.columns_away == 0;
}

/// Draws the triangles again under every other rule, and adds the rules that bring one to the
/// pixel.
void try_other_rules(const Frame& frame, const glm::ivec2& pixel,
                     std::vector<NearTriangle>& found) {
    Scene scene;
    scene.space = frame.scene->space;
    for (const NearTriangle& near : found)
        scene.mesh.add_triangle_of(corners_of(*frame.scene, near.triangle));
    PolygonRows rows;
    for (const CoverageRule& rule : coverage_rules) {
        Settings settings = frame.settings;
        rule.apply(settings);
        if (settings == frame.settings) continue;
        settings.tessellation = 1; // these triangles are already divided
        const Frame other = prepare_frame(scene, settings, frame.replace);
        for (int i = 0; i < other.triangle_count(); ++i) {
            if (!other.is_drawn(i)) continue;
            const NearTriangle now = look_at(other, i, pixel, rows);
            if (covers_pixel(now)) found[i].rules.push_back({rule.text, now.left, now.right});
        }
    }
}

/// Is it a pixel of the picture that the bounds test always refuses?
bool is_out_of_bounds(const Frame& frame, const glm::ivec2& pixel) {
    const Rectangle area = drawn_area(frame);
    return pixel.x < area.left || pixel.y < area.top;
}

/// The squared distance of a triangle's box, and the triangle.
using BoxDistance = std::pair<std::int64_t, int>;

BoxDistance distance_of_box(const Frame& frame, int triangle, const glm::ivec2& pixel) {
    const glm::ivec2 offset = offset_to_box(frame, triangle, pixel);
    return {squared_distance(offset.x, offset.y), triangle};
}

/// This many boxes are kept while all are looked at. Thousands of tiny triangles can have boxes
/// that are equally near: their rows differ by a pixel at most.
constexpr std::size_t kept_boxes = 1024;

void keep_nearest_boxes(std::vector<BoxDistance>& boxes) {
    if (boxes.size() <= kept_boxes) return;
    std::nth_element(boxes.begin(), boxes.begin() + kept_boxes, boxes.end());
    boxes.resize(kept_boxes);
}

/// Boxes are cheap and row tables are not: the triangles are looked at in the order of their boxes,
/// until no box can hold a row nearer than those found.
std::vector<NearTriangle> nearest_rows(const Frame& frame, const glm::ivec2& pixel,
                                       std::vector<BoxDistance> heap, int count) {
    std::make_heap(heap.begin(), heap.end(), std::greater<>());
    std::vector<BoxDistance> best; // nearest first; the second number is an index of `checked`
    std::vector<NearTriangle> checked;
    PolygonRows rows;
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end(), std::greater<>());
        const auto [box_distance, triangle] = heap.back();
        heap.pop_back();
        const bool is_full = static_cast<int>(best.size()) == count;
        if (is_full && box_distance >= best.back().first) break;
        const NearTriangle near = look_at(frame, triangle, pixel, rows);
        const BoxDistance candidate{squared_distance(near), static_cast<int>(checked.size())};
        if (is_full && candidate.first >= best.back().first) continue;
        if (is_full) best.pop_back();
        best.insert(std::upper_bound(best.begin(), best.end(), candidate), candidate);
        checked.push_back(near);
    }
    std::vector<NearTriangle> found;
    for (const BoxDistance& candidate : best)
        found.push_back(checked[static_cast<std::size_t>(candidate.second)]);
    return found;
}

std::string column_direction(int columns) {
    return fmt::format("{} to the {} of", counted(std::abs(columns), "column", "columns"),
                       columns > 0 ? "right" : "left");
}

std::string row_direction(int rows) {
    return fmt::format("{} {}", counted(std::abs(rows), "row", "rows"),
                       rows > 0 ? "below" : "above");
}

} // namespace

std::vector<NearTriangle> nearest_triangles(const Frame& frame, const glm::ivec2& pixel,
                                            int count) {
    NearestSearch search(frame, pixel);
    search.look(frame.triangle_count());
    return search.found(count);
}

NearestSearch::NearestSearch(const Frame& frame, const glm::ivec2& pixel)
    : frame_(&frame), pixel_(pixel) {
    const bool has_rows = has_fragments(frame.settings.stage) && !is_out_of_bounds(frame, pixel);
    if (has_rows) end_ = frame.triangle_count();
}

void NearestSearch::look(int triangles) {
    const int end = next_ + std::min(triangles, end_ - next_);
    for (; next_ < end; ++next_) {
        if (!frame_->is_drawn(next_)) continue;
        boxes_.push_back(distance_of_box(*frame_, next_, pixel_));
        if (boxes_.size() >= 2 * kept_boxes) keep_nearest_boxes(boxes_);
    }
}

std::vector<NearTriangle> NearestSearch::found(int count) {
    if (boxes_.empty() || count <= 0) return {};
    keep_nearest_boxes(boxes_);
    std::vector<NearTriangle> found = nearest_rows(*frame_, pixel_, std::move(boxes_), count);
    try_other_rules(*frame_, pixel_, found);
    // Among equally near ones, those that could have been there come first.
    std::stable_sort(found.begin(), found.end(), [](const NearTriangle& a, const NearTriangle& b) {
        return std::pair(squared_distance(a), a.rules.empty()) <
               std::pair(squared_distance(b), b.rules.empty());
    });
    return found;
}

std::string uncovered_text(const Frame& frame, const glm::ivec2& pixel) {
    if (is_out_of_bounds(frame, pixel)) {
        return "The bounds test lets only columns and rows above 0 through (bounds=excludes_zero).";
    }
    const auto is_left_out = [](const Polygon& p) { return p.rejection != Rejection::none; };
    if (std::all_of(frame.polygons.begin(), frame.polygons.end(), is_left_out)) {
        return "No triangle of the scene is drawn.";
    }
    switch (frame.settings.stage) {
    case Stage::points:
        return "The points stage draws only the vertices, and none falls on this pixel.";
    case Stage::edges:
        return "The edges stage draws only the edges, and none of their samples falls on this "
               "pixel.";
    case Stage::rows:
        return "The rows stage draws only the two ends of each row, and none falls on this pixel.";
    default:
        return "No row of any triangle reaches this pixel.";
    }
}

std::string miss_text(const NearTriangle& near) {
    if (near.rows_away != 0) {
        const char* const which = near.rows_away > 0 ? "first" : "last";
        const std::string text =
            fmt::format("its {} row is {}, {}", which, near.row, row_direction(near.rows_away));
        if (near.columns_away == 0) return text + " the pixel";
        return fmt::format("{} and {} the pixel", text, column_direction(near.columns_away));
    }
    if (near.is_left_out)
        return fmt::format("its row {} is a single pixel, which is passed over", near.row);
    if (near.is_empty) {
        return near.is_by_samples
                   ? fmt::format("no edge sample reached its row {}", near.row)
                   : fmt::format("no {} of its row {} lies inside",
                                 near.has_samples ? "sample" : "pixel centre", near.row);
    }
    const bool begins = near.columns_away > 0;
    return fmt::format("row {} {} at column {}, {} the pixel", near.row, begins ? "begins" : "ends",
                       begins ? near.left : near.right, column_direction(near.columns_away));
}

std::string rules_text(const NearTriangle& near, const glm::ivec2& pixel) {
    const auto outcome = [&](const OtherRule& rule) {
        const bool is_in_row = near.rows_away == 0;
        if (is_in_row && near.columns_away > 0)
            return fmt::format("it begins at column {}", rule.left);
        if (is_in_row && near.columns_away < 0)
            return fmt::format("it ends at column {}", rule.right);
        return fmt::format("its row {} goes from column {} to {}", pixel.y, rule.left, rule.right);
    };
    std::string text, last_outcome;
    for (const OtherRule& rule : near.rules) {
        const std::string now = outcome(rule);
        if (now == last_outcome) {
            text += " or ";
        } else {
            text += last_outcome.empty() ? "with " : " " + last_outcome + ", with ";
        }
        text += rule.rule;
        last_outcome = now;
    }
    return last_outcome.empty() ? text : text + " " + last_outcome;
}

} // namespace rasterwalk
