// Model files in the dialects that programs write, and the reports of their faults.

#include "scene/read_obj.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/faults.h"
#include "base/image.h"
#include "base/limits.h"
#include "scene/model_notice.h"
#include "scene/model_scene.h"
#include "tests/support/catch.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string triangle_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string one_face = triangle_points + "f 1 2 3\n";

std::vector<std::string> faults_of(const std::string& text) {
    return fault_lines(parse_obj(text, "m.obj").report);
}

/// The sentence with which the reader refuses a whole text.
std::string refusal_of_obj(const std::string& text) {
    try {
        parse_obj(text, "m.obj");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string face_of(int corners) {
    std::string face = "f";
    for (int i = 1; i <= corners; ++i)
        face += " " + std::to_string(i);
    return face + "\n";
}

} // namespace

TEST_CASE("A model in each dialect has the right counts") {
    struct Dialect {
        std::string what, text;
        int positions, texcoords, normals, faces, triangles, vertices, parts;
    };
    const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const std::vector<Dialect> dialects{
        {"plain", one_face, 3, 0, 0, 1, 1, 3, 1},
        {"CR LF", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", 3, 0, 0, 1, 1, 3, 1},
        {"CR alone", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", 3, 0, 0, 1, 1, 3, 1},
        {"byte order mark", "\xef\xbb\xbf" + one_face, 3, 0, 0, 1, 1, 3, 1},
        {"no line end at the end", triangle_points + "f 1 2 3", 3, 0, 0, 1, 1, 3, 1},
        {"tabs and blanks", "  v\t0 0  0 \nv 1 0 0\nv 0 1 0\n\tf  1\t2  3  \n", 3, 0, 0, 1, 1, 3,
         1},
        {"comments", "# f 1 2 3 \\\n" + triangle_points + "f 1 2 3 # f 3 2 1\n", 3, 0, 0, 1, 1, 3,
         1},
        {"numbers", "v +.5 -.5 1e-3\nv 1. 1E+2 -0\nv 0 1e-400 0000.1\nf 1 2 3\n", 3, 0, 0, 1, 1, 3,
         1},
        {"counted back", triangle_points + "f -3 -2 -1\nv 2 2 2\nf -4 -2 -1\n", 4, 0, 0, 2, 2, 6,
         1},
        {"a/b", quad + "vt 0 0\nvt 1 0\nf 1/1 2/2 3/1 4/2\n", 4, 2, 0, 1, 2, 4, 1},
        {"a//c", quad + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n", 4, 0, 1, 1, 2, 4, 1},
        {"a/b/c", quad + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n", 4, 1, 1, 1, 2, 4, 1},
        {"back in all three", quad + "vt 0 0\nvn 0 0 1\nf -4/-1/-1 -3/-1/-1 -2/-1/-1\n", 4, 1, 1, 1,
         1, 3, 1},
        {"slashes at the end", triangle_points + "f 1/ 2// 3\n", 3, 0, 0, 1, 1, 3, 1},
        {"joined lines", triangle_points + "f 1 \\\n2 \\\r\n3\n", 3, 0, 0, 1, 1, 3, 1},
        {"points behind their face", "f 1 2 3\n" + triangle_points, 3, 0, 0, 1, 1, 3, 1},
        {"objects and groups", triangle_points + "o a\nf 1 2 3\ng b c\nf 1 3 2\ng b c\nf 1 2 3\n",
         3, 0, 0, 3, 3, 6, 2},
        {"five corners", quad + "v -1 0.5 0\nf 1 2 3 4 5\n", 5, 0, 0, 1, 3, 5, 1},
        {"one and three texture coordinates", triangle_points + "vt 0.5\nvt 0 1 0\nf 1/1 2/2 3/2\n",
         3, 2, 0, 1, 1, 3, 1},
        {"a name that is not UTF-8", triangle_points + "o caf\xe9\nf 1 2 3\n", 3, 0, 0, 1, 1, 3, 1},
        {"NUL bytes in a name", triangle_points + std::string("g a\0b\n", 6) + "f 1 2 3\n", 3, 0, 0,
         1, 1, 3, 1},
    };
    for (const Dialect& dialect : dialects) {
        INFO(dialect.what);
        const ObjModel model = parse_obj(dialect.text, "m.obj");
        const ObjCounts& counts = model.report.counts;
        CHECK(counts.faults == 0);
        CHECK(model.report.skipped.empty());
        CHECK(counts.positions == dialect.positions);
        CHECK(counts.texcoords == dialect.texcoords);
        CHECK(counts.normals == dialect.normals);
        CHECK(counts.faces == dialect.faces);
        CHECK(counts.triangles == dialect.triangles);
        CHECK(counts.vertices == dialect.vertices);
        CHECK(counts.parts == dialect.parts);
        CHECK(model.mesh.triangle_count() == dialect.triangles);
        CHECK(model.mesh.vertices().size() == static_cast<std::size_t>(dialect.vertices));
    }
}

TEST_CASE("A model's numbers reach the mesh as they are written") {
    const Mesh mesh = parse_obj("v +.5 -.5 1e-3\nv 1. 1E+2 -0\nv 0 0 7\nvt 0.25 0.75\n"
                                "vn 0 0 2\nf 1/1/1 2/1/1 3/1/1\n",
                                "m.obj")
                          .mesh;
    CHECK(mesh.corner(0, 0).position == glm::vec3(0.5f, -0.5f, 0.001f));
    CHECK(mesh.corner(0, 1).position == glm::vec3(1.0f, 100.0f, 0.0f));
    CHECK(mesh.corner(0, 2).texcoord == glm::vec2(0.25f, 0.75f));
    CHECK(mesh.corner(0, 2).normal == glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST_CASE("Names of parts that no terminal can show are made visible") {
    CHECK(parse_obj(triangle_points + "o caf\xe9\nf 1 2 3\n", "m.obj").parts.at(0).name ==
          "caf\\xe9");
    CHECK(parse_obj(one_face, "folder/m.obj").parts.at(0).name == "m");
}

TEST_CASE("Faults in a model are reported with their lines, and the rest is read") {
    struct Case {
        std::string line, fault;
    };
    const std::vector<Case> cases{
        {"v 1 nan 0", "'nan' is not a valid number for 'v', which is left out."},
        {"v 1 -inf 0", "'-inf' is not a valid number for 'v', which is left out."},
        {"v 1 1e999 0", "'1e999' is not a valid number for 'v', which is left out."},
        {"v 1 2e9 0", "'2e9' is not a valid number for 'v', which is left out."},
        {"v 1,5 2 3", "'1,5' has a decimal comma, but numbers need a decimal point here; 'v' is "
                      "left out."},
        {"v 1,2,3 2 3", "'1,2,3' is not a valid number for 'v', which is left out."},
        {"vt 0 -0,5e1",
         "'-0,5e1' has a decimal comma, but numbers need a decimal point here; 'vt' is left out."},
        {"v 1 2 3 red 0 0", "'red' is not a valid number for a colour; the point is white."},
        {"v +-1 2 3", "'+-1' is not a valid number for 'v', which is left out."},
        {"v 0x10 2 3", "'0x10' is not a valid number for 'v', which is left out."},
        {"v 1 2", "'v' needs 3 numbers but has 2; it is left out."},
        {"v", "'v' needs 3 numbers but has 0; it is left out."},
        {"vt", "'vt' needs 1 numbers but has 0; it is left out."},
        {"vt u", "'u' is not a valid number for 'vt', which is left out."},
        {"vn 1 2", "'vn' needs 3 numbers but has 2; it is left out."},
        {"vn 1.#QNAN 0 0", "'1.#QNAN' is not a valid number for 'vn', which is left out."},
        {"v 0 1.#INF 0", "'1.#INF' is not a valid number for 'v', which is left out."},
        {"v 0 0 -1.#IND00", "'-1.#IND00' is not a valid number for 'v', which is left out."},
        {"v 1.#SNAN 0 0", "'1.#SNAN' is not a valid number for 'v', which is left out."},
        {"vt 1.#Q", "'1.#Q' is not a valid number for 'vt', which is left out."},
        {"vn 0 0 0", "a normal of length 0 has no direction; a computed one is used in its place."},
        {"f", "'f' has 0 corners, but a face has at least three; the face is left out."},
        {"f 1", "'f' has 1 corner, but a face has at least three; the face is left out."},
        {"f 1 2", "'f' has 2 corners, but a face has at least three; the face is left out."},
        {"f 0 1 2", "points are counted from 1, but 'f' names 0; the face is left out."},
        {"f 1 2 4", "'f' names point 4, but the file has 3; the face is left out."},
        {"f 1 2 -4", "'f' names point -4, but the file has 3 so far; the face is left out."},
        {"f 1 2 4294967297",
         "'f' names point 4294967297, but the file has 3 so far; the face is left out."},
        {"f 1 2 99999999999999999999",
         "'f' names point 99999999999999999999, but the file has 3 so far; the face is left "
         "out."},
        {"f 1/1 2/1 3/1",
         "'f' names texture coordinate 1, but the file has 0; the face is drawn without texture "
         "coordinates."},
        {"f 1//0 2 3", "normals are counted from 1, but 'f' names 0; the normal is computed."},
        {"f 1//-1 2 3", "'f' names normal -1, but the file has 0 so far; the normal is "
                        "computed."},
        {"f 1 2 x", "'x' is not the number of a point; the face is left out."},
        {"f 1 2 3.5", "'3.5' is not the number of a point; the face is left out."},
        {"f 1 2 3/a", "'a' is not the number of a texture coordinate; the face is drawn without "
                      "texture coordinates."},
        {"f 1 2 /3", "'/3' is not a corner (a, a/b, a//c or a/b/c); the face is left out."},
        {"f 1 2 3///1", "'3///1' is not a corner (a, a/b, a//c or a/b/c); what follows its third "
                        "part is not used."},
        {"mtllib", "'mtllib': no file is named; it is left out."},
        {"mtllib not-there.mtl", "'mtllib': there is no file 'not-there.mtl'; it is left out."},
        {"mtllib /dev/zero", "'mtllib': there is no file '/dev/zero' in its folder, below it or in "
                             "a folder next to it; it is left out."},
        {"mtllib .", "'mtllib': '.' is a folder; it is left out."},
        {"usemtl wood\nf 1 2 3", "there is no material 'wood', so its faces are white."},
    };
    for (const Case& one : cases) {
        INFO(one.line);
        const std::string text = one_face + one.line + "\n";
        const ObjModel model = parse_obj(text, "m.obj");
        CHECK(fault_lines(model.report) == std::vector<std::string>{"m.obj:5: " + one.fault});
        CHECK(model.report.counts.faults == 1);
        CHECK(model.mesh.triangle_count() >= 1);
        // The last word of a file may be the last byte, too.
        CHECK(faults_of(one_face + one.line) == fault_lines(model.report));
    }
}

TEST_CASE("A comment can directly follow a number, even one that ends with its point") {
    const ObjModel model = parse_obj(
        "v 0 0 0#.#INF\nv 1 0 2.#top\nv 0 1 -3.#\nv 1 1 4.##QNAN\nf 1 2 3\nf 2 4 3\n", "m.obj");
    CHECK(fault_lines(model.report).empty());
    REQUIRE(model.mesh.triangle_count() == 2);
    CHECK(model.mesh.corner(0, 0).position == glm::vec3(0, 0, 0));
    CHECK(model.mesh.corner(0, 1).position == glm::vec3(1, 0, 2));
    CHECK(model.mesh.corner(0, 2).position == glm::vec3(0, 1, -3));
    CHECK(model.mesh.corner(1, 1).position == glm::vec3(1, 1, 4));
}

TEST_CASE("A point that cannot be read keeps its number, and takes its faces with it") {
    const std::string text = "v 0 0 0\nv 1 0 0\nv nan 0 0\nv 0 1 0\nv 1 1 0\n"
                             "f 1 2 4\nf 1 2 3\nf 4 2 5\n";
    const ObjModel model = parse_obj(text, "m.obj");
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{
              "m.obj:3: 'nan' is not a valid number for 'v', which is left out.",
              "m.obj:7: 'f' names point 3, which could not be read; the face is left out."});
    REQUIRE(model.mesh.triangle_count() == 2);
    CHECK(model.mesh.corner(1, 2).position == glm::vec3(1, 1, 0));
}

TEST_CASE("Statements that have no effect are counted by kind, with the line of the first") {
    const ObjModel model =
        parse_obj("s 1\n" + one_face + "s off\nl 1 2\nzzz\x1b[2J\nv 1 2 3 4\n", "m.obj");
    CHECK(model.report.counts.faults == 0);
    CHECK(skipped_lines(model.report) ==
          std::vector<std::string>{
              "m.obj:1: 2 statements 's' are skipped: smoothing groups are not used; normals are "
              "either given or smoothed by angle.",
              "m.obj:7: 1 statement 'l' is skipped: points and lines are not drawn, only faces.",
              "m.obj:8: 1 statement 'zzz\\u001b[2J' is skipped: it is not a statement of the OBJ "
              "format.",
              "m.obj:9: 1 statement 'v' is skipped: what follows the three numbers of a point is "
              "not a colour and is not used."});
}

TEST_CASE("A file without a face is refused, and says why") {
    CHECK(refusal_of_obj("") == "m.obj:1: there is no face in this file that can be drawn.");
    CHECK(refusal_of_obj("hello\nworld") == "m.obj:1: there is no face in this file that can be "
                                            "drawn.");
    CHECK(refusal_of_obj(triangle_points + "f 1 2") ==
          "m.obj:4: 'f' has 2 corners, but a face has at least three; the face is left out. No "
          "face in the whole file can be drawn.");
    CHECK(refusal_of_obj("\xff\xfe"
                         "f") == "m.obj:1: the file is UTF-16; a model must be plain text.");
    CHECK(refusal_of_obj(std::string("v\0 \0", 4)) ==
          "m.obj:1: the file is UTF-16; a model must be plain text.");
    CHECK(refusal_of_obj("v -1,0 -1,0 0,0\nv 1,0 -1,0 0,0\nv 0,0 1,0 0,0\nf 1 2 3\n") ==
          "m.obj:1: '-1,0' has a decimal comma, but numbers need a decimal point here; 'v' is left "
          "out. There are 2 more like it. No face in the whole file can be drawn.");
    CHECK_THROWS_AS(read_obj("/nowhere/m.obj"), AccessError);
    CHECK_THROWS_WITH(read_obj("/"), "cannot read '/': Is a directory.");
}

TEST_CASE("More faults than are kept are counted") {
    std::string text = one_face;
    for (int i = 0; i < most_faults + 7; ++i)
        text += "f 0 0 0\n";
    const ObjReport report = parse_obj(text, "m.obj").report;
    CHECK(report.counts.faults == most_faults + 7);
    CHECK(report.faults.size() == static_cast<std::size_t>(most_faults));
    CHECK(fault_lines(report).back() == "7 more faults after these.");
    CHECK(fault_notice(report) ==
          "m.obj:5: points are counted from 1, but 'f' names 0; the face is left out. m.obj:6: "
          "points are counted from 1, but 'f' names 0; the face is left out. m.obj:7: points are "
          "counted from 1, but 'f' names 0; the face is left out. 204 more faults after that.");
}

TEST_CASE("A model that is inside out is reported with the cure, and no other model is") {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const auto notice_of = [&](const std::string& faces) {
        return model_notice(scene_of_model(parse_obj(points + faces, "m.obj")));
    };
    CHECK(notice_of("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").empty());
    CHECK_THAT(notice_of("f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"),
               ContainsSubstring("point inward"));
    CHECK(notice_of("f 1 2 3\n").empty());
    for (const char* name : {"cube", "globe", "knot", "sphere", "teapot", "torus"}) {
        INFO(name);
        const ObjModel model = read_obj(project_root() + "/lessons/models/" + name + ".obj");
        CHECK_THAT(model_notice(scene_of_model(model)), !ContainsSubstring("inward"));
    }
}

TEST_CASE("The number of files of materials is limited, and each is looked for only once") {
    std::string text = one_face;
    for (std::size_t i = 0; i < most_material_files + 2; ++i)
        text += "mtllib " + std::to_string(i) + ".mtl\n";
    const std::vector<std::string> faults = faults_of(text + "mtllib 0.mtl\nmtllib 1.mtl\n");
    REQUIRE(faults.size() == most_material_files + 2);
    CHECK(faults[0] == "m.obj:5: 'mtllib': there is no file '0.mtl'; it is left out.");
    CHECK(faults.back() ==
          "m.obj:70: more than 64 material files are named; this one is left out.");
}

TEST_CASE("Kinds of statement beyond those that are distinguished count as one kind") {
    std::string text = one_face;
    for (std::size_t i = 0; i < most_skipped_kinds + 5; ++i)
        text += "word" + std::to_string(i) + "\n";
    const ObjReport report = parse_obj(text, "m.obj").report;
    REQUIRE(report.skipped.size() == most_skipped_kinds + 1);
    CHECK(report.skipped.back().count == 5);
}

TEST_CASE("A model with more triangles than the limit is refused where it passes it") {
    std::string text = "v 0 0 0\n";
    // One face is enough: its corners are counted while it is read.
    std::string face = "f";
    for (int i = 0; i < max_triangles + 3; ++i)
        face += " 1";
    CHECK(refusal_of_obj(text + face) == "m.obj:2: the model has more than 1000000 triangles.");
}

TEST_CASE("A face of 100000 corners is cut if a fan can, and left out in a sentence if not") {
    constexpr int count = 100000;
    std::string round, star;
    for (int i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        const double radius = i % 2 == 0 ? 1.0 : 0.5;
        const auto point = [&](double r) {
            return "v " + std::to_string(r * std::cos(angle)) + " " +
                   std::to_string(r * std::sin(angle)) + " 0\n";
        };
        round += point(1.0);
        star += point(radius);
    }
    CHECK(parse_obj(round + face_of(count), "m.obj").mesh.triangle_count() == count - 2);
    const ObjModel model = parse_obj(star + face_of(count) + "f 1 2 3\n", "m.obj");
    CHECK(model.mesh.triangle_count() == 1);
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{
              "m.obj:100001: cutting a face of 100000 corners that no fan covers is too much work "
              "(ear clipping is limited to 2048 corners); the face is left out."});
}

TEST_CASE("A face whose edges cross is drawn, and reported") {
    // Two triangles of the same size, which together have no area, and two of different size.
    for (const std::string last : {"v 0 2 0\n", "v 0 3 0\n"}) {
        INFO(last);
        const ObjModel model =
            parse_obj("v 0 0 0\nv 2 2 0\nv 2 0 0\n" + last + "f 1 2 3 4\n", "m.obj");
        CHECK(model.mesh.triangle_count() == 2);
        CHECK(fault_lines(model.report) ==
              std::vector<std::string>{
                  "m.obj:5: the edges of this face cross each other, so its triangles overlap."});
    }
}

TEST_CASE("Materials are next to the model, and give its faces their colour") {
    const test::TemporaryFolder folder;
    folder.write(
        "two parts.mtl",
        "# made\r\nnewmtl red clay\r\n  Kd 0.8 0.1 0.1\r\n\tKs 0.5\r\nNs 32\r\n"
        "map_Kd -s 2 2 2 -o 0 0 -clamp on wood grain.png\r\nnorm C:\\art\\bumps.png\r\n"
        "illum 2\r\nnewmtl blue\nKd 0 0 1\nbump -bm 0.25 bumps.png\nnewmtl blue\nKd 1 1 1");
    write_png({1, 1, {9, 9, 9, 255}}, folder.file("wood grain.png"));
    write_png({1, 1, {128, 128, 255, 255}}, folder.file("bumps.png"));
    const std::string path =
        folder.write("m.obj", "mtllib two parts.mtl\nmtllib two parts.mtl\n" + triangle_points +
                                  "vt 0 0\nusemtl red clay\nf 1/1 2/1 3/1\nusemtl blue\nf 1/1 3/1 "
                                  "2/1\nusemtl\nf 1 2 3\n");
    const ObjModel model = read_obj(path);
    CHECK(model.report.counts.faults == 0);
    REQUIRE(model.materials.size() == 3);
    const ObjMaterial& clay = model.materials[0];
    CHECK(clay.name == "red clay");
    CHECK(clay.diffuse == glm::vec3(0.8f, 0.1f, 0.1f));
    CHECK(clay.specular == glm::vec3(0.5f));
    CHECK(clay.shininess == 32.0f);
    CHECK(clay.diffuse_map == folder.file("wood grain.png"));
    CHECK(clay.bump_map == folder.file("bumps.png"));
    CHECK(clay.bump_is_normal);
    CHECK(model.materials[1].bump_strength == 0.25f);
    CHECK_FALSE(model.materials[1].bump_is_normal);
    REQUIRE(model.parts.size() == 3);
    CHECK(model.parts[0].material == 0);
    CHECK(model.parts[1].material == 1); // the first of that name
    CHECK(model.parts[2].material == -1);
    CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(0.8f, 0.1f, 0.1f));
    CHECK(model.mesh.corner(1, 0).reflectance == glm::vec3(0, 0, 1));
    CHECK(model.mesh.corner(2, 0).reflectance == glm::vec3(1));
    CHECK(model.mesh.corner(0, 2).shine == Shine{glm::vec3(0.5f), 32.0f});
    CHECK(model.mesh.corner(1, 0).shine.specular == glm::vec3(0));
    CHECK(model.mesh.corner(2, 0).shine == Shine{});
    const std::string mtl = folder.file("two parts.mtl");
    CHECK(skipped_lines(model.report) ==
          std::vector<std::string>{
              mtl + ":6: 1 statement '-clamp' is skipped: the only options of an image that are "
                    "used are -bm, -mm of disp, and -s and -o of map_Kd.",
              mtl + ":8: 1 statement 'illum' is skipped: this property of a material is not "
                    "used."});
}

TEST_CASE("Scale and offset of an image move the corners of its faces in the texture") {
    const test::TemporaryFolder folder;
    write_png({1, 1, {9, 9, 9, 255}}, folder.file("p.png"));
    const auto corners_by = [&](const std::string& map) {
        folder.write("m.mtl", "newmtl a\nmap_Kd " + map + " p.png\nnewmtl b\nmap_Kd p.png\n");
        const ObjModel model = read_obj(
            folder.write("m.obj", "mtllib m.mtl\n" + triangle_points +
                                      "vt 0.25 0.5\nvt 1 0\nvt 0 3\nusemtl a\nf 1/1 2/2 3/3\n"
                                      "usemtl b\nf 1/1 2/2 3/3\n"));
        const bool has_comma = map.find(',') != map.npos;
        CHECK(fault_lines(model.report) ==
              (has_comma ? std::vector<std::string>{folder.file("m.mtl") +
                                                    ":2: '1,5' has a decimal comma, but numbers "
                                                    "need a decimal point here; '-s' is left out."}
                         : std::vector<std::string>{}));
        // The other material keeps the places of the file.
        CHECK(model.mesh.corner(1, 0).texcoord == glm::vec2(0.25f, 0.5f));
        std::vector<glm::vec2> places;
        for (int corner = 0; corner < 3; ++corner)
            places.push_back(model.mesh.corner(0, corner).texcoord);
        return places;
    };
    using Places = std::vector<glm::vec2>;
    CHECK(corners_by("-s 2 4 1") == Places{{0.5f, 2}, {2, 0}, {0, 12}});
    CHECK(corners_by("-o 0.5 -1 7") == Places{{0.75f, -0.5f}, {1.5f, -1}, {0.5f, 2}});
    CHECK(corners_by("-o 1 1 -s 2") == Places{{1.5f, 1.5f}, {3, 1}, {1, 4}});
    CHECK(corners_by("-s 0 0") == Places{{0, 0}, {0, 0}, {0, 0}});
    CHECK(corners_by("-s") == Places{{0.25f, 0.5f}, {1, 0}, {0, 3}}); // the name is no number
    CHECK(corners_by("-s 2 1,5 1") == Places{{0.5f, 0.5f}, {2, 0}, {0, 3}}); // that is reported
    CHECK(corners_by("-s 1 1e9")[2].y == static_cast<float>(largest_model_coordinate)); // not 3e9
}

TEST_CASE("A file of materials can be named in quotes, and is plain text") {
    const test::TemporaryFolder folder;
    folder.write("my two.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("wide.mtl", std::string("\xff\xfen\0e\0w\0m\0t\0l\0 \0a\0", 18));
    const auto read = [&](const std::string& statement) {
        return read_obj(folder.write("m.obj", statement + "\nusemtl a\n" + one_face));
    };
    folder.write("'tis.mtl", "newmtl a\nKd 1 0 0\n");
    for (const char* const statement :
         {"mtllib \"my two.mtl\"", "mtllib 'my two.mtl'", "mtllib \" my two.mtl",
          "mtllib \"my two.mtl\" # made of clay", "mtllib my two.mtl", "mtllib 'tis.mtl"}) {
        INFO(statement);
        const ObjModel model = read(statement);
        CHECK(fault_lines(model.report).empty());
        CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(1, 0, 0));
    }
    CHECK(fault_lines(read("mtllib wide.mtl").report).front() ==
          folder.file("m.obj") + ":1: 'mtllib': " + folder.file("wide.mtl") +
              ":1: the file is UTF-16; a material file must be plain text. It is left out.");
}

TEST_CASE("Several files of materials can each be named in quotes") {
    const test::TemporaryFolder folder;
    folder.write("my two.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("one.mtl", "newmtl b\nKd 0 1 0\n");
    for (const char* const names :
         {"\"my two.mtl\" \"one.mtl\"", "'one.mtl' \"my two.mtl\"", "one.mtl 'my two.mtl'",
          "'my two.mtl'\tone.mtl", "\"one.mtl\"'my two.mtl'"}) {
        INFO(names);
        const ObjModel model =
            read_obj(folder.write("m.obj", std::string("mtllib ") + names + "\nusemtl a\n" +
                                               one_face + "usemtl b\nf 3 2 1\n"));
        CHECK(fault_lines(model.report).empty());
        REQUIRE(model.mesh.triangle_count() == 2);
        CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(1, 0, 0));
        CHECK(model.mesh.corner(1, 0).reflectance == glm::vec3(0, 1, 0));
    }
}

TEST_CASE("A long name of a material is cut in both files, and an exponent at its limit") {
    const test::TemporaryFolder folder;
    const std::string name(5 * longest_material_name, 'x');
    folder.write("m.mtl", "newmtl " + name + "\nKd 0.5\nKs 1\nNs 1e8\n");
    const ObjModel model =
        read_obj(folder.write("m.obj", "mtllib m.mtl\nusemtl " + name + "\n" + one_face));
    CHECK(model.report.counts.faults == 0);
    REQUIRE(model.materials.size() == 1);
    CHECK(model.materials[0].name.size() == longest_material_name);
    CHECK(model.parts[0].material == 0);
    CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(0.5f));
    CHECK(model.mesh.corner(0, 0).shine == Shine{glm::vec3(1.0f), largest_exponent});
}

TEST_CASE("Faults in a file of materials are reported with their own lines") {
    struct Case {
        std::string line, fault;
    };
    const test::TemporaryFolder folder;
    const std::string mtl = folder.file("m.mtl");
    std::filesystem::create_directory(folder.file("images"));
    write_png({1, 1, {9, 9, 9, 255}}, folder.file("p.png"));
    const std::string path = folder.write("m.obj", "mtllib m.mtl\n" + one_face);
    for (const Case& one : std::vector<Case>{
             {"Kd 0 0 2", "'Kd' takes one or three numbers from 0 to 1; it is left out."},
             {"Kd 0 nan 0", "'Kd' takes one or three numbers from 0 to 1; it is left out."},
             {"Kd 0 0", "'Kd' takes one or three numbers from 0 to 1; it is left out."},
             {"Ks", "'Ks' takes one or three numbers from 0 to 1; it is left out."},
             {"Kd 0 0,5 0",
              "'0,5' has a decimal comma, but numbers need a decimal point here; 'Kd' is left "
              "out."},
             {"d 0,5",
              "'0,5' has a decimal comma, but numbers need a decimal point here; 'd' is left out."},
             {"Ns -1", "'Ns' takes a number from 0 up; it is left out."},
             {"Ns", "'Ns' takes a number from 0 up; it is left out."},
             {"disp -mm 0 nan p.png", "'nan' is not a valid number for '-mm', which is left out."},
             {"disp -mm 0 1e38 p.png",
              "'1e38' is not a valid number for '-mm', which is left out."},
             {"disp -mm 0.05x 1 p.png",
              "'0.05x' is not a valid number for '-mm', which is left out."},
             {"bump -bm inf p.png", "'inf' is not a valid number for '-bm', which is left out."},
             {"newmtl", "'newmtl' has no name; it is left out."},
             {"map_Kd", "'map_Kd': no file is named; the image is left out."},
             {"map_Kd none.png", "'map_Kd': there is no file 'none.png'; the image is left out."},
             {"map_Bump images", "'map_Bump': 'images' is a folder; the image is left out."},
             {"bump /dev/null", "'bump': there is no file '/dev/null' in its folder, below it or "
                                "in a folder next to it; the image is left out."}}) {
        INFO(one.line);
        folder.write("m.mtl", "newmtl a\n" + one.line + "\n");
        CHECK(fault_lines(read_obj(path).report) ==
              std::vector<std::string>{mtl + ":2: " + one.fault});
    }
    folder.write("m.mtl", "newmtl a\ndisp -mm 0.5 nan p.png\n");
    CHECK_FALSE(read_obj(path).materials.at(0).has_height_range);
    folder.write("m.mtl", "Kd 1 1 1\n");
    CHECK(
        fault_lines(read_obj(path).report) ==
        std::vector<std::string>{mtl + ":1: 'Kd' comes before the first newmtl; it is left out."});
    folder.write("m.mtl", std::string(largest_material_file + 1, '\n'));
    CHECK(fault_lines(read_obj(path).report) ==
          std::vector<std::string>{path + ":1: 'mtllib': " + mtl +
                                   ": the file is larger than 4 MB. It is left out."});
}

TEST_CASE("Missing normals are the faces', or smoothed where the angle between faces is small") {
    // A roof: two squares that meet in the edge from (0,0,0) to (0,0,1), 60 degrees apart.
    const std::string roof = "v -1 0 0\nv -1 0 -1\nv 0 0 -1\nv 0 0 0\n"
                             "v 0.5 -0.8660254 0\nv 0.5 -0.8660254 -1\n"
                             "f 1 4 3 2\nf 4 5 6 3\n";
    const glm::vec3 up(0, 1, 0), slope(0.8660254f, 0.5f, 0);
    const auto normal = [&](float crease_angle, int triangle, int corner) {
        return parse_obj(roof, "m.obj", {crease_angle}).mesh.corner(triangle, corner).normal;
    };
    const auto is_near = [](const glm::vec3& a, const glm::vec3& b) {
        return glm::length(a - b) < 1e-5f;
    };
    for (const float angle : {0.0f, 1.0f}) { // 1 radian is 57 degrees
        CHECK(is_near(normal(angle, 0, 0), up));
        CHECK(is_near(normal(angle, 0, 1), up));
        CHECK(is_near(normal(angle, 2, 0), slope));
    }
    // Both have a right angle at the edge, so the normal is halfway.
    CHECK(is_near(normal(1.1f, 0, 0), up));
    CHECK(is_near(normal(1.1f, 0, 1), glm::normalize(up + slope)));
    CHECK(is_near(normal(1.1f, 2, 0), glm::normalize(up + slope)));
    CHECK(is_near(normal(1.1f, 2, 1), slope));
    CHECK(parse_obj(roof, "m.obj", {0.0f}).mesh.vertices().size() == 8);
    CHECK(parse_obj(roof, "m.obj", {1.1f}).mesh.vertices().size() == 6);
}

TEST_CASE("A model is recognized by its file's ending") {
    CHECK(is_model_file("a/m.obj"));
    CHECK(is_model_file("M.OBJ"));
    CHECK_FALSE(is_model_file(".obj"));
    CHECK_FALSE(is_model_file("m.obj.toml"));
    CHECK_FALSE(is_model_file("-"));
}

TEST_CASE("Reading reports its progress, and stops where its watch says so") {
    constexpr int count = 3000; // points, and a triangle after each but the first two
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
        if (i >= 2) text += "f -3 -2 -1\n";
    }
    std::vector<ReadingState> reported;
    const ObjModel model = parse_obj(text, "m.obj", {}, [&](const ReadingState& state) {
        reported.push_back(state);
        return true;
    });
    CHECK(model.mesh == parse_obj(text, "m.obj").mesh);
    REQUIRE(model.mesh.triangle_count() == count - 2);
    // A step is a statement or a face. Progress is reported for those, and once more for each part.
    const std::size_t steps = count + 2 * (count - 2);
    CHECK(reported.size() == steps / WatchedSteps::steps_between + 2);
    const auto first_made =
        std::find_if(reported.begin(), reported.end(), [](const ReadingState& state) {
            return state.part == ReadingPart::triangles;
        });
    REQUIRE(first_made > reported.begin());
    REQUIRE(first_made < reported.end());
    CHECK(*(first_made - 1) ==
          ReadingState{ReadingPart::bytes, std::ssize(text), std::ssize(text)});
    CHECK(*first_made == ReadingState{ReadingPart::triangles, 0, count - 2});
    for (std::size_t i = 1; i < reported.size(); ++i) {
        INFO(i);
        if (reported[i].part == reported[i - 1].part)
            CHECK(reported[i].done > reported[i - 1].done);
        CHECK(reported[i].all ==
              (reported[i].part == ReadingPart::bytes ? std::ssize(text) : count - 2));
    }
    for (std::size_t last = 0; last < reported.size(); ++last) {
        INFO("stopped when asked for the time " << last);
        std::size_t asked = 0;
        CHECK_THROWS_AS(
            parse_obj(text, "m.obj", {}, [&](const ReadingState&) { return asked++ < last; }),
            ReadingStopped);
        CHECK(asked == last + 1);
    }
}
