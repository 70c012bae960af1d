#include "pipeline/work.h"

#include "pipeline/draw.h"
#include "support/made_scene.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("The estimate of a frame's work is near the fragments that it draws") {
    for (const Scene& scene : {lab_room(), made_scene(2'000)}) {
        const Frame frame = prepare_frame(scene, default_settings(scene));
        FrameWork work;
        work.begin(frame);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        const auto fragments = static_cast<double>(draw(frame, {}, framebuffer).fragments);
        CAPTURE(scene.name);
        CHECK(work.total() > fragments);
        CHECK(work.total() < 5.0 * fragments);
    }
}

TEST_CASE("The place of an amount of work has that amount before it") {
    const Scene scene = lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    FrameWork work;
    work.begin(frame);
    CHECK(work.before(cursor_begin) == 0.0);
    CHECK(work.before(cursor_end) == work.total());
    CHECK(work.at(work.total()) == cursor_end);
    Cursor last = cursor_begin;
    for (int i = 0; i < 200; ++i) {
        const double wanted = work.total() * i / 200.0;
        const Cursor cursor = work.at(wanted);
        CHECK(cursor >= last);
        // A triangle of up to 5,000 is not divided; a larger one is divided into rows at most.
        CHECK(work.before(cursor) <= wanted);
        CHECK(work.before(cursor) > wanted - 5'000.0);
        last = cursor;
    }
}

TEST_CASE("The lessons' room is drawn within the limit of one update") {
    const Scene scene = lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    FrameWork work;
    work.begin(frame);
    CHECK(work.total() < 0.8 * frame_limit.at_once);
    CHECK(frame_limit.of(work.total()) == work.total());
    CHECK(frame_limit.of(1e12) == frame_limit.slice);
}

TEST_CASE(
    "A frame's fragments are estimated without drawing, including those outside the picture") {
    const Scene scene = lab_room();
    Settings settings = default_settings(scene);
    for (const float z : {-3.001f, -2.0f, -1.2f, -1.05f}) {
        CAPTURE(z);
        settings.camera.position.z = z;
        const Frame frame = prepare_frame(scene, settings);
        FrameWork work;
        work.begin(frame);
        const DrawTally counted = tally_rows(frame, 0);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        const auto inside = static_cast<double>(draw(frame, {}, framebuffer).fragments);
        const double all = inside + static_cast<double>(counted.fragments_outside);
        CHECK(work.fragments().all > 0.98 * all);
        CHECK(work.fragments().all < 1.02 * all);
        CHECK(work.fragments().in_picture > 0.5 * inside);
        CHECK(work.fragments().in_picture < 2.0 * inside);
    }
    settings.reject = Reject::cheap; // walks nothing outside the picture
    FrameWork work;
    const Frame cheap = prepare_frame(scene, settings);
    work.begin(cheap);
    CHECK(tally_rows(cheap, 0).fragments_outside == 0);
    CHECK(work.fragments().all == work.fragments().in_picture);
    settings.stage = Stage::edges;
    const Frame edges = prepare_frame(scene, settings);
    work.begin(edges);
    CHECK(work.fragments().all == 0.0);
}
