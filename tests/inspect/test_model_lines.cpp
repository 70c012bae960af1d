// The lines of a model's file, compared with the file, and what a click on them leads to, compared
// with a search through all corners.

#include "inspect/model_lines.h"

#include <cmath>
#include <sstream>
#include <string>

#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {
namespace model_lines {

std::string cube_path() {
    return project_root() + "/lessons/models/cube.obj";
}

std::string joined(const FileLine& line) {
    std::string text;
    for (const FilePiece& piece : line.pieces)
        text += piece.text;
    return text;
}

FileLine line_of(const ObjModel& model, int number) {
    const std::vector<FileLine> lines = file_lines(*model.source, model.report, number, 1);
    REQUIRE(lines.size() == 1);
    REQUIRE(lines[0].number == number);
    return lines[0];
}

std::string corners_of_line(const FileLine& line) {
    std::string words;
    for (const FilePiece& piece : line.pieces) {
        if (piece.corner >= 0) words += std::to_string(piece.corner) + "=" + piece.text + " ";
    }
    return words;
}

} // namespace model_lines
} // namespace

using namespace model_lines;

TEST_CASE("The lines of a model's file are those of the file, whichever are asked for") {
    const std::string text = test::bytes_of(cube_path());
    const ObjModel model = read_obj(cube_path());
    const std::vector<FileLine> all = file_lines(*model.source, model.report, 1, 1000);
    REQUIRE(all.size() == static_cast<std::size_t>(model.source->lines));
    std::istringstream in(text);
    std::string expected;
    for (const FileLine& line : all) {
        REQUIRE(std::getline(in, expected));
        CHECK(joined(line) == expected);
        CHECK((line.face > 0) == expected.starts_with("f "));
        CHECK((line.use == FileLineUse::aside) == expected.starts_with("#"));
        CHECK(joined(line_of(model, line.number)) == expected);
    }
    CHECK(file_lines(*model.source, model.report, 26, 5).empty());
    CHECK(corners_of_line(line_of(model, 20)) == "0=5/1/1 1=6/2/1 2=8/3/1 3=7/4/1 ");
}

TEST_CASE("A face over several lines, with a comment, has its corners in order") {
    std::string text = "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (int i = 5; i <= 70; ++i)
        text += "#\n";
    text += "f 1 2\\\n 3 \\\t\n\t4 # 5 \\\n 6\nf 1 2 3";
    const ObjModel model = parse_obj(text, "m.obj");
    CHECK(model.report.counts.faults == 0);
    CHECK(joined(line_of(model, 1)) == "v 0 0 0");
    CHECK(corners_of_line(line_of(model, 71)) == "0=1 1=2 ");
    CHECK(corners_of_line(line_of(model, 72)) == "2=3 ");
    CHECK(joined(line_of(model, 72)) == " 3 \\ ");
    CHECK(corners_of_line(line_of(model, 73)) == "3=4 ");
    CHECK(corners_of_line(line_of(model, 74)).empty());
    CHECK(line_of(model, 74).face == 71);
    CHECK(corners_of_line(line_of(model, 75)) == "0=1 1=2 2=3 ");
    CHECK(line_of(model, 75).face == 75);
}

TEST_CASE("What the reader did not use is set aside, and what is wrong has the reader's sentence") {
    const ObjModel model =
        parse_obj("mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\nf 1 2 9\n"
                  "curv 0 1 1 2\nhello\nv 1,5 2 3\nvn 0 0 0\nv 1 2 3 4\n",
                  "m.obj");
    CHECK(line_of(model, 2).use == FileLineUse::unmarked);
    CHECK(line_of(model, 6).use == FileLineUse::unmarked);
    for (const ObjFault& fault : model.report.faults) {
        const FileLine line = line_of(model, fault.line);
        CHECK(line.use == FileLineUse::faulty);
        CHECK(line.sentence == fault.sentence);
    }
    for (const int line : {1, 5, 7, 10, 11})
        CHECK(line_of(model, line).use == FileLineUse::faulty);
    CHECK(line_of(model, 8).use == FileLineUse::aside);
    CHECK(line_of(model, 8).sentence == "skipped: curves and curved surfaces are not drawn.");
    CHECK(line_of(model, 9).sentence == "skipped: it is not a statement of the OBJ format.");
    // Its place is used; what follows it is not.
    CHECK(line_of(model, 12).use == FileLineUse::unmarked);
    CHECK_FALSE(line_of(model, 12).sentence.empty());
}

TEST_CASE("Of faults that are alike the first line is marked, and says how many more there are") {
    const ObjModel model = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nvn 0 0 0\nvn 0 0 0\n"
                                     "vn 0 0 0\nvt x\nvt y\n",
                                     "m.obj");
    REQUIRE(model.report.counts.faults == 5);
    REQUIRE(model.report.faults.size() == 2);
    CHECK(line_of(model, 5).use == FileLineUse::faulty);
    CHECK(line_of(model, 5).sentence ==
          model.report.faults[0].sentence + " There are 2 more like it. Only the first is marked.");
    CHECK(line_of(model, 8).use == FileLineUse::faulty);
    CHECK(line_of(model, 8).sentence ==
          model.report.faults[1].sentence + " There is 1 more like it. Only the first is marked.");
    for (const int line : {6, 7, 9}) {
        CAPTURE(line);
        CHECK(line_of(model, line).use == FileLineUse::unmarked);
        CHECK(line_of(model, line).sentence.empty());
    }
}

TEST_CASE("A line is not cut within a character of several bytes") {
    std::string comment = "#", shown = "#";
    for (int i = 0; i < 200; ++i)
        comment += "é";
    // The character that begins with byte 299 ends beyond the most that is shown.
    for (int i = 0; i < 149; ++i)
        shown += "é";
    const ObjModel model =
        parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n" + comment + "\n", "m.obj");
    CHECK(joined(line_of(model, 5)) == shown + "…");
}

TEST_CASE("Of a long face, the corners that can be shown are recognized, and none after them") {
    // 5 bytes for each corner.
    std::string face = "f";
    for (int i = 0; i < 1000; ++i)
        face += " 1/" + std::string(i % 2 == 0 ? "11" : "22");
    const ObjModel model =
        parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n" + face + "\\\n 1 2 3\nf 1 2 3\n", "m.obj");
    const FileLine line = line_of(model, 5);
    int corners = 0;
    for (const FilePiece& piece : line.pieces)
        corners += piece.corner >= 0 ? 1 : 0;
    // The letter takes a byte, so the last corner is one byte short.
    CHECK(corners == 60);
    CHECK(line.pieces.back().text == "1/2…");
    CHECK(line_of(model, 6).face == 5);
    CHECK(corners_of_line(line_of(model, 6)).empty());
    CHECK(corners_of_line(line_of(model, 7)) == "0=1 1=2 2=3 ");
}

TEST_CASE("A long or hostile line is cut, and shown in printable form") {
    std::string face = "f 1 2 3";
    for (int i = 0; i < 200'000; ++i)
        face += " 1 2 3";
    const ObjModel model = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n\x1b[2J\xff"
                                     "\t\n" +
                                         face,
                                     "m.obj");
    CHECK(joined(line_of(model, 5)) == "\\u001b[2J\\xff ");
    CHECK(joined(line_of(model, 6)).size() <= most_line_bytes + 4);
    std::string backslashes = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 3";
    for (int i = 0; i < 10'000; ++i)
        backslashes += "\\\n";
    const ObjModel joined_lines = parse_obj(backslashes, "m.obj");
    CHECK(line_of(joined_lines, 5).face == 5);
    CHECK(line_of(joined_lines, 9000).pieces.size() <= 1);
}

TEST_CASE("A corner after what is shown of its line has its number in place of its words") {
    std::string text, face = "f";
    for (int i = 0; i < 200; ++i) {
        const double angle = i * 0.031;
        text +=
            "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const ObjModel model = parse_obj(text + face + "\n", "m.obj");
    const ModelSource& source = *model.source.get();
    const auto words = [&](int number) {
        FileCorner corner;
        corner.line = 201;
        corner.number = number;
        corner.names.position = number;
        return corner_words(source, corner);
    };
    CHECK(words(2) == "corner 3 → v 3");
    CHECK(words(190) == "corner [190] → v 191");
}

TEST_CASE("A vertex of a drawn triangle leads to its corner in the file") {
    const Scene scene = scene_of_model(read_obj(cube_path()));
    Settings settings = default_settings(scene);
    for (const char* hidden : {"hidden=depth_buffer", "hidden=painter"}) {
        set_from_text(settings, hidden);
        const Frame frame = prepare_frame(scene, settings);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            CAPTURE(hidden, t);
            CHECK(drawn_triangle(frame, model_triangle(frame, t)) == t);
            for (int v = 0; v < 3; ++v) {
                const std::optional<FileCorner> corner = file_corner(frame, t, v);
                REQUIRE(corner);
                // The cube's points are in its first lines, with coordinates -1 and 1, and y and z
                // are negated in the scene.
                const glm::vec3 place = frame.scene->corner(t, v).position;
                const int number =
                    (place.x > 0 ? 1 : 0) + (place.y < 0 ? 2 : 0) + (place.z < 0 ? 4 : 0);
                CHECK(corner->names.position == number);
                CHECK(corner->position_line == 2 + number);
                CHECK(corner->texcoord_line == 10 + corner->names.texcoord);
                CHECK(corner->normal_line == 14 + corner->names.normal);
                CHECK(corner->line == 20 + model_triangle(frame, t) / 2);
                const FileLine line =
                    file_lines(*scene.model_source.get(), *scene.model_report, corner->line, 1)
                        .at(0);
                std::string word;
                for (const FilePiece& piece : line.pieces) {
                    if (piece.corner == corner->number) word = piece.text;
                }
                const std::string written = std::to_string(number + 1) + "/" +
                                            std::to_string(corner->names.texcoord + 1) + "/" +
                                            std::to_string(corner->names.normal + 1);
                CHECK(word == written);
                CHECK(corner_words(*scene.model_source.get(), *corner) ==
                      "corner " + written + " → v " + std::to_string(number + 1) + ", vt " +
                          std::to_string(corner->names.texcoord + 1) + ", vn " +
                          std::to_string(corner->names.normal + 1));
            }
        }
    }
    set_from_text(settings, "hidden=depth_buffer");
    set_from_text(settings, "tessellation=3");
    const Frame frame = prepare_frame(scene, settings);
    REQUIRE(frame.triangle_count() == 9 * 12);
    CHECK(model_triangle(frame, 20) == 2);
    CHECK(drawn_triangle(frame, 2) == 18);
    CHECK_FALSE(file_corner(frame, 20, 0));
}

TEST_CASE("A click on a line leads to a triangle that uses it, if possible to the one shown") {
    const ObjModel model = read_obj(cube_path());
    const ModelSource& source = *model.source;
    // The face of line 21 is triangles 2 and 3.
    CHECK(vertex_of_line(source, line_of(model, 21), -1, 0)->triangle == 2);
    CHECK(vertex_of_line(source, line_of(model, 21), -1, 3)->triangle == 3);
    for (int preferred = 0; preferred < 12; ++preferred) {
        for (int number = 1; number <= source.lines; ++number) {
            CAPTURE(preferred, number);
            const FileLine line = line_of(model, number);
            const std::string text = joined(line);
            const std::optional<ModelVertex> found = vertex_of_line(source, line, -1, preferred);
            REQUIRE(found.has_value() == !text.starts_with("#"));
            if (!found || text.starts_with("f ")) continue;
            const auto uses = [&](int triangle, int vertex) {
                const auto corner = source.corners[static_cast<std::size_t>(
                    source.triangles[static_cast<std::size_t>(triangle)]
                        .corners[static_cast<std::size_t>(vertex == 0 ? 0 : 3 - vertex)])];
                if (number <= 9) return corner.position == number - 2;
                return number <= 13 ? corner.texcoord == number - 10 : corner.normal == number - 14;
            };
            CHECK(uses(found->triangle, found->vertex));
            const bool preferred_uses =
                uses(preferred, 0) || uses(preferred, 1) || uses(preferred, 2);
            CHECK((found->triangle == preferred) == preferred_uses);
        }
    }
    for (int corner = 0; corner < 4; ++corner) {
        const std::optional<ModelVertex> found =
            vertex_of_line(source, line_of(model, 20), corner, 0);
        REQUIRE(found);
        const auto& corners = source.triangles[static_cast<std::size_t>(found->triangle)].corners;
        CHECK(corners[found->vertex == 0 ? 0 : static_cast<std::size_t>(3 - found->vertex)] ==
              corner);
    }
    const ObjModel spare = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nf 1 2 3\n", "m.obj");
    CHECK_FALSE(vertex_of_line(*spare.source, line_of(spare, 4), -1, 0));
}
