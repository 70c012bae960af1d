#pragma once

// Orthographic: a box instead of a pyramid, and everything in between.
//
// In:  a point in camera space.
// Out: its position in clip space.
// Picture: the camera goes back and back and takes a longer and longer lens, so that things at one
//          depth keep their size. In the end all rays are parallel, and far things are as large as
//          near ones.
//
// As a matrix it is a small step. Perspective has w = z, orthographic has w = 1, and every mixture
//
//     w = (1 - mix) z + mix
//
// is a projection too: that of a camera mix / (1 - mix) farther back. With w = 1 the division
// changes nothing, so values go in equal steps over the picture, and so does z. The depth is
// therefore not 1/z but z itself from 0 at the near plane to 1 at the far one, (z - n) / (f - n).
//
// The classic mistakes are leaving the scale at f, which is meant to be divided by z, so that a
// scene is far too large or only a few pixels wide; and testing for backs with dot(n, p - C),
// although the rays are parallel.
//
// Source: Shirley, Marschner, Fundamentals of Computer Graphics, 4th edition, sections 7.1 to 7.3,
// orthographic and perspective projection; Akenine-Moeller, Haines, Hoffman, Real-Time Rendering,
// 4th edition, section 4.7, projections. Depth the other way round: Lapidous and Jiao, "Optimal
// Depth Buffer for Low-Cost Graphics Hardware", Graphics Hardware 1999.

#include <glm/vec2.hpp>

#include "stages/depth_test.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// w of a point at this depth in front of the camera: z, 1, or between. Never negative for z >= 0.
/// In float, as in the lab, or in double, as for matrices and the outside view.
template <class Real>
constexpr Real clip_w(Real z, Real mix) {
    return (Real{1} - mix) * z + mix;
}
inline float clip_w(float z, const Projection& projection) {
    return clip_w(z, projection.mix);
}

/// What x and y of camera space are multiplied by, in pixels: f, f/d, or between, so that sizes at
/// the depth d stay the same.
template <class Real>
constexpr Real clip_scale(Real focal_length, Real mix, Real depth) {
    return mix == Real{0} ? focal_length : focal_length * clip_w(depth, mix) / depth;
}
inline float clip_scale(const VertexRules& rules) {
    return clip_scale(rules.camera.focal_length, rules.projection.mix, rules.projection.depth);
}

/// How a point in camera space becomes one in the picture: scale.x · x/w + shift.x pixels to the
/// right of its middle, and scale.y · y/w + shift.y pixels below it.
struct PictureScale {
    glm::dvec2 scale; ///< pixels; see clip_scale()
    glm::dvec2 shift; ///< pixels; 0 unless a window is off-centre
};

/// By projection.box if there is one, otherwise by the focal length.
/// @param focal_length pixels
PictureScale picture_scale(double focal_length, const Viewport& size, const Projection& projection);

/// The window that shows the same as the focal length. Not for rules that have a box.
ViewBox usual_view_box(const VertexRules& rules);

/// How long the view volume is: far - near, world units; never 0.
float view_length(const VertexRules& rules);

/// The third coordinate of clip space at this depth, by rules.projection.clip_depth.
float clip_z(float z, const VertexRules& rules);

/// The depth at this z, as a float: clip_z() after the division.
float depth_at(float z, const DepthRules& rules);

/// The z at this depth, in double: the inverse of depth_at().
double z_of_depth(float depth, const DepthRules& rules);

/// How much farther in front of the camera the second of two depths is than the first, world units.
/// Exact to the last digits for neighbours too: their z differ too little to be subtracted.
double z_between(float from, float to, const DepthRules& rules);

/// In the slot to_clip_space: any projection, and any depth.
glm::vec4 to_clip_space_mixed(const glm::vec3& rotated, const VertexRules& rules);

/// How far in front of the camera a point in clip space lies: z of camera space again.
float camera_depth(const glm::vec4& clip, const VertexRules& rules);

/// How far in front of the camera a fragment lies: from w, or if rays are parallel from z, which
/// then goes in equal steps itself.
float fragment_depth(const Fragment& fragment, float mix);

/// How far in front of the camera the world's origin lies, but at least as far as the near plane:
/// the depth d if none is chosen.
float origin_depth(const Camera& camera, float near);

} // namespace rasterwalk
