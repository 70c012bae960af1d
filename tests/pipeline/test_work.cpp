#include "pipeline/work.h"

#include <catch2/catch.hpp>

#include "pipeline/draw.h"
#include "support/made_scene.h"
#include "support/samples.h"

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
        // A triangle of up to 5,000 is not divided; of a larger one a row is the least.
        CHECK(work.before(cursor) <= wanted);
        CHECK(work.before(cursor) > wanted - 5'000.0);
        last = cursor;
    }
}

TEST_CASE("The lessons' room is drawn and compared within the limit of one update") {
    const Scene scene = lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    FrameWork work;
    work.begin(frame);
    CHECK(work.total() < 0.2 * frame_limit.at_once);
    CHECK(frame_limit.of(work.total()) == work.total());
    CHECK(frame_limit.of(1e12) == frame_limit.slice);
}
