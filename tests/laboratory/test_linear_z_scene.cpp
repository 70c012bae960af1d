// The scene that shows why the depth buffer holds 1/z.

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "support/ray_caster.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Number of the part that a ray through the pixel meets first; -1: none.
int part_seen(const RayCaster& rays, const Scene& scene, double column, double row) {
    const std::vector<RayHit> hits = rays.hits({column - 250.0, row - 250.0});
    return hits.empty() ? -1 : part_of(scene, hits[0].triangle);
}

/// Is the part seen anywhere in the square of two pixels around? A fragment can be that far off its
/// true place; see test_against_rays.cpp.
bool is_seen_near(const RayCaster& rays, const Scene& scene, int column, int row, int part) {
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            if (part_seen(rays, scene, column + dx, row + dy) == part) return true;
        }
    }
    return false;
}

} // namespace

TEST_CASE("In the scene made for it linear z picks the wrong surface, and 1/z the right one") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/linear-z.toml");
    Settings settings = default_settings(scene);
    REQUIRE(settings.viewport == Viewport{500, 500});
    const Framebuffer right = draw_frame(prepare_frame(scene, settings));
    settings.depth_test = DepthTest::linear_z;
    const Framebuffer wrong = draw_frame(prepare_frame(scene, settings));

    const RayCaster rays(scene, settings.camera, settings.light);
    const auto part_drawn = [&](int triangle) {
        return triangle < 0 ? -1 : part_of(scene, triangle);
    };
    int differ = 0, right_at_pixel = 0, wrong_at_pixel = 0;
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            const std::size_t at = right.at(column, row);
            const int by_inverse_z = part_drawn(right.owner[at]);
            const int by_linear_z = part_drawn(wrong.owner[at]);
            if (by_inverse_z == by_linear_z) continue;
            ++differ;
            const int seen = part_seen(rays, scene, column, row);
            right_at_pixel += seen == by_inverse_z ? 1 : 0;
            wrong_at_pixel += seen == by_linear_z ? 1 : 0;
            if (seen != by_inverse_z && !is_seen_near(rays, scene, column, row, by_inverse_z)) {
                FAIL("column " << column << " row " << row << ": drawn with 1/z part "
                               << by_inverse_z << ", rays " << seen);
            }
        }
    }
    // Two fifths of the picture. Of these 105 427 are what the ray through the pixel's own place
    // meets; the others are at the border of two surfaces, less than two pixels off.
    CHECK(differ == 105'686);
    CHECK(right_at_pixel >= 0.99 * differ);
    CHECK(wrong_at_pixel <= 0.01 * differ);
}
