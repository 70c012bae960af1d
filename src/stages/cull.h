#pragma once

// Cull: should a polygon be drawn at all?
//
// In:  the corners of a polygon in clip space.
// Out: why it is not drawn, or none.
// Picture: of a closed object you see only the sides that face the camera; on the screen their
//          corners go round in the opposite direction from those of the sides that face away.
//
// The lab culls nothing: the walls of its room are seen from inside, and both sides are drawn.
//
// You can also test every fragment, by its interpolated normal. That follows a smooth object to the
// pixel, but every row is walked before anything is left out.
//
// The classic mistake is to use the angle to the direction in which the camera looks: under
// perspective you also see some sides whose normals are less than 90 degrees from it. What counts
// is the direction from the camera to the surface.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 15.4, back-face culling. The area of a polygon in homogeneous coordinates: Olano and
// Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997.

#include <span>
#include <string>
#include <vector>

#include "stages/fragment.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// What a way of culling has looked at, and what it decided. Only reports ask for it.
struct CullTest {
    std::string measure; ///< what the values are: "dot(n, p - C)"; empty: nothing was measured
    std::string reason;  ///< why it is a front or a back, after a colon
    std::vector<float> values; ///< of the polygon, or of each corner tested
    bool is_back = false;      ///< it is culled
};

struct Stages;

/// The rays along which the camera sees: what "toward the camera" means under every projection.
struct SightRays {
    glm::vec3 camera{0.0f};  ///< where the rays of perspective meet, in the world
    glm::vec3 forward{0.0f}; ///< the way the camera looks, length 1; orthographic rays run this way
    float mix = 0.0f;        ///< 0: perspective; 1: orthographic; between: a mixture
};

/// The rays of a frame: find them once, since they need the camera's rotation.
SightRays sight_rays(const VertexRules& rules);

/// The ray of sight that meets a point in the world, away from the camera.
inline glm::vec3 sight_ray(const glm::vec3& position_world, const SightRays& rays) {
    glm::vec3 ray = position_world - rays.camera;
    if (rays.mix > 0.0f) ray = (1.0f - rays.mix) * ray + rays.mix * rays.forward;
    return ray;
}

/// dot(n, p - C): positive if the normal points away from the camera. Where rays are parallel,
/// under orthographic projection, their direction replaces p - C; between the two, it is the
/// mixture of both. sight_measure() writes it down.
/// @param varyings of a vertex or a fragment: its normal and its position in the world
float away_from_camera(const Varyings& varyings, const SightRays& rays);

/// The first corner's varyings, with the normal of the whole polygon: if the corners' normals
/// differ, the one worked out from their positions.
Varyings as_one_face(std::span<const ClipVertex> corners);

/// What away_from_camera() works out with these rays: "dot(n, p - C)", "dot(n, forward)" or the
/// mixture.
std::string_view sight_measure(const SightRays& rays);

/// Every polygon is drawn, whichever side it shows.
/// @param corners what clipping has left, at least three
/// @param rays    of the frame
/// @param test    receives what was looked at, or null
inline Rejection cull_nothing(std::span<const ClipVertex> corners, const VertexRules& rules,
                              const SightRays& rays, CullTest* test = nullptr) {
    static_cast<void>(corners);
    static_cast<void>(rules);
    static_cast<void>(rays);
    static_cast<void>(test);
    return Rejection::none;
}

/// By the normal of the surface: it is a back if the normal points away from the camera,
/// away_from_camera() > 0. In world space. It is the normal of the first corner or, if the corners'
/// normals differ, the one worked out from their positions.
Rejection cull_by_face_normal(std::span<const ClipVertex> corners, const VertexRules& rules,
                              const SightRays& rays, CullTest* test = nullptr);

/// By the order of the corners on the screen: the front goes round clockwise, y down, which is a
/// positive area. If a corner lies behind the camera there is no such order, and the polygon is
/// drawn.
Rejection cull_by_screen_area(std::span<const ClipVertex> corners, const VertexRules& rules,
                              const SightRays& rays, CullTest* test = nullptr);

/// By the normals of all corners: it is a back if each of them points away from the camera. A
/// smooth object keeps the faces along its outline.
Rejection cull_by_vertex_normals(std::span<const ClipVertex> corners, const VertexRules& rules,
                                 const SightRays& rays, CullTest* test = nullptr);

/// The varyings that cull_by_fragment_normal() reads.
inline constexpr VaryingSet varyings_read_by_culling =
    VaryingSet::of(&Varyings::position_world, &Varyings::normal);

/// Every fragment goes on to the depth test.
inline bool keep_fragment(const Fragment& fragment, const SightRays& rays, const Stages& stages) {
    static_cast<void>(fragment);
    static_cast<void>(rays);
    static_cast<void>(stages);
    return false;
}

/// By the fragment's interpolated normal: it belongs to a back, and is not drawn, if that normal
/// points away from the camera at the fragment's own position, by away_from_camera(). In world
/// space.
/// @param rays   of the frame
/// @param stages the table whose function divides the varyings by their weight
bool cull_by_fragment_normal(const Fragment& fragment, const SightRays& rays, const Stages& stages);

/// Twice the area of the polygon on the screen in square pixels, times the w of the three corners,
/// for each triangle of its fan; it has the sign of the area if every w is positive.
float screen_area_sign(std::span<const ClipVertex> corners, const VertexRules& rules);

} // namespace rasterwalk
