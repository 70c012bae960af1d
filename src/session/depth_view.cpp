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

/// How much wider than the values the axis is on each side, as a part of their range: there the
/// ends can be taken hold of.
constexpr float axis_margin = 0.06f;

/// The bar of full height: so many times the bin than which this part of all are smaller.
constexpr double typical_part = 0.85;
constexpr double largest_bar = 1.5;

/// The smallest range, as a part of the axis.
constexpr float smallest_range = 0.01f;

DepthRange axis_around(const DepthRange& present) {
    // A single value needs some width as well.
    const float width = std::max(present.near - present.far, 1e-3f * present.near);
    return {std::max(present.far - axis_margin * width, 0.0f), present.near + axis_margin * width};
}

float smallest_distance(const DepthRange& axis) {
    return smallest_range * (axis.near - axis.far);
}

/// A wall that faces the camera fills one bin with more pixels than all others: measured by the
/// largest bin the rest would lie flat on the ground.
std::int64_t full_height(std::vector<std::int64_t> bins) {
    bins.erase(std::remove(bins.begin(), bins.end(), 0), bins.end());
    if (bins.empty()) return 1;
    std::sort(bins.begin(), bins.end());
    const double typical = static_cast<double>(
        bins[static_cast<std::size_t>(typical_part * static_cast<double>(bins.size()))]);
    const auto limit = static_cast<std::int64_t>(largest_bar * typical);
    return std::clamp<std::int64_t>(bins.back(), 1, std::max<std::int64_t>(limit, 1));
}

/// What is interpolated linearly is z, whatever the format.
bool holds_inv_z(const Frame& frame) {
    return depth_rule(frame.settings) == DepthTest::linear_z ||
           clip_depth_rule(frame.settings, frame.scene->space) == ClipDepth::inv_z;
}

} // namespace

std::string_view stored_depth_name(const Frame& frame) {
    return holds_inv_z(frame) ? "1/z" : "depth";
}

double z_of_stored_depth(const Frame& frame, float depth) {
    const double stored = depth;
    if (holds_inv_z(frame)) return 1.0 / stored;
    // stored = w(near) (far - z) / (length w(z)), with w(z) = (1 - mix) z + mix, solved for z.
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const double mix = rules.projection.mix, length = view_length(rules);
    const double near_w = clip_w(rules.near, rules.projection);
    return (near_w * rules.far - stored * length * mix) / (near_w + stored * length * (1.0 - mix));
}

DepthView depth_view(const Framebuffer& framebuffer, const std::optional<DepthRange>& chosen) {
    DepthView view;
    view.present = present_depths(framebuffer);
    view.range = chosen ? *chosen : view.present.value_or(DepthRange{0.0f, 1.0f});
    view.histogram.axis = axis_around(view.present.value_or(view.range));
    view.histogram.bins.assign(depth_bins, 0);
    for (const float depth : framebuffer.depth) {
        if (!(depth > 0.0f) || depth == framebuffer.rules.depth_clear) continue;
        ++view.drawn;
        view.farther += depth < view.range.far ? 1 : 0;
        view.nearer += depth > view.range.near ? 1 : 0;
        const float place = view.histogram.axis.place(depth);
        if (!std::isfinite(place)) continue;
        const int bin = static_cast<int>(std::clamp(place, 0.0f, 1.0f) * depth_bins);
        ++view.histogram.bins[static_cast<std::size_t>(std::min(bin, depth_bins - 1))];
    }
    view.histogram.full = full_height(view.histogram.bins);
    return view;
}

void set_far(Session& session, const DepthView& view, float value) {
    const DepthRange& axis = view.histogram.axis;
    const float largest = std::max(view.range.near - smallest_distance(axis), 0.0f);
    session.depth_range =
        DepthRange{std::clamp(value, std::min(axis.far, largest), largest), view.range.near};
}

void set_near(Session& session, const DepthView& view, float value) {
    const DepthRange& axis = view.histogram.axis;
    const float smallest = view.range.far + smallest_distance(axis);
    session.depth_range =
        DepthRange{view.range.far, std::clamp(value, smallest, std::max(axis.near, smallest))};
}

std::string to_text(const DepthRange& range) {
    return number_text(range.far) + "," + number_text(range.near);
}

std::optional<DepthRange> parse_depth_range(std::string_view text) {
    const std::optional<glm::vec2> ends = parse_place(text);
    if (!ends || ends->x > ends->y) return std::nullopt;
    return DepthRange{ends->x, ends->y};
}

} // namespace rasterwalk
