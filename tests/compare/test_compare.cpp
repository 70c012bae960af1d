#include "compare/compare.h"
#include "compare/run_walk.h"
#include "engines/engine_planes.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"

#include <cmath>

#include "settings/setting_table.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Framebuffer picture(const std::vector<glm::vec3>& colours) {
    Framebuffer framebuffer;
    clear(framebuffer, {static_cast<int>(colours.size()), 1});
    framebuffer.colour = colours;
    return framebuffer;
}

} // namespace

TEST_CASE("Pixels that differ are counted, with the largest and the mean difference") {
    const Framebuffer a = picture({{0, 0, 0}, {0.5f, 0.5f, 0.5f}, {1, 1, 1}, {2, 0, 0}});
    const Framebuffer b =
        picture({{0, 0, 0}, {0.5f, 0.25f, 0.625f}, {1, 1.0000001f, 1}, {2.5f, 0, 0}});
    const PixelDifference difference = pixel_difference(a, b);
    CHECK(difference.pixels == 4);
    CHECK(difference.different == 3);
    CHECK(difference.shown == 1); // the others are cut at 1
    CHECK(difference.largest == 0.5f);
    CHECK(difference.mean == Approx((0.25 + 0.5) / 4));
    CHECK(*difference.worst == glm::ivec2(3, 0));
    const std::vector<float> values = signed_difference(a, b, View::colour);
    CHECK(values[0] == 0.0f);
    CHECK(values[1] == -0.25f);
    CHECK(values[3] == 0.5f);
}

TEST_CASE("Counting pixels a few rows at a time gives the same bits") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    settings.viewport = {90, 70};
    settings.camera.focal_length = 70.0f;
    const Framebuffer a = draw_frame(prepare_frame(scene, settings));
    settings.camera.yaw = 0.1f;
    const Framebuffer b = draw_frame(prepare_frame(scene, settings));
    PixelCount count;
    for (const int row : {1, 20, 21, 70, 70})
        count.count_to(a, b, row);
    CHECK(count.rows() == 70);
    CHECK(count.found().different > 1000);
    CHECK(count.found() == pixel_difference(a, b));
}

TEST_CASE("Colours that are not numbers are compared as they are shown") {
    const Framebuffer a = picture({{NAN, 0, 0}, {INFINITY, 0, 0}, {NAN, 0, 0}});
    const Framebuffer b = picture({{NAN, 0, 0}, {-INFINITY, 0, 0}, {0.5f, 0, 0}});
    const PixelDifference difference = pixel_difference(a, b);
    CHECK(difference.different == 2);
    CHECK(difference.largest == 1.0f);
}

TEST_CASE("The scale of a difference ends at a round number") {
    CHECK(difference_limit(0.0f) == 1.0f);
    CHECK(difference_limit(0.3f) == 0.5f);
    CHECK(difference_limit(0.5f) == 0.5f);
    CHECK(difference_limit(0.0011f) == 0.002f);
    CHECK(difference_limit(7.0f) == 10.0f);
    CHECK(difference_limit(INFINITY) == 1.0f);
}

TEST_CASE("The colours of a difference are symmetric about black") {
    using Rgb = glm::vec<3, std::uint8_t>;
    CHECK(difference_colour(0.0f, 1.0f) == Rgb{0, 0, 0});
    CHECK(difference_colour(-1.0f, 1.0f) == Rgb{86, 180, 233});
    CHECK(difference_colour(-3.0f, 1.0f) == Rgb{86, 180, 233});
    CHECK(difference_colour(1.0f, 1.0f) == Rgb{230, 159, 0});
    CHECK(difference_colour(1e-9f, 1.0f).r > 50);
}

TEST_CASE("Comparing runs in parts gives the same result as comparing them at once") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    set_from_text(settings, "viewport.size=120x100");
    set_from_text(settings, "camera.focal_length=110");
    const Frame a = prepare_frame(scene, settings);
    set_from_text(settings, "rounding=floor");
    const Frame b = prepare_frame(scene, settings);
    const Comparison whole = compare_runs(a, b);
    REQUIRE(whole.divergences.first);
    ComparisonWork work;
    CHECK(work.is_done());
    work.begin(a, b);
    work.advance({0.0, 10'000.0});
    CHECK_FALSE(work.is_done());
    work.begin(a, b); // another step of the camera: the work starts again
    CHECK(work.triangles_done() == 0);
    int parts = 0;
    for (int done = 0; !work.is_done(); ++parts) {
        work.advance({0.0, 10'000.0});
        CHECK(work.triangles_done() >= done);
        CHECK(work.triangles() == 30);
        done = work.triangles_done();
        REQUIRE(parts < 1000);
    }
    CHECK(parts > 5);
    CHECK(work.triangles_done() == 30);
    CHECK(work.found().pixels == whole.pixels);
    CHECK(work.found().different_rows == whole.different_rows);
    CHECK(work.found().divergences.count == whole.divergences.count);
    CHECK(work.found().divergences.groups == whole.divergences.groups);
    REQUIRE(work.found().divergences.first);
    CHECK(work.found().divergences.first->text == whole.divergences.first->text);
}

TEST_CASE("A large triangle is compared in parts of its rows") {
    const Scene scene = test::pixel_scene({{{{0, 0, 1}, {511, 0, 1}, {0, 511, 1}}}}, {512, 512});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    ComparisonWork work;
    work.begin(frame, frame);
    int parts = 0;
    for (; !work.is_done(); ++parts)
        work.advance({0.0, 1.0});
    CHECK(parts > 3);
    CHECK(work.found().is_same());
}

TEST_CASE("A box that reaches far beyond the picture is compared in few parts") {
    const Scene scene =
        test::pixel_scene({{{{-16000, -16000, 1}, {16000, -16000, 1}, {0, 16000, 1}}}}, {2048, 64});
    Settings settings = default_settings(scene);
    set_from_text(settings, "coverage=edge_functions");
    const Frame frame = prepare_frame(scene, settings);
    RunWalk walk(frame, frame, cursor_end);
    int parts = 0;
    std::int64_t tests = 0;
    for (; !walk.is_done() && parts < 20; ++parts) {
        walk.walk_part([&](const PairMoment& moment) {
            tests += moment.a.test != nullptr && moment.b.test != nullptr ? 1 : 0;
            return true;
        });
    }
    CHECK(walk.is_done());
    CHECK(parts <= 4);
    CHECK(parts > 1);
    CHECK(tests == 2048 * 64);
}

TEST_CASE("A slice of a comparison ends where only row tables are made") {
    const Scene scene = test::pixel_scene(
        {10, {{{-16000, -16000, 1}, {-100, -16000, 1}, {-100, 16000, 1}}}}, {16, 16});
    Settings settings = default_settings(scene);
    set_from_text(settings, "coverage=edge_functions");
    const Frame frame = prepare_frame(scene, settings);
    ComparisonWork work;
    work.begin(frame, frame);
    work.advance({0.0, 10'000.0});
    CHECK(work.triangles_done() == 1);
}

TEST_CASE("A comparison in parts agrees with one done at once, and reuses the previous memory") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    settings.viewport = {90, 70};
    settings.camera.focal_length = 70.0f;
    ComparisonWork work;
    for (const std::string_view other :
         {"rounding=floor", "interpolation=affine", "tessellation=2", "depth_test=off"}) {
        CAPTURE(other);
        settings.camera.yaw += 0.05f;
        const Frame a = prepare_frame(scene, settings);
        Settings changed = settings;
        set_from_text(changed, other);
        const Frame b = prepare_frame(scene, changed);
        // An unfinished comparison leaves nothing behind.
        work.begin(b, a);
        for (int i = 0; i < 30; ++i)
            work.advance({0.0, 500.0});
        work.begin(a, b);
        int parts = 0;
        for (; !work.is_done(); ++parts) {
            REQUIRE(parts < 100'000);
            work.advance({0.0, 500.0});
        }
        CHECK(parts > 30);
        const Comparison whole = compare_runs(a, b);
        CHECK(work.found().pixels == whole.pixels);
        CHECK(work.found().pixels == pixel_difference(draw_frame(a), draw_frame(b)));
        CHECK(work.found().different_rows == whole.different_rows);
        CHECK(work.found().divergences.count == whole.divergences.count);
    }
}

TEST_CASE("Runs of the fast engine are compared by their pictures, in parts too") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    settings.viewport = {90, 70};
    settings.camera.focal_length = 70.0f;
    const Frame steps = prepare_frame(scene, settings);
    settings.engine = Engine::fast;
    const Frame fast = prepare_frame(scene, settings);
    Framebuffer planes;
    draw_by_engine(fast, cursor_end, planes);
    const PixelDifference expected = pixel_difference(planes, draw_frame(steps));
    CHECK(expected.different > 0);
    ComparisonWork work;
    work.begin(fast, steps);
    int parts = 0;
    for (; !work.is_done(); ++parts)
        work.advance({100.0, 1'000.0});
    CHECK(parts > 10);
    CHECK(work.found().pixels == expected);
    CHECK(work.triangles_done() == work.triangles());
    CHECK(work.found().only_pictures.starts_with("Run A is drawn by the fast engine; only"));
    CHECK_FALSE(work.found().divergences.first);
    CHECK_FALSE(next_divergence(fast, steps, cursor_begin));
    CHECK_FALSE(previous_divergence(fast, steps, cursor_end));

    CHECK(compare_runs(fast, fast).is_same());
    const Comparison begun = compare_runs(fast, steps, {12, Phase::vertices, 0, 0});
    CHECK(begun.is_same()); // before the end the steps draw both
    settings.camera.yaw = 0.1f;
    const Comparison turned = compare_runs(fast, prepare_frame(scene, settings));
    CHECK(turned.pixels.different > 0);
    CHECK(turned.only_pictures.starts_with("Both runs are drawn by the fast engine"));
}

TEST_CASE("Two runs with samples differ only if their pictures do") {
    const Scene scene = test::small_scene();
    Settings settings = default_settings(scene);
    set_from_text(settings, "stage=pixel_light");
    set_from_text(settings, "coverage=edge_functions");
    settings.samples = 4;
    const Frame a = prepare_frame(scene, settings);
    REQUIRE(a.has_samples());
    const Comparison same = compare_runs(a, a);
    CHECK(same.is_same());
    CHECK_FALSE(same.divergences.first);
    settings.samples = 1;
    const Comparison other = compare_runs(a, prepare_frame(scene, settings));
    CHECK(other.pixels.different > 0);
    CHECK(other.divergences.count == 0);
    CHECK_FALSE(other.is_same());
    CHECK(other.only_pictures.ends_with("so only the pictures are compared."));
}
