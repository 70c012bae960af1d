#include "scene/read_scene.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

const std::string start = "name = \"s\"\n"
                          "[points.p]\n"
                          "A = [1, 2, 3]\n"
                          "B = [0.5, -1, 2]\n"
                          "C = [0, 0, 1]\n";
const std::string part = "[[part]]\n"
                         "name = \"q\"\n"
                         "points = \"p\"\n"
                         "triangles = [\"A B C\"]\n";

/// The sentence with which the reader refuses a text.
std::string refusal(const std::string& text) {
    try {
        parse_scene(text, "s.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// The text with its line `number` (from 1) replaced.
std::string with_line(const std::string& text, int number, const std::string& line) {
    std::size_t first = 0;
    for (int i = 1; i < number; ++i)
        first = text.find('\n', first) + 1;
    std::string changed = text;
    return changed.replace(first, text.find('\n', first) - first, line);
}

/// A triangle of the handout's table: vertices before scaling, divided nowhere.
struct Expected {
    int number;
    std::string part;
    std::array<glm::vec3, 3> points;
    glm::vec3 reflectance;
};

} // namespace

TEST_CASE("The lab's room gives the numbers that were found independently of this program") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    CHECK(scene.triangle_count() == 30);
    Settings settings = default_settings(scene);
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer framebuffer;
    clear(framebuffer, settings.viewport);
    const DrawTally tally = draw(frame, {}, framebuffer);
    CHECK(tally.fragments == 328789);
    CHECK(tally.samples_outside == 4);
    CHECK(std::count(framebuffer.overdraw.begin(), framebuffer.overdraw.end(), 0u) == 998);
    CHECK(*std::max_element(framebuffer.overdraw.begin(), framebuffer.overdraw.end()) == 8);
}

TEST_CASE("The lab's room has the handout's triangles in the handout's order") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    REQUIRE(scene.triangle_count() == 30);
    const std::vector<Expected> table{
        {0, "floor", {{{555, 0, 555}, {0, 0, 0}, {555, 0, 0}}}, {.15f, .75f, .15f}},
        {3, "left wall", {{{555, 0, 555}, {555, 555, 0}, {555, 555, 555}}}, {.75f, .15f, .75f}},
        {4, "right wall", {{{0, 555, 0}, {0, 0, 0}, {0, 0, 555}}}, {.75f, .75f, .15f}},
        {7, "ceiling", {{{0, 555, 0}, {0, 555, 555}, {555, 555, 555}}}, {.15f, .75f, .75f}},
        {9, "back wall", {{{555, 555, 555}, {0, 555, 555}, {0, 0, 555}}}, {.75f, .75f, .75f}},
        {12, "short block", {{{130, 165, 65}, {82, 0, 225}, {130, 0, 65}}}, {.75f, .15f, .15f}},
        {29,
         "tall block",
         {{{472, 330, 406}, {314, 330, 456}, {265, 330, 296}}},
         {.15f, .15f, .75f}},
    };
    for (const Expected& expected : table) {
        INFO("triangle " << expected.number);
        CHECK(part_name(scene, expected.number) == expected.part);
        for (int v = 0; v < 3; ++v) {
            INFO("vertex " << v);
            const Vertex& vertex = scene.corner(expected.number, v);
            const glm::vec3& p = expected.points[static_cast<std::size_t>(v)];
            const glm::vec3 scaled{1 - 2 * p.x / 555, 1 - 2 * p.y / 555, 2 * p.z / 555 - 1};
            CHECK(vertex.position.x == scaled.x);
            CHECK(vertex.position.y == scaled.y);
            CHECK(vertex.position.z == scaled.z);
            CHECK(vertex.reflectance == expected.reflectance);
        }
    }
}

TEST_CASE("The lab's room opens with the handout's camera, light and window") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    CHECK(scene.camera.position == glm::vec3(0.0f, 0.0f, -3.001f));
    CHECK(scene.camera.focal_length == 500.0f);
    CHECK(scene.light.position == glm::vec3(0.0f, -0.5f, -0.7f));
    CHECK(scene.light.power == glm::vec3(1.1f));
    CHECK(scene.light.indirect == glm::vec3(0.5f));
    CHECK(scene.viewport == Viewport{500, 500});
}

TEST_CASE("Normals point into the room from its walls and out of the blocks") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    // Up is -y: the floor's normal, and that of both blocks' tops.
    for (const int t : {0, 1, 18, 19, 28, 29}) {
        INFO("triangle " << t);
        CHECK(scene.corner(t, 0).normal.y == Approx(-1.0f));
    }
    CHECK(scene.corner(2, 0).normal.x == Approx(1.0f));
    CHECK(scene.corner(4, 0).normal.x == Approx(-1.0f));
    CHECK(scene.corner(8, 0).normal.z == Approx(-1.0f));
}

TEST_CASE("The bench opens with the lab's triangle in pixels and offers ten others") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/one-triangle.toml");
    CHECK(scene.space == SceneSpace::pixels);
    REQUIRE(scene.triangle_count() == 1);
    CHECK(scene.corner(0, 0).position == glm::vec3(10, 5, 1));
    CHECK(scene.corner(0, 1).position == glm::vec3(5, 10, 1));
    CHECK(scene.corner(0, 2).position == glm::vec3(15, 15, 1));
    CHECK(scene.examples.size() == 11);
    CHECK(scene.stage == "rows");
}

TEST_CASE("The bench's smallest case of a lost end point does leave its table") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/one-triangle.toml");
    const auto found =
        std::find_if(scene.examples.begin(), scene.examples.end(),
                     [](const BenchExample& e) { return e.name == "A sample outside"; });
    REQUIRE(found != scene.examples.end());
    Scene bench = scene;
    for (int v = 0; v < 3; ++v)
        bench.mesh.place_corner(0, v, found->positions[static_cast<std::size_t>(v)]);
    const Settings settings = default_settings(bench);
    Framebuffer framebuffer;
    clear(framebuffer, settings.viewport);
    CHECK(draw(prepare_frame(bench, settings), {}, framebuffer).samples_outside == 1);
}

TEST_CASE("A small scene is read as it is written") {
    const Scene scene = parse_scene(start + part, "s.toml");
    REQUIRE(scene.triangle_count() == 1);
    CHECK(scene.corner(0, 1).position == glm::vec3(0.5f, -1.0f, 2.0f));
    CHECK(scene.corner(0, 1).reflectance == glm::vec3(1.0f));
    CHECK(scene.parts.at(0).name == "q");
    CHECK(scene.space == SceneSpace::world);
    CHECK(scene.path == "s.toml");
}

TEST_CASE("Colours and lights may be one number for all three channels") {
    const Scene scene =
        parse_scene(start + "[light]\npower = 14\nindirect = [0.1, 0.2, 0.3]\n" + part, "s.toml");
    CHECK(scene.light.power == glm::vec3(14.0f));
    CHECK(scene.light.indirect == glm::vec3(0.1f, 0.2f, 0.3f));
}

TEST_CASE("A broken scene is refused with its file, line and what is wrong") {
    using Catch::Matchers::StartsWith;
    struct Case {
        std::string text, begins;
    };
    const std::string scene = start + part; // 5 + 4 lines
    const std::vector<Case> cases{
        {with_line(scene, 3, "A = [1, 2, 3"), "s.toml:4: "},
        {with_line(scene, 3, "A = [nan, 2, 3]"),
         "s.toml:3: the point 'A' must be a finite number."},
        {with_line(scene, 4, "B = [0, -inf, 3]"),
         "s.toml:4: the point 'B' must be a finite number."},
        {with_line(scene, 4, "B = [0, 1e30, 3]"), "s.toml:4: the point 'B' must be between"},
        {with_line(scene, 4, "B = [0, 1]"), "s.toml:4: the point 'B' must be three numbers."},
        {with_line(scene, 4, "B = [0, \"x\", 3]"), "s.toml:4: the point 'B' must be a number."},
        {with_line(scene, 4, "B = 3"), "s.toml:4: the point 'B' must be three numbers."},
        {with_line(scene, 9, "triangles = [\"A B D\"]"),
         "s.toml:9: there is no point 'D' in the point set 'p'."},
        {with_line(scene, 9, "triangles = [\"A B\"]"),
         "s.toml:9: a triangle has three points, but 'A B' names 2."},
        {with_line(scene, 9, "triangles = [\"A B C A\"]"),
         "s.toml:9: a triangle has three points, but 'A B C A' names 4."},
        {with_line(scene, 9, "triangles = [\"\"]"),
         "s.toml:9: a triangle has three points, but '' names 0."},
        {with_line(scene, 9, "triangles = [[0, 1, 2]]"),
         "s.toml:9: a triangle is written as the names of three points"},
        {with_line(scene, 9, "triangles = []"), "s.toml:9: part 1 has no triangles."},
        {with_line(scene, 9, "triangles = 3"), "s.toml:9: 'triangles' of part 1 must be a list."},
        {with_line(scene, 9, ""), "s.toml:6: part 1 needs 'triangles'."},
        {with_line(scene, 8, "points = \"r\""), "s.toml:8: there is no point set 'r'."},
        {with_line(scene, 7, "nom = \"q\""), "s.toml:7: part 1 has no 'nom'; it has: name, "},
        {with_line(scene, 1, "name = 3"), "s.toml:1: 'name' of the scene must be text in quotes."},
        {with_line(scene, 1, "name = \"\""), "s.toml:1: 'name' of the scene must not be empty."},
        {with_line(scene, 1, ""), "s.toml:1: the scene needs 'name'."},
        {with_line(scene, 1, "name = \"s\"\nspace = \"moon\""),
         "s.toml:2: 'space' must be \"world\" or \"pixels\", not 'moon'."},
        {"name = \"s\"\n", "s.toml:1: the scene has no triangles."},
        {"", "s.toml:1: the scene needs 'name'."},
        {scene + "[viewport]\nwidth = 0\n", "s.toml:11: 'width' of the viewport must be a whole"},
        {scene + "[viewport]\nheight = 100000\n",
         "s.toml:11: 'height' of the viewport must be a whole number between 1 and 4096."},
        {scene + "[viewport]\nwidth = 2.5\n", "s.toml:11: 'width' of the viewport must be a whole"},
        {scene + "[camera]\nyaw = nan\n",
         "s.toml:11: 'yaw' of the camera must be a finite number."},
        {scene + "[camera]\nroll = 1\n", "s.toml:11: the camera has no 'roll'"},
        {scene + "[camera]\nfocal_length = 0\n", "s.toml:11: 'focal_length' of the camera must"},
        {scene + "[light]\npower = -1\n", "s.toml:11: 'power' of the light must be between"},
        {scene + "[transform]\nedge = 0\n", "s.toml:11: 'edge' of the transform must be"},
        {scene + "[transform]\nmirror = [\"x\"]\n", "s.toml:10: the transform needs 'edge'."},
        {scene + "[transform]\nedge = 1\nmirror = [\"w\"]\n", "s.toml:12: 'mirror' lists axes"},
        {scene + "[[example]]\nname = \"e\"\nabout = \"a\"\npoints = [[0,0],[1,0],[0,1]]\n",
         "s.toml:10: examples are only allowed in a scene with space = \"pixels\"."},
    };
    for (const Case& one : cases) {
        INFO(one.text);
        CHECK_THAT(refusal(one.text), StartsWith(one.begins));
    }
}

TEST_CASE("A name with a zero or a control character does not cut the sentence off") {
    for (const char* const character : {"\\u0000", "\\u001b"}) {
        CHECK(refusal(start +
                      with_line(part, 4, "triangles = [\"A B " + std::string(character) + "\"]")) ==
              "s.toml:9: there is no point '" + std::string(character) + "' in the point set 'p'.");
    }
}

TEST_CASE("A point that the transform throws too far out is refused") {
    const std::string scene = with_line(start, 3, "A = [1000, 2, 3]") + part;
    CHECK(refusal(scene + "[transform]\nedge = 1e-3\n") ==
          "s.toml:3: the point 'A' is too far out after the transform.");
}

TEST_CASE("A pixel scene takes columns and rows and refuses what no picture has") {
    const auto pixels = [](const std::string& point) {
        return "name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = " + point +
               "\nB = [1, 1]\nC = [2, 5, 0.5]\n" + part;
    };
    CHECK(parse_scene(pixels("[3, 4]"), "s").corner(0, 0).position == glm::vec3(3, 4, 1));
    CHECK(parse_scene(pixels("[3, 4]"), "s").corner(0, 2).position.z == 0.5f);
    CHECK(refusal(pixels("[3, 4, 0]")).substr(0, 9) == "s.toml:4:");
    CHECK(refusal(pixels("[20000, 4]")).substr(0, 9) == "s.toml:4:");
    CHECK(refusal(pixels("[3]")).substr(0, 9) == "s.toml:4:");
    CHECK(refusal(pixels("[3, 4]") + "[transform]\nedge = 2\n") ==
          "s.toml:11: points in pixels cannot have a transform.");
}

TEST_CASE("A polygon of a scene in pixels becomes a fan, and what is not a polygon is refused") {
    const std::string head = "name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = [2, 2]\n"
                             "B = [10, 8]\nC = [18, 2]\nD = [18, 14]\nE = [2, 14]\n"
                             "[[part]]\nname = \"q\"\npoints = \"p\"\n";
    const Scene scene =
        parse_scene(head + "triangles = [\"A C D\"]\npolygons = [\"A B C D E\", \"B C D E\"]\n" +
                        "[[part]]\nname = \"r\"\npoints = \"p\"\npolygons = [\"E D C B\"]\n",
                    "s.toml");
    REQUIRE(scene.triangle_count() == 8);
    CHECK(scene.polygons == std::vector<ScenePolygon>{{1, 3}, {4, 2}, {6, 2}});
    CHECK(scene.parts.at(0).triangle_count == 6);
    CHECK(scene.parts.at(1).first_triangle == 6);
    CHECK(scene.parts.at(1).triangle_count == 2);
    const auto corners = [&](int triangle) {
        std::vector<glm::vec2> places;
        for (int v = 0; v < 3; ++v)
            places.emplace_back(scene.corner(triangle, v).position);
        return places;
    };
    const glm::vec2 a(2, 2), b(10, 8), c(18, 2), d(18, 14), e(2, 14);
    CHECK(corners(0) == std::vector{a, c, d}); // triangles first
    CHECK(corners(1) == std::vector{a, b, c});
    CHECK(corners(2) == std::vector{a, c, d});
    CHECK(corners(3) == std::vector{a, d, e});
    CHECK(corners(4) == std::vector{b, c, d});
    CHECK(corners(5) == std::vector{b, d, e});

    CHECK(refusal(head + "polygons = [\"A B C\"]\n") ==
          "s.toml:12: a polygon has four to 100 points, but this one names 3.");
    std::string many = "A";
    for (int i = 0; i < 100; ++i)
        many += " B";
    CHECK(refusal(head + "polygons = [\"" + many + "\"]\n") ==
          "s.toml:12: a polygon has four to 100 points, but this one names 101.");
    CHECK(refusal(head + "polygons = [\"A B C X\"]\n") ==
          "s.toml:12: there is no point 'X' in the point set 'p'.");
    CHECK(refusal(head + "polygons = [3]\n") ==
          "s.toml:12: a polygon is written as the names of its points in order, like \"A B C D "
          "E\".");
    CHECK(refusal(head + "polygons = []\n") == "s.toml:12: part 1 has no polygons.");
    CHECK(refusal(head + "polygons = 3\n") == "s.toml:12: 'polygons' of part 1 must be a list.");
    CHECK(refusal(start + with_line(part, 4, "polygons = [\"A B C A\"]")) ==
          "s.toml:9: polygons are only allowed in a scene with space = \"pixels\".");
}

TEST_CASE("A stage that does not exist is refused where the scene asks for it") {
    constexpr std::array<std::string_view, 2> stages{"rows", "fill"};
    const std::string scene = with_line(start, 1, "name = \"s\"\nstage = \"fil\"") + part;
    CHECK_NOTHROW(parse_scene(scene, "s.toml"));
    CHECK_THROWS_WITH(parse_scene(scene, "s.toml", stages),
                      "s.toml:2: there is no stage 'fil'; the stages are: rows, fill.");
}

TEST_CASE("Bytes that are not text are refused and not read as a scene") {
    const std::string zeros("\0\0\0", 3);
    CHECK(refusal(zeros).substr(0, 9) == "s.toml:1:");
    CHECK(refusal("name = \"\xff\xfe\"\n").substr(0, 9) == "s.toml:1:");
    CHECK(refusal(std::string(100000, '[')).substr(0, 9) == "s.toml:1:");
}

TEST_CASE("Text cut off anywhere is read or refused, but never crashes") {
    const std::string whole = test::bytes_of(lessons_folder() + "/scenes/lab-room.toml");
    REQUIRE(whole.size() > 1000);
    int accepted = 0;
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        accepted += refusal(whole.substr(0, length)) == "accepted" ? 1 : 0;
    }
    CHECK(accepted > 0);
    CHECK(accepted < static_cast<int>(whole.size()) / 14);
}

TEST_CASE("A scene file that is not there cannot be read, and this is not called bad input") {
    try {
        read_scene("/nowhere/at/all.toml");
        FAIL("a file that does not exist was read");
    } catch (const Error& error) {
        CHECK(error.code == ExitCode::no_access);
        CHECK(std::string(error.what()) ==
              "cannot read '/nowhere/at/all.toml': No such file or directory.");
    }
}
