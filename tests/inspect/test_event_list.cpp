#include "inspect/event_list.h"

#include <string>
#include <vector>

#include "support/cut_frames.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("The list has every moment of a triangle once and in order") {
    const Scene scene = small_scene();
    const auto check = [](const Frame& frame) {
        const std::vector<Cursor> all = all_moments(frame);
        std::size_t next = 0;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const EventList list = list_events(frame, t);
            if (!frame.has_moments(t)) REQUIRE(list.count() == 0);
            for (int i = 0; i < list.count(); ++i) {
                REQUIRE(next < all.size());
                REQUIRE(to_text(event_cursor(list, i)) == to_text(all[next]));
                REQUIRE(event_text(list, i).starts_with(to_text(all[next]) + "  "));
                ++next;
            }
        }
        REQUIRE(next == all.size());
    };
    for_each_frame(scene, check);
    for_each_cut_frame(cut_scene(), 2, check);
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    CHECK(list_events(frame, -1).count() == 0);
    CHECK(list_events(frame, frame.triangle_count()).count() == 0);
}

TEST_CASE("A line says which moment it is and what it does") {
    const Scene scene = pixel_scene({{{{10, 5, 1}, {5, 10, 1}, {15, 15, 1}}}}, {20, 20});
    const Frame rows = frame_of(scene, Stage::rows, rule_variants().front());
    const EventList list = list_events(rows, 0);
    REQUIRE(list.count() == 3 + 6 + 11 + 11 + 11);
    CHECK(event_text(list, 1) == "t0/v1  vertices[1]: column 5, row 10");
    CHECK(event_text(list, 3) ==
          "t0/e0/s0  edge 0, sample 0: (10.000, 5.000) is column 10, row 5: both ends");
    CHECK(event_text(list, 3 + 6 + 4) ==
          "t0/e1/s4  edge 1, sample 4: (9.000, 12.000) is column 9, row 12: both ends");
    CHECK(event_text(list, 3 + 6 + 11 + 11) == "t0/r0/c0  row 5: from column 10 to 10");
    const EventList filled = list_events(frame_of(scene, Stage::fill, rule_variants().front()), 0);
    CHECK(event_text(filled, 3 + 6 + 11 + 11) == "t0/r0/c0  fragment: column 10, row 5");
}

TEST_CASE("The search of lines ignores case, and stays in the requested range") {
    const Scene scene = pixel_scene({{{{10, 5, 1}, {5, 10, 1}, {15, 15, 1}}}}, {20, 20});
    const EventList list = list_events(frame_of(scene, Stage::rows, rule_variants().front()), 0);
    CHECK(find_events(list, "EDGE 0", 0, list.count()) == std::vector<int>{3, 4, 5, 6, 7, 8});
    CHECK(find_events(list, "edge 0", 5, 7) == std::vector<int>{5, 6});
    CHECK(find_events(list, "", 0, 1000).size() == static_cast<std::size_t>(list.count()));
    CHECK(find_events(list, "no such words", 0, 1000).empty());
    for (const int i : find_events(list, "row 12:", 0, list.count()))
        CHECK(event_text(list, i).find("row 12") != std::string::npos);
}
