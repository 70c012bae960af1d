// Colours of a model's points, in the ways that programs write them, and in the picture, where a
// ray finds the weights of the corners.

#include <algorithm>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "engines/fast/fast_view.h"
#include "pipeline/draw.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "support/fast_pictures.h"
#include "support/ray_caster.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {
namespace coloured_points {

const std::vector<std::string> places{"v -1 -1 0", "v 1 -1 0", "v 0 1 0"};

/// A triangle whose points have these texts after their coordinates.
std::string triangle_with(const std::vector<std::string>& behind) {
    std::string text;
    for (std::size_t i = 0; i < places.size(); ++i)
        text += places[i] + " " + behind[i] + "\n";
    return text + "f 1 2 3\n";
}

std::vector<glm::vec3> colours_of(const ObjModel& model) {
    std::vector<glm::vec3> colours;
    for (int corner = 0; corner < 3; ++corner)
        colours.push_back(model.mesh.corner(0, corner).reflectance);
    return colours;
}

std::vector<glm::vec3> colours_with(const std::vector<std::string>& behind) {
    const ObjModel model = parse_obj(triangle_with(behind), "m.obj");
    CHECK(model.report.counts.faults == 0);
    CHECK(model.report.skipped.empty());
    return colours_of(model);
}

using Colours = std::vector<glm::vec3>;

} // namespace coloured_points
} // namespace

TEST_CASE("Numbers after the coordinates of a point are its colour") {
    using namespace coloured_points;
    const Colours red_green_blue{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(colours_with({"1 0 0", "0 1 0", "0 0 1"}) == red_green_blue);
    CHECK(colours_with({"1.000 0.0 0", "0 1.0 0 # green", "0\t0 1"}) == red_green_blue);
    CHECK(colours_with({"255 0 0", "0 255 0", "0 0 255"}) == red_green_blue);
    CHECK(colours_with({"1 1 0 0", "1 0 1 0", "1 0 0 1"}) == red_green_blue); // w first
    CHECK(colours_with({"1 0 0 1", "0 1 0 1", "0 0 1 1"}) == red_green_blue); // alpha last
    CHECK(colours_with({"255 0 0 255", "0 255 0 255", "0 0 255 255"}) == red_green_blue);
    CHECK(colours_with({"0.25 0.5 0.75", "", "1 0 0"}) ==
          Colours{{0.25f, 0.5f, 0.75f}, {1, 1, 1}, {1, 0, 0}});
    CHECK(colours_with({"51 102 204", "0 1 2", "255 300 -7"}) ==
          Colours{{0.2f, 0.4f, 0.8f}, {0, 1 / 255.0f, 2 / 255.0f}, {1, 1, 0}});
    // A little more than 1 is no proof that the others are bytes.
    CHECK(colours_with({"1.0001 0 0", "0 1 0", "0 0 1"}) == red_green_blue);
}

TEST_CASE("Colours taken to run to 255 are noted with the line that shows it") {
    using namespace coloured_points;
    const ObjReport report =
        parse_obj(triangle_with({"0 0 1", "9 0 0", "255 0 0"}), "m.obj").report;
    CHECK(remark_lines(report) ==
          std::vector<std::string>{"m.obj:2: the colours of the points are taken to run from 0 to "
                                   "255."});
    CHECK(parse_obj(triangle_with({"0 0 1", "1 0 0", "0 0 0"}), "m.obj").report.notes.empty());
}

TEST_CASE("A point followed by anything but a colour stays white, and that is reported") {
    using namespace coloured_points;
    const ObjModel model = parse_obj(triangle_with({"1 0 0", "1 x 0", "nan 0 0"}), "m.obj");
    CHECK(colours_of(model) == Colours{{1, 0, 0}, {1, 1, 1}, {1, 1, 1}});
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{"m.obj:2: 'x' is not a valid number for a colour; the point is "
                                   "white. There is 1 more like it."});
    for (const std::string behind : {"1", "1 0", "1 0 0 1 0"}) {
        INFO(behind);
        const ObjModel other = parse_obj(triangle_with({behind, behind, behind}), "m.obj");
        CHECK(colours_of(other) == Colours(3, glm::vec3(1)));
        REQUIRE(other.report.skipped.size() == 1);
        CHECK(other.report.skipped[0].count == 3);
    }
    // A point that cannot be read keeps its number, and its colour is no other point's.
    const std::string text = "v nan 0 0 0 0 1\n" + triangle_with({"1 0 0", "0 1 0", ""});
    CHECK(colours_of(parse_obj(text.substr(0, text.find('f')) + "f 2 3 4\n", "m.obj")) ==
          Colours{{1, 0, 0}, {0, 1, 0}, {1, 1, 1}});
}

TEST_CASE("The comments with colours that ZBrush writes are read") {
    using namespace coloured_points;
    const std::string points = places[0] + "\n" + places[1] + "\n" + places[2] + "\n";
    const auto colours = [&](const std::string& comments) {
        const ObjModel model = parse_obj(points + comments + "f 1 2 3\n", "m.obj");
        CHECK(model.report.counts.faults == 0);
        return colours_of(model);
    };
    const Colours wanted{{1, 0, 0}, {0, 51 / 255.0f, 0}, {1, 1, 1}};
    CHECK(colours("#MRGB ffff0000ff003300ffffffff\n") == wanted);
    CHECK(colours("#MRGB FFFF0000\n# more\n#MRGB 00003300\n") == wanted);
    CHECK(colours("#MRGB ffff0000ff003300ff0000\n") == wanted); // cut off
    CHECK(colours("#MRGB nothing\n") == Colours(3, glm::vec3(1)));
}

TEST_CASE("Colours of points are multiplied by that of the material") {
    using namespace coloured_points;
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "m.obj", "mtllib m.mtl\nusemtl a\n" + triangle_with({"1 0.5 0", "0 1 0", "0.5 0.5 0.5"}));
    folder.write("m.mtl", "newmtl a\nKd 0.5 0.5 0.25\n");
    CHECK(colours_of(read_obj(path)) ==
          Colours{{0.5f, 0.25f, 0}, {0, 0.5f, 0}, {0.25f, 0.25f, 0.125f}});
    folder.write("m.mtl", "newmtl a\nKd 0 0 0\n");
    const ObjModel model = read_obj(path);
    CHECK(colours_of(model) == Colours{{1, 0.5f, 0}, {0, 1, 0}, {0.5f, 0.5f, 0.5f}});
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{folder.file("m.mtl") +
                                   ":2: 'Kd' 0 would make the colours of the points invisible, so "
                                   "it counts as 1."});
}

TEST_CASE("Colours of points go over a face in perspective, by the steps and by the fast engine") {
    using namespace coloured_points;
    // It tilts steeply away from the camera, so a linear blend on the screen would be wrong.
    const Scene scene = scene_of_model(
        parse_obj("v -1 0 1 1 0 0\nv 1 0 1 0 1 0\nv 0 0.5 -4 0 0 1\nf 1 2 3\n", "m.obj"));
    Settings settings = test::by_fast_rules(default_settings(scene));
    settings.stage = Stage::shade;
    settings.shading = Shading::unlit;
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer steps;
    clear(steps, frame);
    draw(frame, {}, steps);
    const test::RayCaster rays(scene, scene.camera, scene.light);
    int compared = 0;
    for (int row = 2; row < steps.size.height; row += 3) {
        for (int column = 2; column < steps.size.width; column += 3) {
            const glm::dvec2 place(column + 0.5 - 0.5 * steps.size.width,
                                   row + 0.5 - 0.5 * steps.size.height);
            const std::vector<test::RayHit> hits = rays.hits(place);
            if (hits.empty() || rays.distance_to_edges(place) < 1.0) continue;
            ++compared;
            // Corners 1 and 2 of the file have changed places.
            const glm::dvec3 w = hits.front().weights;
            const glm::dvec3 wanted(w[0], w[2], w[1]);
            const glm::dvec3 off =
                glm::abs(glm::dvec3(steps.colour[steps.at(column, row)]) - wanted);
            if (std::max({off.x, off.y, off.z}) > 2e-3)
                FAIL("pixel " << column << "," << row << " is off by " << off.x << " " << off.y
                              << " " << off.z);
        }
    }
    CHECK(compared > 500);
    REQUIRE(fast_engine_refuses(scene, settings).empty());
    const test::FastDifference other = test::difference(test::fast_picture(scene, settings), steps);
    INFO(other.words());
    CHECK(other.is_small());
}
