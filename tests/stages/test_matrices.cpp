// The matrix path compared with the lab's: the room has the same bits, and from any camera a vertex
// moves only if its exact place is within rounding of a border between pixels.

#include "stages/matrices.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pipeline/draw.h"
#include "scene/look_at.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings by_matrices(Settings settings) {
    settings.transform = Transform::matrices;
    return settings;
}

/// A position on screen before truncation to whole pixels, from the middle, in long double and
/// without a matrix: by the angles of the camera, turned one after the other.
struct ExactPlace {
    long double x, y, z;
};
ExactPlace exact_place(const glm::vec3& p, const Camera& camera) {
    const long double dx = static_cast<long double>(p.x) - camera.position.x;
    const long double dy = static_cast<long double>(p.y) - camera.position.y;
    const long double dz = static_cast<long double>(p.z) - camera.position.z;
    const long double cy = std::cos(static_cast<long double>(camera.yaw));
    const long double sy = std::sin(static_cast<long double>(camera.yaw));
    const long double cp = std::cos(static_cast<long double>(camera.pitch));
    const long double sp = std::sin(static_cast<long double>(camera.pitch));
    const long double x = cy * dx - sy * dz, forward = sy * dx + cy * dz;
    const long double y = cp * dy + sp * forward, z = cp * forward - sp * dy;
    return {camera.focal_length * x / z, camera.focal_length * y / z, z};
}

/// How near a number is to a whole one, where int() cuts.
long double distance_to_cut(long double value) {
    return std::abs(value - std::round(value));
}

glm::dvec4 column(const glm::dmat4& matrix, int i) {
    return matrix[i];
}

} // namespace

TEST_CASE(
    "With matrices none of the room's 90 vertices move and none of its 250,000 pixels differ") {
    const Scene room = lab_room();
    const Settings lab = default_settings(room);
    const Frame a = prepare_frame(room, lab), b = prepare_frame(room, by_matrices(lab));
    REQUIRE(a.triangle_count() == 30);
    int elsewhere = 0;
    for (int t = 0; t < 30; ++t) {
        for (std::size_t v = 0; v < 3; ++v)
            elsewhere += a.triangle_vertices(t)[v] == b.triangle_vertices(t)[v] ? 0 : 1;
    }
    CHECK(elsewhere == 0);
    CHECK(b.stages.vertex_shader != a.stages.vertex_shader);
    const Framebuffer in_a = draw_frame(a), in_b = draw_frame(b);
    REQUIRE(in_a.colour.size() == 250'000);
    CHECK(in_a.colour == in_b.colour);
    CHECK(in_a.depth == in_b.depth);
    CHECK(in_a.owner == in_b.owner);
}

TEST_CASE("From any camera a vertex moves only if it is within rounding of a cut") {
    const Scene room = lab_room();
    Random random(123);
    int compared = 0, elsewhere = 0;
    for (int i = 0; i < rounds(3000, 300); ++i) {
        Settings settings = default_settings(room);
        settings.camera.position = {random.number(-2, 2), random.number(-2, 2),
                                    random.number(-6, -1.5)};
        settings.camera.yaw = random.number(-0.6, 0.6);
        settings.camera.pitch = random.number(-0.4, 0.4);
        settings.camera.focal_length = random.number(50, 900);
        settings.viewport = {random.integer(1, 700), random.integer(1, 700)};
        const Frame a = prepare_frame(room, settings);
        const Frame b = prepare_frame(room, by_matrices(settings));
        for (int t = 0; t < a.triangle_count(); ++t) {
            REQUIRE(a.is_drawn(t) == b.is_drawn(t));
            if (!a.is_drawn(t)) continue;
            for (int v = 0; v < 3; ++v) {
                const ScreenVertex& lab = a.triangle_vertices(t)[static_cast<std::size_t>(v)];
                const ScreenVertex& chain = b.triangle_vertices(t)[static_cast<std::size_t>(v)];
                ++compared;
                const ExactPlace exact = exact_place(room.corner(t, v).position, settings.camera);
                // About one float rounding for each of the lab's ten or so operations.
                const long double bound = 2e-6L * (1.0L + std::abs(exact.x) + std::abs(exact.y)) *
                                          (1.0L + 4.0L / exact.z);
                // R is in float, so its rounding is relative to the distance, not to z.
                const glm::vec3 way = room.corner(t, v).position - settings.camera.position;
                CHECK(std::abs(static_cast<long double>(chain.z) - exact.z) <
                      3e-7L * (std::abs(way.x) + std::abs(way.y) + std::abs(way.z)));
                if (lab.column == chain.column && lab.row == chain.row) continue;
                ++elsewhere;
                CAPTURE(i, t, v, lab.column, chain.column, lab.row, chain.row);
                if (lab.column != chain.column) CHECK(distance_to_cut(exact.x) < bound);
                if (lab.row != chain.row) CHECK(distance_to_cut(exact.y) < bound);
            }
        }
    }
    CHECK(compared > 10'000);
    CHECK(elsewhere < compared / 1000);
}

TEST_CASE("The columns of the view matrix are the transformed axes") {
    Random random(124);
    for (int i = 0; i < rounds(500, 50); ++i) {
        Camera camera;
        camera.position = {random.number(-2, 2), random.number(-2, 2), random.number(-2, 2)};
        camera.yaw = random.number(-3, 3);
        camera.pitch = random.number(-1.5, 1.5);
        const glm::mat3 rotation = camera_rotation(camera);
        const glm::dmat4 view = view_matrix(glm::dvec3(camera.position), glm::dmat3(rotation));
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 unit(0.0f);
            unit[axis] = 1.0f;
            const glm::dvec3 turned(rotate_to_camera(unit, rotation));
            CHECK(glm::distance(glm::dvec3(column(view, axis)), turned) == 0.0);
        }
        // The camera itself is at the origin.
        const glm::dvec4 eye = view * glm::dvec4(glm::dvec3(camera.position), 1.0);
        CHECK(glm::length(glm::dvec3(eye)) < 1e-12);
        CHECK(eye.w == 1.0);
    }
}

TEST_CASE("Look-at has its target in the middle, up pointing up, and three axes of unit length") {
    Random random(125);
    for (int i = 0; i < rounds(2000, 200); ++i) {
        Camera camera;
        camera.aim = CameraAim::look_at;
        for (int k = 0; k < 3; ++k) {
            camera.position[k] = random.number(-3, 3);
            camera.target[k] = random.number(-3, 3);
            camera.up[k] = random.number(-1, 1);
        }
        const glm::mat3 r = camera_rotation(camera);
        const glm::vec3 target = rotate_to_camera(camera.target - camera.position, r);
        const float far = glm::distance(camera.target, camera.position);
        CHECK(glm::distance(target, {0.0f, 0.0f, far}) < 1e-5f * (1.0f + far));
        const glm::vec3 up = rotate_to_camera(camera.up, r);
        CHECK(up.x == Approx(0.0f).margin(1e-3f));
        CHECK(up.y < 1e-3f); // y runs down
        CHECK(glm::determinant(r) == Approx(1.0f).margin(1e-4f));
        // As in books: the same axes, with y up and z toward the viewer.
        const glm::dvec3 eye(camera.position);
        const glm::dvec3 w = glm::normalize(eye - glm::dvec3(camera.target));
        const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), w));
        const glm::dvec4 point(0.3, -0.2, 0.9, 1.0);
        const glm::dvec4 ours = view_matrix(eye, glm::dmat3(r)) * point;
        const glm::dvec3 ray = glm::dvec3(point) - eye;
        const glm::dvec3 theirs{glm::dot(u, ray), glm::dot(glm::cross(w, u), ray),
                                glm::dot(w, ray)};
        CHECK(glm::distance(glm::dvec3(ours.x, -ours.y, -ours.z), theirs) < 1e-3);
    }
}

TEST_CASE("A camera that looks nowhere, or along up, still has three axes") {
    for (const glm::vec3& target : {glm::vec3(0.0f), glm::vec3(0.0f, 5.0f, 0.0f),
                                    glm::vec3(0.0f, -5.0f, 0.0f), glm::vec3(0.0f, 0.0f, 3.0f)}) {
        for (const glm::vec3& up :
             {glm::vec3(0.0f), glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(0.0f, 1e-30f, 0.0f),
              glm::vec3(0.0f, 0.0f, 1000.0f)}) {
            const glm::mat3 r = look_at_rotation(glm::vec3(0.0f), target, up);
            CHECK(glm::determinant(r) == Approx(1.0f).margin(1e-5f));
            for (int i = 0; i < 3; ++i)
                CHECK(glm::length(r[i]) == Approx(1.0f));
        }
    }
    const glm::mat3 straight =
        look_at_rotation({0.0f, 0.0f, -3.0f}, glm::vec3(0.0f), {0.0f, -1.0f, 0.0f});
    CHECK(straight == glm::mat3(1.0f));
}

TEST_CASE("The view volume becomes the NDC box, and NDC the window") {
    VertexRules rules;
    rules.viewport = {640, 480};
    rules.camera.focal_length = 400.0f;
    rules.near = 0.5f;
    rules.far = 20.0f;
    for (const float mix : {0.0f, 0.3f, 1.0f}) {
        rules.projection.mix = mix;
        rules.projection.depth = 3.0f;
        const glm::dmat4 projection = projection_matrix(rules);
        const auto ndc = [&](const glm::dvec3& camera) {
            const glm::dvec4 clip = projection * glm::dvec4(camera, 1.0);
            return glm::dvec3(clip) / clip.w;
        };
        CAPTURE(mix);
        CHECK(ndc({0.0, 0.0, 0.5}).z == Approx(0.0).margin(1e-7));
        CHECK(ndc({0.0, 0.0, 20.0}).z == Approx(1.0));
        // At the depth d the picture is as wide as under perspective: 320 of 400 / 3.
        CHECK(ndc({320.0 * 3.0 / 400.0, -240.0 * 3.0 / 400.0, 3.0}).x == Approx(1.0));
        CHECK(ndc({320.0 * 3.0 / 400.0, -240.0 * 3.0 / 400.0, 3.0}).y == Approx(-1.0));
        if (mix == 1.0f) CHECK((projection * glm::dvec4(1.0, 2.0, 17.0, 1.0)).w == 1.0);
    }
    const glm::dmat4 viewport = viewport_matrix(rules);
    CHECK(viewport * glm::dvec4(-1.0, -1.0, 0.0, 1.0) == glm::dvec4(0.0, 0.0, 0.0, 1.0));
    CHECK(viewport * glm::dvec4(1.0, 1.0, 0.5, 1.0) == glm::dvec4(640.0, 480.0, 0.5, 1.0));
    // The lab's middle is a whole number of pixels.
    rules.viewport = {7, 5};
    CHECK(viewport_matrix(rules) * glm::dvec4(0.0, 0.0, 0.0, 1.0) ==
          glm::dvec4(3.0, 2.0, 0.0, 1.0));
}

TEST_CASE("Half of the range of NDC z is used up at twice the near plane") {
    const VertexRules rules; // 0.1 and 100
    const auto z_ndc = [&](double z) { return ndc_depth(z, rules); };
    CHECK(z_ndc(0.2) == Approx(0.5005).margin(5e-6));
    CHECK(z_ndc(4.0) == Approx(0.97598).margin(5e-6));
    CHECK(z_ndc(4.0) == Approx(100.0 / 99.9 * (1.0 - 0.1 / 4.0)));
}

TEST_CASE("The mistakes of rotation and focal length can be made with matrices too") {
    const Scene room = lab_room();
    for (const char* mistake : {"rotation=transposed", "image_axes=mirrored",
                                "image_axes=exchanged", "image_axes=uncentred"}) {
        Settings settings = default_settings(room);
        settings.camera.yaw = 0.125f;
        set_from_text(settings, mistake);
        const Frame right = prepare_frame(room, default_settings(room));
        const Frame a = prepare_frame(room, settings);
        const Frame b = prepare_frame(room, by_matrices(settings));
        int same = 0, moved = 0, all = 0;
        for (int t = 0; t < a.triangle_count(); ++t) {
            if (!a.is_drawn(t) || !b.is_drawn(t)) continue;
            for (std::size_t v = 0; v < 3; ++v, ++all) {
                const ScreenVertex &p = a.triangle_vertices(t)[v], &q = b.triangle_vertices(t)[v];
                same += p.column == q.column && p.row == q.row ? 1 : 0;
                moved += p.column != right.triangle_vertices(t)[v].column ? 1 : 0;
            }
        }
        INFO(mistake);
        CHECK(all > 60);
        CHECK(same == all);
        CHECK(moved > all / 2);
    }
}
