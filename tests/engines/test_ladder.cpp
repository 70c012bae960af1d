// The rungs of the ladder: each draws what the one before it draws, except the one that changes the
// rule of coverage, whose differences are counted a second way, by the stages.

#include "engines/ladder/ladder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "base/error.h"
#include "engines/knot.h"
#include "engines/measure.h"
#include "engines/own_engines.h"
#include "engines/workload.h"
#include "pipeline/draw.h"
#include "support/effort.h"
#include "support/project_root.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings ladder_settings(const Scene& scene, StripStep step, Viewport size) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.viewport = size;
    settings.camera.focal_length = static_cast<float>(size.height);
    return settings;
}

/// Triangles of any shape in front of the camera, with normals of any direction.
Scene random_ladder_scene(Random& random, bool is_bent) {
    Scene scene;
    scene.camera.position = {random.number(-0.5, 0.5), random.number(-0.5, 0.5), -2.0f};
    scene.light.position = {random.number(-1, 1), random.number(-1, 1), random.number(-1.5, -0.5)};
    scene.light.power = glm::vec3(random.number(0.5, 4));
    const int triangles = random.integer(1, 30);
    for (int t = 0; t < triangles; ++t) {
        std::array<Vertex, triangle_corners> corners;
        for (Vertex& corner : corners)
            corner.position = {random.number(-2, 2), random.number(-2, 2), random.number(0, 2)};
        const glm::vec3 normal =
            face_normal(corners[0].position, corners[1].position, corners[2].position);
        const glm::vec3 reflectance(random.number(0, 1), random.number(0, 1), random.number(0, 1));
        for (Vertex& corner : corners) {
            const glm::vec3 bend(random.number(-0.4, 0.4), random.number(-0.4, 0.4), -1.0f);
            corner.normal = is_bent ? glm::normalize(bend) : normal;
            corner.reflectance = reflectance;
        }
        scene.mesh.add_triangle_of(corners);
    }
    return scene;
}

/// All rungs and wrong turnings, each compared with its own.
std::vector<RungTime> measured_rungs(const Scene& scene, const Settings& settings) {
    LadderWork work;
    work.begin(std::make_shared<Scene>(scene), settings, 1);
    while (!work.is_done())
        work.advance();
    return work.times();
}

/// Rungs draw the same bytes within 1/255; the fast engine but for centres of pixels on an edge.
void check_rungs(const Scene& scene, const Settings& settings) {
    const std::vector<RungTime> times = measured_rungs(scene, settings);
    for (std::size_t i = 0; i < rung_count(); ++i) {
        const Rung& rung = rung_at(i);
        CAPTURE(rung.name, difference_text(times[i].from_previous));
        if (rung.has_other_edges || rung.is_random) continue;
        if (rung.name == "fast_engine")
            CHECK(do_agree(times[i].from_previous));
        else
            CHECK(times[i].from_previous.different == 0);
    }
}

/// Does the picture show another triangle at a neighbour of this pixel, or end there?
bool is_at_an_outline(const Framebuffer& planes, int column, int row) {
    const Viewport size = planes.size;
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (x < 0 || y < 0 || x >= size.width || y >= size.height) return true;
            if (planes.owner[planes.at(x, y)] != planes.owner[planes.at(column, row)]) return true;
        }
    }
    return false;
}

} // namespace

TEST_CASE("Every rung draws the lit room as the rung before does") {
    const Scene room = lab_room();
    for (const StripStep step : {StripStep::pixel_light, StripStep::vertex_light}) {
        check_rungs(room, ladder_settings(room, step, {500, 500}));
        check_rungs(room, ladder_settings(room, step, {203, 121}));
    }
}

TEST_CASE("Every rung draws a bent surface as the rung before does") {
    const Scene knot = knot_scene();
    for (const StripStep step : {StripStep::pixel_light, StripStep::vertex_light})
        check_rungs(knot, ladder_settings(knot, step, {120, 90}));
}

TEST_CASE("Every rung draws any triangles as the rung before does") {
    Random random(911);
    for (int i = 0; i < rounds(400, 30); ++i) {
        const Scene scene = random_ladder_scene(random, i % 3 == 0);
        const Settings settings =
            ladder_settings(scene, i % 2 == 0 ? StripStep::pixel_light : StripStep::vertex_light,
                            {random.integer(1, 160), random.integer(1, 120)});
        CAPTURE(i);
        REQUIRE(ladder_refuses(scene, settings) == "");
        check_rungs(scene, settings);
    }
}

TEST_CASE(
    "Where edge functions draw another picture, the stages do too, and it is on an outline or "
    "the light of the centre") {
    const Scene room = lab_room();
    const Settings by_rows = ladder_settings(room, StripStep::pixel_light, {500, 500});
    Settings by_centres = by_rows;
    by_centres.coverage = Coverage::scan_conversion;
    by_centres.fill_rule = FillRule::top_left;
    by_centres.snap = Snap::subpixel;
    const auto picture = [&](std::string_view rung) {
        return find_rung(rung)->make(room, by_rows)->picture(0);
    };
    const EnginePicture before = picture("one_division"), after = picture("edge_functions");
    const EnginePicture of_stages = steps_engine(room, by_centres)->picture(0);
    const PictureDifference counted = difference_of(before, after);
    const PictureDifference again =
        difference_of(steps_engine(room, by_rows)->picture(0), of_stages);
    CHECK(counted.different > 1000);
    CHECK(std::abs(counted.different - again.different) * pixels_to_one_that_differs <=
          counted.pixels);
    CHECK(do_agree(difference_of(after, of_stages)));
    const Framebuffer rows = draw_frame(prepare_frame(room, by_rows));
    const Framebuffer centres = draw_frame(prepare_frame(room, by_centres));
    int on_outlines = 0, elsewhere = 0, most_elsewhere = 0;
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            const EnginePicture one{{1, 1}, {before.colour[rows.at(column, row)]}};
            const EnginePicture other{{1, 1}, {after.colour[rows.at(column, row)]}};
            const PictureDifference difference = difference_of(one, other);
            if (difference.different == 0) continue;
            const bool is_on =
                is_at_an_outline(rows, column, row) || is_at_an_outline(centres, column, row);
            (is_on ? on_outlines : elsewhere) += 1;
            if (!is_on) most_elsewhere = std::max(most_elsewhere, difference.largest);
        }
    }
    CHECK(on_outlines + elsewhere == counted.different);
    CHECK(on_outlines > elsewhere);
    CHECK(most_elsewhere <= 4); // the light of a point half a pixel away
}

TEST_CASE("Each rung has its words, and its file") {
    for (const auto& list : {ladder(), wrong_turnings()}) {
        for (const Rung& rung : list) {
            CAPTURE(rung.name);
            CHECK(find_rung(rung.name) == &rung);
            for (const std::string_view text : {rung.change, rung.why}) {
                CHECK(text.ends_with('.'));
                CHECK(text.find(". ") == std::string_view::npos);
            }
            CHECK_FALSE(rung.title.empty());
            CHECK(std::filesystem::exists(std::filesystem::path(project_root()) /
                                          "src/engines/ladder" / rung.file));
        }
    }
    for (const Rung& rung : ladder())
        CHECK(rung.against.empty());
    for (const Rung& rung : wrong_turnings())
        CHECK(std::any_of(ladder().begin(), ladder().end(),
                          [&](const Rung& other) { return other.name == rung.against; }));
    CHECK(std::count_if(ladder().begin(), ladder().end(),
                        [](const Rung& rung) { return rung.has_other_edges; }) == 1);
    CHECK(find_rung("no_such_rung") == nullptr);
}

TEST_CASE("The place of a rung is that in the two lists, and so is that of the rung before it") {
    REQUIRE(rung_count() == ladder().size() + wrong_turnings().size());
    CHECK(rung_before(0) == 0);
    for (std::size_t i = 0; i < ladder().size(); ++i) {
        CHECK(&rung_at(i) == &ladder()[i]);
        if (i > 0) CHECK(rung_before(i) == i - 1);
    }
    for (std::size_t i = 0; i < wrong_turnings().size(); ++i) {
        const std::size_t place = ladder().size() + i;
        CHECK(&rung_at(place) == &wrong_turnings()[i]);
        CHECK(&rung_at(rung_before(place)) == find_rung(wrong_turnings()[i].against));
    }
}

TEST_CASE("The ladder is measured a picture at a time, and can be stopped and begun again") {
    const Scene room = lab_room();
    const Settings settings = ladder_settings(room, StripStep::pixel_light, {30, 20});
    const auto count = static_cast<int>(rung_count());
    LadderWork work;
    CHECK(work.is_done());
    CHECK(work.share() == 1.0f);
    work.advance(); // nothing to do
    work.begin(std::make_shared<Scene>(room), settings, 3);
    CHECK(work.share() == 0.0f);
    for (int i = 0; i < 2 * count; ++i) {
        CHECK(work.rounds_done() == 0);
        work.advance();
    }
    CHECK(work.rounds_done() == 1);
    CHECK(work.share() == 0.5f);
    CHECK_FALSE(work.is_done());
    work.begin(std::make_shared<Scene>(room), settings, 2);
    CHECK(work.times()[0].milliseconds.empty());
    while (!work.is_done())
        work.advance();
    CHECK(work.rounds_done() == 2);
    CHECK(work.times().size() == static_cast<std::size_t>(count));
    for (const RungTime& time : work.times()) {
        REQUIRE(time.milliseconds.size() == 2);
        CHECK(time.median == median(time.milliseconds));
        CHECK(time.median > 0.0);
        CHECK(time.from_previous.pixels == 600);
    }
    work.advance(); // nothing more
    CHECK(work.times()[0].milliseconds.size() == 2);
}
