// The mistakes of the painter and of the BSP tree. A painter's picture is made a second time, from
// the fragments of each pixel and an order of this file's own.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mistakes/hidden.h"
#include "scene/read_scene.h"
#include "support/bug_runs.h"
#include "support/pixel_fragments.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace hidden_bugs {

constexpr int right_wall = 4, short_block = 10, tall_block = 20, triangles_of_room = 30;
constexpr int floor_begins = 374; // the row of its far edge

bool is_of_block(int triangle) {
    return triangle >= short_block;
}

/// The smallest depth of each triangle's corners, and their mean, from the room's camera: it looks
/// along z.
std::vector<double> room_depths(const Scene& scene, bool of_nearest) {
    std::vector<double> depths;
    for (int t = 0; t < triangles_of_room; ++t) {
        std::array<double, 3> z{};
        for (int i = 0; i < 3; ++i)
            z[static_cast<std::size_t>(i)] = double{scene.corner(t, i).position.z} + 3.001;
        const double mean = (z[0] + z[1] + z[2]) / 3.0;
        // Equal ones differ by what doubles round.
        const double depth = of_nearest ? std::min({z[0], z[1], z[2]}) : mean;
        depths.push_back(std::round(1e5 * depth));
    }
    return depths;
}

std::vector<double> negated(std::vector<double> numbers) {
    for (double& number : numbers)
        number = -number;
    return numbers;
}

} // namespace hidden_bugs
} // namespace

TEST_CASE("B98a: floor and walls are as near as their front edges, and cut off both blocks") {
    using namespace hidden_bugs;
    const BugRuns runs("B98a");
    const PixelFragments pixels(*runs.session.scene, runs.session.b->settings);
    const std::vector<int> wrong = scene_triangles(runs.wrong.frame, runs.wrong.picture);
    CHECK(wrong == pixels.painted(negated(room_depths(*runs.session.scene, true))));
    CHECK(scene_triangles(runs.right.frame, runs.right.picture) ==
          pixels.painted(negated(room_depths(*runs.session.scene, false))));
    const std::vector<int> nearest = pixels.nearest();
    int above = 0, below = 0, edge = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const int row = static_cast<int>(i) / pixels.width;
        // The blocks are not drawn where they stand on the floor, and drawn where they do not.
        if (row > floor_begins) {
            REQUIRE_FALSE(is_of_block(wrong[i]));
            below += is_of_block(nearest[i]) ? 1 : 0;
        } else if (row < floor_begins && is_of_block(nearest[i])) {
            above += is_of_block(wrong[i]) ? 1 : 0;
            if (!is_of_block(wrong[i])) {
                REQUIRE(wrong[i] / 2 == right_wall / 2);
                REQUIRE(nearest[i] < tall_block);
                ++edge;
            }
        }
    }
    CHECK(below > 10000);
    CHECK(above > 20000);
    CHECK(edge > 50);
    CHECK(nearest_depth({4.0f, 2.0f, 2.0f}) == 2.0f);
}

TEST_CASE("B98b: the back wall covers the blocks, and only the foot of the blue one is left") {
    using namespace hidden_bugs;
    const BugRuns runs("B98b");
    const PixelFragments pixels(*runs.session.scene, runs.session.b->settings);
    const std::vector<int> wrong = scene_triangles(runs.wrong.frame, runs.wrong.picture);
    CHECK(wrong == pixels.painted(room_depths(*runs.session.scene, false)));
    int red = 0, blue = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        red += wrong[i] >= short_block && wrong[i] < tall_block ? 1 : 0;
        if (wrong[i] >= tall_block) {
            REQUIRE(static_cast<int>(i) / pixels.width > floor_begins);
            ++blue;
        }
        const auto is_back_wall = [](const PixelFragments::Fragment& fragment) {
            return fragment.triangle == 8 || fragment.triangle == 9;
        };
        if (std::any_of(pixels.pixels[i].begin(), pixels.pixels[i].end(), is_back_wall))
            REQUIRE((wrong[i] == 8 || wrong[i] == 9));
    }
    CHECK(red < 10);
    CHECK(blue > 1000);
    CHECK(blue < 5000);
    // The depths that the panel shows grow from one drawn triangle to the next.
    const std::vector<float>& depths = runs.wrong.frame.list->depths;
    CHECK(std::is_sorted(depths.begin(), depths.end()));
    CHECK(std::is_sorted(runs.right.frame.list->depths.rbegin(),
                         runs.right.frame.list->depths.rend()));
    CHECK(is_nearer_drawn_before(1.0f, 2.0f));
}

TEST_CASE("B98c: the pieces are drawn from front to back, and each needle's tip is on top") {
    using namespace hidden_bugs;
    const BugRuns runs("B98c");
    CHECK(runs.wrong.frame.triangle_count() == runs.right.frame.triangle_count());
    const PixelFragments pixels(*runs.session.scene, runs.session.b->settings);
    const std::vector<int> wrong = scene_triangles(runs.wrong.frame, runs.wrong.picture);
    const std::vector<int> right = scene_triangles(runs.right.frame, runs.right.picture);
    std::array<int, 3> crossings{}, farthest{}, nearest{};
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const std::vector<PixelFragments::Fragment>& there = pixels.pixels[i];
        if (there.size() != 2) continue;
        const bool is_first_near = there[0].zinv > there[1].zinv;
        const int far = there[is_first_near ? 1 : 0].triangle;
        const int near = there[is_first_near ? 0 : 1].triangle;
        const auto tip = static_cast<std::size_t>(far);
        ++crossings[tip];
        farthest[tip] += wrong[i] == far ? 1 : 0;
        nearest[tip] += right[i] == near ? 1 : 0;
    }
    // Corners that a cut has made are rounded to pixels, so outlines are up to a pixel off.
    for (std::size_t tip = 0; tip < crossings.size(); ++tip) {
        CAPTURE(tip, crossings[tip], farthest[tip], nearest[tip]);
        CHECK(crossings[tip] > 50);
        CHECK(farthest[tip] > 0.9 * crossings[tip]);
        CHECK(nearest[tip] > 0.9 * crossings[tip]);
    }
    // In the room nothing of the blocks is left.
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    settings.stage = Stage::depth;
    settings.hidden = Hidden::bsp;
    settings.bsp_rule = runs.session.a.settings.bsp_rule;
    const Frame frame = prepare_frame(room, settings);
    const std::vector<int> shown = scene_triangles(frame, draw_frame(frame));
    CHECK(std::none_of(shown.begin(), shown.end(), is_of_block));
}
