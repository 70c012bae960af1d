#include <algorithm>
#include <map>
#include <vector>

#include "inspect/row_history.h"
#include "inspect/triangle_report.h"
#include "picture/overlay.h"
#include "pipeline/replay.h"
#include "pipeline/timeline.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/oracle.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr int corner_count = 5;

/// A polygon of five corners in the place of the scene's only triangle, as clipping would leave it.
Frame pentagon(const Scene& scene, const StripStep& step) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.line_walk = LineWalk::exact; // so that no sample strays
    Frame frame = prepare_frame(scene, settings);
    const glm::ivec2 places[corner_count] = {{12, 1}, {22, 8}, {18, 19}, {5, 17}, {2, 7}};
    const ScreenVertex from = frame.given_vertex(0, 0).pixel;
    for (const glm::ivec2& place : places) {
        frame.vertices.push_back(from);
        frame.vertices.back().column = place.x;
        frame.vertices.back().row = place.y;
    }
    frame.polygons = {
        {.first = 0, .count = corner_count, .rejection = Rejection::none, .is_cut = true}};
    return frame;
}

Scene one_triangle() {
    return pixel_scene({{{{2, 1, 2}, {20, 3, 2}, {9, 15, 2}}}}, {24, 22});
}

} // namespace

TEST_CASE("A polygon of five corners has the rows that its five edges make") {
    const Scene scene = one_triangle();
    const Frame frame = pentagon(scene, {Stage::depth});
    int outside = 0;
    const std::map<int, RowEnds> expected =
        row_table(frame.triangle_vertices(0), {{LineWalk::exact, Rounding::truncate}}, outside);
    REQUIRE(outside == 0);
    const RowHistory history = row_history(frame, 0);
    REQUIRE(history.rows.size() == static_cast<int>(expected.size()));
    CHECK(history.edge_samples.size() == corner_count);
    std::int64_t pixels = 0;
    for (int r = 0; r < history.rows.size(); ++r) {
        const auto i = static_cast<std::size_t>(r);
        const RowEnds& ends = expected.at(history.rows.first_row + r);
        CAPTURE(r);
        CHECK(history.rows.left[i].column == ends.left);
        CHECK(history.rows.right[i].column == ends.right);
        CHECK(history.left_by[i].edge == ends.left_edge);
        CHECK(history.right_by[i].edge == ends.right_edge);
        pixels += ends.right - ends.left + 1;
    }
    const Framebuffer picture = draw_frame(frame);
    CHECK(std::count(picture.owner.begin(), picture.owner.end(), 0) == pixels);
}

TEST_CASE("All moments of a polygon of five corners exist, in order, and each is drawn") {
    const Scene scene = one_triangle();
    for (const StageInfo& info : stage_list()) {
        const Frame frame = pentagon(scene, info.step);
        CAPTURE(std::string(info.name));
        const std::vector<Cursor> moments = all_moments(frame);
        const Timeline timeline(frame);
        CHECK(timeline.moments(0).count == static_cast<int>(moments.size()));
        Cursor at = timeline.first();
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (at != moments[i]) FAIL("moment " << i << " is " << to_text(at));
            if (timeline.ordinal(at) != static_cast<int>(i)) FAIL("its number is wrong");
            if (timeline.at_ordinal(0, static_cast<int>(i)) != at) FAIL("it is not found again");
            at = timeline.next(at, Granularity::moment);
        }
        CHECK(at == cursor_end);
        CHECK(timeline.exists({0, Phase::vertices, 2, 0}));
        CHECK_FALSE(timeline.exists({0, Phase::vertices, 3, 0}));
        const Cursor after_vertices = timeline.next(timeline.first(), Granularity::line);
        CHECK(after_vertices ==
              (info.step.stage == Stage::points ? cursor_end : Cursor{0, Phase::edges, 0, 0}));

        // Replay forward and backward shows the same as drawing up to there.
        Replay replay;
        replay.begin(frame);
        for (std::size_t i = 0; i < moments.size(); i += 7) {
            const Cursor& to = moments[i % 2 == 0 ? i : moments.size() - i];
            Framebuffer drawn;
            clear(drawn, frame);
            draw(frame, {cursor_begin, to, {}}, drawn);
            require_same(replay.at(to), drawn);
        }
    }
}

TEST_CASE("Observer, report and wires have all five corners and edges") {
    const Scene scene = one_triangle();
    const Frame frame = pentagon(scene, {Stage::fill});
    Framebuffer picture;
    clear(picture, frame);
    Recorder recorder(true);
    draw(frame, {}, picture, &recorder);
    CHECK(recorder.vertices.size() == 3); // of the scene
    const TriangleReport report = triangle_report(frame, 0);
    REQUIRE(report.edges.size() == corner_count);
    std::size_t samples = 0;
    for (std::size_t e = 0; e < corner_count; ++e) {
        const EdgeReport& edge = report.edges[e];
        CHECK(edge.to == report.edges[(e + 1) % corner_count].from);
        CHECK(edge.from == frame.vertices[e]);
        CHECK(edge.count == static_cast<int>(edge.samples.size()));
        samples += edge.samples.size();
    }
    CHECK(recorder.samples.size() == samples);
    CHECK(recorder.samples.back().cursor.index == corner_count - 1);
    OverlaySet shown;
    shown.set(Overlay::wireframe, true);
    OverlayPicture overlay;
    compose_overlays(frame, cursor_end, draw_frame(frame), shown, false, overlay);
    const std::vector<WireEdge>& wires = overlay.wires;
    REQUIRE(wires.size() == corner_count);
    CHECK(wires.back().to == glm::ivec2(12, 1));
}

TEST_CASE("A rejected triangle keeps its entry, even without any corner") {
    const Scene scene = one_triangle();
    Frame frame = pentagon(scene, {Stage::depth});
    for (const Rejection reason :
         {Rejection::outside, Rejection::clipped_away, Rejection::back_facing}) {
        frame.polygons = {{.first = 0, .count = 0, .rejection = reason, .is_cut = true}};
        CHECK(frame.triangle_count() == 1);
        CHECK_FALSE(frame.is_drawn(0));
        const Timeline timeline(frame);
        // The cursor can be at a triangle that clip or cull removed, with the vertices of the
        // scene.
        CHECK(timeline.first() == (reason == Rejection::outside ? cursor_end : cursor_begin));
        CHECK_FALSE(timeline.exists({0, Phase::edges, 0, 0}));
        const Framebuffer picture = draw_frame(frame);
        CHECK(std::count(picture.owner.begin(), picture.owner.end(), 0) == 0);
        CHECK(triangle_report(frame, 0).edges.empty());
        CHECK_FALSE(words(reason).sentence.empty());
    }
}

TEST_CASE("Each rejection has a unique name and all its words") {
    for (int i = 1; i < rejection_count; ++i) {
        const RejectionWords& of = words(static_cast<Rejection>(i));
        CHECK_FALSE(of.name.empty());
        CHECK_FALSE(of.sentence.empty());
        CHECK_FALSE(of.cause.empty());
        CHECK_FALSE(of.detail.empty());
        for (int k = 0; k < i; ++k)
            CHECK(of.name != words(static_cast<Rejection>(k)).name);
    }
}
