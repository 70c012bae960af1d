#pragma once

// The vertex shader: from a point in the world to clip space. The lab's VertexShader is this and
// project(), which divides.
//
// In:  a vertex and the camera.
// Out: its place in clip space, and the varyings that start their way at this vertex.
// Picture: move the world so that the camera stands at the origin, turn it so that the camera looks
//          along +z, scale by the focal length.
//
// The classic mistakes: R v instead of v R (the camera turns the wrong way), a vertex behind the
// camera (dividing by a negative z mirrors it), and int() on a negative coordinate, which rounds
// toward the middle of the picture and leaves the left column and the top row black. What is behind
// the camera has no pixel; a mark for it that is a possible column, such as -1, is one day mistaken
// for a real one, and moving a vertex to the picture's border bends the edges that end in it.

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "stages/fragment.h"
#include "stages/interpolate.h"
#include "stages/light.h"
#include "stages/rejection.h"

namespace rasterwalk {

struct Stages;

/// Where light is computed.
enum class Lighting : std::uint8_t { none, per_vertex, per_pixel };

/// What becomes of a vertex on or behind the camera plane.
enum class BehindCamera : std::uint8_t {
    left_out,       ///< its triangles are not drawn
    drawn,          ///< divided by z all the same, which mirrors it: mistake B13
    mark_minus_one, ///< as left_out, but marked by the column -1, which others have too
};

/// What becomes of a vertex whose pixel lies outside the picture.
enum class OutsidePicture : std::uint8_t {
    kept,    ///< it stays where it is
    clamped, ///< it is moved to the picture's border: mistake B15
};

/// How the camera's rotation is applied.
enum class Rotation : std::uint8_t {
    row_vector, ///< v R
    transposed, ///< R v, the turn the other way round: mistake B24
};

/// The sign of the focal length.
enum class ImageAxes : std::uint8_t {
    right_way, ///< f: x right, y down
    mirrored,  ///< -f: the picture turned by half a turn: mistake B25
};

/// Projected coordinates beyond this many pixels from the picture's middle are not drawn: a vertex
/// just in front of the camera would otherwise make an edge of millions of samples.
inline constexpr float max_pixel_distance = 16384.0f;

/// What the vertex shader needs beside the vertex.
struct VertexRules {
    Camera camera;
    Light light;
    Viewport viewport;
    SceneSpace space = SceneSpace::world;
    Rounding rounding = Rounding::truncate;
    Lighting lighting = Lighting::none;
    BehindCamera behind_camera = BehindCamera::left_out;
    OutsidePicture outside_picture = OutsidePicture::kept;
    Rotation rotation = Rotation::row_vector;
    ImageAxes image_axes = ImageAxes::right_way;
};

/// A vertex in clip space: before the division that makes perspective.
struct ClipVertex {
    /// f x, f y, 1, z of camera space: x and y become pixels from the middle of the picture when
    /// they are divided by w, and 1 becomes the depth 1/z. In a scene in pixel space x and y are
    /// columns and rows already. All NaN if a coordinate in camera space is not finite.
    glm::vec4 position_clip{0.0f};
    Varyings varyings; ///< as q: not yet divided by z
};

/// A vertex in one of the spaces that it goes through.
struct SpacePoint {
    std::string_view space; ///< "minus_camera"
    glm::vec3 place{0.0f};
};

/// The spaces of a vertex in the order of its way: `world`, `minus_camera`, `rotated` (camera
/// space: x right, y down, z forward) from the vertex shader, then `projected` (pixels from the
/// middle, before rounding) from project(). Only reports ask for it.
struct VertexSpaces {
    std::vector<SpacePoint> points;

    void add(std::string_view space, const glm::vec3& place) { points.push_back({space, place}); }
    /// The place in a space; zero if the vertex did not get there.
    glm::vec3 in(std::string_view space) const;
};

/// R of the camera, for row vectors: v * R. Yaw turns about y, then pitch about x.
glm::mat3 camera_rotation(const Camera& camera);

/// From the world to clip space. `rotation` is camera_rotation(rules.camera), computed once a
/// frame. `stages` is the table whose functions light the vertex.
/// @param spaces receives the places on the way, or null
ClipVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                         const Stages& stages, VertexSpaces* spaces);

} // namespace rasterwalk
