// Which step of the lab a picture shows.

#include "mine/picture_check.h"

#include <algorithm>
#include <cstdint>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "settings/settings.h"
#include "support/catch.h"
#include "support/samples.h"

using namespace rasterwalk;

namespace {

Image picture_of(const Scene& scene, Stage stage) {
    Settings settings = default_settings(scene);
    set_step(settings, {stage});
    return view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
}

/// The first pixels that are not black; all others are black.
Image first_pixels(Image picture, int count) {
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
        const bool is_lit = picture.rgba[at] + picture.rgba[at + 1] + picture.rgba[at + 2] > 0;
        if (is_lit && count-- <= 0) std::fill_n(&picture.rgba[at], 3, std::uint8_t{0});
    }
    return picture;
}

} // namespace

TEST_CASE("Points in wrong places are points, even if all of them lie on edges") {
    const Scene room = test::lab_room();
    const Settings settings = default_settings(room);
    const Image edges = picture_of(room, Stage::edges);
    CHECK(nearest_step(edges, room, settings).stage == Stage::edges);
    CHECK(nearest_step(picture_of(room, Stage::points), room, settings).stage == Stage::points);
    for (const int count : {1, 40, 90}) {
        INFO(count << " pixels");
        CHECK(nearest_step(first_pixels(edges, count), room, settings).stage == Stage::points);
    }
    CHECK(nearest_step(first_pixels(edges, 2000), room, settings).stage == Stage::edges);
}
