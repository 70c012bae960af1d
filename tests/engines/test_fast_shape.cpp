// Depth and owners of the fast engine, compared with rays cast into the scene one by one.

#include "engines/fast/fast_shape.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "stages/vertex_shader.h"
#include "support/effort.h"
#include "support/ray_caster.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

constexpr Viewport shape_size{200, 160};

FastEye shape_eye(const Camera& camera) {
    return {.size = shape_size,
            .position = camera.position,
            .rotation = camera_rotation(camera),
            .focal_length = 150.0f,
            .middle = {100.0f, 80.0f}};
}

/// A camera in the room, looking in any direction.
Camera random_camera(test::Random& random) {
    Camera camera;
    camera.position = {random.number(-0.9, 0.9), random.number(-0.9, 0.9),
                       random.number(-2.5, 0.9)};
    camera.yaw = random.number(-4, 4);
    camera.pitch = random.number(-1.4, 1.4);
    camera.focal_length = 150.0f;
    return camera;
}

std::vector<std::int32_t> all_of(const Scene& scene) {
    std::vector<std::int32_t> numbers(static_cast<std::size_t>(scene.triangle_count()));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

} // namespace

TEST_CASE("A shape shows at each pixel the chosen triangle that a ray meets first, and its depth") {
    test::Random random(71);
    const Scene room = test::lab_room();
    FastShape shape(room.mesh);
    FastPicture picture;
    int compared = 0, empty = 0;
    for (int i = 0; i < test::rounds(60, 12); ++i) {
        const Camera camera = random_camera(random);
        const test::RayCaster rays(room, camera, room.light);
        std::vector<std::int32_t> numbers;
        for (const std::int32_t number : all_of(room)) {
            if (random.integer(0, 2) > 0) numbers.push_back(number);
        }
        const std::set<int> chosen(numbers.begin(), numbers.end());
        shape.draw(shape_eye(camera), numbers, picture);
        REQUIRE(picture.size == shape_size);
        const auto owner_at = [&](const glm::dvec2& place) {
            for (const test::RayHit& hit : rays.hits(place)) {
                if (chosen.count(hit.triangle) > 0) return hit;
            }
            return test::RayHit{};
        };
        for (int k = 0; k < 200; ++k) {
            const int column = random.integer(0, shape_size.width - 1);
            const int row = random.integer(0, shape_size.height - 1);
            const glm::dvec2 place(column + 0.5 - 100.0, row + 0.5 - 80.0);
            const test::RayHit met = owner_at(place);
            bool is_inner = true; // no edge passes by
            for (const glm::dvec2 aside : {glm::dvec2(-0.1, 0), {0.1, 0}, {0, -0.1}, {0, 0.1}})
                is_inner &= owner_at(place + aside).triangle == met.triangle;
            if (!is_inner) continue;
            const std::size_t at = picture.at(column, row);
            INFO("round " << i << ", pixel " << column << ", " << row);
            REQUIRE(picture.owner[at] == met.triangle);
            if (met.triangle >= 0)
                REQUIRE(std::abs(static_cast<double>(picture.inv_z[at]) - met.zinv) <
                        0.01 * met.zinv);
            ++compared;
            empty += met.triangle < 0 ? 1 : 0;
        }
    }
    CHECK(compared > 100 * test::rounds(60, 12));
    CHECK(empty > 0);
    CHECK(empty < compared);
}

TEST_CASE("A part of an eye's picture is the same part of the whole") {
    test::Random random(72);
    const Scene room = test::lab_room();
    FastShape shape(room.mesh);
    FastPicture whole, part;
    int different = 0, all = 0;
    for (int i = 0; i < test::rounds(40, 8); ++i) {
        FastEye eye = shape_eye(random_camera(random));
        shape.draw(eye, all_of(room), whole);
        const int left = random.integer(0, 100), top = random.integer(0, 100);
        eye.middle -= glm::vec2(left, top);
        eye.size = {random.integer(1, 90), random.integer(1, 50)};
        shape.draw(eye, all_of(room), part);
        for (int row = 0; row < eye.size.height; ++row) {
            for (int column = 0; column < eye.size.width; ++column) {
                const std::int32_t a = part.owner[part.at(column, row)];
                different += a == whole.owner[whole.at(left + column, top + row)] ? 0 : 1;
                ++all;
            }
        }
    }
    // A corner may be rounded to another 256th of a pixel.
    CHECK(different <= all / 1000);
    CHECK(all > 1000);
}

TEST_CASE("A shape skips triangles with NaN or huge corners, and given none, it draws nothing") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Mesh mesh;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        std::array<Vertex, triangle_corners> corners;
        corners[0].position = a;
        corners[1].position = b;
        corners[2].position = c;
        mesh.add_triangle_of(corners);
    };
    add({-1, -1, 1}, {1, -1, 1}, {nan, 1, 1});
    add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    add({-1, 1e20f, 1}, {1, -1, 1}, {0, 1, 1});
    FastShape shape(mesh);
    FastPicture picture;
    FastEye eye = shape_eye(Camera{});
    eye.position = glm::vec3(0.0f);
    const std::vector<std::int32_t> numbers{0, 1, 2};
    shape.draw(eye, numbers, picture);
    const std::size_t middle = picture.at(100, 80);
    CHECK(picture.owner[middle] == 1);
    CHECK(picture.inv_z[middle] == 0.5f);
    shape.draw(eye, {}, picture);
    CHECK(picture.owner[middle] == -1);
    CHECK(picture.inv_z[middle] == 0.0f);
}
