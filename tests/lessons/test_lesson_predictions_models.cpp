// The predictions of lesson 30, worked out a second time: the cubes' files read word by word.

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace models_track {

using Place = std::array<double, 3>;

/// The content of a file without faults: points, and the words of each face.
struct PlainFile {
    std::vector<Place> points;
    std::vector<std::vector<std::string>> faces;

    explicit PlainFile(const std::string& name) {
        std::istringstream text(read_file(lessons_folder() + "/models/" + name));
        for (std::string line; std::getline(text, line);) {
            std::istringstream words(line);
            std::string kind, word;
            words >> kind;
            if (kind == "v") {
                Place& place = points.emplace_back();
                words >> place[0] >> place[1] >> place[2];
            }
            if (kind != "f") continue;
            faces.emplace_back();
            while (words >> word)
                faces.back().push_back(word);
        }
    }

    int triangle_count() const {
        int count = 0;
        for (const auto& face : faces)
            count += static_cast<int>(face.size()) - 2;
        return count;
    }
    const Place& corner(std::size_t face, std::size_t i) const {
        return points[static_cast<std::size_t>(std::stoi(faces[face][i])) - 1];
    }
    /// The cross product of a face's first two edges: outside where corners go counterclockwise.
    Place front(std::size_t face) const {
        const Place &a = corner(face, 0), &b = corner(face, 1), &c = corner(face, 2);
        const Place p{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const Place q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }
};

double dot_of(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From this world to the file's axes: half a turn about x. Both cubes reach from -1 to 1.
Place in_file(const glm::vec3& place) {
    return {static_cast<double>(place.x), -static_cast<double>(place.y),
            -static_cast<double>(place.z)};
}

PREDICTIONS_TEST("Lesson 30: a cube and its corners, counted in the file", "30-obj", "minus-six",
                 "vertices-of-cube", "triangles-of-cube", "turned-light", "culled", "spout-tip") {
    const Questions lesson("30-obj");
    const PlainFile cube("cube.obj"), turned("turned-face.obj"), teapot("teapot.obj");
    REQUIRE(cube.points.size() == 8);
    REQUIRE(cube.faces.size() == 6);
    lesson.require_number("minus-six", static_cast<double>(cube.points.size()) - 6 + 1, 0.0, 6.0);
    std::set<std::string> corners;
    for (const auto& face : cube.faces)
        corners.insert(face.begin(), face.end());
    lesson.require_number("vertices-of-cube", static_cast<double>(corners.size()), 0.0, 8.0);
    CHECK(corners.size() == 24);
    lesson.require_number("triangles-of-cube", cube.triangle_count(), 0.0, 6.0);
    CHECK(teapot.faces.size() == 1296); // as the lesson says
    CHECK(std::count_if(teapot.faces.begin(), teapot.faces.end(),
                        [](const auto& face) { return face.size() == 4; }) > 648);
    CHECK(static_cast<double>(ObjOptions().crease_angle) * 180.0 / 3.141592653589793 ==
          Approx(40.0).margin(0.5));

    const Scene scene = read_scene_file(lessons_folder() + "/models/turned-face.obj");
    const Place eye = in_file(scene.camera.position), lamp = in_file(scene.light.position);
    int culled = 0;
    for (std::size_t face = 0; face < turned.faces.size(); ++face) {
        INFO("face " << face);
        const Place& at = turned.corner(face, 0);
        const Place front = turned.front(face);
        // The middle of the cube is the origin, so a corner of a face is on its outer side.
        const bool is_turned = dot_of(front, at) < 0.0;
        CHECK(is_turned == (face == 3));
        const Place to_eye{eye[0] - at[0], eye[1] - at[1], eye[2] - at[2]};
        if (dot_of(front, to_eye) < 0.0) culled += 2;
        if (!is_turned) continue;
        CHECK(front[0] > 0.0); // of the left face, where it should be negative
        const Place to_lamp{lamp[0] - at[0], lamp[1] - at[1], lamp[2] - at[2]};
        CHECK(dot_of(front, to_lamp) < 0.0); // no direct light, and would have it if it were right
    }
    CHECK(scene.light.indirect == glm::vec3(0.15f));
    lesson.require_choice("turned-light", 1);
    lesson.require_number("culled", culled, 0.0, 6.0);
    CHECK(culled == 8);

    Place low = teapot.points[0], high = low;
    for (const Place& point : teapot.points) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    const Place said_low{-1.48, -0.01, -0.91}, said_high{1.62, 1.5, 0.91};
    double longest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(low[axis] == Approx(said_low[axis]).margin(0.005));
        CHECK(high[axis] == Approx(said_high[axis]).margin(0.005));
        longest = std::max(longest, high[axis] - low[axis]);
    }
    const double tip = (high[0] - (low[0] + high[0]) / 2.0) / (longest / 2.0);
    for (const double wrong : {1.62, 1.55, 1.62 / 1.55})
        lesson.require_number("spout-tip", tip, 1e-4, wrong);
}

TEST_CASE("Lesson 30: point 8 of the cube is a corner of the front, and of two more faces") {
    const PlainFile cube("cube.obj");
    CHECK(cube.points[7] == Place{1, 1, 1});
    CHECK(cube.faces[0] == std::vector<std::string>{"5/1/1", "6/2/1", "8/3/1", "7/4/1"});
    std::set<std::string> normals;
    for (const auto& face : cube.faces) {
        for (const std::string& corner : face) {
            if (corner.rfind("8/", 0) == 0) normals.insert(corner.substr(corner.rfind('/') + 1));
        }
    }
    CHECK(normals == std::set<std::string>{"1", "2", "5"}); // (0, 0, 1), (1, 0, 0), (0, 1, 0)
}

} // namespace models_track
} // namespace
