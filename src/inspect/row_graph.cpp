#include "inspect/row_graph.h"

#include <algorithm>
#include <cmath>

#include "stages/orthographic.h"

namespace rasterwalk {

std::optional<RowGraph> row_graph(const Frame& frame, int triangle, int index) {
    const std::optional<CarriedRow> row = carried_row(frame, triangle, index);
    if (!row) return std::nullopt;
    RowGraph graph;
    graph.row = *row;
    graph.projection = vertex_rules(frame.settings, frame.scene->space).projection;
    graph.first_column = row->under(Interpolation::perspective).left.column;
    for (const Interpolation mode : all_interpolations) {
        graph.fragments[static_cast<std::size_t>(mode)] = row->fragments(mode);
    }
    return graph;
}

std::optional<int> widest_row(const Frame& frame, int triangle) {
    PolygonRows rows;
    compute_rows(frame, triangle, rows, nullptr, {});
    const Rectangle area = drawn_area(frame);
    std::optional<int> widest;
    int most = 0;
    for (int r = 0; r < rows.size(); ++r) {
        const int row = rows.first_row + r;
        if (row < area.top || row >= area.bottom || rows.is_empty_row(r)) continue;
        const RowSpan span = row_span(frame.stages, rows, r);
        const int count =
            std::min(span.left + span.drawn, area.right) - std::max(span.left, area.left);
        if (count > most) {
            most = count;
            widest = r;
        }
    }
    return widest;
}

float true_value(const RowGraph& graph, Quantity quantity, int index) {
    const Fragment& fragment = graph.at(Interpolation::perspective, index);
    if (quantity == Quantity::zinv) return fragment.inv_w;
    if (quantity == Quantity::z) return fragment_depth(fragment, graph.projection.mix);
    return part_of(
        recover_varyings(fragment,
                         graph.row.stages[static_cast<std::size_t>(Interpolation::perspective)]),
        quantity);
}

float affine_value(const RowGraph& graph, Quantity quantity, int index) {
    const Fragment& fragment = graph.at(Interpolation::affine, index);
    if (quantity == Quantity::zinv) return 1.0f / clip_w(fragment.z, graph.projection);
    if (quantity == Quantity::z) return fragment.z;
    return part_of(fragment.varyings, quantity);
}

float carried_value(const RowGraph& graph, Quantity quantity, int index) {
    const Fragment& fragment = graph.at(Interpolation::perspective, index);
    return is_varying(quantity) ? part_of(fragment.varyings, quantity) : fragment.inv_w;
}

int worst_index(const RowGraph& graph, Quantity quantity) {
    int worst = 0;
    float largest = 0.0f;
    for (int i = 0; i < graph.count(); ++i) {
        const float error =
            std::abs(affine_value(graph, quantity, i) - true_value(graph, quantity, i));
        if (error > largest) {
            largest = error;
            worst = i;
        }
    }
    return worst;
}

Ticks nice_ticks(const Interval& range, int most) {
    Ticks ticks;
    const double width = range.high - range.low;
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || !(width > 0.0) || most < 1) {
        return ticks;
    }
    // A width that vanishes next to the numbers would make ticks that look the same.
    if (width < 1e-12 * std::max(std::abs(range.low), std::abs(range.high))) return ticks;
    double power = std::pow(10.0, std::floor(std::log10(width / most)));
    const auto fits = [&](double step) {
        return std::floor(range.high / step) - std::ceil(range.low / step) + 1.0 <= most;
    };
    double step = power;
    for (int i = 0; !fits(step); ++i) {
        if (i % 3 == 2) power *= 10.0;
        step = power * (i % 3 == 0 ? 2.0 : i % 3 == 1 ? 5.0 : 1.0);
    }
    ticks.digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const auto first = static_cast<long long>(std::ceil(range.low / step));
    const auto last = static_cast<long long>(std::floor(range.high / step));
    for (long long k = first; k <= last; ++k)
        ticks.places.push_back(static_cast<double>(k) * step);
    return ticks;
}

Interval with_margin(const Interval& range, double share) {
    double width = range.high - range.low;
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    // Without any change along the row the line lies in the middle.
    const double least = std::max(1e-3 * size, 1e-6);
    double low = range.low, high = range.high;
    if (width < least) {
        const double middle = 0.5 * (low + high);
        low = middle - 0.5 * least;
        high = middle + 0.5 * least;
        width = least;
    }
    return {low - share * width, high + share * width};
}

} // namespace rasterwalk
