// The window on the near plane, compared with glm's frustum and ortho, with rays through it made
// without a matrix, and with the focal length where both show the same.

#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/matrix.hpp>

#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "stages/matrices.h"
#include "stages/orthographic.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The room by matrices, seen through any off-centre window.
Settings any_box(const Scene& room, Random& random) {
    Settings settings = default_settings(room);
    settings.transform = Transform::matrices;
    settings.near = random.number(0.05, 1);
    settings.far = settings.near + random.number(1, 50);
    const float left = random.number(-2, 1), bottom = random.number(-2, 1);
    settings.view_box =
        ViewBox{left, left + random.number(0.1, 2), bottom, bottom + random.number(0.1, 2)};
    settings.viewport = {random.integer(1, 700), random.integer(1, 700)};
    return settings;
}

} // namespace

TEST_CASE(
    "A window's projection matrix is glm's frustum or ortho, except for the signs of y and z") {
    const Scene room = lab_room();
    Random random(301);
    for (int i = 0; i < rounds(400, 100); ++i) {
        Settings settings = any_box(room, random);
        const bool is_orthographic = i % 2 == 1;
        settings.projection_mix = is_orthographic ? 1.0f : 0.0f;
        const double left = settings.view_box->left, right = settings.view_box->right;
        const double bottom = settings.view_box->bottom, top = settings.view_box->top;
        const double near = settings.near, far = settings.far;
        const glm::dmat4 book = is_orthographic
                                    ? glm::orthoRH_ZO(left, right, bottom, top, near, far)
                                    : glm::frustumRH_ZO(left, right, bottom, top, near, far);
        // Books have y up, here and in the picture, and look along -z.
        glm::dmat4 turned_axes(1.0), rows_down(1.0);
        turned_axes[1][1] = turned_axes[2][2] = rows_down[1][1] = -1.0;
        const glm::dmat4 expected = rows_down * book * turned_axes;
        const glm::dmat4 ours = projection_matrix(vertex_rules(settings, room.space));
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                CAPTURE(i, row, column);
                CHECK(ours[column][row] ==
                      Approx(expected[column][row]).epsilon(1e-5).margin(1e-9));
            }
        }
    }
}

TEST_CASE("Vertices are drawn where rays through the window at the near plane put them") {
    const Scene room = lab_room();
    Random random(302);
    int compared = 0;
    for (int i = 0; i < rounds(200, 40); ++i) {
        Settings settings = any_box(room, random);
        settings.projection_mix = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 1.0f : random.number(0.1, 0.9);
        settings.camera.position.z = random.number(-4, -2.5);
        const Frame frame = prepare_frame(room, settings);
        const ViewBox& box = *settings.view_box;
        // Rays meet behind the camera, or nowhere.
        const double mix = settings.projection_mix, near = settings.near;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            for (int v = 0; v < 3; ++v) {
                const glm::dvec3 place =
                    glm::dvec3(room.corner(t, v).position) - glm::dvec3(settings.camera.position);
                const double meet = mix == 1.0 ? 0.0 : -mix / (1.0 - mix);
                const double share = mix == 1.0 ? 1.0 : (near - meet) / (place.z - meet);
                const double across = (share * place.x - box.left) / (box.right - box.left);
                const double down = (box.top + share * place.y) / (box.top - box.bottom);
                const auto& drawn = frame.triangle_vertices(t)[static_cast<std::size_t>(v)];
                // The middle of the picture is a whole number of pixels.
                const double odd_x = 0.5 * (settings.viewport.width % 2);
                const double odd_y = 0.5 * (settings.viewport.height % 2);
                const double x = across * settings.viewport.width - odd_x;
                const double y = down * settings.viewport.height - odd_y;
                CAPTURE(i, t, v, mix);
                CHECK(drawn.position.x == Approx(x).epsilon(1e-5).margin(0.01));
                CHECK(drawn.position.y == Approx(y).epsilon(1e-5).margin(0.01));
                ++compared;
            }
        }
    }
    CHECK(compared > 1000);
}

TEST_CASE("A window equal to the focal length's view gives the same picture, another does not") {
    const Scene room = lab_room();
    for (const char* projection : {"projection=perspective", "projection=orthographic"}) {
        // Powers of 2, so that no number is rounded.
        Settings settings = default_settings(room);
        for (const char* set : {projection, "transform=matrices", "camera.focal_length=512",
                                "orthographic_depth=2", "near=0.125", "viewport.size=512x256"})
            set_from_text(settings, set);
        const Framebuffer usual = draw_frame(prepare_frame(room, settings));
        const ViewBox box = usual_view_box(vertex_rules(settings, room.space));
        // By hand: 256 and 128 of 512 pixels, at the depth 0.125; or at d = 2, whatever near is.
        const float half = settings.projection_mix == 0.0f ? 0.0625f : 1.0f;
        CAPTURE(projection);
        CHECK(box == ViewBox{-half, half, -0.5f * half, 0.5f * half});
        settings.view_box = box;
        CHECK(draw_frame(prepare_frame(room, settings)) == usual);
        settings.camera.focal_length = 300.0f; // the box replaces it
        settings.orthographic_depth = 3.0f;
        CHECK(draw_frame(prepare_frame(room, settings)).colour == usual.colour);
        settings.view_box->right *= 1.5f;
        CHECK_FALSE(draw_frame(prepare_frame(room, settings)).colour == usual.colour);
        settings.transform = Transform::lab;
        settings.camera.focal_length = 512.0f;
        settings.orthographic_depth = 2.0f;
        CHECK(draw_frame(prepare_frame(room, settings)).colour == usual.colour);
    }
}

TEST_CASE("Boxes as thin, wide and far off-centre as possible are drawn") {
    const Scene room = lab_room();
    const auto& kind = std::get<BoxSetting>(find_setting("view_box")->kind);
    const float end = kind.largest, thin = kind.least_side;
    for (const ViewBox& box :
         {ViewBox{-end, end, -end, end}, ViewBox{0.0f, thin, 0.0f, thin},
          ViewBox{-end, -end + 1.0f, end - 1.0f, end}, ViewBox{0.0f, thin, -end, end}}) {
        for (const char* near : {"near=0.000001", "near=0.1", "near=1000"}) {
            for (const char* clip : {"clip=leave_out", "clip=all", "clip=none"}) {
                for (const char* mix :
                     {"projection_mix=0", "projection_mix=0.5", "projection_mix=1"}) {
                    Settings settings = default_settings(room);
                    for (const char* set :
                         {near, clip, mix, "transform=matrices", "viewport.size=40x30"})
                        set_from_text(settings, set);
                    settings.view_box = box;
                    const glm::dmat4 projection =
                        projection_matrix(vertex_rules(settings, room.space));
                    CAPTURE(value_text(*find_setting("view_box"), settings), near, clip, mix);
                    for (int column = 0; column < 4; ++column)
                        for (int row = 0; row < 4; ++row)
                            CHECK(std::isfinite(projection[column][row]));
                    CHECK(draw_frame(prepare_frame(room, settings)).colour.size() == 1200);
                }
            }
        }
    }
}
