#include "ui/bars/time_window.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

namespace {

/// The least part of a triangle's line that a piece gets.
constexpr double least_share = 0.16;

/// Limits the window to the frame.
void keep_inside(TimeWindow& window) {
    const double all = std::max(window.triangles, 1);
    window.width = std::min(window.width, all);
    window.begin = std::clamp(window.begin, 0.0, all - window.width);
}

} // namespace

void follow_moment(TimeWindow& window, int triangles, double place, const Cursor& cursor,
                   double usual) {
    const bool is_new = window.triangles != triangles || window.usual != usual;
    const bool has_moved = is_new || cursor != window.followed;
    window.triangles = triangles;
    window.usual = usual;
    window.followed = cursor;
    if (is_new) show_triangle(window, place);
    const bool is_outside = place < window.begin || place >= window.begin + window.width;
    if (has_moved && is_outside && !window.is_dragged) {
        window.begin += std::floor((place - window.begin) / window.width) * window.width;
    }
    keep_inside(window);
}

void zoom_window(TimeWindow& window, double factor, double about, double least) {
    const double all = std::max(window.triangles, 1);
    const double width = std::clamp(window.width * factor, std::min(least, all), all);
    const double share = std::clamp((about - window.begin) / window.width, 0.0, 1.0);
    window.begin += share * (window.width - width);
    window.width = width;
    keep_inside(window);
}

void pan_window(TimeWindow& window, double by) {
    window.begin += by;
    keep_inside(window);
}

void show_triangle(TimeWindow& window, double place) {
    window.width = window.usual;
    const double page = std::floor(std::min(place, window.triangles - 1.0) / window.usual);
    window.begin = page * window.usual;
    keep_inside(window);
}

double TriangleScale::share_of(int ordinal) const {
    const auto end = std::upper_bound(ordinals.begin() + 1, ordinals.end() - 1, ordinal);
    const auto piece = static_cast<std::size_t>(end - ordinals.begin()) - 1;
    const double within = static_cast<double>(ordinal - ordinals[piece]) /
                          std::max(ordinals[piece + 1] - ordinals[piece], 1);
    return shares[piece] + std::clamp(within, 0.0, 1.0) * (shares[piece + 1] - shares[piece]);
}

int TriangleScale::ordinal_at(double share) const {
    // Converting there and back loses a little; no more than this part of a moment.
    constexpr double slack = 0.01;
    const auto end = std::upper_bound(shares.begin() + 1, shares.end() - 1, share);
    const auto piece = static_cast<std::size_t>(end - shares.begin()) - 1;
    const double width = shares[piece + 1] - shares[piece];
    const double within = width > 0.0 ? std::clamp((share - shares[piece]) / width, 0.0, 1.0) : 0.0;
    const int count = ordinals[piece + 1] - ordinals[piece];
    return ordinals[piece] + std::min(static_cast<int>(within * count + slack), count);
}

TriangleScale triangle_scale(const TriangleMoments& moments) {
    TriangleScale scale;
    scale.ordinals.push_back(0);
    int before = 0;
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = moments.of(info.phase);
        if (info.phase == Phase::edges) {
            for (std::size_t e = 1; e < phase.before.size(); ++e)
                scale.ordinals.push_back(before + phase.before[e]);
        } else if (phase.count() > 0) {
            scale.ordinals.push_back(before + phase.count());
        }
        before += phase.count();
    }
    if (scale.ordinals.size() == 1) scale.ordinals.push_back(before);
    const double least = least_share * moments.count;
    scale.shares.push_back(0.0);
    for (std::size_t i = 1; i < scale.ordinals.size(); ++i) {
        const int count = scale.ordinals[i] - scale.ordinals[i - 1];
        scale.shares.push_back(scale.shares.back() + std::max(static_cast<double>(count), least));
    }
    const double all = scale.shares.back();
    for (double& share : scale.shares)
        share = all > 0.0 ? share / all : 0.0;
    scale.shares.back() = 1.0;
    return scale;
}

} // namespace rasterwalk
