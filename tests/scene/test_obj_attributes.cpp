// Normals and texture coordinates that a model's faces name wrongly do not cost a face. The result
// must be the same as for the model written without them.

#include <algorithm>
#include <string>
#include <vector>

#include "base/faults.h"
#include "base/image.h"
#include "scene/read_obj.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {
namespace wrong_attributes {

// A tent: two squares at 90 degrees to each other.
const std::string points = "v -1 0 0\nv -1 0 -2\nv 0 1 -2\nv 0 1 0\nv 1 0 0\nv 1 0 -2\n";
const std::string faces = "f 1 4 3 2\nf 4 5 6 3\n";

/// The faces of the tent, with the same text after each point.
std::string faces_with(const std::string& behind) {
    std::string text = faces;
    for (std::size_t i = text.size(); i-- > 0;) {
        if (text[i] >= '1' && text[i] <= '6') text.insert(i + 1, behind);
    }
    return text;
}

} // namespace wrong_attributes
} // namespace

TEST_CASE("A normal or texture coordinate that is wrong costs no face, and is reported once") {
    using namespace wrong_attributes;
    const std::string without = " the face is drawn without texture coordinates.";
    const std::string computed = " the normal is computed.";
    struct Case {
        std::string lines, behind, fault;
    };
    const std::vector<Case> cases{
        {"", "//1", "'f' names normal 1, but the file has 0;" + computed},
        {"", "//99", "'f' names normal 99, but the file has 0;" + computed},
        {"vn 1 0 0\n", "//2", "'f' names normal 2, but the file has 1;" + computed},
        {"vn 1 0 0\n", "//0", "normals are counted from 1, but 'f' names 0;" + computed},
        {"vn 1 0 0\n", "//-2", "'f' names normal -2, but the file has 1 so far;" + computed},
        {"", "//4294967295", "'f' names normal 4294967295, but the file has 0 so far;" + computed},
        {"", "//nan", "'nan' is not the number of a normal;" + computed},
        {"", "//1.0", "'1.0' is not the number of a normal;" + computed},
        {"", "/1", "'f' names texture coordinate 1, but the file has 0;" + without},
        {"", "/1/", "'f' names texture coordinate 1, but the file has 0;" + without},
        {"vt 1 1\n", "/0", "texture coordinates are counted from 1, but 'f' names 0;" + without},
        {"vt 1 1\n", "/-2",
         "'f' names texture coordinate -2, but the file has 1 so far;" + without},
        {"", "/x", "'x' is not the number of a texture coordinate;" + without},
        {"", "///", ""},
        {"", "/", ""},
        {"", "//", ""},
    };
    const Mesh wanted = parse_obj(points + faces, "m.obj").mesh;
    REQUIRE(wanted.triangle_count() == 4);
    for (const Case& one : cases) {
        INFO(one.lines << one.behind);
        const std::string before = points + one.lines;
        const ObjModel model = parse_obj(before + faces_with(one.behind), "m.obj");
        CHECK(model.mesh == wanted);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        std::vector<std::string> reported;
        if (!one.fault.empty()) {
            reported.push_back("m.obj:" + std::to_string(line) + ": " + one.fault +
                               " There is 1 more like it.");
        }
        CHECK(fault_lines(model.report) == reported);
        CHECK(model.report.counts.faults == (reported.empty() ? 0 : 2));
    }
}

TEST_CASE("Both attributes may be wrong in one face, and each is reported") {
    using namespace wrong_attributes;
    const ObjModel model = parse_obj(points + faces_with("/7/8"), "m.obj");
    CHECK(model.mesh == parse_obj(points + faces, "m.obj").mesh);
    CHECK(fault_lines(model.report).size() == 2);
    CHECK(model.report.counts.faults == 4);
}

TEST_CASE("Parts of a corner after the third are not used") {
    using namespace wrong_attributes;
    const std::string lines = points + "vt 0.5 0.25\nvn 1 0 0\n";
    const ObjModel model = parse_obj(lines + faces_with("/1/1/9"), "m.obj");
    CHECK(model.mesh == parse_obj(lines + faces_with("/1/1"), "m.obj").mesh);
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{"m.obj:9: '1/1/1/9' is not a corner (a, a/b, a//c or a/b/c); "
                                   "what follows its third part is not used. There is 1 more like "
                                   "it."});
}

TEST_CASE("The other corners of a face keep the normals that are there") {
    const ObjModel model =
        parse_obj("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 1 0 0\nf 1//0 2//1 3//1\n", "m.obj");
    CHECK(model.mesh.corner(0, 0).normal == glm::vec3(0, 0, 1));
    CHECK(model.mesh.corner(0, 1).normal == glm::vec3(1, 0, 0));
    CHECK(model.mesh.corner(0, 2).normal == glm::vec3(1, 0, 0));
    CHECK(model.report.counts.computed_normals == 1);
}

TEST_CASE("A vn or vt that is broken keeps its number, and costs no face") {
    const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const std::string line : {"vn nan 0 0", "vn 1 0", "vn up", "vn", "vn 0 0 0", "vn 0,5 0 1",
                                   "vn -nan(ind) 0 1", "vn 1e999 0 0"}) {
        INFO(line);
        const ObjModel model = parse_obj(
            start + line + "\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 2//2 3//2\n" + line, "m.obj");
        REQUIRE(model.mesh.triangle_count() == 2);
        CHECK(model.mesh.corner(0, 0).normal == glm::vec3(0, 0, 1));
        CHECK(model.mesh.corner(1, 0).normal == glm::vec3(1, 0, 0));
        // The first line, and the same at the end counted with it.
        CHECK(model.report.counts.faults == 2);
        CHECK(fault_lines(model.report).size() == 1);
    }
    for (const std::string line : {"vt nan 0", "vt", "vt u v", "vt 0,5 0,5"}) {
        INFO(line);
        const ObjModel model =
            parse_obj(start + line + "\nvt 0.5\nf 1/1 2/1 3/2\nf 1/2 2/2 3/2\n", "m.obj");
        REQUIRE(model.mesh.triangle_count() == 2);
        CHECK(model.mesh.corner(0, 2).texcoord == glm::vec2(0));
        CHECK(model.mesh.corner(1, 2).texcoord == glm::vec2(0.5f, 0.0f));
        CHECK(model.report.counts.faults == 1);
    }
}

TEST_CASE("A face with a wrong texture coordinate is drawn without its image") {
    const test::TemporaryFolder folder;
    write_png(test::many_colours(2, 2), folder.file("p.png"));
    folder.write("m.mtl", "newmtl a\nKd 0.5 0.25 1\nmap_Kd p.png\n");
    const ObjModel model = read_obj(folder.write(
        "m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt nan 1\n"
                 "f 1/1 2/1 3/1\nf 1/1 2/9 3/1\nf 1/1 2/2 3/1\n"));
    REQUIRE(model.mesh.triangle_count() == 3);
    REQUIRE(model.parts.size() == 2);
    CHECK(model.parts[0].texture == 0);
    CHECK(model.parts[1].texture == -1);
    CHECK(model.parts[1].triangle_count == 2);
    CHECK(model.mesh.corner(1, 0).reflectance == glm::vec3(0.5f, 0.25f, 1.0f));
}

TEST_CASE("A hundred thousand faces with a wrong normal are one fault, and leave room for others") {
    constexpr int count = 100'000;
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < count; ++i)
        text += "f 1//5 2//5 3//5\n";
    const ObjModel model = parse_obj(text + "f 1 2\n", "m.obj");
    CHECK(model.mesh.triangle_count() == count);
    CHECK(model.report.counts.faults == count + 1);
    CHECK(fault_notice(model.report) ==
          "m.obj:100004: 'f' has 2 corners, but a face has at least three; the face is left out. "
          "m.obj:4: 'f' names normal 5, but the file has 0; the normal is computed. There are "
          "99999 more like it.");
}

TEST_CASE("Faults beyond the room of the report are still counted") {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < most_faults; ++i)
        text += "f 0 0 0\n";
    const ObjReport report =
        parse_obj(text + "f 1//0 2//1 3//1\nf 1//0 2 3\nf 1 2\n", "m.obj").report;
    CHECK(report.faults.size() == static_cast<std::size_t>(most_faults));
    // Two faces name the normal 0, one of them the normal 1 as well, and one has two corners.
    CHECK(fault_lines(report).back() == "4 more faults after these.");
}
