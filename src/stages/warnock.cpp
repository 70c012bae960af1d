#include "stages/warnock.h"

#include <algorithm>
#include <utility>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// The rows that a polygon and a square have in common.
struct CommonRows {
    int first, end;
};
CommonRows common_rows(const PixelSurface& surface, const Rectangle& square) {
    return {std::max(surface.box.top, square.top), std::min(surface.box.bottom, square.bottom)};
}

bool is_nearer_at(const SurfaceRow& row, const SurfaceRow& than, int column, ClipDepth kind) {
    const double depth = row.depth_at(column), other = than.depth_at(column);
    return is_smaller_nearer(kind) ? depth < other : depth > other;
}

} // namespace

void find_box(PixelSurface& surface) {
    surface.box = {};
    for (std::size_t i = 0; i < surface.rows.size(); ++i) {
        const SurfaceRow& row = surface.rows[i];
        const int y = surface.first_row + static_cast<int>(i);
        surface.box = around(surface.box, {row.left, y, row.end, y + 1});
    }
}

SquareRelation relation_to(const PixelSurface& surface, const Rectangle& square) {
    if (is_empty(intersection(surface.box, square))) return SquareRelation::disjoint;
    const auto [first, end] = common_rows(surface, square);
    bool meets = false, surrounds = first == square.top && end == square.bottom;
    for (int y = first; y < end && (surrounds || !meets); ++y) {
        const SurfaceRow& row = surface.row(y);
        meets = meets || std::max(row.left, square.left) < std::min(row.end, square.right);
        surrounds = surrounds && row.left <= square.left && row.end >= square.right;
    }
    return surrounds ? SquareRelation::surrounding
           : meets   ? SquareRelation::intersecting
                     : SquareRelation::disjoint;
}

bool is_in_front(const PixelSurface& surface, const PixelSurface& other, const Rectangle& square,
                 ClipDepth kind, bool wins_ties) {
    const auto [first, end] = common_rows(other, square);
    for (int y = first; y < end; ++y) {
        const SurfaceRow &row = surface.row(y), &behind = other.row(y);
        const int left = std::max(behind.left, square.left);
        const int last = std::min(behind.end, square.right) - 1;
        if (left > last) continue;
        for (const int column : {left, last}) {
            const bool wins = wins_ties ? !is_nearer_at(behind, row, column, kind)
                                        : is_nearer_at(row, behind, column, kind);
            if (!wins) return false;
        }
    }
    return true;
}

int divide(const Rectangle& square, std::array<Rectangle, 4>& parts) {
    const int width = square.right - square.left, height = square.bottom - square.top;
    const int x = square.left + width / 2, y = square.top + height / 2;
    int count = 0;
    for (const auto& [top, bottom] : {std::pair(square.top, y), std::pair(y, square.bottom)}) {
        for (const auto& [left, right] : {std::pair(square.left, x), std::pair(x, square.right)}) {
            const Rectangle part{left, top, right, bottom};
            if (!is_empty(part)) parts[static_cast<std::size_t>(count++)] = part;
        }
    }
    return count > 1 ? count : 0;
}

WarnockDivision::WarnockDivision(std::span<const PixelSurface> surfaces, const Rectangle& picture,
                                 ClipDepth kind)
    : surfaces_(surfaces), kind_(kind) {
    if (is_empty(picture)) return;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!is_empty(intersection(surfaces[i].box, picture)))
            lists_.push_back(static_cast<int>(i));
    }
    waiting_.push_back({picture, 0, -1, 0, lists_.size()});
}

bool WarnockDivision::is_too_much() const {
    return squares_.size() > most_warnock_squares || steps_ > most_warnock_steps;
}

void WarnockDivision::advance(double most) {
    const std::int64_t begun = steps_;
    while (!is_done() && !is_too_much() && static_cast<double>(steps_ - begun) < most) {
        const Waiting next = waiting_.back();
        waiting_.pop_back();
        look_at(next);
    }
}

void WarnockDivision::look_at(const Waiting& waiting) {
    const Rectangle& pixels = waiting.pixels;
    met_.clear();
    ++steps_;
    for (std::size_t i = waiting.list_begin; i < waiting.list_end; ++i) {
        const int surface = lists_[i];
        ++comparisons_;
        steps_ += pixels.bottom - pixels.top;
        const SquareRelation relation =
            relation_to(surfaces_[static_cast<std::size_t>(surface)], pixels);
        if (relation != SquareRelation::disjoint) met_.push_back({surface, relation});
    }
    WarnockSquare square{pixels, SquareReason::empty, -1, waiting.depth, waiting.parent, 0};
    square.reason = reason_of(pixels, square.surface);
    const int number = static_cast<int>(squares_.size());
    for (int above = square.parent; above >= 0;
         above = squares_[static_cast<std::size_t>(above)].parent)
        ++squares_[static_cast<std::size_t>(above)].below;
    squares_.push_back(square);
    if (square.reason != SquareReason::divide) return;
    // Lists beyond the parent's belong to squares that are done.
    lists_.resize(waiting.list_end);
    for (const Met& met : met_)
        lists_.push_back(met.surface);
    std::array<Rectangle, 4> parts;
    for (int part = divide(pixels, parts); part-- > 0;) {
        waiting_.push_back({parts[static_cast<std::size_t>(part)], square.depth + 1, number,
                            waiting.list_end, lists_.size()});
    }
}

/// The surrounding polygon that is nearest at the first pixel of a square, the only one that can be
/// in front of all others; -1: none surrounds it.
int WarnockDivision::nearest_surrounding(const Rectangle& square) {
    int nearest = -1;
    for (const Met& met : met_) {
        if (met.relation != SquareRelation::surrounding) continue;
        if (nearest < 0) {
            nearest = met.surface;
            continue;
        }
        ++comparisons_;
        ++steps_;
        const SurfaceRow& row = surfaces_[static_cast<std::size_t>(met.surface)].row(square.top);
        const SurfaceRow& other = surfaces_[static_cast<std::size_t>(nearest)].row(square.top);
        if (is_nearer_at(row, other, square.left, kind_)) nearest = met.surface;
    }
    return nearest;
}

SquareReason WarnockDivision::reason_of(const Rectangle& pixels, int& surface) {
    if (met_.empty()) return SquareReason::empty;
    surface = met_.front().surface;
    if (met_.size() == 1) return SquareReason::one_surface;
    const int nearest = nearest_surrounding(pixels);
    surface = nearest;
    const bool is_pixel = pixels.right - pixels.left == 1 && pixels.bottom - pixels.top == 1;
    if (is_pixel) return SquareReason::one_pixel;
    const auto is_behind = [&](const Met& met) {
        if (met.surface == nearest) return true;
        ++comparisons_;
        steps_ += pixels.bottom - pixels.top;
        return is_in_front(surfaces_[static_cast<std::size_t>(nearest)],
                           surfaces_[static_cast<std::size_t>(met.surface)], pixels, kind_,
                           nearest < met.surface);
    };
    if (nearest >= 0 && std::all_of(met_.begin(), met_.end(), is_behind))
        return SquareReason::one_in_front;
    surface = -1;
    return SquareReason::divide;
}

} // namespace rasterwalk
