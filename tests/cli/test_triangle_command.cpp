#include <algorithm>
#include <climits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "inspect/triangle_report.h"
#include "session/content.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string bench_file = lessons_folder() + "/scenes/one-triangle.toml";

std::string json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"triangle", "--json"});
    const CliRun result = run(arguments);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return without_blanks(result.out);
}

/// From a key's value to the end of the list that it is.
std::string list_of(const std::string& json, const std::string& key) {
    const std::size_t begin = json.find("\"" + key + "\":[");
    if (begin == std::string::npos) return "no " + key;
    std::size_t at = begin + key.size() + 3;
    int depth = 0;
    do {
        depth += json[at] == '[' ? 1 : json[at] == ']' ? -1 : 0;
        ++at;
    } while (depth > 0 && at < json.size());
    return json.substr(begin, at - begin);
}

} // namespace

TEST_CASE("triangle prints the bench triangle's vertices, edges and rows in words") {
    const CliRun result = run({"triangle", "0", "--scene", bench_file});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, ContainsSubstring("triangles[0] of 1 (triangle)\n"));
    CHECK_THAT(result.out, ContainsSubstring("  pixel          column            10             5"
                                             "            15\n"));
    CHECK_THAT(result.out, ContainsSubstring("  edge 0 from (10,5) to (5,10): 6 samples\n"
                                             "  edge 1 from (5,10) to (15,15): 11 samples\n"
                                             "  edge 2 from (15,15) to (10,5): 11 samples\n"));
    CHECK_THAT(result.out, ContainsSubstring("Samples outside the row table: 0\n"));
    CHECK_THAT(
        result.out,
        ContainsSubstring("     5         10         10       1   e0/s0                  e0/s0\n"));
    // The bench_file has no camera.
    CHECK_THAT(result.out, !ContainsSubstring("minus camera"));
}

TEST_CASE("triangle --json has the rows of rows --json") {
    const std::string rows = without_blanks(run({"rows", "--json", "10,5", "5,10", "15,15"}).out);
    const std::string triangle = json_of({"0", "--scene", bench_file});
    CHECK(list_of(triangle, "rows") == list_of(rows, "rows"));
    CHECK_THAT(list_of(rows, "rows"), ContainsSubstring("\"row\":15"));
    CHECK(list_of(triangle, "outside") == "\"outside\":[]");
}

TEST_CASE("triangle --json lists every sample with what it wrote") {
    const std::string json = json_of({"0", "--scene", bench_file});
    CHECK_THAT(json, ContainsSubstring("{\"count\":6,\"edge\":0,\"from\":[10,5],\"samples\":["
                                       "{\"column\":10,\"row\":5,\"sample\":0,\"wrote\":\"both\","
                                       "\"x\":10.0,\"y\":5.0},"));
    CHECK_THAT(json, ContainsSubstring("{\"column\":6,\"row\":10,\"sample\":1,\"wrote\":\"right\","
                                       "\"x\":6.0,\"y\":10.5}"));
    CHECK_THAT(json, ContainsSubstring("\"wrote\":\"nothing\""));
}

TEST_CASE("triangle --json gives the vertices through the spaces") {
    const std::string json = json_of({"20", "--set", "stage=rows"});
    CHECK_THAT(json, ContainsSubstring("\"triangle\":20"));
    CHECK_THAT(json, ContainsSubstring("\"name\":\"tallblock\""));
    for (const char* key : {"world", "minus_camera", "rotated", "projected", "pixel", "zinv"})
        CHECK_THAT(json, ContainsSubstring(std::string("\"").append(key).append("\":")));
    CHECK_THAT(json, ContainsSubstring("\"pixel\":[160,218]"));
}

TEST_CASE("triangle shows every space with its matrix if vertices go through matrices") {
    const CliRun rows = run({"triangle", "0", "--set", "transform=matrices"});
    INFO(rows.err);
    CHECK(rows.exit_code == 0);
    CHECK_THAT(rows.out, ContainsSubstring("Spaces: window = (p · Tm · Tv · Tp) / w · Ts"));
    CHECK_THAT(rows.out, ContainsSubstring("  Tv, to camera space\n"));
    // Row vectors: the translation is in the last row.
    CHECK_THAT(rows.out,
               ContainsSubstring("         0.0000      0.0000      3.0010      1.0000\n"));
    CHECK_THAT(rows.out, !ContainsSubstring("-0.0000"));
    const std::string conventions = "Conventions: vertices[0] by the lab's projection";
    REQUIRE_THAT(rows.out, ContainsSubstring(conventions));
    // They are the lab's, whatever else is drawn.
    const CliRun boxed = run(
        {"triangle", "0", "--set", "transform=matrices", "--set", "view_box=-0.05,0.1,-0.05,0.05"});
    REQUIRE_THAT(boxed.out, ContainsSubstring(conventions));
    CHECK(boxed.out.substr(boxed.out.find(conventions)) ==
          rows.out.substr(rows.out.find(conventions)));
    CHECK(boxed.out != rows.out);
    CHECK_THAT(rows.out,
               ContainsSubstring("Y up in the world and rows counted from the bottom cancel each "
                                 "other out."));
    const CliRun columns = run(
        {"triangle", "0", "--set", "transform=matrices", "--set", "matrix_order=column_vectors"});
    CHECK_THAT(columns.out, ContainsSubstring("Spaces: window = Ts · (Tp · Tv · Tm · p) / w"));
    CHECK_THAT(columns.out,
               ContainsSubstring("         0.0000      0.0000      1.0000      3.0010\n"));
    const std::string json = json_of({"0", "--set", "transform=matrices"});
    CHECK_THAT(json, ContainsSubstring("\"matrix_name\":\"Tp\""));
    CHECK_THAT(json, ContainsSubstring("\"space\":\"ndc\""));
    CHECK_THAT(json, ContainsSubstring("\"cancelling\":["));
    // The lab has no matrices.
    CHECK_THAT(run({"triangle", "0"}).out, !ContainsSubstring("Spaces"));
    CHECK_THAT(json_of({"0"}), !ContainsSubstring("\"spaces\""));
}

TEST_CASE("A triangle with samples outside names them") {
    // The room has four; find one of them by its report.
    int found = 0;
    for (int t = 0; t < 30 && found == 0; ++t) {
        const std::string json = json_of({std::to_string(t)});
        if (list_of(json, "outside") == "\"outside\":[]") continue;
        ++found;
        CHECK_THAT(json, ContainsSubstring("\"wrote\":\"outside\""));
        const CliRun text = run({"triangle", std::to_string(t)});
        CHECK_THAT(text.out, ContainsSubstring("Samples outside the row table: 1\n  e"));
        CHECK_THAT(text.out, ContainsSubstring("; it is not written\n"));
    }
    CHECK(found == 1);
}

TEST_CASE("triangle --to stops in the middle of the row table") {
    const CliRun text = run({"triangle", "0", "--scene", bench_file, "--to", "t0/e1/s2"});
    CHECK_THAT(text.out,
               ContainsSubstring("edge 1 from (5,10) to (15,15): 11 samples, 2 of them so far\n"));
    CHECK_THAT(text.out, ContainsSubstring("    15   +INT_MAX   -INT_MAX       0   -"));
    const std::string json = json_of({"0", "--scene", bench_file, "--to", "t0/e1/s2"});
    CHECK_THAT(json, ContainsSubstring("\"edge\":2,\"from\":[15,15],\"samples\":[],"));
    const std::string nothing = json_of({"3", "--to", "t2/e1/s2"});
    CHECK_THAT(nothing, ContainsSubstring("\"samples\":[],"));
    CHECK_THAT(nothing, !ContainsSubstring("\"wrote\""));
}

TEST_CASE("The report of a cut or culled triangle has every plane and edge, and the answer") {
    const std::vector<std::string> cut{"--set", "camera.position=0,0,-0.9", "--set", "clip=near"};
    // Corner 0 is at z = 1.9, the others 0.1 behind the camera: 1.8 of 2.0 up to the plane.
    const CliRun text = run({"triangle", "0", cut[0], cut[1], cut[2], cut[3]});
    CHECK(text.exit_code == 0);
    CHECK_THAT(text.out,
               ContainsSubstring(
                   "\nClipping"
                   "\n  near plane: 3 corners before, 3 after"
                   "\n    edge 0: corner 0 is inside and kept, the edge leaves at t = 0.9000: ("));
    CHECK_THAT(text.out,
               ContainsSubstring("    edge 1: corner 1 is outside and left out\n    edge 2: corner "
                                 "2 is outside and left out, the edge enters at t = 0.9000: ("));
    CHECK_THAT(text.out, ContainsSubstring(")\n  drawn as 1 triangle\n"));
    CHECK_THAT(text.out, !ContainsSubstring("Culling"));
    const std::string json = json_of({"0", cut[0], cut[1], cut[2], cut[3]});
    CHECK_THAT(json, ContainsSubstring("\"plane\":\"near\",\"steps\":[{\"cut\":["));
    CHECK_THAT(json, ContainsSubstring("\"outcodes\":[\"inside\",\"near\",\"near\"]"));
    CHECK_THAT(json, ContainsSubstring("\"cull\":null"));
    CHECK_THAT(json, ContainsSubstring("\"triangles\":1"));
    const std::vector<std::string> culled{"--set", "camera.position=0,5,-3", "--set",
                                          "cull=face_normal"};
    const CliRun back = run({"triangle", "0", culled[0], culled[1], culled[2], culled[3]});
    CHECK_THAT(back.out,
               ContainsSubstring("\nCulling\n  culls: dot(n, p - C) = 4, the normal points away "
                                 "from the camera\n"));
    CHECK_THAT(back.out, ContainsSubstring("It is left out: it faces away from the camera.\n"));
    CHECK_THAT(json_of({"0", culled[0], culled[1], culled[2], culled[3]}),
               ContainsSubstring("\"cull\":{\"culled\":true,"));
    // If nothing cuts and nothing culls, there is nothing to report.
    const CliRun plain = run({"triangle", "0"});
    CHECK_THAT(plain.out, !ContainsSubstring("Clipping"));
    CHECK_THAT(plain.out, !ContainsSubstring("Culling"));
    CHECK_THAT(json_of({"0"}), ContainsSubstring("\"planes\":[]"));
}

TEST_CASE("A triangle's cost is its own, drawn over what is there") {
    const std::vector<std::string> small{"--size", "100x100"};
    std::int64_t fragments = 0, written = 0;
    for (int t = 0; t < 30; ++t) {
        std::vector<std::string> arguments{std::to_string(t)};
        arguments.insert(arguments.end(), small.begin(), small.end());
        arguments.insert(arguments.begin(), {"triangle", "--json"});
        const auto json = nlohmann::json::parse(run(arguments).out);
        const auto& cost = json["cost"];
        CHECK(cost["depth_tests"] == cost["fragments"]);
        CHECK(cost["pixel_lights"] == cost["written"]);
        CHECK_FALSE(cost.contains("vertices"));
        fragments += cost["fragments"].get<std::int64_t>();
        written += cost["written"].get<std::int64_t>();
    }
    const auto stats = nlohmann::json::parse(run({"stats", "--json", "--size", "100x100"}).out);
    CHECK(fragments == stats["fragments"]);
    CHECK(written == stats["shaded"]);
    CHECK_THAT(run({"triangle", "12"}).out, ContainsSubstring("\nCost\n  edge samples "));
}

TEST_CASE("A triangle that is left out says why, and still has its vertices") {
    const std::vector<std::string> view{"--set", "camera.position=0,0,0"};
    const CliRun text = run({"triangle", "0", view[0], view[1]});
    CHECK(text.exit_code == 0);
    CHECK_THAT(text.out,
               ContainsSubstring("It is left out: a vertex lies on or behind the camera plane.\n"));
    const std::string json = json_of({"0", view[0], view[1]});
    CHECK_THAT(json, ContainsSubstring("\"left_out\":\"behind_camera\""));
    CHECK_THAT(json, ContainsSubstring("\"edges\":[]"));
    CHECK_THAT(json, ContainsSubstring("\"rows\":[]"));
}

TEST_CASE("A triangle that does not exist is wrong usage, and the message says which do") {
    const auto complaint = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "triangle");
        const CliRun result = run(arguments);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        return result.err;
    };
    CHECK(complaint({"30"}) ==
          "rasterwalk: there is no triangle 30: the scene has triangles 0 to 29.\n");
    CHECK(complaint({"-1"}) ==
          "rasterwalk: there is no triangle -1: the scene has triangles 0 to 29.\n");
    CHECK(complaint({"99999999999999999999"}) ==
          "rasterwalk: there is no triangle 99999999999999999999: the scene has triangles 0 to 29."
          "\n");
    CHECK(complaint({"1", "--scene", bench_file}) ==
          "rasterwalk: there is no triangle 1: the scene has only triangle 0.\n");
    for (const char* word : {"t0", "1.5", "", "0x1", "1 2"}) {
        CAPTURE(word);
        CHECK_THAT(complaint({word}), ContainsSubstring("is not the number of a triangle"));
    }
    CHECK_THAT(complaint({}), ContainsSubstring("N is required"));
}

TEST_CASE("A triangle's report is the row table built at once, sample by sample") {
    const Scene scene = small_scene();
    for (const Variant& variant : rule_variants()) {
        Settings settings = default_settings(scene);
        variant.apply(settings);
        const Frame frame = prepare_frame(scene, settings);
        CAPTURE(variant.name);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            CAPTURE(t);
            // A new table: rows that no sample reaches have only their columns emptied.
            PolygonRows direct;
            const TriangleReport report = triangle_report(frame, t);
            CHECK(report.rejection == frame.rejection(t));
            if (!frame.is_drawn(t)) {
                CHECK(report.rows.rows.size() == 0);
                continue;
            }
            compute_polygon_rows(frame.triangle_vertices(t), settings, direct);
            CHECK(report.rows.rows.left == direct.left);
            CHECK(report.rows.rows.right == direct.right);
            int samples = 0;
            std::size_t outside = 0;
            for (const EdgeReport& edge : report.edges) {
                CHECK(static_cast<int>(edge.samples.size()) == edge.count);
                for (const EdgeSample& step : edge.samples) {
                    // The table made up to this sample has it as its last.
                    const RowHistory until = row_history(
                        frame.triangle_vertices(t), edge_rules(settings), frame.stages, ++samples);
                    REQUIRE(until.last);
                    if (!(until.last->write == step.write) || until.last->x != step.x ||
                        until.last->y != step.y || !(until.last->fragment == step.fragment)) {
                        FAIL("edge " << step.edge << ", sample " << step.sample);
                    }
                    outside += step.write.inside ? 0 : 1;
                }
            }
            CHECK(outside == report.rows.outside.size());
        }
    }
}

TEST_CASE("Lines that make decisions have them in the JSON, and others have none") {
    const std::string lab = json_of({"0", "--scene", bench_file});
    CHECK_THAT(lab, !ContainsSubstring("\"decision\""));
    // Edge 1, from (5,10) to (15,15): l = 10, s = 5, so that d begins at 0.
    const std::string lines =
        json_of({"0", "--scene", bench_file, "--set", "line=bresenham", "--to", "t0/e1/s1"});
    CHECK_THAT(lines, ContainsSubstring("{\"column\":5,\"decision\":0.0,\"row\":10,\"sample\":0,"
                                        "\"step\":\"diagonal\""));
}

TEST_CASE("triangle shows its polygon as a row table and a fan cover it") {
    const std::string dented = lessons_folder() + "/scenes/dented.toml";
    const std::vector<std::string> rules{"--set", "coverage=edge_functions", "--set",
                                         "fill_rule=top_left"};
    std::vector<std::string> left{"triangle", "1", "--scene", dented};
    left.insert(left.end(), rules.begin(), rules.end());
    CHECK_THAT(run(left).out,
               ContainsSubstring("\nPolygon of 5 corners, 144 square pixels"
                                 "\n  inside, by active edges: 136 pixels"
                                 "\n  row table: 176 pixels; 5 of 11 rows reach outside"
                                 "\n  fan: 192 pixels, covered 248 times in all; 240 square pixels"
                                 "\n"));
    std::vector<std::string> right{"4", "--scene", dented};
    right.insert(right.end(), rules.begin(), rules.end());
    CHECK_THAT(json_of(right),
               ContainsSubstring(
                   "\"polygon\":{\"area\":144.0,\"corners\":5,\"fan\":136,\"fan_area\":144.0,"
                   "\"fan_laid\":136,\"inside\":136,\"rows\":11,\"table\":176,"
                   "\"wrong_rows\":5}"));
    CHECK_THAT(run({"triangle", "0", "--scene", bench_file}).out, !ContainsSubstring("Polygon"));
}

TEST_CASE("triangle shows the edges shared with a neighbour under each fill rule") {
    const std::string square = lessons_folder() + "/scenes/shared-edge.toml";
    CHECK_THAT(run({"triangle", "0", "--scene", square, "--set", "coverage=scan_conversion"}).out,
               ContainsSubstring("\nShared edges\n"
                                 "  edge 2, edge 0 of triangles[1]\n"
                                 "    inclusive: 9 pixels drawn twice, 0 holes\n"
                                 "    exclusive: 0 pixels drawn twice, 7 holes\n"
                                 "    top_left:  0 pixels drawn twice, 0 holes\n"));
    CHECK_THAT(
        json_of({"1", "--scene", square, "--set", "coverage=edge_functions"}),
        ContainsSubstring("\"shared_edges\":[{\"edge\":0,\"neighbour\":0,\"neighbour_edge\":2,"
                          "\"rules\":[{\"holes\":0,\"rule\":\"inclusive\",\"twice\":9},"
                          "{\"holes\":7,\"rule\":\"exclusive\",\"twice\":0},"
                          "{\"holes\":0,\"rule\":\"top_left\",\"twice\":0}]}]"));
    // The lab's rows have no fill rule.
    CHECK_THAT(run({"triangle", "0", "--scene", square}).out, !ContainsSubstring("Shared"));
    CHECK_THAT(json_of({"0", "--scene", square}), !ContainsSubstring("shared_edges"));
}

TEST_CASE("triangle --formulas explains each of its vertices") {
    const std::string text = run({"triangle", "21", "--formulas"}).out;
    for (const char* const vertex : {"vertices[0]", "vertices[1]", "vertices[2]"})
        CHECK_THAT(text,
                   ContainsSubstring(std::string("\n") + vertex + "\nvertex\n  world x = v = "));
    CHECK_THAT(text, ContainsSubstring("\n  1/z = 1 / z = 1 / "));
    const std::string json = without_blanks(run({"triangle", "21", "--formulas", "--json"}).out);
    CHECK_THAT(json, ContainsSubstring("\"formulas\":[{\"formulas\":[{\"expression\":\"v\""));
    CHECK_THAT(json, ContainsSubstring("\"id\":\"light.R.blue\""));
}
