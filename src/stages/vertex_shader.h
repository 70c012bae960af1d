#pragma once

// The vertex shader: from a point in the world to clip space. The lab's VertexShader is this and
// project(), which divides.
//
// In:  a vertex and the camera.
// Out: its position in clip space, and the varyings that start their way at this vertex.
// Picture: move the world so that the camera is at the origin, turn it so that the camera looks
//          along +z, scale by the focal length.
//
// The classic mistakes are R v instead of v R, so that the camera turns the wrong way; v + C, or
// v R - C, for (v - C) R, so that it is in the wrong place; a minus before the focal length, which
// turns the picture by half a turn; x and y swapped; and the distance for z.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// chapter 6, viewing in 3D; Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH
// 1978, on clip space.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "stages/interpolate.h"
#include "stages/light.h"
#include "stages/rejection.h"
#include "stages/varyings.h"

namespace rasterwalk {

struct Occluders;
struct Stages;

/// Where light is computed.
enum class Shading : std::uint8_t {
    unlit,   ///< nowhere: a surface shows its own colour
    flat,    ///< once per triangle, in its middle
    gouraud, ///< at the vertices, and interpolated between them
    phong,   ///< at every pixel, from interpolated positions and normals
};

/// How a projected vertex becomes a pixel. The first three are those of Rounding: they work on the
/// position counted from the middle of the picture, and then the middle is added.
enum class VertexRounding : std::uint8_t {
    truncate, ///< int(f x/z) + W/2: toward the middle, so that the left and top borders stay empty
    floor,    ///< floor(f x/z) + W/2
    round,    ///< floor(f x/z + 0.5) + W/2
    /// int(f x/z + W/2): the same as floor unless the sum is negative. Points up to a pixel beyond
    /// the left or top border are truncated to column or row 0, which thus takes in two pixels'
    /// width.
    truncate_sum,
};

/// What the third coordinate of clip space becomes after the division: the depth buffer's values.
enum class ClipDepth : std::uint8_t {
    inv_z, ///< it is 1, which becomes 1/z: 0 infinitely far, larger is nearer. The lab
    ndc,   ///< it is 0 at the near plane and w at the far one, which become 0 and 1
    /// the other way round, 1 near and 0 far: floats have most of their steps near 0, where under
    /// perspective nearly all of the view lies
    reversed,
};

/// Is a smaller depth of this kind nearer?
constexpr bool is_smaller_nearer(ClipDepth kind) {
    return kind == ClipDepth::ndc;
}

/// How much nearer a depth is than another: above 0 it is nearer.
constexpr float depth_ahead(float depth, float other, ClipDepth kind) {
    return is_smaller_nearer(kind) ? other - depth : depth - other;
}

/// Is it nearer? NaN is not.
constexpr bool is_nearer(float depth, float other, ClipDepth kind) {
    return is_smaller_nearer(kind) ? depth < other : depth > other;
}

/// The depth of a point infinitely far away, or on the far plane: nothing that counts is farther.
constexpr float farthest_depth(ClipDepth kind) {
    return is_smaller_nearer(kind) ? 1.0f : 0.0f;
}

/// The window on the near plane, which fills the picture: world units in camera space, x to the
/// right and y up, as for glFrustum and glOrtho. left < right, bottom < top.
struct ViewBox {
    float left = -1.0f, right = 1.0f, bottom = -1.0f, top = 1.0f;

    friend bool operator==(const ViewBox&, const ViewBox&) = default;
};

/// How camera space becomes clip space, in addition to the focal length and the near and far
/// planes.
struct Projection {
    float mix = 0.0f;   ///< 0: perspective; 1: orthographic; between: a mixture
    float depth = 1.0f; ///< where the size of things does not depend on `mix`, world units
    ClipDepth clip_depth = ClipDepth::inv_z;
    /// What fills the picture at `depth`, which is then the near plane's; none: the focal length
    /// counts. Only matrices use it.
    std::optional<ViewBox> box{};
};

/// What the vertex shader needs besides the vertex.
struct VertexRules {
    Camera camera;
    Light light;
    Viewport viewport;
    SceneSpace space = SceneSpace::world;
    VertexRounding rounding = VertexRounding::truncate;
    Shading shading = Shading::unlit;
    float near = 0.1f, far = 100.0f; ///< of the view volume, in front of the camera, world units
    Projection projection;
    const Occluders* occluders = nullptr; ///< what casts shadows; null: nothing does
};

/// A vertex in clip space: before the division that makes perspective.
struct ClipVertex {
    /// f x, f y, 1, z of camera space: x and y become pixels from the middle of the picture when
    /// they are divided by w, and 1 becomes the depth 1/z. Other projections have another w, and
    /// another third coordinate, see ClipDepth. In a scene in pixel space x and y are already
    /// columns and rows. All NaN if a coordinate in camera space is not finite.
    glm::vec4 position_clip{0.0f};
    Varyings varyings; ///< as q: not yet divided by z
};

/// A vertex in one of the spaces it goes through.
struct SpacePoint {
    std::string_view space; ///< "minus_camera"
    glm::vec3 place{0.0f};
};

/// The spaces of a vertex in order: `world`, `minus_camera`, `rotated` (camera space: x right, y
/// down, z forward) from the vertex shader, then `projected` (pixels from the middle, before
/// rounding) from project(). Only reports ask for them.
struct VertexSpaces {
    std::vector<SpacePoint> points;

    void add(std::string_view space, const glm::vec3& place) { points.push_back({space, place}); }
    /// The position in a space; zero if the vertex did not get there.
    glm::vec3 in(std::string_view space) const;
};

/// R of the camera, for row vectors: v * R. Its columns are the camera's right, down and forward
/// axes in the world. Yaw turns about y, then pitch about x; or it looks at its target, see
/// scene/look_at.h.
glm::mat3 camera_rotation(const Camera& camera);

/// Turns the world so that the camera looks along +z: the row vector times R.
inline glm::vec3 rotate_to_camera(const glm::vec3& minus_camera, const glm::mat3& rotation) {
    return minus_camera * rotation;
}

/// A point of the world on its way to the camera.
struct CameraPlace {
    glm::vec3 minus_camera; ///< the camera is at the origin
    glm::vec3 rotated;      ///< and looks along +z: camera space
};

/// Moves the world so that the camera is at the origin, and then turns it: (v - C) R. If it were
/// turned first, the camera's position would have to be turned as well.
/// @param stages the table whose function turns
CameraPlace to_camera_space(const glm::vec3& position_world, const Camera& camera,
                            const glm::mat3& rotation, const Stages& stages);

/// The linear part of the perspective projection, from camera space to clip space: the division by
/// w follows.
inline glm::vec4 to_clip_space(const glm::vec3& rotated, const VertexRules& rules) {
    const float f = rules.camera.focal_length;
    return {f * rotated.x, f * rotated.y, 1.0f, rotated.z};
}

/// The varyings that start their way at a vertex, by the rules of light.
Varyings start_varyings(const Vertex& vertex, const VertexRules& rules, const Stages& stages);

/// From the world to clip space. `rotation` is camera_rotation(rules.camera), computed once a
/// frame. `stages` is the table whose functions turn, project and light the vertex.
/// @param spaces receives the positions on the way, or null
ClipVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                         const Stages& stages, VertexSpaces* spaces);

} // namespace rasterwalk
