#include <glm/geometric.hpp>

#include "stages/light.h"
#include "stages/pixel_shader.h"
#include "support/bits.h"
#include "support/random.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::same_bits;

namespace {

Surface red_wall() {
    return {{0.0f, 0.0f, -1.0f}, {0.75f, 0.15f, 0.15f}};
}

Varyings varyings_of(const glm::vec3& position, const glm::vec3& illumination) {
    Varyings varyings;
    varyings.position_world = position;
    varyings.illumination = illumination;
    return varyings;
}

Fragment carried(const glm::vec3& position, const glm::vec3& illumination, float z,
                 Interpolation interpolation) {
    Fragment fragment;
    fragment.z = z;
    fragment.inv_w = 1.0f / z;
    fragment.varyings = varyings_of(position, illumination);
    if (interpolation == Interpolation::perspective) {
        fragment.varyings = fragment.varyings * fragment.inv_w;
    }
    return fragment;
}

} // namespace

TEST_CASE("Without light a fragment has the colour of its surface") {
    PixelRules rules;
    rules.shading = Shading::unlit;
    const Fragment fragment = carried({1, 2, 3}, {9, 9, 9}, 2.0f, Interpolation::perspective);
    CHECK(pixel_shader(fragment, red_wall(), rules, {}) == red_wall().reflectance);
}

TEST_CASE("Varyings are recovered by 1/z if they were carried as q/z, and kept if they were not") {
    test::Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 position{random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)};
        const glm::vec3 illumination{random.number(0, 1), random.number(0, 1), random.number(0, 1)};
        const float z = random.number(0.2, 8.0);
        const Fragment affine = carried(position, illumination, z, Interpolation::affine);
        CHECK(test::recover_varyings(affine, Interpolation::affine) ==
              varyings_of(position, illumination));
        const Varyings right =
            test::recover_varyings(carried(position, illumination, z, Interpolation::perspective),
                                   Interpolation::perspective);
        CHECK(glm::distance(right.position_world, position) < 5e-7f);
        CHECK(glm::distance(right.illumination, illumination) < 5e-7f);
    }
}

TEST_CASE("Light per vertex is what the vertices carry, whatever the surface and lamp") {
    PixelRules rules;
    rules.shading = Shading::gouraud;
    for (const Interpolation way : {Interpolation::perspective, Interpolation::affine}) {
        // z = 4: dividing and multiplying by it loses nothing.
        const Fragment fragment = carried({1, 2, 3}, {0.25f, 0.5f, 2.0f}, 4.0f, way);
        CHECK(pixel_shader(fragment, red_wall(), rules, test::stages_under(way)) ==
              glm::vec3(0.25f, 0.5f, 2.0f));
    }
}

TEST_CASE("Light per pixel is worked out at the fragment's own place, and is not clamped") {
    PixelRules rules;
    rules.shading = Shading::phong;
    rules.light.power = glm::vec3(200.0f);
    const glm::vec3 place{0.25f, -0.25f, 0.5f};
    const Surface wall = red_wall();
    for (const Interpolation way : {Interpolation::perspective, Interpolation::affine}) {
        const glm::vec3 colour =
            pixel_shader(carried(place, {}, 4.0f, way), wall, rules, test::stages_under(way));
        CHECK(same_bits(
            colour, reflected_light(place, wall.normal, wall.reflectance, rules.light).reflected));
        CHECK(colour.r > 1.0f);
    }
}
