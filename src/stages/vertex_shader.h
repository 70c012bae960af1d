#pragma once

// The vertex shader: from a point in the world to a pixel.
//
// In:  a vertex, the camera, the size of the picture.
// Out: column and row, 1/z, and the varyings that start their way at this vertex.
// Picture: move the world so that the camera stands at the origin, turn it so that the camera looks
//          along +z, divide by z, scale by the focal length, shift to the middle of the picture.
//
// The classic mistakes: R v instead of v R (the camera turns the wrong way), a vertex behind the
// camera (dividing by a negative z mirrors it), and int() on a negative coordinate, which rounds
// toward the middle of the picture and leaves the left column and the top row black. What is behind
// the camera has no pixel; a mark for it that is a possible column, such as -1, is one day mistaken
// for a real one, and moving a vertex to the picture's border bends the edges that end in it.

#include <cstdint>

#include <glm/mat3x3.hpp>

#include "scene/scene.h"
#include "stages/fragment.h"
#include "stages/interpolate.h"
#include "stages/light.h"

namespace rasterwalk {

struct Stages;

/// Where light is computed.
enum class Lighting : std::uint8_t { none, per_vertex, per_pixel };

/// Why a vertex has no pixel.
enum class VertexFault : std::uint8_t {
    none,
    not_finite,       ///< a coordinate is not a number, or infinite
    behind_camera,    ///< z <= 0 in camera space: on or behind the camera plane
    too_far_out,      ///< projected farther from the middle than max_pixel_distance
    taken_for_behind, ///< its column is -1, which is the mark for "behind the camera": mistake B14
};

inline constexpr int vertex_fault_count = 5;

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

/// A vertex in every space on its way, in the order of the way.
struct ShadedVertex {
    glm::vec3 position_world{0.0f};
    glm::vec3 minus_camera{0.0f};    ///< position_world - camera position
    glm::vec3 position_camera{0.0f}; ///< minus_camera * R: x right, y down, z forward
    float projected_x = 0.0f;        ///< f x / z, pixels from the middle, before rounding
    float projected_y = 0.0f;        ///< f y / z, pixels from the middle, before rounding
    Fragment pixel;                  ///< valid only without fault
    VertexFault fault = VertexFault::none;
};

/// R of the camera, for row vectors: v * R. Yaw turns about y, then pitch about x.
glm::mat3 camera_rotation(const Camera& camera);

/// The lab's VertexShader. `rotation` is camera_rotation(rules.camera), computed once a frame.
/// `stages` is the table whose functions light the vertex and weigh its varyings.
ShadedVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation,
                           const VertexRules& rules, const Stages& stages);

} // namespace rasterwalk
