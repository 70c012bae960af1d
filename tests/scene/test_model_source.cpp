// The text of a model's file and the lines that its triangles were made of, compared with the file
// as the standard library reads it.

#include "scene/model_source.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "base/limits.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "tests/support/catch.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {
namespace model_source {

constexpr const char* square_model = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// The point of a line "v x y z".
glm::vec3 point_on(const std::string& line) {
    glm::vec3 point(0.0f);
    REQUIRE(std::sscanf(line.c_str(), "v %f %f %f", &point.x, &point.y, &point.z) == 3);
    return point;
}

} // namespace model_source
} // namespace

using namespace model_source;

TEST_CASE("Each triangle of a model knows the line of its face, and its corners the lines of v") {
    for (const char* name : {"cube", "torus", "teapot"}) {
        CAPTURE(name);
        const std::string path = project_root() + "/lessons/models/" + name + ".obj";
        const std::vector<std::string> lines = lines_of(test::bytes_of(path));
        const ObjModel model = read_obj(path);
        const ModelSource& source = *model.source;
        CHECK(source.text == test::bytes_of(path));
        CHECK(source.bytes == source.text.size());
        CHECK(source.lines == static_cast<int>(lines.size()));
        REQUIRE(source.triangles.size() == model.mesh.triangles().size());
        int line_before = 0;
        for (int t = 0; t < model.mesh.triangle_count(); ++t) {
            const TriangleOrigin& origin = source.triangles[static_cast<std::size_t>(t)];
            REQUIRE(origin.line >= line_before);
            line_before = origin.line;
            const std::string& face = lines.at(static_cast<std::size_t>(origin.line - 1));
            REQUIRE(face.starts_with("f "));
            for (std::size_t i = 0; i < origin.corners.size(); ++i) {
                const ObjCorner& corner =
                    source.corners.at(static_cast<std::size_t>(origin.corners[i]));
                // One word of the line is this corner.
                std::istringstream words(face.substr(2));
                bool is_written = false;
                for (std::string word; words >> word;)
                    is_written = is_written || std::stoi(word) == corner.position + 1;
                CHECK(is_written);
                const int line =
                    source.position_lines.at(static_cast<std::size_t>(corner.position));
                CHECK(model.mesh.corner(t, static_cast<int>(i)).position ==
                      point_on(lines.at(static_cast<std::size_t>(line - 1))));
            }
        }
    }
}

TEST_CASE("Corners are found behind relative numbers, joined lines and a face cut by ears") {
    // An arrow: no fan from its first corner covers it.
    const ObjModel model = parse_obj("# a\r\nv 0 0 0\r\nv 4 2 0\rv 0 4 0\nv 1 2 0\nvt 0 0\n"
                                     "vn 0 0 1\n\nf -4//-1 \\\n -3/1/-1 -2 \\\n-1/7/1\n",
                                     "m.obj");
    const ModelSource& source = *model.source;
    CHECK(source.position_lines == std::vector<int>{2, 3, 4, 5});
    CHECK(source.texcoord_lines == std::vector<int>{6});
    CHECK(source.normal_lines == std::vector<int>{7});
    CHECK(source.lines == 11);
    REQUIRE(source.triangles.size() == 2);
    // vt 7 does not exist, and is not used.
    const std::vector<ObjCorner> expected{{0, -1, 0}, {1, 0, 0}, {2, -1, -1}, {3, -1, 0}};
    CHECK(source.corners == expected);
    for (const TriangleOrigin& origin : source.triangles)
        CHECK(origin.line == 9);
    for (int t = 0; t < 2; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int corner = source.triangles[static_cast<std::size_t>(t)].corners[i];
            const std::array<glm::vec3, 4> places{glm::vec3(0, 0, 0), glm::vec3(4, 2, 0),
                                                  glm::vec3(0, 4, 0), glm::vec3(1, 2, 0)};
            CHECK(model.mesh.corner(t, static_cast<int>(i)).position ==
                  places.at(static_cast<std::size_t>(corner)));
        }
    }
}

TEST_CASE("The text can be read from any line on") {
    std::string text = square_model;
    for (int i = 0; i < 300; ++i)
        text += "# line " + std::to_string(5 + i) +
                (i % 3 == 0   ? "\r\n"
                 : i % 3 == 1 ? "\r"
                              : "\n");
    text += "f 1 2 3 4";
    const ObjModel model = parse_obj(text, "m.obj");
    CHECK(model.source->lines == 305);
    for (int line = 5; line < 305; ++line) {
        const std::string begin = "# line " + std::to_string(line);
        REQUIRE(text_from_line(*model.source, line).substr(0, begin.size()) == begin);
    }
    CHECK(text_from_line(*model.source, 305) == "f 1 2 3 4");
    for (const int none : {-1, 0, 306, 400, 2'000'000'000})
        CHECK(text_from_line(*model.source, none).empty());
}

TEST_CASE("The text of a file that is too large is not kept, but the lines of its triangles are") {
    std::string text = std::string(square_model) + "f 1 2 3 4\n#";
    text.resize(most_kept_model_text, '.');
    CHECK(parse_obj(text, "m.obj").source->text.size() == text.size());
    text += '.';
    const ObjModel model = parse_obj(text, "m.obj");
    CHECK(model.source->bytes == text.size());
    CHECK(model.source->text.empty());
    CHECK(model.source->corners.empty());
    CHECK(model.source->line_marks.empty());
    REQUIRE(model.source->triangles.size() == 2);
    CHECK(model.source->triangles[1].line == 5);
}

TEST_CASE("A scene shares the source of its model with its copies") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("m.obj", std::string(square_model) + "f 1 2 3 4\n");
    const Scene scene = scene_of_model(read_obj(path));
    const Scene copy = scene;
    CHECK(copy.model_source.get() == scene.model_source.get());
    CHECK(copy == scene);
    CHECK(scene.model_source.get()->state == file_state(path));
    folder.write("m.obj", std::string(square_model) + "f 1 2 3\nf 1 3 4\n");
    CHECK(scene.model_source.get()->state != file_state(path));
    CHECK_FALSE(scene_of_model(read_obj(path)).model_source == scene.model_source);
    // A corner of the scene is where its corner of the file is, once the model is put in its place.
    const ModelSource& source = *scene.model_source.get();
    const std::array<glm::vec3, 4> places{glm::vec3(-1, 1, 0), glm::vec3(1, 1, 0),
                                          glm::vec3(1, -1, 0), glm::vec3(-1, -1, 0)};
    for (int t = 0; t < 2; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int corner = source.triangles[static_cast<std::size_t>(t)]
                                   .corners[static_cast<std::size_t>(model_corners[i])];
            CHECK(scene.corner(t, static_cast<int>(i)).position ==
                  places.at(static_cast<std::size_t>(corner)));
        }
    }
}
