#include "pipeline/frame_preparation.h"

#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/made_scene.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

void require_same_frame(const Frame& frame, const Frame& expected) {
    REQUIRE(frame.triangles == expected.triangles);
    REQUIRE(frame.shaded.size() == expected.shaded.size());
    REQUIRE(frame.projected.size() == expected.projected.size());
    for (std::size_t i = 0; i < frame.projected.size(); ++i) {
        INFO("vertex " << i);
        REQUIRE(same_bits(frame.projected[i].pixel, expected.projected[i].pixel));
    }
    REQUIRE(frame.polygons == expected.polygons);
    REQUIRE(frame.vertices.size() == expected.vertices.size());
    for (std::size_t i = 0; i < frame.vertices.size(); ++i) {
        INFO("corner " << i);
        REQUIRE(same_bits(frame.vertices[i], expected.vertices[i]));
    }
}

} // namespace

TEST_CASE("A frame and its work are the same in whatever parts they are prepared") {
    Random random(131);
    const Scene room = lab_room(), made = made_scene(700), other = made_scene(10);
    int parts = 0;
    for (int i = 0; i < rounds(40, 8); ++i) {
        const Scene& scene = i % 4 == 0 ? room : made;
        Settings settings = default_settings(scene);
        settings.camera.yaw = static_cast<float>(random.number(-3, 3));
        set_from_text(settings, i % 2 == 0 ? "clip=all" : "clip=none");
        if (i % 3 == 0) set_from_text(settings, "tessellation=2");
        const Frame expected = prepare_frame(scene, settings);
        FrameWork expected_work;
        expected_work.begin(expected);

        Frame frame = prepare_frame(other, default_settings(other));
        FramePreparation preparation = begin_frame(scene, settings, nullptr, frame);
        for (; !preparation.is_done(); ++parts)
            preparation.advance({0.0, random.number(0, 5'000)});
        CAPTURE(i);
        require_same_frame(frame, expected);

        FrameWork work;
        for (work.start(frame); !work.is_done();)
            work.advance({0.0, random.number(0, 5'000)});
        REQUIRE(work.total() == expected_work.total());
        REQUIRE(work.fragments().all == expected_work.fragments().all);
        REQUIRE(work.fragments().in_picture == expected_work.fragments().in_picture);
        for (int t = 0; t < frame.triangle_count(); ++t)
            REQUIRE(work.before({t, Phase::vertices, 0, 0}) ==
                    expected_work.before({t, Phase::vertices, 0, 0}));
    }
    CHECK(parts > 5 * rounds(40, 8));
}

TEST_CASE("The work of a frame without triangles is done before it is begun") {
    const Scene scene = pixel_scene({}, {20, 20});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    FrameWork work;
    work.start(frame);
    CHECK(work.is_done());
    CHECK(work.total() == 0.0);
}
