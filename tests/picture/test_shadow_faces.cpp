// The faces of the shadow map as pictures, compared with rays of the test's own from the lamp.

#include "picture/shadow_faces.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "picture/colour_map.h"
#include "pipeline/shadow_pass.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// How far along `ray` a triangle is met, by Cramer's rule; infinite if it is not.
double own_distance(const std::array<Vertex, triangle_corners>& corners, const glm::dvec3& from,
                    const glm::dvec3& ray) {
    const glm::dvec3 a(corners[0].position), ab = glm::dvec3(corners[1].position) - a,
                                             ac = glm::dvec3(corners[2].position) - a,
                                             off = from - a;
    const double det = glm::dot(glm::cross(ab, ac), -ray);
    if (std::abs(det) < 1e-14) return std::numeric_limits<double>::infinity();
    const double u = glm::dot(glm::cross(off, ac), -ray) / det;
    const double v = glm::dot(glm::cross(ab, off), -ray) / det;
    const double t = glm::dot(glm::cross(ab, ac), off) / det;
    const bool is_met = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-3;
    return is_met ? t : std::numeric_limits<double>::infinity();
}

/// z of the nearest thing along a direction from the lamp, whose part along the face's axis is 1.
double own_z(const Scene& scene, const glm::dvec3& lamp, const glm::dvec3& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int t = 0; t < scene.triangle_count(); ++t)
        nearest = std::min(nearest, own_distance(corners_of(scene, t), lamp, ray));
    return nearest;
}

struct OwnAxes {
    glm::dvec3 right, down, forward;
};

/// Right, down and forward of each face, by hand: −y is up, except on the faces that look along y.
constexpr std::array<std::array<std::array<int, 3>, 3>, 6> face_axes{{
    {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}},
    {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}},
    {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}},
    {{{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}}},
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
}};

OwnAxes own_axes(int face) {
    const auto& of = face_axes[static_cast<std::size_t>(face)];
    const auto vector = [](const std::array<int, 3>& v) { return glm::dvec3(v[0], v[1], v[2]); };
    return {vector(of[0]), vector(of[1]), vector(of[2])};
}

} // namespace

TEST_CASE("Each pixel of a face has the colour of the depth that a ray finds there") {
    const Scene scene = lab_room();
    const glm::vec3 lamp(0.0f, -0.5f, -0.7f);
    const ShadowMap map = draw_shadow_map(scene, lamp, 90);
    for (const int side : {90, 30}) {
        const ShadowFacePictures pictures = shadow_face_pictures(map, side);
        CHECK(pictures.nearest > 0.0f);
        CHECK(pictures.nearest < pictures.farthest);
        int compared = 0, seen = 0, different = 0;
        for (int face = 0; face < shadow_face_count; ++face) {
            const Image& image = pictures.faces[static_cast<std::size_t>(face)];
            REQUIRE(image.width == side);
            REQUIRE(image.height == side);
            const OwnAxes axes = own_axes(face);
            for (int row = 0; row < side; row += 3) {
                for (int column = 0; column < side; column += 3) {
                    // The middle of the pixel is that of a texel: the sides divide to odd numbers.
                    const double x = (2.0 * column + 1.0) / side - 1.0;
                    const double y = (2.0 * row + 1.0) / side - 1.0;
                    const double z = own_z(scene, glm::dvec3(lamp),
                                           axes.forward + x * axes.right + y * axes.down);
                    const std::size_t at = 4 * static_cast<std::size_t>(row * side + column);
                    glm::vec<3, std::uint8_t> colour{0, 0, 0};
                    if (std::isfinite(z)) {
                        ++seen;
                        colour = viridis(static_cast<float>(
                            (pictures.farthest - z) / (pictures.farthest - pictures.nearest)));
                    }
                    ++compared;
                    for (int c = 0; c < 3; ++c) {
                        const int drawn = image.rgba[at + static_cast<std::size_t>(c)];
                        if (std::abs(drawn - int{colour[c]}) > 2) {
                            ++different;
                            break;
                        }
                    }
                }
            }
        }
        CAPTURE(side, compared, seen, different);
        CHECK(seen > compared / 2);
        // Only where an edge passes within rounding of a texel's centre.
        CHECK(different <= compared / 100);
    }
}

TEST_CASE("A coarse map is shown texel by texel, and a map without texels not at all") {
    const ShadowMap map = draw_shadow_map(lab_room(), glm::vec3(0.0f, -0.5f, -0.7f), 5);
    const ShadowFacePictures pictures = shadow_face_pictures(map, 64);
    for (const Image& face : pictures.faces)
        CHECK(face.width == 5);
    CHECK(shadow_face_pictures(ShadowMap{}, 64).faces[0].width == 0);
    const ShadowMap empty = draw_shadow_map(Scene{}, glm::vec3(0.0f), 8);
    const ShadowFacePictures nothing = shadow_face_pictures(empty, 8);
    CHECK(nothing.farthest == 0.0f);
    for (std::size_t i = 0; i < nothing.faces[0].rgba.size(); ++i)
        CHECK(nothing.faces[0].rgba[i] == (i % 4 == 3 ? 255 : 0));
}
