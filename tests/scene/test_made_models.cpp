// The models that come with the program: their files are what the generator writes, and a walk
// around them finds them closed, with their fronts outside.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/image.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/made_models.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

std::string models_folder() {
    return project_root() + "/lessons/models";
}

ObjModel made_model(const std::string& name) {
    return read_obj(models_folder() + "/" + name + ".obj");
}

/// Six times the volume inside, by the divergence theorem: positive where fronts are outside.
double six_volumes(const Mesh& mesh) {
    double sum = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        sum += glm::dot(glm::dvec3(mesh.corner(t, 0).position),
                        glm::cross(glm::dvec3(mesh.corner(t, 1).position),
                                   glm::dvec3(mesh.corner(t, 2).position)));
    }
    return sum;
}

} // namespace

// With RASTERWALK_REWRITE_MODELS set they are written again.
TEST_CASE("The models' files are what their generator writes, and there are no others") {
    const bool rewrites = std::getenv("RASTERWALK_REWRITE_MODELS") != nullptr;
    std::size_t count = 0;
    for (const test::MadeFile& made : test::made_models()) {
        INFO(made.name);
        const std::string path = models_folder() + "/" + made.name;
        if (rewrites) std::ofstream(path, std::ios::binary) << made.text;
        const bool is_same = test::bytes_of(path) == made.text;
        CHECK(is_same);
        ++count;
    }
    for (const test::MadeImage& made : test::made_images()) {
        INFO(made.name);
        const std::string path = models_folder() + "/" + made.name;
        if (rewrites) write_png(made.image, path);
        CHECK(read_image(path) == made.image);
        ++count;
    }
    const std::filesystem::directory_iterator first(models_folder());
    CHECK(static_cast<std::size_t>(std::distance(begin(first), end(first))) == count);
}

TEST_CASE("The models have the counts of their formulas, and nothing is wrong with them") {
    struct Expected {
        std::string name;
        int positions, faces, triangles, parts;
        int textures = 0;
    };
    // Bands of n quads: 2 n triangles each, and n where a band ends in a pole.
    for (const Expected& expected :
         {Expected{"cube", 8, 6, 12, 1}, Expected{"sphere", 15 * 24 + 2, 16 * 24, 24 * 30, 1},
          Expected{"torus", 41 * 20, 800, 1600, 1}, Expected{"knot", 97 * 12, 1152, 2304, 1},
          Expected{"teapot", 20 * 24 + 1 + 20 * 24 + 1 + 17 * 12 + 13 * 12,
                   24 * 20 + 24 * 20 + 12 * 16 + 12 * 12, 24 * 39 + 24 * 39 + 24 * 16 + 24 * 12, 4},
          // The sphere, and 13 rings, the first of which is a point.
          Expected{"globe", 15 * 24 + 2 + 1 + 12 * 16, 16 * 24 + 12 * 16, 24 * 30 + 16 * 23, 2,
                   2}}) {
        INFO(expected.name);
        const ObjModel model = made_model(expected.name);
        const ObjCounts& counts = model.report.counts;
        CHECK(counts.faults == 0);
        CHECK(model.report.skipped.empty());
        CHECK(counts.positions == expected.positions);
        CHECK(counts.faces == expected.faces);
        CHECK(counts.triangles == expected.triangles);
        CHECK(counts.parts == expected.parts);
        CHECK(counts.textures == expected.textures);
        CHECK(counts.computed_normals == 0);
    }
    CHECK(made_model("cube").mesh.vertices().size() == 24);
}

TEST_CASE("The models' fronts are outside, and their normals point there") {
    for (const std::string name : {"cube", "sphere", "torus", "knot"}) {
        INFO(name);
        const Mesh mesh = made_model(name).mesh;
        CHECK(six_volumes(mesh) > 0.0);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            INFO("triangle " << t);
            const glm::vec3 a = mesh.corner(t, 0).position, b = mesh.corner(t, 1).position;
            const glm::vec3 front = glm::cross(b - a, mesh.corner(t, 2).position - a);
            const glm::vec3 sum =
                mesh.corner(t, 0).normal + mesh.corner(t, 1).normal + mesh.corner(t, 2).normal;
            if (!(glm::dot(front, sum) > 0.0f)) FAIL("a normal points to the back");
        }
    }
    CHECK(six_volumes(made_model("cube").mesh) == 48.0);
    // Less than the round bodies that they stand in for, by as much as their sides are flat.
    const double pi = 3.141592653589793;
    CHECK(six_volumes(made_model("sphere").mesh) / (8 * pi) == Approx(1.0).margin(0.03));
    CHECK(six_volumes(made_model("torus").mesh) / (12 * pi * pi * 0.16) ==
          Approx(1.0).margin(0.03));
}
