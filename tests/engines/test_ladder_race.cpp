// Two threads that share one depth buffer. What they draw cannot be foretold, but some of it can:
// one thread draws the right picture, and a wrong pixel still shows a triangle that covers it.

#include <set>
#include <vector>

#include "engines/ladder/ladder.h"
#include "engines/ladder/race.h"
#include "engines/ladder/rungs.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings settings_of_size(const Scene& scene, Viewport size) {
    Settings settings = race_settings(scene);
    settings.viewport = size;
    settings.camera.focal_length = static_cast<float>(size.height);
    return settings;
}

LadderPicture raced(const Scene& scene, const Settings& settings, int threads) {
    WorkerPool pool(threads);
    LadderPicture picture;
    rungs::two_threads_one_buffer::draw(scene, settings, picture, pool);
    return picture;
}

} // namespace

TEST_CASE("One thread by itself draws the right picture in the race's scene and in the room") {
    for (const Scene& scene : {race_scene(), lab_room()}) {
        const Settings settings = settings_of_size(scene, {150, 150});
        REQUIRE(ladder_refuses(scene, settings) == "");
        const LadderPicture alone = raced(scene, settings, 1);
        LadderPicture right;
        rungs::edge_functions::draw(scene, settings, right);
        CHECK(difference_of({alone.size, alone.colour}, {right.size, right.colour}).different == 0);
    }
}

TEST_CASE("A wrong pixel of the race shows a triangle that covers it") {
    const Scene scene = race_scene();
    const Settings settings = settings_of_size(scene, {150, 150});
    const LadderPicture right = raced(scene, settings, 1);
    // What each triangle shows at each of its pixels, drawn by itself.
    std::vector<std::set<std::uint32_t>> shown(right.colour.size());
    for (int t = 0; t < scene.triangle_count(); ++t) {
        Scene one = scene;
        one.mesh = {};
        one.mesh.add_triangle_of(corners_of(scene, t));
        const LadderPicture alone = raced(one, settings, 1);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (alone.depth[i] > 0.0f) shown[i].insert(alone.colour[i]);
        }
    }
    for (int run = 0; run < 5; ++run) {
        const LadderPicture picture = raced(scene, settings, ladder_threads());
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (shown[i].empty())
                REQUIRE(picture.colour[i] == 0);
            else
                REQUIRE(shown[i].count(picture.colour[i]) == 1);
        }
    }
}

TEST_CASE("Each run of the race has a count, and a race that is stopped has fewer") {
    const Scene scene = race_scene();
    const Settings settings = settings_of_size(scene, {60, 60});
    const std::vector<std::int64_t> wrong = race_pictures(scene, settings, 4);
    if (ladder_threads() == 1) {
        CHECK(wrong.empty());
        return;
    }
    REQUIRE(wrong.size() == 4);
    for (const std::int64_t pixels : wrong)
        CHECK(pixels <= 3600);
    int asked = 0;
    CHECK(race_pictures(scene, settings, 4, [&] { return ++asked > 2; }).size() == 2);
}
