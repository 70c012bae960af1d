#include "stages/clip.h"

#include <algorithm>
#include <cmath>

#include "stages/orthographic.h"
#include "stages/project.h"

namespace rasterwalk {

namespace {

/// How far from the picture's middle the sides of the guard band lie: at half of what project() can
/// take, so that rounding cannot push a cut corner over its limit.
constexpr float guard_band_distance = max_pixel_distance / 2.0f;

/// The planes near and far: z - n and f - z of camera space, from the z of clip space.
std::array<glm::vec4, 2> depth_planes(const VertexRules& rules) {
    const Projection& projection = rules.projection;
    // The third coordinate is 0 at one plane, and has this slope toward the other.
    const float from_near = view_length(rules) / clip_w(rules.far, projection);
    const float from_far = view_length(rules) / clip_w(rules.near, projection);
    switch (projection.clip_depth) {
    case ClipDepth::inv_z:
        break;
    case ClipDepth::ndc:
        return {glm::vec4{0.0f, 0.0f, from_near, 0.0f}, glm::vec4{0.0f, 0.0f, -from_far, from_far}};
    case ClipDepth::reversed:
        return {glm::vec4{0.0f, 0.0f, -from_near, from_near},
                glm::vec4{0.0f, 0.0f, from_far, 0.0f}};
    }
    // w is z, and the third coordinate is 1.
    return {glm::vec4{0.0f, 0.0f, -rules.near, 1.0f}, glm::vec4{0.0f, 0.0f, rules.far, -1.0f}};
}

/// The planes with these four sides, in pixels from the middle.
ClipPlanes planes(const VertexRules& rules, float left, float right, float top, float bottom) {
    const auto [near, far] = depth_planes(rules);
    // x and y are pixels from the middle, times w.
    return {near,
            far,
            glm::vec4{1.0f, 0.0f, 0.0f, left},
            glm::vec4{-1.0f, 0.0f, 0.0f, right},
            glm::vec4{0.0f, 1.0f, 0.0f, top},
            glm::vec4{0.0f, -1.0f, 0.0f, bottom}};
}

/// The planes with their sides this many pixels outside the picture.
ClipPlanes planes_with_margin(const VertexRules& rules, float pixels) {
    const glm::vec2 middle = viewport_middle(rules);
    const glm::vec2 rest = glm::vec2(rules.viewport.width, rules.viewport.height) - middle;
    return planes(rules, middle.x + pixels, rest.x + pixels, middle.y + pixels, rest.y + pixels);
}

/// Cuts by the first `count` planes. A polygon given in pixels has no view volume.
Clipped clip_by(const ViewVolume& volume, const ClipPlanes& planes, std::size_t count,
                std::vector<ClipVertex>& corners, ClipSink* sink) {
    if (volume.rules.space == SceneSpace::pixels) return {};
    // NaN is on neither side of a plane; project() reports it.
    const auto is_finite = [](const ClipVertex& v) { return std::isfinite(v.position_clip.w); };
    if (!std::all_of(corners.begin(), corners.end(), is_finite)) return {};
    if (sink != nullptr) sink->begin_planes(planes, count);
    Clipped clipped;
    std::vector<ClipVertex> kept;
    for (std::size_t p = 0; p < count; ++p) {
        const auto is_outside = [&](const ClipVertex& v) {
            return !(inner_distance(planes[p], v) >= 0.0f);
        };
        if (std::none_of(corners.begin(), corners.end(), is_outside)) continue;
        clipped.is_cut = true;
        const auto is_within = [&](const ClipVertex& v) {
            return inner_distance(planes[p], v) > 0.0f;
        };
        const bool is_any_within = std::any_of(corners.begin(), corners.end(), is_within);
        clip_by_plane(corners, planes, static_cast<ClipPlane>(p), kept, sink);
        corners.swap(kept);
        // A polygon that only touches the plane has no area inside.
        if (!is_any_within) {
            clipped.rejection = Rejection::clipped_away;
            break;
        }
    }
    return clipped;
}

} // namespace

ClipPlanes view_planes(const VertexRules& rules) {
    return planes_with_margin(rules, 0.0f);
}

ClipPlanes outer_planes(const VertexRules& rules) {
    return planes_with_margin(rules, 2.0f);
}

ClipPlanes guard_band_planes(const VertexRules& rules) {
    return planes(rules, guard_band_distance, guard_band_distance, guard_band_distance,
                  guard_band_distance);
}

ClipVertex cut_edge(const ClipVertex& inside, const ClipVertex& outside, double d_inside,
                    double d_outside) {
    ClipVertex cut;
    if (is_too_large_for_float(inside) || is_too_large_for_float(outside)) {
        const double t = cut_place(d_inside, d_outside);
        const glm::dvec4 from(inside.position_clip), to(outside.position_clip);
        cut.position_clip = glm::vec4(from + t * (to - from));
        // From the nearer end, so that the float has the digits that count.
        cut.varyings =
            t < 0.5 ? inside.varyings + (outside.varyings - inside.varyings) * static_cast<float>(t)
                    : outside.varyings +
                          (inside.varyings - outside.varyings) * static_cast<float>(1.0 - t);
        return cut;
    }
    const float t = cut_place(static_cast<float>(d_inside), static_cast<float>(d_outside));
    cut.position_clip = inside.position_clip + t * (outside.position_clip - inside.position_clip);
    cut.varyings = inside.varyings + (outside.varyings - inside.varyings) * t;
    return cut;
}

namespace {

/// The new corner of an edge that this plane cuts. For an edge too large for float both distances
/// are taken in double, as long as they have the same signs there.
ClipVertex cut_at_plane(const glm::vec4& plane, const ClipVertex& inside,
                        const ClipVertex& outside) {
    const auto exact = [&](const ClipVertex& v) {
        return glm::dot(glm::dvec4(plane), glm::dvec4(v.position_clip));
    };
    const bool is_far = is_too_large_for_float(inside) || is_too_large_for_float(outside);
    if (is_far && exact(inside) >= 0.0 && exact(outside) < 0.0)
        return cut_edge(inside, outside, exact(inside), exact(outside));
    return cut_edge(inside, outside, wide_inner_distance(plane, inside),
                    wide_inner_distance(plane, outside));
}

} // namespace

void clip_by_plane(std::span<const ClipVertex> corners, const ClipPlanes& planes, ClipPlane plane,
                   std::vector<ClipVertex>& result, ClipSink* sink) {
    const glm::vec4& coefficients = planes[static_cast<std::size_t>(plane)];
    if (sink != nullptr) sink->begin_plane(plane, corners);
    result.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        const ClipVertex& a = corners[i];
        const ClipVertex& b = corners[next];
        const double d_a = wide_inner_distance(coefficients, a),
                     d_b = wide_inner_distance(coefficients, b);
        const bool is_a_inside = d_a >= 0.0, is_b_inside = d_b >= 0.0;
        const std::size_t first_kept = result.size();
        if (is_a_inside) result.push_back(a);
        if (is_a_inside && !is_b_inside)
            result.push_back(cut_at_plane(coefficients, a, b));
        else if (!is_a_inside && is_b_inside)
            result.push_back(cut_at_plane(coefficients, b, a));
        if (sink == nullptr) continue;
        ClipStep step;
        step.plane = plane;
        step.from = static_cast<int>(i);
        step.to = static_cast<int>(next);
        step.d_from = static_cast<float>(d_a);
        step.d_to = static_cast<float>(d_b);
        step.is_from_inside = step.keeps_from = is_a_inside;
        step.is_to_inside = is_b_inside;
        step.is_cut = is_a_inside != is_b_inside;
        if (step.is_cut) {
            step.t =
                is_a_inside ? cut_place(step.d_from, step.d_to) : cut_place(step.d_to, step.d_from);
            step.cut = result.back();
        }
        step.first_kept = static_cast<int>(first_kept);
        sink->clip_step(step);
    }
    if (sink != nullptr) sink->end_plane(plane, result);
}

Clipped clip_near(std::vector<ClipVertex>& corners, const ViewVolume& volume, ClipSink* sink) {
    return clip_by(volume, volume.view, 1, corners, sink);
}

Clipped clip_all(std::vector<ClipVertex>& corners, const ViewVolume& volume, ClipSink* sink) {
    return clip_by(volume, volume.view, clip_plane_count, corners, sink);
}

Clipped clip_guard_band(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                        ClipSink* sink) {
    return clip_by(volume, volume.guard_band, clip_plane_count, corners, sink);
}

} // namespace rasterwalk
