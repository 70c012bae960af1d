#include "pipeline/squares_preparation.h"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <utility>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// Relative to a fragment: the cost of looking at a row of a polygon in a square, and of a row of a
/// table.
constexpr double square_row_work = 0.25;
constexpr double table_row_work = 10;

/// How many rows are looked at for each pixel of a picture, about: as many as in the lab's room.
constexpr double rows_of_pixel = 4;

/// The rows of a table inside an area, as they are drawn.
PixelSurface surface_of_rows(const Frame& frame, const PolygonRows& rows, const Rectangle& area) {
    PixelSurface surface;
    const int first = std::max(area.top - rows.first_row, 0);
    const int end = std::min(area.bottom - rows.first_row, rows.size());
    surface.first_row = rows.first_row + first;
    for (int r = first; r < end; ++r) {
        const RowSpan span = row_span(frame.stages, rows, r);
        const auto i = static_cast<std::size_t>(r);
        SurfaceRow row;
        row.left = span.left;
        // A row that no sample has reached begins at INT_MAX.
        row.end = static_cast<int>(
            std::min<std::int64_t>(std::int64_t{span.left} + std::max(span.drawn, 0), INT_MAX));
        row.depth = double{rows.left[i].depth};
        row.step = (double{rows.right[i].depth} - row.depth) / std::max(span.count - 1, 1);
        surface.rows.push_back(row);
    }
    find_box(surface);
    return surface;
}

} // namespace

SquaresPreparation::SquaresPreparation(const Frame& frame) : frame_(&frame) {
    made_.table_of.assign(static_cast<std::size_t>(frame.triangle_count()), -1);
}

/// Are there rows left for the table of a triangle? Asked before a table is made: it may be huge.
bool SquaresPreparation::fits(int triangle) {
    const Rectangle box = frame_->stages.polygon_box(frame_->triangle_vertices(triangle),
                                                     edge_rules(frame_->settings), frame_->stages);
    rows_sum_ += std::max<long long>(static_cast<long long>(box.bottom) - box.top, 0);
    return rows_sum_ <= most_warnock_rows;
}

void SquaresPreparation::add_table(int triangle) {
    compute_rows(*frame_, triangle, rows_);
    made_.table_of[static_cast<std::size_t>(triangle)] = static_cast<int>(made_.tables.size());
    PolygonRows& kept = made_.tables.emplace_back(rows_);
    // What only makes the table is not kept.
    kept.line = {};
    kept.decisions = {};
    kept.points = {};
    surfaces_.push_back(surface_of_rows(*frame_, kept, drawn_area(*frame_)));
    triangles_.push_back(triangle);
}

void SquaresPreparation::advance(double most) {
    double left = most;
    for (; !is_too_much_ && next_ < frame_->triangle_count() && left > 0.0; ++next_) {
        left -= 1.0;
        if (!frame_->is_drawn(next_)) continue;
        is_too_much_ = !fits(next_);
        if (is_too_much_) break;
        add_table(next_);
        left -= table_row_work * made_.tables.back().size();
    }
    if (is_too_much_ || next_ < frame_->triangle_count()) return;
    if (!division_) division_.emplace(surfaces_, drawn_area(*frame_), depth_kind(*frame_));
    if (left > 0.0) division_->advance(left / square_row_work);
    is_too_much_ = division_->is_too_much();
}

bool SquaresPreparation::is_done() const {
    return is_too_much_ || (division_ && division_->is_done());
}

std::shared_ptr<const WarnockSquares> SquaresPreparation::take() {
    if (is_too_much_) return nullptr;
    made_.squares = division_->take_squares();
    made_.comparisons = division_->comparisons();
    for (WarnockSquare& square : made_.squares) {
        if (square.surface >= 0)
            square.surface = triangles_[static_cast<std::size_t>(square.surface)];
    }
    return std::make_shared<const WarnockSquares>(std::move(made_));
}

double squares_work(const Frame& frame) {
    const Rectangle area = drawn_area(frame);
    if (is_empty(area)) return 0.0;
    return square_row_work * rows_of_pixel * (area.right - area.left) * (area.bottom - area.top);
}

} // namespace rasterwalk
