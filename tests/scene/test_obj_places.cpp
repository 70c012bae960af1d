// Models far from the origin, very large or very small, look like the same model near it.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace far_away {

struct Shell {
    int columns = 24, rows = 12;
    double radius = 1.0;     ///< of the file's units
    double rounded_to = 0.0; ///< of coordinates, before they are moved; 0: not rounded
    glm::dvec3 move{0.0};
    std::string number = "{:.17g}";
};

/// A bent sheet without normals, so that they are computed from the places.
std::string text_of(const Shell& shell) {
    std::string text;
    for (int row = 0; row <= shell.rows; ++row) {
        for (int column = 0; column <= shell.columns; ++column) {
            const double turn = 4.5 * column / shell.columns, tilt = -1.2 + 2.2 * row / shell.rows;
            glm::dvec3 place =
                shell.radius * glm::dvec3(std::cos(tilt) * std::cos(turn),
                                          std::cos(tilt) * std::sin(turn), std::sin(tilt));
            if (shell.rounded_to > 0.0)
                place = glm::round(place / shell.rounded_to) * shell.rounded_to;
            text += "v";
            for (int axis = 0; axis < 3; ++axis)
                text +=
                    " " + fmt::format(fmt::runtime(shell.number), place[axis] + shell.move[axis]);
            text += "\n";
        }
    }
    for (int row = 0; row < shell.rows; ++row) {
        for (int column = 0; column < shell.columns; ++column) {
            const int a = row * (shell.columns + 1) + column + 1, b = a + shell.columns + 1;
            text += fmt::format("f {} {} {} {}\n", a, a + 1, b + 1, b);
        }
    }
    return text;
}

Scene scene_of(const Shell& shell) {
    return scene_of_model(parse_obj(text_of(shell), "m.obj"));
}

std::vector<glm::vec3> colours_of(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer picture;
    clear(picture, frame);
    draw(frame, {}, picture);
    return picture.colour;
}

/// The largest difference of two places or normals of the same corner.
float difference(const Scene& a, const Scene& b) {
    REQUIRE(a.triangle_count() == b.triangle_count());
    float largest = 0.0f;
    for (int triangle = 0; triangle < a.triangle_count(); ++triangle) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vertex& one = a.corner(triangle, corner);
            const Vertex& other = b.corner(triangle, corner);
            largest = std::max({largest, glm::length(one.position - other.position),
                                glm::length(one.normal - other.normal)});
        }
    }
    return largest;
}

} // namespace far_away
} // namespace

TEST_CASE("A model in coordinates of a map is the same picture, bit for bit, as at the origin") {
    using namespace far_away;
    // Sixty-fourths are exact in the text, in double and in float near the origin.
    const Shell near{.rounded_to = 1.0 / 64.0};
    const std::vector<glm::vec3> wanted = colours_of(scene_of(near));
    REQUIRE(std::count(wanted.begin(), wanted.end(), wanted[0]) < std::ssize(wanted) * 9 / 10);
    for (const glm::dvec3 move : {glm::dvec3(432100, 6543211, 100), glm::dvec3(-9e8, 0, 0),
                                  glm::dvec3(40, -20, 17), glm::dvec3(0, 0, 1e6)}) {
        INFO(move.x << " " << move.y << " " << move.z);
        Shell moved = near;
        moved.move = move;
        const Scene scene = scene_of(moved);
        CHECK(difference(scene, scene_of(near)) == 0.0f);
        CHECK(colours_of(scene) == wanted);
    }
}

TEST_CASE("A model far away is as exact as the digits of its file") {
    using namespace far_away;
    const Shell near{};
    const Shell far{.move = {432100.125, 6543211.5, 100}, .number = "{:.6f}"};
    // The digits leave half a millionth open, and a corner's normal tilts by that over an edge's
    // length, which is more than 0.03.
    CHECK(difference(scene_of(far), scene_of(near)) < 1e-6f / 0.03f);
}

TEST_CASE("The offset subtracted from a model far away is a round number, and noted") {
    using namespace far_away;
    const Shell far{.rounded_to = 1.0 / 64.0, .move = {432100, 6543211, 100}};
    const ObjModel model = parse_obj(text_of(far), "m.obj");
    CHECK(glm::length(model.origin - far.move) < 1.0);
    CHECK(model.origin == glm::round(model.origin * 256.0) / 256.0);
    CHECK(model.mesh.vertices()[0].position ==
          parse_obj(text_of({.rounded_to = 1.0 / 64.0, .move = far.move - model.origin}), "m.obj")
              .mesh.vertices()[0]
              .position);
    REQUIRE(model.report.notes.size() == 1);
    CHECK_THAT(model.report.notes[0].sentence,
               Catch::Matchers::StartsWith("the model is far from the origin, so ("));
    CHECK(model.report.counts.faults == 0);
    for (const std::string& near :
         {text_of({}), text_of({.move = {3, -2, 1}}), std::string("v 9 9 9\nf 1 1 1\n")}) {
        const ObjModel kept = parse_obj(near, "m.obj");
        CHECK(kept.origin == glm::dvec3(0));
        CHECK(kept.report.notes.empty());
    }
}

TEST_CASE("A point that no face names does not move a model") {
    using namespace far_away;
    const Shell far{.rounded_to = 1.0 / 64.0, .move = {0, 6543211, 0}};
    const Scene scene = scene_of_model(parse_obj(text_of(far) + "v 0 0 0\nv nan 0 0\n", "m.obj"));
    CHECK(difference(scene, scene_of({.rounded_to = 1.0 / 64.0})) < 1e-6f);
}

TEST_CASE("A model may be of any size") {
    using namespace far_away;
    const Scene usual = scene_of({});
    for (const double size : {1e7, 5e8, 1e-4, 1e-7, 1e-12, 1e-25}) {
        INFO(size);
        const Scene scene = scene_of({.radius = size});
        CHECK(difference(scene, usual) < 1e-5f);
        // A thousand of its sizes away from the origin, too.
        const double away = std::min(1000.0 * size, 4e8);
        CHECK(difference(scene_of({.radius = size, .move = {away, -away, 0}}), usual) < 1e-5f);
    }
}

TEST_CASE("Sizes that differ enormously between the axes still give numbers") {
    for (const std::string text : {"v 1e9 0 0\nv 1e9 1e-300 0\nv 1e9 0 1e-300\nf 1 2 3\n",
                                   "v 1e9 1e-310 0\nv 1e9 2e-310 0\nv 1e9 0 1e-310\nf 1 2 3\n",
                                   "v -1e9 -1e9 0\nv 1e9 1e9 1e-300\nv 0 1e-300 0\nf 1 2 3\n"}) {
        INFO(text);
        const Scene scene = scene_of_model(parse_obj(text, "m.obj"));
        for (const Vertex& vertex : scene.mesh.vertices()) {
            CHECK(std::abs(vertex.position.x) <= 1.001f);
            CHECK(std::abs(vertex.position.y) <= 1.001f);
            CHECK(std::abs(vertex.position.z) <= 1.001f);
        }
    }
}
