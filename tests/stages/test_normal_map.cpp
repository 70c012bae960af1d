#include "stages/normal_map.h"

#include <cmath>
#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "mistakes/normal_map.h"
#include "scene/texture_files.h"
#include "support/painted.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// A triangle on the wall that faces the camera at the origin.
std::array<Vertex, triangle_corners> wall(const glm::vec2& uv_0, const glm::vec2& uv_right,
                                          const glm::vec2& uv_down) {
    std::array<Vertex, triangle_corners> corners;
    corners[0].position = {-1, -1, 2};
    corners[1].position = {1, -1, 2};
    corners[2].position = {-1, 1, 2};
    corners[0].texcoord = uv_0;
    corners[1].texcoord = uv_right;
    corners[2].texcoord = uv_down;
    return corners;
}

constexpr glm::vec3 to_camera{0, 0, -1};

/// Makes -0 the same as 0.
void check_vector(const glm::vec3& value, const glm::vec3& wanted) {
    INFO(value.x << " " << value.y << " " << value.z);
    CHECK(glm::distance(value, wanted) <= 1e-6f);
}

} // namespace

TEST_CASE("The axes of a wall: t along u, b toward the texture's top, also in a mirror") {
    const UvDirections straight = uv_directions(wall({0, 0}, {1, 0}, {0, 1}));
    check_vector(straight.along_u, {2, 0, 0});
    check_vector(straight.along_v, {0, 2, 0});
    const TangentFrame axes = tangent_frame(straight, to_camera);
    check_vector(axes.tangent, {1, 0, 0});
    check_vector(axes.bitangent, {0, -1, 0});
    CHECK(handedness(straight, axes) == 1.0f);

    const UvDirections mirrored = uv_directions(wall({1, 0}, {0, 0}, {1, 1}));
    const TangentFrame other = tangent_frame(mirrored, to_camera);
    check_vector(other.tangent, {-1, 0, 0});
    check_vector(other.bitangent, {0, -1, 0});
    CHECK(handedness(mirrored, other) == -1.0f);
    check_vector(tangent_frame_unasked(mirrored, to_camera).bitangent, {0, 1, 0});

    // Turned by a quarter: u runs down, the top is on the right.
    const UvDirections turned = uv_directions(wall({0, 1}, {0, 0}, {1, 1}));
    const TangentFrame quarter = tangent_frame(turned, to_camera);
    check_vector(quarter.tangent, {0, 1, 0});
    check_vector(quarter.bitangent, {1, 0, 0});
    CHECK(handedness(turned, quarter) == 1.0f);
}

TEST_CASE("t is perpendicular to the given normal, and of unit length") {
    const UvDirections uv = uv_directions(wall({0.1f, 0.2f}, {0.9f, 0.5f}, {-0.3f, 0.8f}));
    for (const glm::vec3 leaning : {glm::vec3{0.3f, -0.2f, -1}, {-0.9f, 0.4f, -0.3f}, {0, 0, 1}}) {
        const glm::vec3 normal = glm::normalize(leaning);
        const TangentFrame axes = tangent_frame(uv, normal);
        CHECK(std::abs(glm::dot(axes.tangent, normal)) <= 1e-6f);
        CHECK(std::abs(glm::dot(axes.bitangent, normal)) <= 1e-6f);
        CHECK(std::abs(glm::dot(axes.bitangent, axes.tangent)) <= 1e-6f);
        CHECK(glm::length(axes.tangent) == Approx(1.0f).margin(1e-6));
        CHECK(glm::dot(axes.bitangent, uv.along_v) < 0.0f);
    }
}

TEST_CASE("A texture without area, or with coordinates that are not numbers, has no axes") {
    constexpr float huge = 3e38f, none = std::numeric_limits<float>::quiet_NaN();
    for (const auto& corners :
         {wall({0, 0}, {0, 0}, {0, 0}), wall({0, 0}, {1, 1}, {2, 2}),
          wall({0, 0}, {none, 0}, {0, 1}), wall({0, 0}, {1e-30f, 0}, {0, 1e-30f}),
          wall({-huge, 0}, {huge, 0}, {0, huge})}) {
        const UvDirections uv = uv_directions(corners);
        CHECK(uv == UvDirections{});
        const TangentFrame axes = tangent_frame(uv, to_camera);
        CHECK(bent_normal({0.6f, 0, 0.8f}, axes) == to_camera);
    }
}

TEST_CASE(
    "The flat blue of a normal map leans by a third of a degree, since bytes have no middle") {
    const TangentFrame axes = tangent_frame(uv_directions(wall({0, 0}, {1, 0}, {0, 1})), to_camera);
    const glm::vec3 blue{128.0f / 255.0f, 128.0f / 255.0f, 1.0f};
    const glm::vec3 bent = bent_normal(arrow_of_texel(blue), axes);
    const double degrees = std::acos(-static_cast<double>(bent.z)) * 57.29577951;
    CHECK(degrees == Approx(0.3178).margin(0.002));
    CHECK(bent.x > 0.0f);
    CHECK(bent.y < 0.0f);
    check_vector(bent_normal(arrow_of_texel({1, 0.5f, 0.5f}), axes), {1, 0, 0});
    check_vector(bent_normal(arrow_of_texel({0.5f, 1, 0.5f}), axes), {0, -1, 0});
    check_vector(bent_normal(arrow_with_green_turned({0.5f, 1, 0.5f}), axes), {0, 1, 0});
    // Undecoded, flat ground leans by 35.3 degrees, whose tangent is the square root of 1/2.
    const glm::vec3 askew = bent_normal(arrow_undecoded({0.5f, 0.5f, 1.0f}), axes);
    CHECK(std::acos(-static_cast<double>(askew.z)) * 57.29577951 == Approx(35.2644).margin(0.001));
    // Grey has no direction at all.
    CHECK(bent_normal(arrow_of_texel(glm::vec3(0.5f)), axes) == to_camera);
}

namespace {

glm::dvec3 along(const glm::dmat3& axes, const glm::dvec3& vector) {
    return glm::inverse(axes) * vector;
}

glm::vec3 any_direction(test::Random& random) {
    return glm::normalize(
        glm::vec3(random.number(-1, 1), random.number(-1, 1), random.number(0.2, 1)));
}

} // namespace

TEST_CASE("Tangent space has unit axes, and light in it agrees with double") {
    test::Random random(2329);
    const UvDirections uv = uv_directions(wall({0.1f, 0.2f}, {0.9f, 0.5f}, {-0.3f, 0.8f}));
    double worst_askew = 0.0;
    for (int i = 0; i < 300; ++i) {
        const float length = i % 3 == 0 ? random.number(0.2, 0.95) : 1.0f;
        const TangentFrame given = tangent_frame(uv, any_direction(random) * length);
        const glm::vec3 arrow = any_direction(random), light = 3.0f * any_direction(random);
        const std::optional<TangentSpace> space = tangent_space(arrow, given);
        REQUIRE(space);
        const TangentFrame& axes = space->axes;
        const glm::dmat3 square(axes.tangent, axes.bitangent, axes.normal);
        const glm::dmat3 unit = glm::transpose(square) * square;
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row)
                CHECK(std::abs(unit[column][row] - (column == row ? 1.0 : 0.0)) < 1e-5);
        }
        const glm::dvec3 taken = along(square, glm::dvec3(light));
        CHECK(glm::distance(glm::dvec3(along_axes(light, axes)), taken) < 1e-5);
        // The slant in the world, by the given axes.
        const glm::dmat3 as_given(given.tangent, given.bitangent, given.normal);
        const double wanted =
            glm::dot(glm::dvec3(light), glm::normalize(as_given * glm::dvec3(arrow)));
        CHECK(glm::dot(taken, glm::dvec3(space->normal)) == Approx(wanted).margin(1e-5));
        if (length == 1.0f) {
            check_vector(space->normal, arrow);
            check_vector(axes.normal, given.normal);
        } else {
            // Here the inverse of the given axes would give different light.
            const double askew = glm::dot(along(as_given, glm::dvec3(light)), glm::dvec3(arrow));
            worst_askew = std::max(worst_askew, std::abs(askew - wanted));
        }
    }
    CHECK(worst_askew > 0.1);
    CHECK_FALSE(world_space({0, 0, 1}, tangent_frame(uv, to_camera)));
}

TEST_CASE("Without axes, or without an arrow, there is no tangent space") {
    const TangentFrame axes = tangent_frame(uv_directions(wall({0, 0}, {1, 0}, {0, 1})), to_camera);
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    CHECK(tangent_space({0, 0, 1}, axes));
    CHECK_FALSE(tangent_space({0, 0, 0}, axes));
    CHECK_FALSE(tangent_space({none, 0, 1}, axes));
    CHECK_FALSE(tangent_space({0, 0, 1}, tangent_frame({}, to_camera)));
    CHECK_FALSE(tangent_space(
        {0, 0, 1}, tangent_frame(uv_directions(wall({0, 0}, {1, 0}, {0, 1})), glm::vec3(0.0f))));
}

TEST_CASE("A height map rises to the right and up as its normals lean to the left and down") {
    // A ramp of 30 of 255 a texel, in a picture so wide that its middle sees no border.
    const Image right = test::painted(8, 3, [](int x, int) {
        return test::Rgb{30 * x, 30 * x, 30 * x};
    });
    const Image normals = normals_of_heights(right, 8.5f); // a slope of 1
    const auto at = [](const Image& image, int x, int y, int channel) {
        return int{image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + channel)]};
    };
    // -1/sqrt 2 and 1/sqrt 2 as bytes.
    CHECK(at(normals, 3, 1, 0) == 37);
    CHECK(at(normals, 3, 1, 1) == 128);
    CHECK(at(normals, 3, 1, 2) == 218);
    CHECK(at(normals, 3, 1, 3) == 255);
    const Image up = test::painted(3, 8, [](int, int y) {
        return test::Rgb{210 - 30 * y, 210 - 30 * y, 210 - 30 * y};
    });
    const Image leaning = normals_of_heights(up, 8.5f);
    CHECK(at(leaning, 1, 3, 0) == 128);
    CHECK(at(leaning, 1, 3, 1) == 37);
    // Beyond the border the picture repeats: 0 to the right of 210, from 180 down by 90 a texel.
    CHECK(at(normals, 7, 0, 0) > 218);
    CHECK_FALSE(looks_like_normals(right));
    CHECK_FALSE(looks_like_normals(up));
    CHECK(looks_like_normals(test::painted(2, 2, [](int, int) {
        return test::Rgb{128, 128, 255};
    })));
    CHECK_FALSE(looks_like_normals(test::painted(2, 2, [](int, int) {
        return test::Rgb{128, 128, 128};
    })));
}
