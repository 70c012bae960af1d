// The same files, translated by the compiler: a student who copies them gets the picture that the
// window shows, to the last bit.

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/draw.h"
#include "pipeline/shadow_pass.h"
#include "support/samples.h"
#include "tests/support/catch.h"

// A student's compiler is not as strict as ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-parameter"

// clang-format off
#define depth_clear_0 1
#define fill_rule_inclusive 1
#define camera_known 1
#define line_interpolate 1

#define stage_rows 1
namespace rasterwalk::test::compiled_rows {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_rows
#undef stage_rows

#define stage_vertex_light 1
#define vertex_normals 1
namespace rasterwalk::test::compiled_vertex_light {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_vertex_light
#undef vertex_normals
#undef stage_vertex_light

#define stage_pixel_light 1
#define carried_pos3d 1
#define coverage_edge_functions 1
#define fragments_by_weights 1
namespace rasterwalk::test::compiled_edge_functions {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_edge_functions
#undef fragments_by_weights
#undef coverage_edge_functions

#undef line_interpolate
#define line_bresenham 1
#define interpolation_affine 1
namespace rasterwalk::test::compiled_bresenham {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_bresenham
#undef line_bresenham
#define line_interpolate 1
#undef interpolation_affine

#define clip_space 1
#define cuts_polygons 1
#define clip_all 1
#define has_positive_w 1
#define transform_matrices 1
namespace rasterwalk::test::compiled_clipping {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_clipping
#undef transform_matrices
#undef has_positive_w
#undef clip_all
#undef cuts_polygons
#undef clip_space

#define scene_shadows 1
#define shadows_rays 1
namespace rasterwalk::test::compiled_shadow_rays {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_shadow_rays
#undef shadows_rays

#define shadows_map 1
#define shadow_slope_bias_0 1
#define shadow_filter_four 1
namespace rasterwalk::test::compiled_shadow_map {
#include "lab_files.inc"
} // namespace rasterwalk::test::compiled_shadow_map
#undef shadow_filter_four
#undef shadow_slope_bias_0
#undef shadows_map
#undef scene_shadows
#undef carried_pos3d
#undef stage_pixel_light
#undef line_interpolate
#undef camera_known
#undef fill_rule_inclusive
#undef depth_clear_0
// clang-format on

#pragma GCC diagnostic pop

namespace rasterwalk::test {

namespace {

/// The picture of the stages, and the room as the code has it.
class CompiledRoom {
  public:
    Scene scene = lab_room();
    Settings settings = default_settings(scene);

    explicit CompiledRoom(const char* stage) { set_step(settings, find_stage(stage)->step); }

    /// Has the program draw the room, too, and says the first pixel with another colour; empty:
    /// none. The parameters are the program's own.
    template <class Triangle, class Picture>
    std::string first_wrong_pixel(std::vector<Triangle>& list, glm::mat3& rotation, glm::vec3& eye,
                                  void (*clear)(), void (*draw)(), const Picture& picture) {
        settings.camera.yaw = 0.2f;
        right_ = draw_frame(prepare_frame(scene, settings));
        list = triangles<Triangle>();
        rotation = camera_rotation(settings.camera);
        eye = settings.camera.position;
        clear();
        draw();
        return difference_to(picture);
    }

  private:
    template <class Triangle>
    std::vector<Triangle> triangles() const {
        std::vector<Triangle> list;
        for (int t = 0; t < scene.triangle_count(); ++t) {
            const std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
            Triangle triangle;
            triangle.v0 = corners[0].position;
            triangle.v1 = corners[1].position;
            triangle.v2 = corners[2].position;
            triangle.normal = corners[0].normal;
            triangle.color = corners[0].reflectance;
            list.push_back(triangle);
        }
        return list;
    }

    template <class Picture>
    std::string difference_to(const Picture& picture) const {
        for (int y = 0; y < right_.size.height; ++y) {
            for (int x = 0; x < right_.size.width; ++x) {
                const glm::vec3& wanted = right_.colour[right_.at(x, y)];
                if (std::memcmp(&picture[y][x], &wanted, sizeof wanted) != 0)
                    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
            }
        }
        return {};
    }

    Framebuffer right_; ///< the picture of the stages
};

} // namespace

TEST_CASE("The compiled code draws the ends of the rows as the stages do") {
    CompiledRoom room("rows");
    namespace code = compiled_rows;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code draws light per vertex as the stages do") {
    CompiledRoom room("vertex_light");
    namespace code = compiled_vertex_light;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code draws with edge functions as the stages do") {
    CompiledRoom room("pixel_light");
    room.settings.coverage = Coverage::edge_functions;
    namespace code = compiled_edge_functions;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code casts shadows by rays as the stages do") {
    CompiledRoom room("pixel_light");
    room.settings.shadows = Shadows::rays;
    namespace code = compiled_shadow_rays;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code casts shadows by a map as the stages do") {
    CompiledRoom room("pixel_light");
    room.settings.shadows = Shadows::map;
    room.settings.shadow_filter = ShadowFilter::four;
    room.settings.shadow_resolution = 64;
    namespace code = compiled_shadow_map;
    const ShadowMap map = draw_shadow_map(room.scene, code::lightPos, 64);
    code::shadowMapSize = 64;
    for (std::size_t face = 0; face < map.faces.size(); ++face) {
        const ShadowFace& drawn = map.faces[face];
        code::shadowAxes[face] = drawn.axes;
        code::shadowMap.insert(code::shadowMap.end(), drawn.inv_depth.begin(),
                               drawn.inv_depth.end());
    }
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code draws with matrices, and what clipping leaves, as the stages do") {
    CompiledRoom room("pixel_light");
    room.settings.transform = Transform::matrices;
    room.settings.clip = Clip::all;
    room.settings.camera.position.z = -0.5f;
    namespace code = compiled_clipping;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

TEST_CASE("The compiled code draws Bresenham's lines and affine values as the stages do") {
    CompiledRoom room("pixel_light");
    room.settings.line = LineAlgorithm::bresenham;
    room.settings.interpolation = Interpolation::affine;
    namespace code = compiled_bresenham;
    CHECK(room.first_wrong_pixel(code::triangles, code::R, code::cameraPos, code::Clear, code::Draw,
                                 code::frame) == "");
}

} // namespace rasterwalk::test
