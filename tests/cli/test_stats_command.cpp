// The counts of `rasterwalk stats` for rejecting, clipping and culling, compared with counts made
// another way, in double from the scene's own corners; and the times that it measures.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/clip_oracle.h"
#include "support/oracle.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// What stats prints about the frame, counted without the stages that reject, clip and cull.
struct Counts {
    int rejected = 0, clipped = 0, clip_triangles = 0, culled = 0;
    std::int64_t fragments_outside = 0;
};

/// A place in clip space; the camera turns about the y axis alone.
glm::dvec4 clip_place(const glm::vec3& world, const Settings& settings) {
    const glm::dvec3 way = glm::dvec3(world) - glm::dvec3(settings.camera.position);
    const double c = std::cos(static_cast<double>(settings.camera.yaw));
    const double s = std::sin(static_cast<double>(settings.camera.yaw));
    const double f = settings.camera.focal_length;
    return {f * (c * way.x - s * way.z), f * way.y, 1.0, s * way.x + c * way.z};
}

/// Are all three beyond the same plane, the sides two pixels farther out?
bool is_beyond_one(const std::array<glm::dvec4, 3>& corners, const Settings& settings) {
    const double x = settings.viewport.width / 2 + 2, y = settings.viewport.height / 2 + 2;
    const glm::dvec4 planes[] = {{0, 0, -static_cast<double>(settings.near), 1},
                                 {0, 0, static_cast<double>(settings.far), -1},
                                 {1, 0, 0, x},
                                 {-1, 0, 0, x},
                                 {0, 1, 0, y},
                                 {0, -1, 0, y}};
    return std::any_of(std::begin(planes), std::end(planes), [&](const glm::dvec4& plane) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const glm::dvec4& corner) { return glm::dot(plane, corner) < 0.0; });
    });
}

bool is_back(const Scene& scene, int triangle, const Settings& settings) {
    const Vertex& corner = scene.corner(triangle, 0);
    return glm::dot(glm::dvec3(corner.normal),
                    glm::dvec3(corner.position) - glm::dvec3(settings.camera.position)) > 0.0;
}

/// The fragments of a polygon's row table, by its definition, that are outside the picture.
std::int64_t outside_of(PolygonCorners polygon, const Viewport& picture) {
    int ignored = 0;
    std::int64_t outside = 0;
    for (const auto& [row, ends] : row_table(polygon, {}, ignored)) {
        if (ends.left > ends.right) continue;
        const bool is_row_inside = row >= 0 && row < picture.height;
        const int left = std::max(ends.left, 0), right = std::min(ends.right, picture.width - 1);
        const int inside = is_row_inside ? std::max(right - left + 1, 0) : 0;
        outside += ends.right - ends.left + 1 - inside;
    }
    return outside;
}

Counts count_again(const Scene& scene, const Settings& settings) {
    const Frame frame = prepare_frame(scene, settings); // for the pixels of its corners
    Counts counts;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<glm::dvec4, 3> corners;
        for (int v = 0; v < 3; ++v)
            corners[static_cast<std::size_t>(v)] =
                clip_place(scene.corner(t, v).position, settings);
        if (settings.reject != Reject::none && is_beyond_one(corners, settings)) {
            ++counts.rejected;
            continue;
        }
        const OracleClip left = oracle_clip(corners, oracle_planes(settings, scene.space));
        REQUIRE(left.least > 1e-6); // or rounding decides
        if (left.is_gone) continue;
        counts.clipped += left.is_cut ? 1 : 0;
        counts.clip_triangles += static_cast<int>(left.corners.size()) - 2;
        if (settings.cull == Cull::face_normal && is_back(scene, t, settings)) {
            ++counts.culled;
            continue;
        }
        if (settings.reject != Reject::cheap)
            counts.fragments_outside += outside_of(frame.triangle_vertices(t), settings.viewport);
    }
    return counts;
}

/// A clock that moves on by a given step each time it is read, milliseconds.
Clock steady_clock(double step) {
    return [now = 0.0, step]() mutable { return now += step; };
}

} // namespace

TEST_CASE("stats counts what is rejected, clipped, culled and outside, as a second count does") {
    struct View {
        const char *scene, *position, *yaw;
    };
    constexpr View views[] = {{"corridor", "0.05,0.1,0.33", "0.61"},
                              {"corridor", "-0.4,-0.3,4.1", "-1.9"},
                              {"lab-room", "0.1,0.05,-1.23", "0.27"},
                              {"lab-room", "-0.31,0.2,-0.57", "2.53"},
                              {"outcodes", "0.03,0.02,0.01", "0.04"}};
    constexpr const char* rules[][3] = {{"reject=none", "clip=near", "cull=none"},
                                        {"reject=outcodes", "clip=all", "cull=face_normal"},
                                        {"reject=outcodes", "clip=near", "cull=face_normal"},
                                        {"reject=none", "clip=guard_band", "cull=face_normal"},
                                        {"reject=cheap", "clip=near", "cull=none"}};
    Counts sum;
    for (const View& view : views) {
        const std::string path = lessons_folder() + "/scenes/" + view.scene + ".toml";
        const Scene scene = read_scene(path);
        for (const auto& rule : rules) {
            std::vector<std::string> arguments{"stats", "--json",  "--scene",
                                               path,    "--stage", "depth"};
            Settings settings = default_settings(scene);
            set_step(settings, {Stage::depth, Shading::unlit});
            for (const std::string& assignment :
                 // Small, since near corners are thousands of pixels away from large pictures.
                 {std::string("viewport.size=60x60"), std::string("camera.focal_length=60"),
                  std::string("camera.position=") + view.position,
                  std::string("camera.yaw=") + view.yaw, std::string(rule[0]), std::string(rule[1]),
                  std::string(rule[2])}) {
                set_from_text(settings, assignment);
                arguments.insert(arguments.end(), {"--set", assignment});
            }
            CAPTURE(view.scene, view.position, rule[0], rule[1], rule[2]);
            const CliRun result = run(arguments);
            REQUIRE(result.exit_code == 0);
            const auto output = nlohmann::json::parse(result.out);
            const Counts counts = count_again(scene, settings);
            CHECK(output["rejected"] == counts.rejected);
            CHECK(output["clipped"] == counts.clipped);
            CHECK(output["clip_triangles"] == counts.clip_triangles);
            CHECK(output["culled"] == counts.culled);
            CHECK(output["fragments_outside"] == counts.fragments_outside);
            sum.rejected += counts.rejected;
            sum.clipped += counts.clipped;
            sum.culled += counts.culled;
            sum.fragments_outside += counts.fragments_outside;
        }
    }
    CHECK(sum.rejected > 10);
    CHECK(sum.clipped > 50);
    CHECK(sum.culled > 20);
    CHECK(sum.fragments_outside > 100'000);
}

TEST_CASE("The help of stats says what each of its numbers counts") {
    const std::string help = run({"stats", "--help"}).out;
    const auto output = nlohmann::json::parse(run({"stats", "--json"}).out);
    for (const auto& [name, value] : output.items()) {
        CAPTURE(name);
        CHECK_THAT(help, ContainsSubstring("\n  " + name + " "));
    }
    CHECK_THAT(help, ContainsSubstring("--time"));
}

TEST_CASE("stats --time shows how much each way of culling saves") {
    const std::vector<std::string> arguments{
        "stats", "--time", "--set", "viewport.size=100x100", "--set", "camera.focal_length=100"};
    std::vector<std::string> as_json = arguments;
    as_json.emplace_back("--json");
    const auto json = nlohmann::json::parse(run(as_json, steady_clock(0.5)).out);
    const auto& times = json["culling_times"];
    const auto& ways = times["ways"];
    constexpr const char* names[] = {"none", "face_normal", "screen_area", "vertex_normals",
                                     "fragment_normal"};
    REQUIRE(ways.size() == std::size(names));
    CHECK(times["draws"] == 31); // less than a second in all
    for (std::size_t i = 0; i < ways.size(); ++i) {
        CAPTURE(names[i]);
        CHECK(ways[i]["cull"] == names[i]);
        CHECK(ways[i]["milliseconds"] == 0.5);
        CHECK(ways[i]["share"] == 1.0);
        // The counts are the same as without a comparison.
        std::vector<std::string> alone = arguments;
        alone.erase(alone.begin() + 1);
        alone.insert(alone.end(), {"--json", "--set", std::string("cull=") + names[i]});
        const auto output = nlohmann::json::parse(run(alone).out);
        for (const char* count : {"culled", "fragments", "shaded"})
            CHECK(ways[i][count] == output[count]);
    }
    CHECK(ways[1]["culled"] == 10);
    const auto& measures = json["measures"];
    CHECK(measures["draws"] == 31);
    REQUIRE(measures["ways"].size() == 15);
    for (const auto& way : measures["ways"]) {
        CHECK(way["milliseconds"] == 0.5);
        if (way["measure"] != "cull") continue;
        const auto same = std::find_if(ways.begin(), ways.end(), [&](const auto& culled) {
            return culled["cull"] == way["way"];
        });
        REQUIRE(same != ways.end());
        CHECK((*same)["fragments"] == way["fragments"]);
        CHECK((*same)["culled"] == way["left_out"]);
    }
    const CliRun text = run(arguments, steady_clock(200.0));
    CHECK(text.exit_code == 0);
    for (const char* name : names)
        CHECK_THAT(text.out, ContainsSubstring("\n" + std::string(name) + " "));
    for (const char* name : {"before_depth_test", "near_first", "outcodes", "on", "draw_order"})
        CHECK_THAT(text.out, ContainsSubstring("\n" + std::string(name) + " "));
    CHECK_THAT(text.out, ContainsSubstring("200.000"));
    CHECK_THAT(text.out, ContainsSubstring("1.000"));
}

TEST_CASE("Without a clock nothing can be measured, and stats says so") {
    const CliRun result = run({"stats", "--time"});
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, ContainsSubstring("clock"));
}
