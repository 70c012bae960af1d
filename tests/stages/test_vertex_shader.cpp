#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "stages/light.h"
#include "stages/project.h"
#include "stages/stage_table.h"
#include "support/bits.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Vertex vertex_at(const glm::vec3& position) {
    Vertex vertex;
    vertex.position = position;
    vertex.normal = {0.0f, 0.0f, -1.0f};
    return vertex;
}

ShadedVertex shade(const glm::vec3& position, const VertexRules& rules = {}) {
    return shade_vertex(vertex_at(position), camera_rotation(rules.camera), rules, {});
}

/// A camera at the origin that looks along z.
VertexRules plain_rules(float focal_length = 100.0f) {
    VertexRules rules;
    rules.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, focal_length};
    return rules;
}

} // namespace

TEST_CASE("The room's corners fall on the handout's pixels") {
    // z = 2.001 for the near corners: 500 / 2.001 = 249.875 pixels from the middle.
    const ShadedVertex near = shade({-1.0f, -1.0f, -1.0f});
    CHECK(near.pixel.column == 1);
    CHECK(near.pixel.row == 1);
    CHECK(near.in("projected").x == Approx(-249.87506));
    CHECK(shade({1.0f, 1.0f, -1.0f}).pixel.column == 499);
    const ShadedVertex far = shade({1.0f, -1.0f, 1.0f});
    CHECK(far.pixel.column == 250 + 124);
    CHECK(far.pixel.row == 250 - 124);
    CHECK(far.pixel.inv_w == Approx(1.0 / 4.001));
    CHECK(far.pixel.z == Approx(4.001));
    CHECK(far.rejection == Rejection::none);
}

TEST_CASE("A vertex passes through every space as in double precision") {
    Random random(13);
    for (int i = 0; i < 5000; ++i) {
        VertexRules rules;
        rules.camera = {{random.number(-2, 2), random.number(-2, 2), random.number(-4, -2)},
                        random.number(-3.2, 3.2),
                        random.number(-1.6, 1.6),
                        random.number(50, 900)};
        rules.viewport = {random.integer(1, 900), random.integer(1, 900)};
        const auto rounding = static_cast<Rounding>(i % 3);
        rules.rounding = static_cast<VertexRounding>(rounding);
        const glm::vec3 world{random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)};
        const ShadedVertex shaded = shade(world, rules);
        const glm::dvec3 moved = glm::dvec3(world) - glm::dvec3(rules.camera.position);
        // First about y, then about x, each by its own formula.
        const double cy = std::cos(double{rules.camera.yaw}),
                     sy = std::sin(double{rules.camera.yaw});
        const double cp = std::cos(double{rules.camera.pitch});
        const double sp = std::sin(double{rules.camera.pitch});
        const double turned_z = moved.x * sy + moved.z * cy;
        const glm::dvec3 camera{moved.x * cy - moved.z * sy, moved.y * cp + turned_z * sp,
                                -moved.y * sp + turned_z * cp};
        CAPTURE(i, camera.x, camera.y, camera.z);
        CHECK(shaded.in("world") == world);
        CHECK(glm::distance(glm::dvec3(shaded.in("minus_camera")), moved) < 1e-6);
        CHECK(glm::distance(glm::dvec3(shaded.in("rotated")), camera) < 2e-6);
        if (camera.z < 0.05) {
            if (camera.z < -1e-5) CHECK(shaded.rejection == Rejection::behind_camera);
            continue;
        }
        const double x = rules.camera.focal_length * camera.x / camera.z;
        const double y = rules.camera.focal_length * camera.y / camera.z;
        // 2e-6 of a place nearer than a tenth moves a pixel by this much.
        const double tolerance =
            1e-5 * rules.camera.focal_length / camera.z * (1.0 + glm::length(camera) / camera.z);
        if (std::max(std::abs(x), std::abs(y)) > 16000.0) continue;
        REQUIRE(shaded.rejection == Rejection::none);
        CHECK(std::abs(shaded.in("projected").x - x) < tolerance);
        CHECK(std::abs(shaded.in("projected").y - y) < tolerance);
        CHECK(shaded.pixel.column ==
              round_float(shaded.in("projected").x, rounding) + rules.viewport.width / 2);
        CHECK(shaded.pixel.row ==
              round_float(shaded.in("projected").y, rounding) + rules.viewport.height / 2);
        CHECK(same_bits(shaded.pixel.z, shaded.in("rotated").z));
        CHECK(same_bits(shaded.pixel.inv_w, 1.0f / shaded.in("rotated").z));
    }
}

TEST_CASE("The camera's matrix is a turn: it keeps lengths, angles and handedness") {
    Random random(14);
    for (int i = 0; i < 500; ++i) {
        Camera camera;
        camera.yaw = random.number(-10, 10);
        camera.pitch = random.number(-1.6, 1.6);
        const glm::mat3 r = camera_rotation(camera);
        CAPTURE(camera.yaw, camera.pitch);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b)
                CHECK(std::abs(glm::dot(r[a], r[b]) - (a == b ? 1.0f : 0.0f)) < 1e-6f);
        }
        CHECK(glm::determinant(r) == Approx(1.0f));
    }
}

TEST_CASE("The lab's row vector times R is the transposed matrix times a column vector") {
    Camera camera;
    camera.yaw = 0.3f;
    // The lab's R for yaw, row by row: (c 0 s) (0 1 0) (-s 0 c).
    const float c = std::cos(0.3f), s = std::sin(0.3f);
    const glm::mat3 lab(glm::vec3(c, 0.0f, -s), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(s, 0.0f, c));
    CHECK(camera_rotation(camera) == lab);
    camera.pitch = -0.4f;
    const glm::mat3 r = camera_rotation(camera);
    const glm::vec3 v(0.2f, -0.7f, 1.5f);
    CHECK(glm::distance(v * r, glm::transpose(r) * v) < 1e-6f);
    // Mistake B24, R v, turns the other way.
    CHECK(glm::distance(v * r, r * v) > 0.1f);
}

TEST_CASE("The camera's target is in the middle; turning right moves the world left") {
    VertexRules rules = plain_rules();
    rules.viewport = {200, 100};
    for (const float yaw : {-1.0f, 0.0f, 0.4f}) {
        for (const float pitch : {-0.7f, 0.0f, 0.2f}) {
            rules.camera.yaw = yaw;
            rules.camera.pitch = pitch;
            const glm::vec3 forward = camera_rotation(rules.camera)[2];
            const ShadedVertex middle = shade(3.0f * forward, rules);
            CAPTURE(yaw, pitch);
            CHECK(middle.pixel.column == 100);
            CHECK(middle.pixel.row == 50);
            CHECK(middle.pixel.z == Approx(3.0));
        }
    }
    rules = plain_rules();
    rules.camera.yaw = 0.1f;
    CHECK(shade({0, 0, 5}, rules).in("projected").x < -9.0f);
    rules = plain_rules();
    rules.camera.pitch = 0.1f;
    // Pitch looks up, and y points down.
    CHECK(shade({0, 0, 5}, rules).in("projected").y > 9.0f);
}

TEST_CASE("Truncation toward zero doubles the middle and loses the far left, floor does neither") {
    VertexRules rules = plain_rules(1.0f);
    rules.viewport = {10, 10};
    const auto column = [&](float x, VertexRounding rounding) {
        rules.rounding = rounding;
        return shade({x, 0.0f, 1.0f}, rules).pixel.column;
    };
    CHECK(column(-0.9f, VertexRounding::truncate) == 5);
    CHECK(column(0.9f, VertexRounding::truncate) == 5);
    CHECK(column(-4.9f, VertexRounding::truncate) == 1);
    CHECK(column(-0.9f, VertexRounding::floor) == 4);
    CHECK(column(0.9f, VertexRounding::floor) == 5);
    CHECK(column(-4.9f, VertexRounding::floor) == 0);
    CHECK(column(-0.5f, VertexRounding::round) == 5);
    CHECK(column(-0.51f, VertexRounding::round) == 4);
    CHECK(column(0.5f, VertexRounding::round) == 6);
    CHECK(column(-3.0f, VertexRounding::truncate) == 2);
    CHECK(column(-3.0f, VertexRounding::floor) == 2);
    CHECK(column(-3.0f, VertexRounding::round) == 2);
}

TEST_CASE("Cut after the middle was added, only the first column and row are twice as wide") {
    VertexRules rules = plain_rules(1.0f);
    rules.viewport = {10, 7};
    rules.rounding = VertexRounding::truncate_sum;
    const auto pixel = [&](float x, float y) {
        const ScreenVertex at = shade({x, y, 1.0f}, rules).pixel;
        return glm::ivec2(at.column, at.row);
    };
    // The middle is where floor has it: column 5, and row 7 / 2 = 3.
    CHECK(pixel(-0.9f, -0.9f) == glm::ivec2(4, 2));
    CHECK(pixel(0.9f, 0.9f) == glm::ivec2(5, 3));
    CHECK(pixel(-4.9f, -2.9f) == glm::ivec2(0, 0));
    // Up to a pixel beyond the border is truncated onto it, where floor leaves the picture.
    CHECK(pixel(-5.9f, -3.9f) == glm::ivec2(0, 0));
    CHECK(pixel(-6.0f, -4.0f) == glm::ivec2(-1, -1));
    CHECK(pixel(4.9f, 3.9f) == glm::ivec2(9, 6));
}

TEST_CASE("The middle of an odd picture is its width halved and cut") {
    VertexRules rules = plain_rules();
    rules.viewport = {7, 5};
    const ShadedVertex middle = shade({0, 0, 1}, rules);
    CHECK(middle.pixel.column == 3);
    CHECK(middle.pixel.row == 2);
}

TEST_CASE("In pixel space a vertex keeps its column, row and depth, without a camera") {
    VertexRules rules;
    rules.space = SceneSpace::pixels;
    rules.camera.position = {7, 7, 7};
    rules.camera.yaw = 1.0f;
    const ShadedVertex shaded = shade({10.0f, -5.0f, 4.0f}, rules);
    CHECK(shaded.rejection == Rejection::none);
    CHECK(shaded.pixel.column == 10);
    CHECK(shaded.pixel.row == -5);
    CHECK(shaded.pixel.inv_w == 0.25f);
    CHECK(shade({10.9f, -5.9f, 1.0f}, rules).pixel.column == 10);
    CHECK(shade({10.9f, -5.9f, 1.0f}, rules).pixel.row == -5);
    CHECK(shade({0, 0, 0}, rules).rejection == Rejection::behind_camera);
    CHECK(shade({16385, 0, 1}, rules).rejection == Rejection::too_far_out);
}

TEST_CASE("A vertex on or behind the camera plane is left out") {
    const VertexRules rules = plain_rules();
    for (const float z : {0.0f, -0.0f, -1e-30f, -1.0f, -1e30f}) {
        CAPTURE(z);
        CHECK(shade({1.0f, 1.0f, z}, rules).rejection == Rejection::behind_camera);
    }
    CHECK(shade({0, 0, -3.001f}).rejection == Rejection::behind_camera);
}

TEST_CASE("A vertex with a coordinate that is not finite is left out") {
    for (const float bad : {not_a_number, infinity, -infinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 position(0.5f, 0.5f, 2.0f);
            position[axis] = bad;
            CAPTURE(bad, axis);
            CHECK(shade(position, plain_rules()).rejection == Rejection::not_finite);
            VertexRules pixels;
            pixels.space = SceneSpace::pixels;
            CHECK(shade(position, pixels).rejection == Rejection::not_finite);
            VertexRules moved;
            moved.camera.position[axis] = bad;
            CHECK(shade({0, 0, 0}, moved).rejection == Rejection::not_finite);
        }
    }
    // Finite, but not after the camera is subtracted.
    VertexRules rules = plain_rules();
    rules.camera.position.x = -3e38f;
    CHECK(shade({3e38f, 0, 1}, rules).rejection == Rejection::not_finite);
}

TEST_CASE("A vertex farther out than the limit is left out, and one on the limit is drawn") {
    const VertexRules rules = plain_rules(1.0f);
    const float limit = max_pixel_distance, beyond = std::nextafter(limit, infinity);
    for (const float sign : {-1.0f, 1.0f}) {
        CHECK(shade({sign * limit, 0, 1}, rules).rejection == Rejection::none);
        CHECK(shade({0, sign * limit, 1}, rules).rejection == Rejection::none);
        CHECK(shade({sign * beyond, 0, 1}, rules).rejection == Rejection::too_far_out);
        CHECK(shade({0, sign * beyond, 1}, rules).rejection == Rejection::too_far_out);
    }
    CHECK(shade({limit, 0, 1}, rules).pixel.column == 250 + 16384);
    // So near that 1/z overflows, even in the middle of the picture.
    CHECK(shade({0, 0, 1e-40f}, rules).rejection == Rejection::too_far_out);
    CHECK(shade({0, 0, 1e-30f}, rules).rejection == Rejection::none);
    for (const float focal_length : {not_a_number, infinity}) {
        CHECK(shade({1, 1, 1}, plain_rules(focal_length)).rejection == Rejection::too_far_out);
    }
}

TEST_CASE("A vertex starts with its place and, for light per vertex, its light, divided by z") {
    VertexRules rules;
    rules.light.power = glm::vec3(14.0f);
    const Vertex vertex = [] {
        Vertex v = vertex_at({0.5f, 1.0f, 0.999f});
        v.normal = {0.0f, -1.0f, 0.0f};
        v.reflectance = {0.15f, 0.75f, 0.15f};
        return v;
    }();
    const glm::mat3 rotation = camera_rotation(rules.camera);
    const glm::vec3 light =
        reflected_light(vertex.position, vertex.normal, vertex.reflectance, rules.light).reflected;
    REQUIRE(light.g > 0.4f);

    const Stages right = test::stages_under(Interpolation::perspective);
    const Stages wrong = test::stages_under(Interpolation::affine);
    for (const Shading shading : {Shading::unlit, Shading::gouraud, Shading::phong}) {
        rules.shading = shading;
        const Varyings affine = shade_vertex(vertex, rotation, rules, wrong).pixel.varyings;
        const ScreenVertex pixel = shade_vertex(vertex, rotation, rules, right).pixel;
        // Before the division there is no weight yet, however the varyings will be carried.
        const ClipVertex clip = vertex_shader(vertex, rotation, rules, right, nullptr);
        CHECK(same_bits(clip.varyings.illumination, affine.illumination));
        CHECK(same_bits(pixel.inv_w, 1.0f / clip.position_clip.w));
        const bool lit = shading == Shading::gouraud;
        CHECK(same_bits(affine.position_world, vertex.position));
        CHECK(same_bits(affine.illumination, lit ? light : glm::vec3(0.0f)));
        CHECK(same_bits(pixel.varyings.position_world, vertex.position * pixel.inv_w));
        CHECK(same_bits(pixel.varyings.illumination, affine.illumination * pixel.inv_w));
    }
}
