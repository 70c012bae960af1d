// For any wrong input from the user: one sentence on standard error, nothing on standard output,
// and the promised exit code.

#include <algorithm>
#include <string>
#include <vector>

#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using test::CliRun;
using test::run;

namespace {

const std::string room_file = lessons_folder() + "/scenes/lab-room.toml";

/// Runs, and expects this exit code and this message.
void expect(const std::vector<std::string>& arguments, int exit_code, const std::string& sentence) {
    std::string line;
    for (const std::string& argument : arguments)
        line += argument + " ";
    INFO("rasterwalk " << line);
    const CliRun result = run(arguments);
    CHECK(result.exit_code == exit_code);
    CHECK(result.err == "rasterwalk: " + sentence + "\n");
    CHECK(result.out.empty());
    CHECK_FALSE(result.request.open_window);
}

/// The room's file with one piece of text replaced.
std::string room_with(const test::TemporaryFolder& folder, const std::string& old,
                      const std::string& replacement) {
    std::string text = test::bytes_of(room_file);
    REQUIRE(text.find(old) != std::string::npos);
    text.replace(text.find(old), old.size(), replacement);
    return folder.write("room.toml", text);
}

int line_of(const std::string& text) {
    const std::string whole = test::bytes_of(room_file);
    const auto place = static_cast<std::ptrdiff_t>(whole.find(text));
    return 1 + static_cast<int>(std::count(whole.begin(), whole.begin() + place, '\n'));
}

} // namespace

TEST_CASE("An argument that begins with a minus is quoted as it was given") {
    const CliRun place = run({"--scene", "scenes/one-triangle.toml", "--vertices", "-1000000,0/1"});
    CHECK(place.exit_code == 2);
    CHECK(place.err.ends_with(", not '-1000000,0/1'.\n"));
    CHECK(run({"stats", "--scene", "-5.toml"}).err ==
          "rasterwalk: cannot read '-5.toml': No such file or directory.\n");
    CHECK(run({"rows", "-5,3", "4,9", "7,-2"}).exit_code == 0);
}

TEST_CASE("A missing file ends with exit code 4, however it is named") {
    const std::string sentence = "cannot read 'none.toml': No such file or directory.";
    expect({"none.toml"}, 4, sentence);
    expect({"--scene", "none.toml"}, 4, sentence);
    expect({"render", "--scene", "none.toml", "-o", "/dev/null"}, 4, sentence);
    expect({"stats", "--scene", "none.toml"}, 4, sentence);
    expect({"settings", "--scene", "none.toml"}, 4, sentence);
}

TEST_CASE("Malformed TOML ends with exit code 3 and names the line") {
    const test::TemporaryFolder folder;
    const std::string place = "A = [555, 0, 0]";
    const std::string path = room_with(folder, place, "A = = [555, 0, 0]");
    const CliRun result = run({"stats", "--scene", path});
    CHECK(result.exit_code == 3);
    const std::string begin = "rasterwalk: " + path + ":" + std::to_string(line_of(place)) + ": ";
    CHECK(result.err.substr(0, begin.size()) == begin);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
}

TEST_CASE("A coordinate that is not a number ends with exit code 3 and names point and line") {
    const test::TemporaryFolder folder;
    const std::string place = "A = [555, 0, 0]";
    const std::string path = room_with(folder, place, "A = [nan, 0, 0]");
    expect({"stats", "--scene", path}, 3,
           path + ":" + std::to_string(line_of(place)) +
               ": the point 'A' must be a finite number.");
}

TEST_CASE("A point that does not exist ends with exit code 3 and names point and line") {
    const test::TemporaryFolder folder;
    const std::string path = room_with(folder, "\"C B A\"", "\"C B Z\"");
    expect({"stats", "--scene", path}, 3,
           path + ":" + std::to_string(line_of("\"C B A\"")) +
               ": there is no point 'Z' in the point set 'room'.");
}

TEST_CASE("A file that is not a scene ends with exit code 3") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("noise.toml", std::string("\x7f"
                                                                    "ELF\0\1",
                                                                    6));
    CHECK(run({path}).exit_code == 3);
    expect({folder.write("empty.toml", "")}, 3,
           folder.file("empty.toml") + ":1: the scene needs 'name'.");
}

TEST_CASE("A scene of absurd size ends with exit code 3") {
    const test::TemporaryFolder folder;
    const std::string path = room_with(folder, "width = 500", "width = 100000");
    expect({"stats", "--scene", path}, 3,
           path + ":" + std::to_string(line_of("width = 500")) +
               ": 'width' of the viewport must be a whole number between 1 and 4096.");
}

TEST_CASE("An unknown setting, value, preset or stage ends with exit code 2") {
    expect({"stats", "--set", "lite.power=3"}, 2,
           "there is no setting 'lite.power'. Did you mean 'light.power'?");
    expect({"stats", "--set", "rounding=up"}, 2,
           "rounding cannot be 'up': it takes truncate, floor or round.");
    expect({"stats", "--set", "light.power=nan"}, 2,
           "light.power cannot be 'nan': it takes one number or three, each from 0 to 10000.");
    expect({"stats", "--preset", "exakt"}, 2,
           "there is no preset 'exakt'; the presets are: handout, exact, visible light. Did you "
           "mean 'exact'?");
    expect({"stats", "--stage", "filled"}, 2,
           "stage cannot be 'filled': it takes points, edges, rows, fill, depth, vertex_light or "
           "pixel_light.");
    expect(
        {"render", "--view", "color", "-o", "/dev/null"}, 2,
        "--view must be colour, depth, triangle or overdraw, not 'color'. Did you mean 'colour'?");
}

TEST_CASE("A picture of size 0x0 or 100000x100000 ends with exit code 2") {
    for (const std::string size : {"0x0", "100000x100000", "500", "-1x5", "4097x1"}) {
        expect({"stats", "--size", size}, 2,
               "viewport.size cannot be '" + size +
                   "': it takes WIDTHxHEIGHT, each from 1 to 4096.");
    }
}

TEST_CASE("An output that cannot be written ends with exit code 4 and leaves nothing behind") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("none/x.png");
    expect({"render", "-o", path}, 4, "cannot write '" + path + "': No such file or directory.");
    expect({"render", "-o", folder.file("")}, 4,
           "cannot write '" + folder.file("") + "': Is a directory.");
    CHECK(folder.file_count() == 0);
}

TEST_CASE("A moment of clip or cull that does not exist says which ones do") {
    // Two corners of the floor are behind this camera, and one plane cuts it.
    const auto expect_at = [](const char* text, const std::string& complaint) {
        expect({"stats", "--to", text, "--set", "clip=near", "--set", "camera.position=0,0,-0.9"},
               2, std::string("there is no moment ") + text + ": " + complaint);
    };
    expect_at("t0/p0/s3", "the near plane p0 has the steps s0 to s2 for triangle t0.");
    expect_at("t0/p3/s0", "triangle t0 is cut by planes p0.");
    expect_at("t0/p99/s99", "triangle t0 is cut by planes p0.");
    expect_at("t0/p2147483647/s2147483647", "triangle t0 is cut by planes p0.");
    expect_at("t0/k", "no triangle is culled.");
    expect_at("t0/v3", "a triangle has vertices v0 to v2.");
    const std::vector<std::string> at_edge{"stats",
                                           "--to",
                                           "t0/e0/s0",
                                           "--set",
                                           "cull=face_normal",
                                           "--set",
                                           "camera.position=0,5,-3"};
    expect(at_edge, 2,
           "there is no moment t0/e0/s0: triangle t0 is left out: it faces away from the "
           "camera.");
    CHECK(
        run({"stats", "--to", "t0/k", at_edge[3], at_edge[4], at_edge[5], at_edge[6]}).exit_code ==
        0);
    CHECK(run({"stats", "--to", "t0/p0/s2", "--set", "clip=near", "--set",
               "camera.position=0,0,-0.9"})
              .exit_code == 0);
}

TEST_CASE("A moment that does not exist ends with exit code 2 and says which ones do") {
    expect({"stats", "--to", "t30"}, 2,
           "there is no moment t30: the scene has the triangles t0 to t29.");
    expect({"stats", "--to", "t3/v3"}, 2,
           "there is no moment t3/v3: a triangle has vertices v0 to v2.");
    expect({"stats", "--to", "t3/p0/s2"}, 2,
           "there is no moment t3/p0/s2: no plane cuts triangle t3.");
    expect({"stats", "--to", "t3/k"}, 2, "there is no moment t3/k: no triangle is culled.");
    expect(
        {"stats", "--to", "p1:t3/k"}, 2,
        "there is no moment p1:t3/k: the picture is drawn in a single pass; only shadows=map has "
        "passes before it.");
    expect({"stats", "--to", "t3/e3"}, 2,
           "there is no moment t3/e3: a triangle has edges e0 to e2.");
    expect({"stats", "--to", "t12/e1/s9999"}, 2,
           "there is no moment t12/e1/s9999: edge e1 of triangle t12 has the samples s0 to s46.");
    expect({"stats", "--to", "t12/r999"}, 2,
           "there is no moment t12/r999: triangle t12 has the rows r0 to r133.");
    expect({"stats", "--to", "t3/r0", "--stage", "edges"}, 2,
           "there is no moment t3/r0: in the edges stage a triangle has no rows.");
    expect({"stats", "--to", "t3/e0", "--stage", "points"}, 2,
           "there is no moment t3/e0: in the points stage a triangle has no edges.");
    expect({"stats", "--to", "t3/e0/s0", "--stage", "fill", "--set", "coverage=active_edges"}, 2,
           "there is no moment t3/e0/s0: coverage=active_edges walks no edges in the fill stage.");
    expect({"stats", "--to", "t0", "--set", "camera.position=0,0,900"}, 2,
           "there is no moment t0: triangle t0 is left out: a vertex lies on or behind the camera "
           "plane.");
    for (const std::string text : {"t", "x", "t1/", "t-1", "t1/v1/s1", "t99999999999", "END"}) {
        expect({"stats", "--to", text}, 2,
               "'" + text +
                   "' is not a moment; moments are written t12, t12/v1, t12/p2/s1, t12/k, "
                   "t12/e2/s14, t12/b4/c7, t12/r37/c5, s37/c5, w12, p1:t12 or end.");
    }
}

TEST_CASE("A point that is malformed or too far out ends with exit code 2") {
    for (const std::string point : {"5", "5,", ",5", "5,nan", "1.5,2", "1,2,3", "16385,0",
                                    "0,-16385", "99999999999,0", "", "a,b"}) {
        expect({"rows", "1,1", point}, 2,
               "'" + point +
                   "' is not a point. Write it as X,Y in whole numbers from -16384 to 16384.");
    }
    CHECK(run({"rows", "16384,-16384"}).exit_code == 0);
}

TEST_CASE("rows refuses settings that rows do not depend on, and endless polygons") {
    expect({"rows", "1,1", "--set", "light.power=3"}, 2,
           "rows depend on rounding, line, bresenham_rule, line_walk, edge_samples, row_start, "
           "row_search and viewport.size, not on light.power.");
    std::vector<std::string> arguments(1002, "1,1");
    arguments[0] = "rows";
    expect(arguments, 2, "a polygon may have at most 1000 points.");
}

TEST_CASE("A link that is not one of the page ends with exit code 2") {
    expect({"#lesson=05-row-tabel"}, 2,
           "there is no lesson '05-row-tabel'. Did you mean '05-row-table'?");
    expect({"https://example.edu/#light=3"}, 2, "a link cannot set 'light'.");
    expect({"--stage", "fill", "#stage=edges"}, 2, "a link and options cannot be given together.");
    CHECK(run({"#scene=../../secret.toml"}).exit_code == 2);
    CHECK(run({"stats", "#stage=edges"}).exit_code == 4); // as FILE, and there is none
}

TEST_CASE("Unknown words on the command line end with exit code 2") {
    expect({"rendr"}, 2,
           "there is neither a command nor a file named 'rendr'. Did you mean 'render'?");
    expect({"render"}, 2, "--output is required. See rasterwalk --help.");
    expect({"stats", "--bogus"}, 2,
           "The following argument was not expected: --bogus. See rasterwalk --help.");
    expect({"--stage", "fill", "stats"}, 2, "the options of a command go after its name.");
    expect({room_file, "--scene", room_file}, 2,
           "the scene is named twice, as FILE and by --scene.");
    CHECK(run({"rows"}).exit_code == 2);
    CHECK(run({"stats", "render"}).exit_code == 4); // as FILE, and there is none
    CHECK(run({"stats", "--set"}).exit_code == 2);
}
