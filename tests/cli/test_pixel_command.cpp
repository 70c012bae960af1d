#include "cli/cli.h"

#include <algorithm>

#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using test::CliRun;
using test::run;
using test::without_blanks;

namespace {

std::size_t count_of(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

} // namespace

TEST_CASE("pixel prints the history of a pixel of the room, line by line") {
    const CliRun result = run({"pixel", "240,300"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(result.out ==
          "pixel 240,300, stage pixel_light: 3 fragments.\n"
          "  #  moment           part                   1/z     stored     margin  to winner  "
          "fate     colour after\n"
          "  0  t8/r174/c114     back wall          0.249938   0.000000  +0.249938  -0.079533  "
          "written  0.3906 0.3906 0.3906\n"
          "  1  t21/r82/c39      tall block         0.329470   0.249938  +0.079533  +0.000000  "
          "written  0.0823 0.0823 0.4115  stays\n"
          "  2  t23/r80/c8       tall block         0.290940   0.329470  -0.038530  -0.038530  "
          "hidden   0.0823 0.0823 0.4115\n");
}

TEST_CASE("pixel --json gives every number of the history") {
    const CliRun result = run({"pixel", "240,300", "--json"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    const std::string json = without_blanks(result.out);
    CHECK_THAT(json, ContainsSubstring("\"covered\":true"));
    CHECK_THAT(json, ContainsSubstring("\"uncovered\":[]"));
    CHECK(count_of("\"triangle\":", json) == 3);
    CHECK_THAT(json, ContainsSubstring("\"depth_holds\":\"1/z\""));
    CHECK_THAT(
        json, ContainsSubstring("{\"colour_after\":[0.082292571663856506,0.082292571663856506,"
                                "0.41146284341812134],\"colour_before\":[0.39060357213020325,"
                                "0.39060357213020325,0.39060357213020325],\"column\":39,\"cursor\":"
                                "\"t21/r82/c39\",\"depth\":0.32947039604187012,\"drawn\":true,"
                                "\"fate\":\"written\",\"margin\":0.07953287661075592,"
                                "\"margin_to_winner\":0.0,\"name\":\"tallblock\",\"row\":82,"
                                "\"stays\":true,\"stored\":0.2499375194311142,"
                                "\"stored_zinv\":0.2499375194311142,\"triangle\":21,"
                                "\"zinv\":0.32947039604187012}"));
    CHECK(count_of("\"fate\":\"depth_failed\"", json) == 1);
    CHECK(count_of("\"stays\":true", json) == 1);
}

TEST_CASE("pixel --to shows what is drawn up to a moment and what is still to come") {
    const CliRun text = run({"pixel", "240,300", "--to", "t21"});
    CHECK(text.exit_code == 0);
    CHECK(count_of("not drawn yet", text.out) == 2);
    const std::string json = without_blanks(run({"pixel", "240,300", "--to", "t21", "--json"}).out);
    CHECK(count_of("\"drawn\":true", json) == 1);
    CHECK(count_of("\"drawn\":false", json) == 2);
    CHECK_THAT(json, ContainsSubstring("{\"colour\":[0.39060357213020325,0.39060357213020325,"
                                       "0.39060357213020325],\"column\":240,"));
}

TEST_CASE("pixel says why nothing falls on the black border") {
    const CliRun text = run({"pixel", "0,250"});
    CHECK(text.exit_code == 0);
    CHECK(text.out == "pixel 0,250, stage pixel_light: nothing falls on it.\n"
                      "No row of any triangle reaches this pixel.\n"
                      "t2 left wall: row 250 begins at column 1, 1 column to the right of the "
                      "pixel; with rounding=floor or rounding=round it begins at column 0.\n");
    const std::string json = without_blanks(run({"pixel", "0,250", "--json"}).out);
    CHECK_THAT(json, ContainsSubstring("\"covered\":false"));
    CHECK_THAT(json, ContainsSubstring("\"history\":[]"));
    CHECK_THAT(json, ContainsSubstring(
                         "\"uncovered\":[{\"columns_away\":1,\"left\":1,\"name\":\"leftwall\","
                         "\"right\":84,\"row\":250,\"rows_away\":0,\"rules\":[{\"left\":0,"
                         "\"right\":83,\"rule\":\"rounding=floor\"},"));
    CHECK(count_of("nothing falls", run({"pixel", "0,250", "--preset", "exact"}).out) == 0);
}

TEST_CASE("pixel follows the view: stage, settings, size and scene") {
    CHECK_THAT(run({"pixel", "126,126", "--stage", "edges"}).out,
               ContainsSubstring("stage edges: 10 marks.\n") &&
                   ContainsSubstring("  0  t3/e1/s125 "));
    CHECK_THAT(run({"pixel", "240,300", "--stage", "rows"}).out,
               ContainsSubstring("draws only the two ends of each row"));
    const std::string fill = run({"pixel", "240,300", "--stage", "fill"}).out;
    CHECK(count_of("written", fill) == 3);
    CHECK_THAT(fill, ContainsSubstring("t23/r80/c8"));
    const std::string bench = lessons_folder() + "/scenes/one-triangle.toml";
    CHECK_THAT(run({"pixel", "9,8", "--scene", bench, "--stage", "fill"}).out,
               ContainsSubstring("t0/r3/c2 "));
    CHECK(run({"pixel", "640,3", "--size", "641x20"}).exit_code == 0);
}

TEST_CASE("pixel without a pixel of the picture is wrong usage, and says which pixels exist") {
    for (const char* outside : {"500,0", "0,500", "-1,3", "3,-1", "2147483647,0"}) {
        const CliRun result = run({"pixel", outside});
        INFO(outside);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK(result.err == "rasterwalk: there is no pixel " + std::string(outside) +
                                ": the picture has columns 0 to 499, rows 0 to 499.\n");
    }
    for (const char* nonsense :
         {"", "3", "3,", ",3", "3,4,5", "3;4", "a,b", "1.5,2", "3, 4x", "99999999999,1"}) {
        const CliRun result = run({"pixel", nonsense});
        INFO(nonsense);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK_THAT(result.err, ContainsSubstring("is not a pixel. Write it as COLUMN,ROW"));
    }
    CHECK(run({"pixel"}).exit_code == 2);
    CHECK_THAT(run({"pixel", "40,3", "--size", "40x30"}).err,
               ContainsSubstring("columns 0 to 39, rows 0 to 29"));
}

TEST_CASE("pixel says which of its tests have been done at the moment") {
    const std::string bench = lessons_folder() + "/scenes/one-triangle.toml";
    const auto output = [&](const std::string& moment, const std::string& form) {
        return without_blanks(run({"pixel", "9,8", "--scene", bench, "--stage", "fill", "--set",
                                   "coverage=edge_functions", "--to", moment, form})
                                  .out);
    };
    CHECK(count_of("\"asked\":false", output("t0/v0", "--json")) == 1);
    CHECK(count_of("\"asked\":true", output("end", "--json")) == 1);
    const std::string text = run({"pixel", "9,8", "--scene", bench, "--stage", "fill", "--set",
                                  "coverage=edge_functions", "--to", "t0/v0"})
                                 .out;
    CHECK_THAT(text, ContainsSubstring("  not tested yet\n"));
    CHECK(count_of("not tested yet", run({"pixel", "9,8", "--scene", bench, "--stage", "fill",
                                          "--set", "coverage=edge_functions"})
                                         .out) == 0);
}

TEST_CASE("pixel lists the texels that a pixel took, with weights, footprint and level") {
    const std::string scene = lessons_folder() + "/scenes/receding-wall.toml";
    const std::vector<std::string> asked{"pixel",   "100,70",
                                         "--scene", scene,
                                         "--set",   "coverage=edge_functions",
                                         "--set",   "texture_filter=bilinear"};
    const CliRun result = run(asked);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    // u = 1/3 and v = 1/2 - 1/9 of 8 texels are 2.6667 and 3.1111: 1/6 beyond the centre 2.5, and
    // 0.6111 beyond the centre 2.5.
    CHECK_THAT(
        result.out,
        ContainsSubstring("texture textures/checkerboard.png: u 0.333333, v 0.388889; reaches "));
    CHECK_THAT(result.out, ContainsSubstring("level 0.0000."));
    CHECK_THAT(result.out,
               ContainsSubstring("  level 0  column    2  row    2  weight 0.324074  0.9216 "
                                 "0.9098 0.8706\n"));
    CHECK_THAT(result.out,
               ContainsSubstring("  level 0  column    3  row    2  weight 0.064815  0.1725 "
                                 "0.2588 0.4314\n"));
    CHECK(count_of("  level 0  column", result.out) == 4);
    std::vector<std::string> as_json = asked;
    as_json.push_back("--json");
    const std::string json = without_blanks(run(as_json).out);
    CHECK_THAT(json, ContainsSubstring("\"texture\":{\"colour\":["));
    CHECK_THAT(json, ContainsSubstring("\"level\":0.0,\"name\":\"textures/checkerboard.png\""));
    CHECK(count_of("\"weight\":", json) == 4);
    CHECK(count_of("\"texture\":", without_blanks(run({"pixel", "240,300", "--json"}).out)) == 0);
}

TEST_CASE("pixel gives the shift of a height map as JSON and with its formulas") {
    const std::vector<std::string> asked{"pixel",   "200,136",
                                         "--scene", lessons_folder() + "/scenes/brick-heights.toml",
                                         "--set",   "coverage=edge_functions"};
    const auto with = [&](const std::string& word, const char* option) {
        std::vector<std::string> all = asked;
        all.insert(all.end(), {"--set", word, option});
        return run(all).out;
    };
    const std::string json = without_blanks(with("parallax=divided", "--json"));
    CHECK_THAT(json, ContainsSubstring("\"parallax\":{\"height\":-0.0"));
    for (const char* const key : {"shift_u", "shift_v", "step_t", "unshifted_u", "view"})
        CHECK(count_of(std::string("\"") + key + "\":", json) == 1);
    CHECK_THAT(with("parallax=divided", "--formulas"),
               ContainsSubstring("height h = texel · scale + bias = 0 · 0.06 + (−0.06) = −0.06\n"));
    CHECK(count_of("\"parallax\":", without_blanks(with("parallax=off", "--json"))) == 0);
}

TEST_CASE("A scene whose texture is missing ends with 3, file and line") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "s.toml", "name = \"s\"\n[points.p]\nA = [0, 0, 1]\nB = [1, 0, 1]\nC = [1, 1, 1]\n"
                  "[[part]]\nname = \"q\"\npoints = \"p\"\ntriangles = [\"A B C\"]\n"
                  "texture = \"none.png\"\ntexcoords = [[[0, 0], [1, 0], [1, 1]]]\n");
    const CliRun result = run({"stats", "--scene", path});
    CHECK(result.exit_code == 3);
    CHECK(result.out.empty());
    CHECK_THAT(result.err,
               ContainsSubstring(path + ":10: the texture 'none.png' cannot be used: "));
}

TEST_CASE("pixel says whether the lamp's light arrives, and what blocks it") {
    CHECK_THAT(
        run({"pixel", "400,450", "--set", "shadows=rays"}).out,
        ContainsSubstring("\nIn shadow: triangles[12] (short block) is in between, 0.20 of the way "
                          "to the lamp."
                          "\n"));
    CHECK_THAT(run({"pixel", "60,300", "--set", "shadows=rays"}).out,
               ContainsSubstring("\nLit: nothing is between here and the lamp.\n"));
    CHECK_THAT(run({"pixel", "400,450", "--set", "shadows=map"}).out,
               ContainsSubstring(
                   "\nIn shadow: the lamp saw as far as 0.9054; this is at 1.5000 − 0.0500 (face "
                   "+y, column 383, row 224)."
                   "\n"));
    CHECK(count_of("shadow", run({"pixel", "400,450"}).out) == 0);
    const std::string ray =
        without_blanks(run({"pixel", "400,450", "--set", "shadows=rays", "--json"}).out);
    CHECK_THAT(ray,
               ContainsSubstring("\"shadow\":{\"asked\":true,\"lit\":0.0,\"name\":\"shortblock\","
                                 "\"triangle\":12,\"way\":0.20"));
    const std::string map =
        without_blanks(run({"pixel", "400,450", "--set", "shadows=map", "--json"}).out);
    CHECK_THAT(map, ContainsSubstring("\"face\":\"+y\""));
    CHECK_THAT(
        map, ContainsSubstring("\"texels\":[{\"column\":383,\"lit\":false,\"row\":224,\"z\":0.90"));
}

TEST_CASE("pixel --formulas explains the fragment that stays, section by section") {
    const std::string text = run({"pixel", "240,300", "--formulas"}).out;
    CHECK_THAT(text, ContainsSubstring("\n\nvalues\n  column = left + i = "));
    CHECK_THAT(text, ContainsSubstring("\npixel light: lamp\n  r² = r.x² + r.y² + r.z² = "));
    CHECK_THAT(text, ContainsSubstring("\n  z affine = accumulate(left, "));
    CHECK_THAT(text, ContainsSubstring("\n  z perspective = 1 / (1/z) = "));
    CHECK_THAT(text, ContainsSubstring("\n  D = P · (cosine / area) = "));
    CHECK_THAT(text,
               ContainsSubstring("\ndepth\n  margin: new − stored = 0.3295 − 0.2499 = 0.07953\n"));
    // What you only get to from other numbers is not listed.
    CHECK_THAT(text, !ContainsSubstring("r.x = "));
    CHECK_THAT(text, ContainsSubstring("\nvertex light: reflected, not in use\n"));
    CHECK_THAT(text, ContainsSubstring("\npixel light: colour\n  red = clamp(R, 0, 1) = "));
    CHECK(run({"pixel", "0,0", "--formulas", "--stage", "points"})
              .out.ends_with("\nNo fragment stays.\n"));
}

TEST_CASE("pixel --json --formulas adds each formula to what --json prints") {
    const std::string plain = run({"pixel", "240,300", "--json"}).out;
    const std::string json = run({"pixel", "240,300", "--json", "--formulas"}).out;
    const std::string formulas = without_blanks(json);
    CHECK_THAT(formulas, ContainsSubstring("\"id\":\"pixel_light.r.x\""));
    CHECK_THAT(formulas, ContainsSubstring("\"section\":\"pixel_light.lamp\""));
    CHECK_THAT(formulas,
               ContainsSubstring("{\"formula\":\"pixel_light.cosine\",\"symbol\":\"cosine\""));
    CHECK_THAT(formulas, ContainsSubstring("{\"from\":\"settinglight.power\",\"symbol\":\"P\""));
    // All that comes before the formulas, without the end of the object.
    const std::string before = plain.substr(0, plain.rfind("\n}"));
    CHECK(json.starts_with(before));
}
