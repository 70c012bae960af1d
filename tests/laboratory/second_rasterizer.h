#pragma once

// A second rasterizer of the lab's room, written from the handout as a student writes one, in
// float. It shares no code with the stages: its pictures are like those that students bring to the
// laboratory. Where several rules are right the program chooses one; every mistake is a switch.

#include <array>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.h"

namespace rasterwalk::test {

/// One triangle of the room, in world space.
struct StudentTriangle {
    std::array<glm::vec3, 3> corners;
    glm::vec3 normal{0.0f}; ///< of unit length
    glm::vec3 colour{0.0f}; ///< 0..1
    int number = 0;         ///< 0..29, in the order of drawing
};

/// The room of the handout.
std::vector<StudentTriangle> student_room();

/// How far the student has come.
enum class StudentStage { fill, depth, vertex_light, pixel_light };

/// How a projected vertex becomes a pixel; sum_cut is int(f x/z + W/2), the others add W/2 after.
enum class VertexCut { cut, floor, round, sum_cut };
/// How x/z is multiplied: f * x * zinv, f * (x * zinv), f * x / z or f * (x / z).
enum class VertexProduct { by_zinv, zinv_first, by_z, z_first };
/// How the samples of an edge and of a row are walked; blend_ends is a (1 - t) + b t, which is
/// right only where samples are rounded.
enum class Walk { add_steps, multiply_step, blend_ends };

/// The mistakes of a program; none by default.
struct StudentMistakes {
    // Vertices and camera
    bool camera_added = false;           ///< v + C
    bool rotated_first = false;          ///< v R - C
    bool rotation_transposed = false;    ///< R v
    bool focal_length_negative = false;  ///< -f
    bool axes_exchanged = false;         ///< y for x and x for y
    bool half_forgotten = false;         ///< no + W/2, + H/2
    bool distance_for_z = false;         ///< 1/|p| for 1/z
    bool dropped_partly_outside = false; ///< if any vertex is outside the picture
    bool culled_by_lamp = false;         ///< what faces away from the lamp is left out
    // Edges and rows
    bool edges_by_rows = false;         ///< |dy| + 1 samples
    bool one_inside_abs = false;        ///< |a - b + 1| samples
    bool whole_steps = false;           ///< int / int
    bool step_over_count = false;       ///< (b - a) / N
    bool last_sample_lost = false;      ///< of each edge
    bool third_edge_lost = false;       ///< the one from corner 2 to corner 0
    bool last_row_lost = false;         ///< ymax - ymin rows
    bool samples_clamped = false;       ///< a sample outside the table goes to its nearest row
    bool ends_take_only_x = false;      ///< 1/z and what is carried stay 0
    bool rows_begin_at_window = false;  ///< left = W, right = 0
    bool single_pixels_skipped = false; ///< left < right
    bool last_column_lost = false;      ///< x < right
    bool zero_is_outside = false;       ///< x > 0 && y > 0
    // Depth and interpolation
    bool depth_reversed = false;        ///< <
    bool depth_or_equal = false;        ///< >=
    float depth_clear = 0.0f;           ///< what the buffer starts with, in 1/z
    float depth_epsilon = 0.0f;         ///< how much nearer it must be, in 1/z
    bool depth_falls_along_row = false; ///< the step of 1/z has the wrong sign
    bool position_straight = false;     ///< p itself is carried
    bool multiplied_twice = false;      ///< by 1/z: for the edges and again for the rows
    bool never_divided = false;         ///< p/z is used as p
    bool divided_twice = false;         ///< p/z / (1/z) / (1/z)
    // Light
    bool light_vector_reversed = false; ///< p - lamp
    bool light_vector_as_long = false;  ///< not of unit length
    bool light_vector_with_w = false;   ///< a vec4 whose w is 1
    bool four_pi_forgotten = false;     ///< P / r^2
    bool distance_cubed = false;        ///< P / (4 pi r^3)
    bool pi_by_wrong_atan = false;      ///< atan(1) / 4
    bool pi_is_three = false;           ///< 3
    bool reflectance_added = false;     ///< D + reflectance
    bool reflectance_twice = false;     ///< reflectance * reflectance * (D + N)
    // Bytes
    bool colour_wraps = false;         ///< no clamp
    bool red_and_blue_swapped = false; ///< blue first
    bool gamma_applied = false;        ///< pow(c, 1 / 2.2)
};

/// A point where light is computed.
struct StudentPoint {
    glm::vec3 position{0.0f}; ///< world space
    glm::vec3 normal{0.0f};
    glm::vec3 colour{0.0f};
    int triangle = 0;
    float zinv = 0.0f; ///< 1/z at the pixel or the vertex
};

/// A student's program: choices, each of them right; known mistakes; and hooks for mistakes that
/// the laboratory does not know.
struct StudentProgram {
    StudentStage stage = StudentStage::pixel_light;
    int width = 500, height = 500;
    float zoom = 1.0f; ///< focal length over the height of the picture
    glm::vec3 camera{0.0f, 0.0f, -3.001f};
    float yaw = 0.0f; ///< radians
    glm::vec3 lamp{0.0f, -0.5f, -0.7f};
    glm::vec3 power{1.1f};
    glm::vec3 indirect{0.5f};
    VertexCut vertex_cut = VertexCut::cut;
    VertexProduct vertex_product = VertexProduct::by_zinv;
    Walk walk = Walk::add_steps;
    bool lines_rounded = false;         ///< samples to the nearest pixel
    bool vertex_light_straight = false; ///< straight across the picture, as in the handout
    bool bytes_rounded = false;         ///< int(255 c + 0.5)

    StudentMistakes mistakes;

    // Hooks for unknown mistakes; an empty one changes nothing.
    std::function<void(std::vector<StudentTriangle>&)> change_room;
    /// From 1/z and the triangle's number: the depth that is compared and stored.
    std::function<float(float, int)> change_depth;
    /// From the light that was computed: the light that is shown.
    std::function<glm::vec3(const StudentProgram&, glm::vec3, const StudentPoint&)> change_light;
    /// From a new colour and that of the pixel so far: the colour that is stored.
    std::function<glm::vec3(glm::vec3, glm::vec3)> change_mix;
    std::function<void(Image&)> change_picture;

    /// The same program with nothing wrong: only its choices.
    StudentProgram without_mistakes() const;
};

/// D of the handout, the light of the lamp alone, with the mistakes of the program.
glm::vec3 student_lamp_light(const StudentProgram& program, glm::vec3 position, glm::vec3 normal);

/// The picture that the program draws.
Image draw(const StudentProgram& program);

} // namespace rasterwalk::test
