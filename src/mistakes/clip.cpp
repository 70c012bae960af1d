#include "mistakes/clip.h"

#include <algorithm>
#include <cmath>

#include "stages/reject.h"

namespace rasterwalk {

namespace {

/// The corner on the edge from `outside` to `inside`, with t over the wrong length.
ClipVertex cut_with_wrong_t(const ClipVertex& inside, const ClipVertex& outside, float near) {
    const float t = (near - outside.position_clip.w) / inside.position_clip.w;
    ClipVertex cut;
    cut.position_clip = outside.position_clip + t * (inside.position_clip - outside.position_clip);
    cut.varyings = outside.varyings + (inside.varyings - outside.varyings) * t;
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

bool is_finite(const ClipVertex& vertex) {
    const glm::vec4& p = vertex.position_clip;
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

} // namespace

Clipped drop_partly_outside(std::vector<ClipVertex>& corners, const VertexRules& rules) {
    if (rules.space == SceneSpace::pixels) return {};
    const ClipPlanes planes = view_planes(rules);
    const bool is_dropped = std::any_of(corners.begin(), corners.end(), [&](const ClipVertex& v) {
        return outcode(v, planes) != 0;
    });
    return {is_dropped ? Rejection::partly_outside : Rejection::none, false};
}

Clipped clip_near_with_wrong_t(std::vector<ClipVertex>& corners, const VertexRules& rules) {
    if (rules.space == SceneSpace::pixels) return {};
    const auto is_inside = [&](const ClipVertex& v) { return v.position_clip.w >= rules.near; };
    if (std::all_of(corners.begin(), corners.end(), is_inside)) return {};
    std::vector<ClipVertex> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ClipVertex& a = corners[i];
        const ClipVertex& b = corners[(i + 1) % corners.size()];
        if (is_inside(a)) kept.push_back(a);
        if (is_inside(a) && !is_inside(b)) kept.push_back(cut_with_wrong_t(a, b, rules.near));
        if (!is_inside(a) && is_inside(b)) kept.push_back(cut_with_wrong_t(b, a, rules.near));
    }
    corners.swap(kept);
    return {Rejection::none, true};
}

Clipped clip_after_division(std::vector<ClipVertex>& corners, const VertexRules& rules) {
    if (rules.space == SceneSpace::pixels) return {};
    std::vector<ClipVertex> screen;
    for (const ClipVertex& corner : corners)
        screen.push_back(divided(corner));
    // A corner in the camera itself has no place on the screen; project() says so of it.
    if (!std::all_of(screen.begin(), screen.end(), is_finite)) return {};
    const ClipPlanes planes = view_planes(rules);
    constexpr auto first_side = static_cast<std::size_t>(ClipPlane::left);
    bool is_cut = false;
    std::vector<ClipVertex> kept;
    for (std::size_t p = first_side; p < planes.size(); ++p) {
        const auto is_outside = [&](const ClipVertex& v) {
            return inner_distance(planes[p], v) < 0.0f;
        };
        if (std::none_of(screen.begin(), screen.end(), is_outside)) continue;
        is_cut = true;
        clip_by_plane(screen, planes[p], kept);
        screen.swap(kept);
    }
    if (!is_cut) return {};
    corners.clear();
    for (const ClipVertex& corner : screen)
        corners.push_back(multiplied(corner));
    return {Rejection::none, true};
}

Clipped move_to_near_plane(std::vector<ClipVertex>& corners, const VertexRules& rules) {
    Clipped clipped;
    if (rules.space == SceneSpace::pixels) return clipped;
    for (ClipVertex& corner : corners) {
        if (!(corner.position_clip.w < rules.near)) continue;
        corner.position_clip.w = rules.near;
        clipped.is_cut = true;
    }
    return clipped;
}

} // namespace rasterwalk
