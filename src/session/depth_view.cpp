#include "session/depth_view.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// How far the axis extends beyond the values on each side, as a part of their range: room to grab
/// the ends.
constexpr float axis_margin = 0.06f;

/// A bar of full height is `largest_bar` times the bin at this quantile.
constexpr double typical_part = 0.85;
constexpr double largest_bar = 1.5;

/// The smallest range, as a part of the axis.
constexpr float smallest_range = 0.01f;

DepthRange axis_around(const DepthRange& present, ClipDepth kind) {
    const auto [low, high] = values_of(present);
    // A single value needs some width as well.
    const float least = is_smaller_nearer(kind) ? 1e-3f : 1e-3f * high;
    const float margin = axis_margin * std::max(high - low, least);
    // Nothing is beyond the farthest depth.
    if (is_smaller_nearer(kind))
        return {std::min(high + margin, farthest_depth(kind)), low - margin};
    return {std::max(low - margin, farthest_depth(kind)), high + margin};
}

float smallest_distance(const DepthRange& axis) {
    return smallest_range * std::abs(axis.near - axis.far);
}

/// The count for full height. A wall that faces the camera fills one bin with more pixels than all
/// others; relative to the largest bin, the rest would be flat.
std::int64_t full_height(std::vector<std::int64_t> bins) {
    bins.erase(std::remove(bins.begin(), bins.end(), 0), bins.end());
    if (bins.empty()) return 1;
    std::sort(bins.begin(), bins.end());
    const double typical = static_cast<double>(
        bins[static_cast<std::size_t>(typical_part * static_cast<double>(bins.size()))]);
    const auto limit = static_cast<std::int64_t>(largest_bar * typical);
    return std::clamp<std::int64_t>(bins.back(), 1, std::max<std::int64_t>(limit, 1));
}

/// Sets the smaller or the larger end of the range, as stored.
/// @param bottom the smallest value allowed for the end
void set_low(Session& session, const DepthView& view, float bottom, float value) {
    const DepthRange& axis = view.histogram.axis;
    const float high = values_of(view.range).largest;
    const float largest = std::max(high - smallest_distance(axis), bottom);
    const float smallest = std::min(values_of(axis).smallest, largest);
    session.depth_range = DepthInterval{std::clamp(value, smallest, largest), high};
}
void set_high(Session& session, const DepthView& view, float value) {
    const DepthRange& axis = view.histogram.axis;
    const float low = values_of(view.range).smallest;
    const float smallest = low + smallest_distance(axis);
    const float largest = std::max(values_of(axis).largest, smallest);
    session.depth_range = DepthInterval{low, std::clamp(value, smallest, largest)};
}

} // namespace

double z_of_stored_depth(const Frame& frame, float depth) {
    return z_of_depth(depth, depth_rules(frame.settings, frame.scene->space));
}

DepthView depth_view(const Framebuffer& framebuffer, const std::optional<DepthInterval>& chosen) {
    DepthView view;
    const ClipDepth kind = view.kind = framebuffer.rules.depth_kind;
    view.present = present_depths(framebuffer);
    view.range = shown_depths(kind, chosen, view.present);
    view.histogram.axis = axis_around(view.present.value_or(view.range), kind);
    view.histogram.bins.assign(depth_bins, 0);
    for (const float depth : framebuffer.depth) {
        if (!has_depth(framebuffer, depth)) continue;
        ++view.drawn;
        view.farther += is_nearer(view.range.far, depth, kind) ? 1 : 0;
        view.nearer += is_nearer(depth, view.range.near, kind) ? 1 : 0;
        const float place = view.histogram.axis.place(depth);
        if (!std::isfinite(place)) continue;
        const int bin = static_cast<int>(std::clamp(place, 0.0f, 1.0f) * depth_bins);
        ++view.histogram.bins[static_cast<std::size_t>(std::min(bin, depth_bins - 1))];
    }
    view.histogram.full = full_height(view.histogram.bins);
    return view;
}

void set_far(Session& session, const DepthView& view, float value) {
    if (is_smaller_nearer(view.kind))
        set_high(session, view, value);
    else
        set_low(session, view, farthest_depth(view.kind), value);
}

void set_near(Session& session, const DepthView& view, float value) {
    if (is_smaller_nearer(view.kind))
        set_low(session, view, view.histogram.axis.near, value);
    else
        set_high(session, view, value);
}

std::string to_text(const DepthInterval& range) {
    return number_text(range.smallest) + "," + number_text(range.largest);
}

std::optional<DepthInterval> parse_depth_range(std::string_view text) {
    const std::optional<glm::vec2> ends = parse_place(text);
    if (!ends || ends->x > ends->y) return std::nullopt;
    return DepthInterval{ends->x, ends->y};
}

} // namespace rasterwalk
