#include "mistakes/clip.h"

#include <algorithm>
#include <cmath>

#include "stages/reject.h"

namespace rasterwalk {

namespace {

/// A new corner at the near plane.
struct NearCut {
    float t = 0.0f; ///< from the corner inside, 0, to the one outside, 1
    ClipVertex corner;
};

/// B31: over the wrong length, counted from the corner outside.
NearCut cut_with_wrong_t(const ClipVertex& inside, const ClipVertex& outside, float near) {
    const float t = (near - outside.position_clip.w) / inside.position_clip.w;
    NearCut cut{1.0f - t, {}};
    cut.corner.position_clip =
        outside.position_clip + t * (inside.position_clip - outside.position_clip);
    cut.corner.varyings = outside.varyings + (inside.varyings - outside.varyings) * t;
    return cut;
}

/// B82: in the right place, with the varyings of the corner outside.
NearCut cut_place_alone(const ClipVertex& inside, const ClipVertex& outside, float near) {
    const float d_inside = inside.position_clip.w - near;
    const float d_outside = outside.position_clip.w - near;
    NearCut cut{cut_place(d_inside, d_outside),
                cut_edge(inside, outside, double{d_inside}, double{d_outside})};
    cut.corner.varyings = outside.varyings;
    return cut;
}

/// x, y and 1/z on the screen; w is 1.
ClipVertex divided(ClipVertex vertex) {
    const float inv_w = 1.0f / vertex.position_clip.w;
    vertex.position_clip = {vertex.position_clip.x * inv_w, vertex.position_clip.y * inv_w, inv_w,
                            1.0f};
    return vertex;
}

/// Undoes divided(), so that project() can divide.
ClipVertex multiplied(ClipVertex vertex) {
    const float w = 1.0f / vertex.position_clip.z;
    vertex.position_clip = {vertex.position_clip.x * w, vertex.position_clip.y * w, 1.0f, w};
    return vertex;
}

bool has_place(const ClipVertex& vertex) {
    const glm::vec4& p = vertex.position_clip;
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

/// These work only in the lab's clip space, where w is z and the third coordinate is 1.
bool is_labs(const VertexRules& rules) {
    return rules.space == SceneSpace::world && rules.projection.clip_depth == ClipDepth::inv_z;
}

/// Cuts by the near plane with corners that `cut` makes.
template <NearCut (*cut)(const ClipVertex& inside, const ClipVertex& outside, float near)>
Clipped clip_near_with(std::vector<ClipVertex>& corners, const ViewVolume& volume, ClipSink* sink) {
    if (!is_labs(volume.rules)) return {};
    const float near = volume.rules.near;
    const auto is_inside = [&](const ClipVertex& v) { return v.position_clip.w >= near; };
    if (std::all_of(corners.begin(), corners.end(), is_inside)) return {};
    if (sink != nullptr) {
        sink->begin_planes(volume.view, 1);
        sink->begin_plane(ClipPlane::near, corners);
    }
    std::vector<ClipVertex> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        const ClipVertex& a = corners[i];
        const ClipVertex& b = corners[next];
        ClipStep step;
        step.from = static_cast<int>(i);
        step.to = static_cast<int>(next);
        step.d_from = a.position_clip.w - near;
        step.d_to = b.position_clip.w - near;
        step.is_from_inside = step.keeps_from = is_inside(a);
        step.is_to_inside = is_inside(b);
        step.is_cut = step.is_from_inside != step.is_to_inside;
        step.first_kept = static_cast<int>(kept.size());
        if (step.keeps_from) kept.push_back(a);
        if (step.is_cut) {
            const ClipVertex& inside = step.is_from_inside ? a : b;
            const ClipVertex& outside = step.is_from_inside ? b : a;
            const NearCut made = cut(inside, outside, near);
            step.t = made.t;
            step.cut = made.corner;
            kept.push_back(step.cut);
        }
        if (sink != nullptr) sink->clip_step(step);
    }
    if (sink != nullptr) sink->end_plane(ClipPlane::near, kept);
    corners.swap(kept);
    return {Rejection::none, true};
}

} // namespace

Clipped drop_partly_outside(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                            ClipSink* sink) {
    static_cast<void>(sink);
    if (volume.rules.space == SceneSpace::pixels) return {};
    const bool is_dropped = std::any_of(corners.begin(), corners.end(), [&](const ClipVertex& v) {
        return outcode(v, volume.view) != 0;
    });
    return {is_dropped ? Rejection::partly_outside : Rejection::none, false};
}

Clipped clip_near_with_wrong_t(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                               ClipSink* sink) {
    return clip_near_with<cut_with_wrong_t>(corners, volume, sink);
}

Clipped clip_near_with_uncut_varyings(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                                      ClipSink* sink) {
    return clip_near_with<cut_place_alone>(corners, volume, sink);
}

Clipped clip_after_division(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                            ClipSink* sink) {
    if (!is_labs(volume.rules)) return {};
    std::vector<ClipVertex> screen;
    for (const ClipVertex& corner : corners)
        screen.push_back(divided(corner));
    // A corner at the camera itself has no position on the screen; project() reports it.
    if (!std::all_of(screen.begin(), screen.end(), has_place)) return {};
    const ClipPlanes& planes = volume.view;
    constexpr auto first_side = static_cast<std::size_t>(ClipPlane::left);
    if (sink != nullptr) sink->begin_planes(planes, planes.size());
    bool is_cut = false;
    std::vector<ClipVertex> kept;
    for (std::size_t p = first_side; p < planes.size(); ++p) {
        const auto is_outside = [&](const ClipVertex& v) {
            return inner_distance(planes[p], v) < 0.0f;
        };
        if (std::none_of(screen.begin(), screen.end(), is_outside)) continue;
        is_cut = true;
        clip_by_plane(screen, planes, static_cast<ClipPlane>(p), kept, sink);
        screen.swap(kept);
    }
    if (!is_cut) return {};
    corners.clear();
    for (const ClipVertex& corner : screen)
        corners.push_back(multiplied(corner));
    return {Rejection::none, true};
}

Clipped move_to_near_plane(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                           ClipSink* sink) {
    static_cast<void>(sink);
    Clipped clipped;
    if (!is_labs(volume.rules)) return clipped;
    for (ClipVertex& corner : corners) {
        if (!(corner.position_clip.w < volume.rules.near)) continue;
        corner.position_clip.w = volume.rules.near;
        clipped.is_cut = true;
    }
    return clipped;
}

} // namespace rasterwalk
