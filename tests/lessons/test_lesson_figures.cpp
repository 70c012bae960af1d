// What lessons, notes and the list of mistakes state in figures beyond their predictions, found a
// second time: by definition, by counting, or from the planes of a drawn frame.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "inspect/stats.h"
#include "picture/pixel_facts.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/oracle.h"
#include "support/quoted_text.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A scene of the lessons' folder under settings, drawn to its end.
struct Drawn {
    Scene scene;
    Frame frame;
    Framebuffer picture;
    FrameStats stats;

    explicit Drawn(const std::vector<std::string>& assignments,
                   const std::string& name = "lab-room")
        : scene(read_scene(lessons_folder() + "/scenes/" + name + ".toml")) {
        Settings settings = default_settings(scene);
        for (const std::string& assignment : assignments)
            set_from_text(settings, assignment);
        frame = prepare_frame(scene, settings);
        stats = frame_stats(frame, cursor_end, picture);
    }
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;

    std::int64_t drawn_twice() const {
        const PixelFacts facts = pixel_facts(frame, cursor_end, {.drawn_twice = true});
        return std::count_if(facts.drawn_twice.begin(), facts.drawn_twice.end(),
                             [](const DrawnTwice& pair) { return bool(pair); });
    }
};

using ColumnRow = std::array<int, 2>;

/// Every pixel that triangles fill by their tables, with or without the last one of each row.
std::set<ColumnRow> filled(const Frame& frame, bool has_last) {
    std::set<ColumnRow> pixels;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        int outside = 0;
        for (const auto& [row, ends] :
             row_table(frame.triangle_vertices(t), WalkRules(), outside)) {
            for (int column = ends.left; column < ends.right + (has_last ? 1 : 0); ++column)
                pixels.insert({column, row});
        }
    }
    return pixels;
}

} // namespace

TEST_CASE("About one edge in a hundred misses its end by a + i * step; by a (1 - t) + b t none") {
    require_text("04-edges.md", "This happens to about one edge in a hundred.");
    constexpr int edges = 20'000;
    Random random(4);
    int missed = 0, mixed_missed = 0;
    for (int edge = 0; edge < edges; ++edge) {
        const auto anywhere = [&] { return random.integer(0, 499); };
        const ColumnRow a{anywhere(), anywhere()}, b{anywhere(), anywhere()};
        const int steps = std::max({std::abs(b[0] - a[0]), std::abs(b[1] - a[1]), 1});
        bool arrives = true, mixed_arrives = true;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto from = static_cast<float>(a[axis]), to = static_cast<float>(b[axis]);
            const float last = walked(from, to, steps, steps + 1, LineWalk::multiply);
            arrives = arrives && static_cast<int>(last) == b[axis];
            volatile const float t = static_cast<float>(steps) / static_cast<float>(steps);
            volatile const float of_a = from * (1.0f - t), of_b = to * t;
            mixed_arrives = mixed_arrives && static_cast<int>(of_a + of_b) == b[axis];
        }
        missed += arrives ? 0 : 1;
        mixed_missed += mixed_arrives ? 0 : 1;
    }
    INFO(missed << " of " << edges);
    CHECK(missed > edges / 200);
    CHECK(missed < edges / 70);
    CHECK(mixed_missed == 0);
}

TEST_CASE(
    "The program's multiplied walk misses the end that lesson 4 shows, and no exact one does") {
    ScreenVertex a, b;
    a.row = 8;
    b.column = 13;
    b.row = 1;
    const auto last_row = [&](const LineRules& rules) {
        std::vector<Fragment> samples(14);
        interpolate(a, b, rules, samples);
        CHECK(samples.back().column == 13);
        return samples.back().row;
    };
    CHECK(last_row({LineWalk::multiply, Rounding::truncate}) == 0);
    CHECK(last_row({LineWalk::exact, Rounding::truncate}) == 1);
    CHECK(last_row({LineWalk::multiply, Rounding::round}) == 1);
    CHECK(last_row({LineWalk::accumulate, Rounding::round}) == 1);
}

TEST_CASE("24 of the room's 90 edges miss their end, and they have 15 109 samples") {
    require_text("04-edges.md", "Of the room's 90 edges, 24 miss their own end point.");
    const Drawn room({"stage=edges"});
    int edges = 0, missed = 0, samples = 0;
    for (int t = 0; t < room.frame.triangle_count(); ++t) {
        const auto vertices = room.frame.triangle_vertices(t);
        for (std::size_t e = 0; e < 3; ++e) {
            const ScreenVertex &a = vertices[e], &b = vertices[(e + 1) % 3];
            const int count = 1 + std::max(std::abs(b.column - a.column), std::abs(b.row - a.row));
            const test::Place last = line_places(a, b, count, {}).back();
            ++edges;
            samples += count;
            missed += last == test::Place{b.column, b.row} ? 0 : 1;
        }
    }
    CHECK(edges == 90);
    CHECK(missed == 24);
    CHECK(samples == 15'109);
}

TEST_CASE("Without the last pixel of each row the lab's triangle loses two rows and two tips") {
    require_text("06-filling.md", "Rows 5 and 15 have only one pixel, so they vanish");
    const Drawn bench({"stage=fill"}, "one-triangle");
    const std::set<ColumnRow> all = filled(bench.frame, true),
                              without_last = filled(bench.frame, false);
    std::set<int> rows, rows_left;
    for (const ColumnRow& pixel : all)
        rows.insert(pixel[1]);
    for (const ColumnRow& pixel : without_last)
        rows_left.insert(pixel[1]);
    CHECK(rows.size() == 11);
    CHECK(rows_left.size() == 9);
    CHECK(rows_left.count(5) + rows_left.count(15) == 0);
    CHECK(without_last.count({10, 5}) + without_last.count({15, 15}) == 0);
    CHECK(without_last.count({5, 10}) == 1);
}

TEST_CASE("Without the last pixel of each row the room loses column 499, and no gap opens") {
    require_text("bugs.toml", "In the room, the whole of column 499 is black.");
    require_text("stages/fill.md", "column 499 stays black");
    const Drawn whole({"stage=fill"}), narrow({"stage=fill", "spans=last_dropped"});
    CHECK(whole.stats.uncovered == 998);
    CHECK(narrow.stats.uncovered == 1'497);
    const std::set<ColumnRow> before = filled(whole.frame, true),
                              after = filled(whole.frame, false);
    std::vector<ColumnRow> lost;
    std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                        std::back_inserter(lost));
    CHECK(lost.size() == 1'497 - 998);
    for (const ColumnRow& pixel : lost)
        CHECK(pixel[0] == 499);
    // Neighbours still overlap elsewhere: lesson 6.
    CHECK(narrow.drawn_twice() == 1'398);
}

TEST_CASE("About 1.6 percent of the fragments of the room are second copies on a shared edge") {
    require_text("bugs.toml", "About 1.6 percent of all fragments are second copies.");
    const Drawn room({"stage=fill"});
    const double share =
        100.0 * static_cast<double>(room.drawn_twice()) / static_cast<double>(room.stats.fragments);
    CHECK(share == Approx(1.6).margin(0.05));
}

TEST_CASE("The lamp would appear in row 142") {
    require_text("09-light-per-vertex.md", "(pixel:250,142)");
    // The lab's vertex shader: the fraction is cut before the middle is added.
    CHECK(static_cast<int>(500.0 * -0.5 / (-0.7 + 3.001)) + 250 == 142);
}

TEST_CASE("The spot on the ceiling is pale and not white: its red is 0.74") {
    require_text("10-light-per-pixel.md", "while red still grows, up to 0.74");
    const Drawn room({"stage=pixel_light", "light.power=14"});
    float red = 0.0f, green = 0.0f;
    for (std::size_t i = 0; i < room.picture.colour.size(); ++i) {
        if (room.picture.owner[i] != 6 && room.picture.owner[i] != 7) continue;
        red = std::max(red, room.picture.colour[i].r);
        green = std::max(green, room.picture.colour[i].g);
    }
    // Half a unit away, squarely: D and the indirect light, times a reflectance of 0.15.
    const double pi = std::acos(-1.0);
    CHECK(0.15 * (14.0 / (4.0 * pi * 0.25) + 0.5) == Approx(0.7435).margin(5e-4));
    CHECK(red == Approx(0.7435).margin(2e-3));
    CHECK(green > 3.7f);
}

TEST_CASE("Affine interpolation is right on a wall parallel to the picture, and off on others") {
    const Drawn affine({"stage=pixel_light", "interpolation=affine"});
    const PixelFacts facts = pixel_facts(affine.frame, cursor_end, {.affine_error = true});
    double back_wall = 0.0, left_wall = 0.0;
    for (std::size_t i = 0; i < affine.picture.owner.size(); ++i) {
        const int owner = affine.picture.owner[i];
        const double error = facts.affine_error[i];
        if (owner == 8 || owner == 9) back_wall = std::max(back_wall, error);
        if (owner == 2 || owner == 3) left_wall = std::max(left_wall, error);
    }
    CHECK(back_wall < 0.002); // what the floats leave
    CHECK(left_wall > 0.3);
}

TEST_CASE("r cubed brightens what is nearer than one unit and darkens what is farther away") {
    const Drawn right({"stage=pixel_light", "light.power=14", "light.indirect=0"});
    const Drawn cubed(
        {"stage=pixel_light", "light.power=14", "light.indirect=0", "light.falloff=cubed"});
    int brighter = 0, darker = 0;
    for (std::size_t i = 0; i < right.picture.colour.size(); ++i) {
        const double d = double(cubed.picture.colour[i].g) - right.picture.colour[i].g;
        brighter += d > 0.01 ? 1 : 0;
        darker += d < -0.01 ? 1 : 0;
    }
    CHECK(brighter > 1000);
    CHECK(darker > 1000);
}

TEST_CASE("Lessons 17 to 19 state what clipping, rejecting and culling leave") {
    const Drawn left_out({"stage=depth", "camera.position=0,0,-0.9", "camera.focal_length=250"});
    CHECK(left_out.stats.left_out.of(Rejection::behind_camera) == 8);
    CHECK(std::count(left_out.picture.owner.begin(), left_out.picture.owner.end(), -1) == 126'200);
    require_text("17-near-plane.md", "8 of 30 triangles");
    require_text("17-near-plane.md", "126 200 pixels");

    const Drawn cut({"stage=depth", "clip=all", "camera.position=0,0,-1.05"});
    CHECK(cut.stats.fragments_outside == 1311);
    CHECK(cut.stats.clipped == 21);
    require_text("18-outcodes.md", "only 1311 fragments of this frame fall outside");
    require_text("18-outcodes.md", "here 21 triangles are cut");

    const Drawn turned({"stage=depth", "reject=outcodes", "clip=all", "camera.position=0,0,-1.5",
                        "camera.yaw=0.2"});
    CHECK(turned.stats.left_out.of(Rejection::outside) == 4);
    CHECK(turned.stats.left_out.of(Rejection::clipped_away) == 2);
    CHECK(turned.frame.rejection(2) == Rejection::outside);
    require_text("18-outcodes.md", "reject four triangles; `triangles[2]`");

    const Drawn culled({"stage=depth", "cull=face_normal"});
    CHECK(culled.stats.fragments == 294'473);
    require_text("19-culling.md", "whole triangles leaves only 294 473");
}
