#include "facts/facts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/numbers.h"
#include "explain/light_formulas.h"
#include "picture/view_image.h"
#include "session/content.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// A session with its results, and what lessons can ask of them.
struct Asked {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Results results;
    FactCache cache;

    Value value(std::string_view name) {
        finish(session, results);
        return Facts(session, results, &cache)(name);
    }
    double number(std::string_view name) {
        const Value found = value(name);
        INFO(name);
        REQUIRE(std::holds_alternative<double>(found));
        return std::get<double>(found);
    }
    bool is_there(std::string_view name) { return rasterwalk::is_there(value(name)); }
};

} // namespace

TEST_CASE("Names of facts are listed once and have a sentence") {
    std::set<std::string> names;
    for (const std::string& name : all_names()) {
        INFO(name);
        CHECK(names.insert(name).second);
        CHECK(find_name(name));
    }
    for (const Fact& fact : fact_table()) {
        INFO(fact.name);
        CHECK(fact.help.ends_with('.'));
    }
    CHECK_FALSE(find_name("camera.position"));
    CHECK_FALSE(find_name("camera.position.w"));
    CHECK_FALSE(find_name(""));
}

TEST_CASE("Every fact has a value of its type and in its range, or none") {
    Asked room;
    room.session.selection = {21, 1, 250, glm::ivec2(250, 131)};
    room.session.cursor = {21, Phase::rows, 10, 3};
    compare_with(room.session, room.session.a.settings);
    for (const std::string& name : all_names()) {
        INFO(name);
        const Value value = room.value(name);
        const ValueRange range = *find_name(name);
        if (!is_there(value)) continue;
        switch (range.type) {
        case ValueType::number: {
            const double number = std::get<double>(value);
            CHECK(number >= range.low);
            CHECK(number <= range.high);
            if (range.is_whole) CHECK(number == std::floor(number));
            break;
        }
        case ValueType::word:
            CHECK(std::count(range.words.begin(), range.words.end(),
                             std::get<std::string>(value)) == 1);
            break;
        case ValueType::moment:
            CHECK(std::holds_alternative<Cursor>(value));
            break;
        case ValueType::truth:
            CHECK(false);
        }
    }
}

TEST_CASE("Settings are facts under their own names") {
    Asked room;
    CHECK(room.number("light.power") == 1.1);
    CHECK(room.number("light.power.green") == 1.1);
    CHECK(room.number("camera.position.z") == -3.001);
    CHECK(room.number("viewport.width") == 500);
    CHECK(room.value("stage") == Value(std::string("pixel_light")));
    CHECK_FALSE(room.is_there("camera.position"));
}

TEST_CASE("The sides of a box are facts if there is one") {
    Asked room;
    CHECK_FALSE(room.is_there("view_box.left"));
    room.session.a.settings.view_box = ViewBox{-0.5f, 0.25f, 0.0f, 2.0f};
    CHECK(room.number("view_box.left") == -0.5);
    CHECK(room.number("view_box.right") == 0.25);
    CHECK(room.number("view_box.bottom") == 0.0);
    CHECK(room.number("view_box.top") == 2.0);
}

TEST_CASE("The weights of a pixel are given to the full precision of their floats") {
    Asked triangle;
    triangle.session = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    triangle.session.a.settings.coverage = Coverage::edge_functions;
    triangle.session.cursor = {0, Phase::tests, 5, 5}; // its centre of gravity comes next
    double sum = 0.0;
    for (const char* name : {"test.weight0", "test.weight1", "test.weight2"}) {
        CHECK(triangle.number(name) == static_cast<double>(1.0f / 3.0f));
        CHECK(decimals(triangle.number(name), 9) == "0.333333343");
        sum += triangle.number(name);
    }
    CHECK(decimals(sum, 9) == "1.000000030");
}

TEST_CASE("Facts say what the ray through the picked pixel brings back, in either run") {
    Asked room;
    room.session.selection.pixel = {250, 350};
    CHECK_FALSE(room.is_there("rays.triangle")); // the steps draw
    compare_with(room.session, room.session.a.settings);
    room.session.b->settings.engine = Engine::rays;
    CHECK(room.number("rays.triangle") == room.number("pixel.owner"));
    CHECK(room.number("rays.red") == Approx(room.number("pixel.red")).margin(0.01));
    CHECK(room.number("rays.green") == Approx(room.number("pixel.green")).margin(0.01));
    CHECK(room.number("rays.blue") == Approx(room.number("pixel.blue")).margin(0.01));
    room.session.b.reset();
    room.session.a.settings.engine = Engine::rays;
    CHECK(room.number("rays.triangle") == 10); // the front of the short block
    room.session.selection.pixel = {380, 380}; // between the floor and the right wall
    CHECK(room.number("rays.triangle") == -1);
    CHECK(room.number("rays.red") == 0.0);
    room.session.selection.pixel.reset();
    CHECK_FALSE(room.is_there("rays.triangle"));
}

TEST_CASE("The facts of the room's frame are its known numbers") {
    Asked room;
    CHECK(room.number("frame.fragments") == 328'789);
    CHECK(room.number("frame.triangles") == 30);
    CHECK(room.number("frame.left_out") == 0);
    CHECK(room.number("frame.max_overdraw") == 8);
    CHECK(room.number("frame.uncovered") == 998);
    CHECK(room.number("frame.rows_outside") == 4);
    // Each fragment is tested, and each that passes is lit and written.
    CHECK(room.number("frame.vertices") == 70);
    CHECK(room.number("frame.depth_tests") == 328'789);
    CHECK(room.number("frame.shaded") == 293'357);
    CHECK(room.number("frame.pixel_lights") == 293'357);
    CHECK(room.number("frame.written") == 293'357);
    CHECK(room.number("frame.lights") == 293'357);
    CHECK(room.number("frame.depth_bytes") == 4 * (328'789 + 293'357));
    CHECK(room.number("frame.texels") == 0);
    CHECK(room.number("frame.shadow_tests") == 0);
    CHECK(room.number("frame.prepass_shaded") == 500 * 500 - 998);
    room.session.a.settings.camera.position.z = -0.9f;
    CHECK(room.number("frame.left_out") > 0);
    CHECK(room.number("frame.triangles") + room.number("frame.left_out") == 30);
}

TEST_CASE("Clipping and culling of the triangle shown are facts, and so are their moments") {
    Asked room;
    room.session.selection.triangle = 0;
    CHECK(room.number("polygon.planes") == 0);
    CHECK(room.number("polygon.corners") == 3);
    CHECK(room.number("polygon.triangles") == 1);
    CHECK_FALSE(room.is_there("cursor.plane"));
    room.session.a.settings.camera.position.z = -0.9f;
    room.session.a.settings.clip = Clip::near;
    CHECK(room.number("polygon.planes") == 1);
    CHECK(room.number("polygon.cuts") == 2);
    CHECK(room.number("polygon.corners") == 3); // with two of its corners behind the plane
    room.session.selection.triangle = 1;
    CHECK(room.number("polygon.corners") == 4);
    CHECK(room.number("polygon.triangles") == 2);
    CHECK(room.number("polygon.culled") == 0);
    room.session.cursor = {1, Phase::clip, 0, 2};
    CHECK(room.value("cursor.phase") == Value(std::string("clip")));
    CHECK(room.value("cursor.plane") == Value(std::string("near")));
    CHECK(room.number("cursor.clip_edge") == 2);
    CHECK_FALSE(room.is_there("cursor.edge"));
    room.session.a.settings.cull = Cull::face_normal;
    room.session.a.settings.camera.position = {0.0f, 5.0f, -3.0f};
    CHECK(room.number("polygon.culled") == 1);
    room.session.cursor = {1, Phase::cull, 0, 0};
    CHECK(room.value("cursor.phase") == Value(std::string("cull")));
    CHECK(room.value("cursor") == Value(Cursor{1, Phase::cull, 0, 0}));
}

TEST_CASE("Without a selection there are no facts about it") {
    Asked room;
    for (const char* name :
         {"triangle", "row", "vertex", "pixel.column", "pixel.owner", "pixel.z",
          "pixel.light_error", "pixel.u", "pixel.texels", "table.left", "table.count",
          "vertex.column", "cursor.triangle", "cursor.edge", "cursor.plane", "cursor.clip_edge",
          "cursor.row", "compare.first", "compare.different_pixels"}) {
        INFO(name);
        CHECK_FALSE(room.is_there(name));
    }
    room.session.selection.pixel = glm::ivec2(0, 0);
    CHECK(room.number("pixel.uncovered") == 1);
    CHECK(room.number("pixel.owner") == -1);
    CHECK(room.number("pixel.red") == 0);
    CHECK_FALSE(room.is_there("pixel.z"));
    room.session.selection.pixel = glm::ivec2(600, 0);
    CHECK_FALSE(room.is_there("pixel.uncovered"));
}

TEST_CASE("A pixel's facts are those of the fragment that stays") {
    Asked room;
    room.session.selection.pixel = glm::ivec2(250, 400);
    room.session.a.settings.stage = Stage::depth;
    CHECK(room.number("pixel.owner") >= 10);
    CHECK(room.number("pixel.owner") < 20);
    CHECK(room.number("pixel.zinv") == Approx(0.4170).margin(1e-4));
    CHECK(room.number("pixel.z") == Approx(1.0 / 0.4170).margin(1e-3));
    CHECK(room.number("pixel.losers") >= 1);
    CHECK(room.number("pixel.red") == 0.75);
    // The same as in the report on that fragment.
    set_step(room.session.a.settings, StripStep::pixel_light);
    const double error = room.number("pixel.position_error");
    const auto at = fragment_on_pixel(room.results.a.frame, {250, 400}, cursor_end);
    REQUIRE(at);
    const auto report = fragment_report(room.results.a.frame, *at);
    REQUIRE(report);
    const glm::vec3 apart = report->under(Interpolation::affine).position_world -
                            report->under(Interpolation::perspective).position_world;
    CHECK(error == static_cast<double>(glm::length(apart)));
    CHECK(room.number("pixel.light_error") >= 0.0);
}

TEST_CASE("The light error is the difference of the two pictures") {
    Asked room;
    room.session.a.settings.light.power = glm::vec3(14.0f);
    const glm::ivec2 pixel(60, 420);
    room.session.selection.pixel = pixel;
    const auto colour = [&](Interpolation way) {
        room.session.a.settings.interpolation = way;
        update(room.session, room.results);
        return room.results.a.framebuffer->colour[room.results.a.framebuffer->at(pixel.x, pixel.y)];
    };
    const glm::vec3 apart =
        glm::abs(colour(Interpolation::affine) - colour(Interpolation::perspective));
    const double expected = static_cast<double>(std::max({apart.x, apart.y, apart.z}));
    CHECK(expected > 0.0);
    CHECK(room.number("pixel.light_error") == expected);
}

TEST_CASE("The light's facts are the terms of the fragment that stays") {
    Asked room;
    room.session.selection.pixel = glm::ivec2(250, 400);
    CHECK(room.number("pixel.cosine") > 0.0);
    CHECK(room.number("pixel.highlight.red") == 0.0);
    CHECK_FALSE(room.is_there("pixel.normal_length")); // a flat wall has nothing to interpolate
    room.session.a.settings.stage = Stage::depth;
    CHECK_FALSE(room.is_there("pixel.cosine"));

    Asked round;
    round.session = open_session(lessons_folder() + "/scenes/cylinder.toml");
    const glm::ivec2 pixel(123, 110); // near the middle of a side, in the highlight
    round.session.selection.pixel = pixel;
    update(round.session, round.results);
    const std::size_t at = round.results.a.framebuffer->at(pixel.x, pixel.y);
    const glm::vec3 shining = round.results.a.framebuffer->colour[at];
    const double length = round.number("pixel.normal_length");
    const double n_dot_h = round.number("pixel.n_dot_h");
    const double shine = round.number("pixel.shine");
    const double red = round.number("pixel.highlight.red");
    const double distance = round.number("pixel.lamp_distance");
    // Normals 30 degrees apart are cos 15 degrees long in the middle.
    CHECK(length >= std::cos(3.14159265 / 12.0) - 1e-3);
    CHECK(length < 1.0);
    CHECK(shine == Approx(std::pow(n_dot_h, 50.0)).epsilon(1e-3));
    CHECK(red == Approx(0.7 * 45.0 * shine / (4.0 * 3.14159265 * distance * distance)));
    CHECK(red > 0.0);
    // What the highlight adds to the picture.
    round.session.a.settings.light.model = LightModel::lambert;
    update(round.session, round.results);
    CHECK(static_cast<double>(shining.r - round.results.a.framebuffer->colour[at].r) ==
          Approx(red).margin(1e-5));
    CHECK(round.number("pixel.n_dot_h") == 0.0);
    // Affine interpolation of normals changes the light as the picture does.
    const auto colour = [&](Interpolation way) {
        round.session.a.settings.interpolation = way;
        update(round.session, round.results);
        return round.results.a.framebuffer->colour[at];
    };
    const glm::vec3 apart =
        glm::abs(colour(Interpolation::affine) - colour(Interpolation::perspective));
    CHECK(round.number("pixel.light_error") ==
          static_cast<double>(std::max({apart.x, apart.y, apart.z})));
}

TEST_CASE("The table's facts are of the finished table of the triangle shown") {
    Asked bench;
    bench.session = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    bench.session.cursor = cursor_begin;
    update(bench.session, bench.results);
    const RowHistory rows = row_history(bench.results.a.frame, 0);
    CHECK(bench.number("table.rows") == rows.rows.size());
    CHECK(bench.number("table.first_row") == rows.rows.first_row);
    CHECK(bench.number("table.e0.samples") == 6);
    CHECK(bench.number("table.e0.samples") + bench.number("table.e1.samples") +
              bench.number("table.e2.samples") ==
          rows.sample_count);
    double sum = 0.0;
    for (int i = 0; i < rows.rows.size(); ++i) {
        bench.session.selection.row = rows.rows.first_row + i;
        const auto at = static_cast<std::size_t>(i);
        CHECK(bench.number("table.count") ==
              row_pixel_count(rows.rows.left[at].column, rows.rows.right[at].column));
        CHECK(bench.number("table.left") == rows.rows.left[static_cast<std::size_t>(i)].column);
        CHECK(bench.number("table.right") == rows.rows.right[static_cast<std::size_t>(i)].column);
        sum += bench.number("table.count");
    }
    CHECK(bench.number("table.fragments") == sum);
    bench.session.selection.row = rows.rows.first_row - 1;
    CHECK_FALSE(bench.is_there("table.count"));
}

TEST_CASE("The result of each fill rule on the shared edge nearest to the pixel is a fact") {
    Asked square;
    square.session = open_session(lessons_folder() + "/scenes/shared-edge.toml");
    square.session.selection.triangle = 0;
    CHECK_FALSE(square.is_there("shared.edge")); // by the lab's rows
    square.session.a.settings.coverage = Coverage::edge_functions;
    CHECK(square.number("shared.edge") == 2);
    CHECK(square.number("shared.neighbour") == 1);
    CHECK(square.number("shared.twice_inclusive") == 9);
    CHECK(square.number("shared.holes_inclusive") == 0);
    CHECK(square.number("shared.twice_exclusive") == 0);
    CHECK(square.number("shared.holes_exclusive") == 7);
    CHECK(square.number("shared.twice_top_left") + square.number("shared.holes_top_left") == 0);
    Asked hexagon;
    hexagon.session = open_session(lessons_folder() + "/scenes/hexagon.toml");
    hexagon.session.a.settings.coverage = Coverage::edge_functions;
    hexagon.session.selection.triangle = 1;
    hexagon.session.selection.pixel = {10, 4};
    CHECK(hexagon.number("shared.edge") == 0);
    hexagon.session.selection.pixel = {16, 6};
    CHECK(hexagon.number("shared.edge") == 2);
    CHECK(hexagon.number("shared.holes_exclusive") == 15); // of 17 pixels; the ends are not holes
}

TEST_CASE("The cursor's facts say what comes next") {
    Asked room;
    room.session.cursor = {4, Phase::edges, 1, 7};
    CHECK(room.number("cursor.triangle") == 4);
    CHECK(room.value("cursor.phase") == Value(std::string("edges")));
    CHECK(room.number("cursor.edge") == 1);
    CHECK(room.number("cursor.sample") == 7);
    CHECK_FALSE(room.is_there("cursor.vertex"));
    CHECK_FALSE(room.is_there("cursor.column"));
    room.session.cursor = {20, Phase::rows, 30, 2};
    update(room.session, room.results);
    const Timeline timeline(room.results.a.frame);
    const PolygonRows& rows = timeline.moments(20).rows;
    CHECK(room.number("cursor.row") == rows.first_row + 30);
    CHECK(room.number("cursor.column") == rows.left[30].column + 2);
    room.session.cursor = cursor_end;
    CHECK(room.value("cursor.phase") == Value(std::string("end")));
    CHECK(room.value("cursor") == Value(cursor_end));
}

TEST_CASE("Two runs have facts while they are compared") {
    Asked room;
    Settings other = room.session.a.settings;
    other.interpolation = Interpolation::affine;
    compare_with(room.session, other);
    CHECK(room.number("comparing") == 1);
    CHECK(room.number("compare.different_pixels") > 1000);
    CHECK(room.number("compare.largest_difference") > 0.0);
    CHECK(room.is_there("compare.first"));
    stop_comparing(room.session);
    CHECK(room.number("comparing") == 0);
    CHECK_FALSE(room.is_there("compare.different_pixels"));
}

TEST_CASE("With matrices no vertex or pixel differs; with a turned camera vertices do") {
    Asked room;
    Settings other = room.session.a.settings;
    other.transform = Transform::matrices;
    compare_with(room.session, other);
    CHECK(room.number("compare.vertices_elsewhere") == 0);
    CHECK(room.number("compare.different_pixels") == 0);
    other.camera.yaw = 0.1f;
    compare_with(room.session, other);
    CHECK(room.number("compare.vertices_elsewhere") > 60);
    CHECK(room.number("compare.vertices_elsewhere") <= 90);
}

TEST_CASE("NDC z is given for a vertex and for a pixel, under either projection") {
    Asked room;
    room.session.selection.triangle = 0;
    room.session.selection.vertex = 0;
    const double z = room.number("vertex.z");
    CHECK(room.number("vertex.z_ndc") == Approx(100.0 / 99.9 * (1.0 - 0.1 / z)).margin(1e-6));
    room.session.selection.pixel = glm::ivec2(250, 400);
    const double of_pixel = room.number("pixel.z");
    CHECK(room.number("pixel.z_ndc") == Approx(100.0 / 99.9 * (1.0 - 0.1 / of_pixel)).margin(1e-6));
    room.session.a.settings.projection_mix = 1.0f;
    const double parallel = room.number("pixel.z");
    CHECK(room.number("pixel.z_ndc") == Approx((parallel - 0.1) / 99.9).margin(1e-6));
    CHECK(room.number("vertex.z_ndc") == Approx((z - 0.1) / 99.9).margin(1e-6));
}

TEST_CASE("The names of tabs and views are found") {
    CHECK(value_of_word<View>("overdraw") == View::overdraw);
    CHECK_FALSE(value_of_word<View>("colours"));
    CHECK(std::count(tab_names().begin(), tab_names().end(), "rows") == 1);
}

TEST_CASE("Facts of lines: missed ends, samples elsewhere in run B, decisions") {
    Asked room;
    CHECK(room.number("frame.edges") == 90);
    CHECK(room.number("frame.ends_missed") == 24);
    CHECK_FALSE(room.is_there("compare.samples"));
    CHECK_FALSE(room.is_there("cursor.decision"));
    room.session.selection.triangle = 7;
    Settings other = room.session.a.settings;
    other.line = LineAlgorithm::bresenham;
    compare_with(room.session, other);
    CHECK(room.number("compare.samples") == 3463);
    CHECK(room.number("compare.e2.samples") == 187);
    room.session.b->settings.line = LineAlgorithm::interpolate;
    CHECK(room.number("compare.samples") == 0);
    CHECK(room.number("compare.e2.samples") == 0);

    room.session.a.settings.line = LineAlgorithm::bresenham;
    room.session.selection.triangle.reset();
    room.session.cursor = {0, Phase::edges, 0, 0};
    CHECK(room.number("frame.ends_missed") == 0);
    CHECK(room.is_there("cursor.decision"));
    CHECK(room.is_there("cursor.diagonal"));
    // If the next thing is not a sample, nothing is decided.
    room.session.cursor = {0, Phase::vertices, 0, 0};
    CHECK_FALSE(room.is_there("cursor.decision"));
}

TEST_CASE("A picked pixel's place in its texture and its texels are facts") {
    Asked wall;
    wall.session = open_session(lessons_folder() + "/scenes/receding-wall.toml");
    wall.session.selection.pixel = glm::ivec2(100, 70);
    Settings& settings = wall.session.a.settings;
    settings.coverage = Coverage::edge_functions;
    // Halfway on the screen from depth 2 to 4; a row is 10 above the middle of the picture.
    const double z = 8.0 / 3.0, height = 1.2;
    CHECK(wall.number("pixel.u") == Approx(1.0 / 3.0).margin(1e-6));
    CHECK(wall.number("pixel.v") == Approx(0.5 - 10.0 / 200.0 * z / height).margin(1e-6));
    CHECK(wall.number("pixel.texel.column") == 2); // of 8: 8/3
    CHECK(wall.number("pixel.texel.row") == 3);    // 8 (0.5 - 1/9) = 3.11
    CHECK(wall.number("pixel.texel.level") == 0);
    CHECK(wall.number("pixel.texels") == 1);
    // A pixel is 1/200 of a unit high per unit of depth; of the 8 texels there are 8 / 1.2 a unit.
    CHECK(wall.number("pixel.footprint") < 0.12);
    CHECK(wall.number("pixel.footprint") >= Approx(z / 200.0 * 8.0 / height));
    CHECK(wall.number("pixel.level") == 0);
    settings.texture_filter = TextureFilter::bilinear;
    CHECK(wall.number("pixel.texels") == 4);
    settings.interpolation = Interpolation::affine;
    CHECK(wall.number("pixel.u") == Approx(0.5).margin(1e-6));
    settings.texture = TextureUse::off;
    CHECK_FALSE(wall.is_there("pixel.u"));
    CHECK(wall.number("pixel.red") == 1);
    settings.texture = TextureUse::on;
    wall.session.selection.pixel = glm::ivec2(2, 2);
    CHECK_FALSE(wall.is_there("pixel.u"));

    wall.session = open_session(lessons_folder() + "/scenes/checkered-floor.toml");
    wall.session.selection.pixel = glm::ivec2(120, 84);
    wall.session.a.settings.texture_filter = TextureFilter::trilinear;
    CHECK(wall.number("pixel.level") > 1);
    CHECK(wall.number("pixel.texel.level") >= 1);
}

TEST_CASE("Affine interpolation is off by whole texels, which the light error includes") {
    Asked wall;
    wall.session = open_session(lessons_folder() + "/scenes/receding-wall.toml");
    Settings& settings = wall.session.a.settings;
    settings.stage = Stage::shade;
    // Near a border of two texels a pixel's own rounding decides.
    const auto is_tie = [](double texels) { return std::abs(texels - std::round(texels)) < 0.08; };
    const auto is_white = [](double x, double y) {
        return (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 == 0;
    };
    int asked = 0, other_texel = 0;
    for (int column = 36; column < 170; column += 4) {
        // On the screen the wall goes from (20, 20) and (20, 140) to (180, 50) and (180, 110).
        const double row = 74.0, share = (column - 20.0) / 160.0, z = 4.0 / (2.0 - share);
        const double u = 8.0 * share / (2.0 - share);
        const double v = 8.0 * (0.5 + (row - 80.0) / 200.0 * z / 1.2);
        const double upper = (row - 20.0 - 30.0 * share) / 120.0; // v in the upper triangle
        const double affine_u = 8.0 * share;
        const double affine_v =
            8.0 * (share + upper <= 1.0 ? upper : 1.0 - (140.0 - row - 30.0 * share) / 60.0);
        if (is_tie(u) || is_tie(v) || is_tie(affine_u) || is_tie(affine_v)) continue;
        wall.session.selection.pixel = glm::ivec2(column, 74);
        settings.texture = TextureUse::off;
        const double plain = wall.number("pixel.light_error");
        settings.texture = TextureUse::on;
        const double painted = wall.number("pixel.light_error");
        INFO("column " << column << ": without a texture " << plain << ", with it " << painted);
        // Texels are 0..1, so the error cannot grow where both ways take the same colour.
        const bool is_other = is_white(u, v) != is_white(affine_u, affine_v);
        CHECK((painted > plain + 0.2) == is_other);
        ++asked;
        other_texel += is_other ? 1 : 0;
    }
    CHECK(asked > 12);
    CHECK(other_texel > 3);
    CHECK(other_texel < asked - 3);
}

TEST_CASE("Every formula of the pixel, the vertex and the triangle is a fact by its id") {
    Asked room;
    room.session.selection = {21, 1, 250, glm::ivec2(250, 131)};
    finish(room.session, room.results);
    const Facts facts(room.session, room.results, &room.cache);
    REQUIRE(facts.fragment() != nullptr);
    REQUIRE(facts.vertex() != nullptr);
    const std::vector<std::pair<std::string, const std::vector<Formula>*>> all{
        {"pixel.", &facts.fragment()->formulas}, {"vertex.", &facts.vertex()->formulas}};
    for (const auto& [owner, formulas] : all) {
        for (const Formula& formula : *formulas) {
            const std::string name = owner + formula.id;
            CAPTURE(name);
            CHECK(find_name(name));
            // A fact with a row of its own may be another number: the final depth, the final z.
            const std::vector<std::string> listed = all_names();
            if (std::count(listed.begin(), listed.end(), name) > 0) continue;
            CHECK(room.number(name) == Approx(static_cast<double>(formula.result.value)));
        }
    }
    CHECK(room.is_there("triangle.corner.0.w"));
    CHECK(room.is_there("triangle.cull.normal"));
    // Known, but not there.
    CHECK(find_name("pixel.texture.level"));
    CHECK_FALSE(room.is_there("pixel.texture.level"));
    for (const char* const unknown :
         {"pixel.ligth.cosine", "vertex.world_q", "triangle.edge.0", "pixel.", "pixel.pixel_light",
          "pixel.bump", "vertex.light", "triangle.cull", "pixel.pixel_light."})
        CHECK_FALSE(find_name(unknown));
}
