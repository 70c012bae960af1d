#include "cli/cli.h"

#include <algorithm>

#include "base/image.h"
#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/handout_rows.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using test::CliRun;
using test::run;
using test::without_blanks;

namespace {

const std::string room = lessons_folder() + "/scenes/lab-room.toml";
const std::string bench = lessons_folder() + "/scenes/one-triangle.toml";

} // namespace

TEST_CASE("rows prints the lab's eleven lines exactly, and nothing else") {
    const CliRun result = run({"rows", "10,5", "5,10", "15,15"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(result.out == test::handout_rows);
}

TEST_CASE("rows takes negative coordinates") {
    CHECK(run({"rows", "-2,-3", "1,-3"}).out == "Start: (-2,-3). End: (1,-3).\n");
    CHECK(run({"rows", "0,0", "-1,0", "--set", "rounding=floor"}).out ==
          "Start: (-1,0). End: (0,0).\n");
}

TEST_CASE("rows --json says who wrote each end and which samples fell outside") {
    const CliRun result = run({"rows", "--json", "0,2", "3,1"});
    CHECK(result.exit_code == 0);
    const std::string json = without_blanks(result.out);
    CHECK_THAT(json,
               ContainsSubstring("\"rows\":[{\"left\":1,\"left_by\":{\"edge\":0,\"replaced\":0,"
                                 "\"sample\":1},\"right\":3,"));
    CHECK_THAT(json,
               ContainsSubstring("\"outside\":[{\"column\":3,\"edge\":0,\"row\":0,\"sample\":3,"
                                 "\"x\":3.0,\"y\":0.99999988079071045}]"));
    CHECK_THAT(result.err, ContainsSubstring("edge 0, line[3] at (3, 0.999999881) falls in row 0"));
}

TEST_CASE("rows follows the rules it is given") {
    const std::vector<std::string> points{"rows", "0,2", "3,1"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), points.begin(), points.end());
        return run(more);
    };
    CHECK_FALSE(run(points).err.empty());
    CHECK(with({"--preset", "exact"}).err.empty());
    CHECK(with({"--set", "line_walk=exact"}).err.empty());
    CHECK(with({"--set", "edge_samples=rows"}).out == "Start: (3,1). End: (3,1).\n"
                                                      "Start: (0,2). End: (0,2).\n");
}

TEST_CASE("stats of the lab's room are the numbers that were found independently") {
    const CliRun result = run({"stats", "--json"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(without_blanks(result.out) ==
          "{\"clip_triangles\":30,\"clipped\":0,\"colour_bytes\":3520284,\"comparisons\":328789,"
          "\"culled\":0,\"depth_bytes\":2488584,\"depth_outside\":0,\"depth_tests\":328789,"
          "\"edge_samples\":15109,"
          "\"fragments\":328789,\"fragments_outside\":0,\"left_out\":{\"behind_camera\":0,"
          "\"not_finite\":0,\"taken_for_behind\":0,\"too_far_out\":0},\"max_overdraw\":8,"
          "\"memory\":1000000,\"pixel_lights\":293357,\"pixels_"
          "tested\":0,"
          "\"rejected\":0,\"rows_looked_at\":15109,\"rows_outside\":4,\"rows_outside_triangles\":4,"
          "\"shaded\":293357,\"shadow_tests\":0,\"splits\":0,\"squares\":0,\"texels\":0,"
          "\"texture_bytes\":0,\"triangles\":30,\"uncovered\":998,\"unset_rows\":0,"
          "\"vertex_lights\":0,\"vertices\":70,\"written\":293357}");
    CHECK_THAT(run({"stats"}).out, ContainsSubstring("fragments               328789\n"));
}

TEST_CASE(
    "Changing the picture's size keeps the field of view unless the focal length is set too") {
    const auto focal_length = [](std::vector<std::string> arguments) {
        return run(arguments).request.session.a.settings.camera.focal_length;
    };
    CHECK(focal_length({"--size", "250x250"}) == 250.0f);
    CHECK(focal_length({"--size", "1000x250"}) == 250.0f);
    CHECK(focal_length({"--size", "250x250", "--set", "camera.focal_length=400"}) == 400.0f);
    CHECK(focal_length({"--set", "viewport.size=250x250"}) == 500.0f);
    CHECK(run({"--size", "640x480"}).request.session.a.settings.viewport == Viewport{640, 480});
}

TEST_CASE("The view options set the session, and the more specific one wins") {
    const CliRun result = run({"--preset", "visible light", "--preset", "exact", "--set",
                               "rounding=round", "--stage", "depth", "--to", "t3/e1/s2"});
    REQUIRE(result.exit_code == 0);
    CHECK(result.request.open_window);
    const Settings& settings = result.request.session.a.settings;
    CHECK(settings.light.power == glm::vec3(14.0f));
    CHECK(common_rounding(settings) == Rounding::round);
    CHECK(settings.line_walk == LineWalk::exact);
    CHECK(settings.stage == Stage::depth);
    CHECK(result.request.session.cursor == Cursor{3, Phase::edges, 1, 2});
}

TEST_CASE("Without a command the window is opened, with the lab's room or the named file") {
    CHECK(run({}).request.open_window);
    CHECK(run({}).request.session.scene->triangle_count() == 30);
    CHECK(run({bench}).request.session.scene->triangle_count() == 1);
    CHECK(run({"--scene", bench}).request.session.scene->triangle_count() == 1);
    CHECK_FALSE(run({"stats"}).request.open_window);
    CHECK_FALSE(run({"--help"}).request.open_window);
}

TEST_CASE("A link of the page opens the same view in the window") {
    for (const char* const before : {"", "https://example.edu/cg/", "file:///site/index.html"}) {
        INFO(before);
        const CliRun result = run({before + std::string("#lesson=05-row-table&step=3")});
        REQUIRE(result.exit_code == 0);
        CHECK(result.request.open_window);
        CHECK_FALSE(result.request.is_plain);
        CHECK(result.request.session.lesson == "05-row-table");
        CHECK(result.request.session.step == 3);
    }
}

TEST_CASE("render writes the picture in the requested size") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("x.png");
    REQUIRE(run({"render", "--size", "60x40", "-o", path}).exit_code == 0);
    const Image image = read_image(path);
    CHECK(image.width == 60);
    CHECK(image.height == 40);
    CHECK(folder.file_count() == 1);
}

TEST_CASE("render draws each plane, and only up to the requested moment") {
    const test::TemporaryFolder folder;
    const auto render = [&](std::vector<std::string> arguments) {
        const std::string path = folder.file("x.png");
        arguments.insert(arguments.begin(), {"render", "-o", path, "--size", "50x50"});
        const CliRun result = run(arguments);
        INFO(result.err);
        REQUIRE(result.exit_code == 0);
        return read_image(path).rgba;
    };
    const auto whole = render({"--stage", "depth"});
    CHECK(render({"--stage", "depth", "--to", "end"}) == whole);
    CHECK(render({"--stage", "depth", "--to", "t20"}) != whole);
    CHECK(render({"--stage", "depth", "--view", "depth"}) != whole);
    CHECK(render({"--stage", "depth", "--view", "triangle"}) != whole);
    CHECK(render({"--stage", "depth", "--view", "overdraw"}) != whole);
    const auto nothing = render({"--to", "t0"});
    for (std::size_t i = 0; i < nothing.size(); ++i) {
        if (nothing[i] != (i % 4 == 3 ? 255 : 0)) FAIL("byte " << i << " is not black");
    }
}

TEST_CASE("A row without a column is the row's first pixel in the picture") {
    const std::vector<std::string> common{"--scene", bench, "--stage", "fill", "--to"};
    const auto cursor = [&](const std::string& to) {
        std::vector<std::string> arguments = common;
        arguments.push_back(to);
        return run(arguments).request.session.cursor;
    };
    CHECK(cursor("t0/r3") == Cursor{0, Phase::rows, 3, 0});
    CHECK(cursor("t0/r3/c2") == Cursor{0, Phase::rows, 3, 2});
    CHECK(cursor("end") == cursor_end);
}

TEST_CASE("settings lists every setting with its value, and marks what is not the default") {
    const CliRun text = run({"settings", "--set", "light.power=14"});
    CHECK(text.exit_code == 0);
    CHECK_THAT(text.out, ContainsSubstring("light.power=14   (default: 1.1)"));
    CHECK_THAT(text.out, ContainsSubstring("rounding=truncate\n"));
    const std::string json = run({"settings", "--json"}).out;
    for (const char* name : {"\"stage\"", "\"camera.position\"", "\"viewport.size\""}) {
        CHECK_THAT(json, ContainsSubstring(name));
    }
    CHECK_THAT(without_blanks(json), StartsWith("{\"settings\":[{"));
}

TEST_CASE("presets lists the presets with what they set") {
    CHECK_THAT(run({"presets"}).out, ContainsSubstring("visible light\n"));
    CHECK_THAT(
        without_blanks(run({"presets", "--json"}).out),
        ContainsSubstring("\"name\":\"exact\",\"set\":[\"rounding=floor\",\"line_walk=exact\"]"));
}

TEST_CASE("help and version go to standard output and succeed") {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"}, {"-h"}, {"render", "--help"}, {"rows", "-h"}}) {
        const CliRun result = run(arguments);
        CHECK(result.exit_code == 0);
        CHECK_THAT(result.out, ContainsSubstring("Usage: rasterwalk"));
        CHECK(result.err.empty());
    }
    CHECK(run({"--version"}).out == "rasterwalk " + version_text() + "\n");
    for (const char* command : {"render", "stats", "rows", "settings", "presets"}) {
        CHECK_THAT(run({"--help"}).out, ContainsSubstring(command));
    }
}

TEST_CASE("An output that cannot be written is reported") {
    std::ostringstream err;
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    CliRequest request;
    const char* const argv[] = {"rasterwalk", "presets"};
    CHECK(run_cli(2, argv, out, err, request) == 4);
    CHECK(err.str() == "rasterwalk: the output could not be written.\n");
}

TEST_CASE("Triangles that are left out are reported on standard error, and the rest are drawn") {
    const CliRun result = run({"stats", "--json", "--set", "camera.position=0,0,0"});
    CHECK(result.exit_code == 0);
    CHECK(result.err ==
          "rasterwalk: 23 triangles are left out: a vertex lies on or behind the camera plane.\n");
    CHECK_THAT(without_blanks(result.out), ContainsSubstring("\"behind_camera\":23"));
}

TEST_CASE("Several triangles that are left out are reported in the plural") {
    const CliRun all = run({"stats", "--set", "camera.position=0,0,9", "--set", "clip=all"});
    CHECK(all.err == "rasterwalk: 30 triangles are left out: clipping leaves nothing of them.\n");
    const CliRun backs = run({"stats", "--set", "cull=face_normal"});
    CHECK(backs.err == "rasterwalk: 10 triangles are left out: they face away from the camera.\n");
}

TEST_CASE("Settings that contradict each other are reported on standard error") {
    const CliRun planes = run({"stats", "--set", "near=3", "--set", "far=1"});
    CHECK(planes.exit_code == 0);
    CHECK(planes.err == "rasterwalk: the far plane, at 1, is not behind the near plane, at 3, so "
                        "nothing lies between them."
                        "\n");
    const CliRun target = run({"stats", "--set", "camera.aim=look_at", "--set",
                               "camera.target=0,0,-3", "--set", "camera.position=0,0,-3"});
    CHECK_THAT(target.err,
               ContainsSubstring("rasterwalk: the camera is at its own target, which gives it no "
                                 "direction to look in: it looks along z."
                                 "\n"));
    const CliRun up = run({"stats", "--set", "camera.aim=look_at", "--set", "camera.up=0,0,2"});
    CHECK_THAT(up.err,
               ContainsSubstring("rasterwalk: the camera's up points along its view, or nowhere: a "
                                 "different direction is used as up."
                                 "\n"));
    const CliRun angles = run({"stats", "--set", "camera.up=0,0,2"});
    CHECK(angles.err.empty());
}
