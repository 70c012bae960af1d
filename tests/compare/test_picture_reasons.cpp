#include "compare/picture_reasons.h"

#include <string>
#include <vector>

#include "compare/compare.h"
#include "pipeline/clearing.h"
#include "settings/setting_table.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// Small planes with these owners, row by row, all of one colour.
Framebuffer painted(const Frame& frame, const std::vector<int>& owners, int width, float channel) {
    Framebuffer planes;
    const Viewport size{width, static_cast<int>(owners.size()) / width};
    clear(planes, size, {0, 0}, picture_rules(frame));
    for (std::size_t i = 0; i < owners.size(); ++i) {
        planes.owner[i] = owners[i];
        planes.colour[i] = glm::vec3(owners[i] < 0 ? 0.0f : channel);
    }
    return planes;
}

/// The reason of the middle pixel of two pictures of 5 x 3 pixels.
DifferentPixel reason_of_middle(const Frame& frame, const std::vector<int>& in_a,
                                const std::vector<int>& in_b, float channel_b = 0.5f,
                                Engine engine_b = Engine::rays) {
    const Framebuffer a = painted(frame, in_a, 5, 0.25f), b = painted(frame, in_b, 5, channel_b);
    PictureReasons reasons;
    reasons.add({frame, a, Engine::steps}, {frame, b, engine_b}, {2, 1});
    REQUIRE(reasons.first());
    CHECK(reasons.count(reasons.first()->reason) == 1);
    return *reasons.first();
}

} // namespace

TEST_CASE("A pixel that differs has the reason that the pictures around it show") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const std::vector<int> all_floor(15, 0), all_wall(15, 3);
    std::vector<int> hole = all_floor, edge = all_floor, side = all_floor;
    hole[7] = -1;
    for (const std::size_t i : {7u, 8u, 9u, 12u, 13u, 14u})
        edge[i] = 3;
    for (const std::size_t i : {2u, 3u, 4u, 7u, 8u, 9u, 12u, 13u, 14u})
        side[i] = -1;
    CHECK(reason_of_middle(frame, all_floor, all_floor, 0.2505f).reason == PixelReason::rounding);
    CHECK(reason_of_middle(frame, all_floor, all_floor, 0.26f).reason == PixelReason::colour);
    CHECK(reason_of_middle(frame, all_floor, edge).reason == PixelReason::coverage);
    CHECK(reason_of_middle(frame, all_floor, hole).reason == PixelReason::crack);
    CHECK(reason_of_middle(frame, hole, all_floor).reason == PixelReason::crack);
    CHECK(reason_of_middle(frame, all_floor, all_wall).reason == PixelReason::depth);
    const std::vector<int> nothing(15, -1);
    CHECK(reason_of_middle(frame, all_floor, nothing).reason == PixelReason::left_out);
    // The end of a surface is no crack: nothing is drawn on its other side.
    CHECK(reason_of_middle(frame, all_floor, side).reason == PixelReason::coverage);
}

TEST_CASE("The sentence of a reason names what is shown, and what has drawn it") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const std::vector<int> floor(15, 0);
    std::vector<int> edge = floor;
    edge[7] = 3;
    CHECK(reason_of_middle(frame, floor, edge).text ==
          "A shows floor (triangles[0]) and B left wall (triangles[3]); A finds the pixels of a "
          "triangle by rows between the samples of its edges, B by a ray through each pixel's "
          "centre.");
    // Both alike: then the rules of coverage are not the reason.
    CHECK(reason_of_middle(frame, floor, edge, 0.5f, Engine::steps).text ==
          "A shows floor (triangles[0]) and B left wall (triangles[3]); an outline is there, and "
          "they do not agree about it.");
    CHECK(reason_of_middle(frame, floor, floor, 0.2505f, Engine::fast).text ==
          "A shows floor (triangles[0]) and B floor (triangles[0]); their colours are at most "
          "1/255 apart: A keeps floats, B 8 bits per channel.");
}

TEST_CASE("The first pixel beyond rounding is named, if there is one") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const std::vector<int> floor(15, 0), wall(15, 3);
    const Framebuffer a = painted(frame, floor, 5, 0.25f), near = painted(frame, floor, 5, 0.2505f);
    const Framebuffer b = painted(frame, wall, 5, 0.5f);
    PictureReasons reasons;
    reasons.add({frame, a, Engine::steps}, {frame, near, Engine::steps}, {0, 0});
    CHECK(reasons.first()->place == glm::ivec2(0, 0));
    reasons.add({frame, a, Engine::steps}, {frame, b, Engine::steps}, {3, 1});
    CHECK(reasons.first()->place == glm::ivec2(3, 1));
    CHECK(reasons.count(PixelReason::rounding) == 1);
    CHECK(reasons.count(PixelReason::depth) == 1);
}

TEST_CASE("The reasons of two engines add up to the pixels that differ") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "viewport.size=101x83");
    const Frame steps = prepare_frame(room, settings);
    for (const char* engine : {"engine=fast", "engine=rays"}) {
        Settings other = settings;
        set_from_text(other, engine);
        const Comparison found = compare_runs(steps, prepare_frame(room, other));
        std::int64_t sum = 0;
        for (const PixelReasonWords& words : pixel_reason_list())
            sum += found.reasons.count(words.reason);
        CHECK(sum == found.pixels.different);
        CHECK(sum > 0);
        CHECK(found.divergences.count == 0);
    }
}
