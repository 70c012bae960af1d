#include "scene/read_surface.h"

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// Points of a roof: two squares that meet in the ridge B C; one of them is cut in two.
const std::string roof = "name = \"s\"\n"
                         "[points.p]\n"
                         "A = [-1, 0, 0]\n"
                         "B = [0, -1, 0]\n"
                         "C = [0, -1, 1]\n"
                         "D = [-1, 0, 1]\n"
                         "E = [1, 0, 0]\n"
                         "F = [1, 0, 1]\n";
/// Lines 9 to 14.
const std::string sections = "[materials.m]\n"
                             "specular = 0.5\n"
                             "[normals.n]\n"
                             "A = [0, -2, 0]\n"
                             "[colours.c]\n"
                             "C = [1, 0, 0.5]\n";

/// A part of the roof with these keys; its name is in line 16.
std::string written_part(const std::string& keys) {
    return "[[part]]\nname = \"q\"\npoints = \"p\"\n"
           "triangles = [\"A D B\", \"D C B\", \"B C E\", \"C F E\"]\n" +
           keys;
}

Scene read(const std::string& text) {
    return parse_scene(text, "s.toml");
}

std::string refusal_of(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// The corner of a triangle at this place.
const Vertex& corner_at(const Scene& scene, int triangle, const glm::vec3& place) {
    for (int i = 0; i < triangle_corners; ++i) {
        if (scene.corner(triangle, i).position == place) return scene.corner(triangle, i);
    }
    FAIL("triangle " << triangle << " has no such corner");
    return scene.corner(triangle, 0);
}

constexpr glm::vec3 a{-1, 0, 0}, b{0, -1, 0}, c{0, -1, 1};

} // namespace

TEST_CASE("A part has its triangles' normals, averaged ones, or those of a set") {
    const double half = std::sqrt(0.5);
    const Scene faces = read(roof + written_part(""));
    CHECK(faces.mesh.differences() == CornerDifferences{});
    CHECK(read(roof + written_part("normals = \"face\"\n")) == faces);
    const glm::vec3 left = faces.corner(0, 0).normal;
    CHECK(std::abs(left.x) == Approx(half));

    // At the ridge both slopes count alike, although one has two triangles at B and one at C. At
    // the eaves there is only one slope.
    const Scene smooth = read(roof + written_part("normals = \"averaged\"\n"));
    CHECK(smooth.mesh.differences() == CornerDifferences{true, false});
    for (int t = 0; t < 2; ++t) {
        CAPTURE(t);
        CHECK(glm::distance(corner_at(smooth, t, b).normal, {0, left.y > 0 ? 1 : -1, 0}) < 1e-6f);
    }
    CHECK(glm::distance(corner_at(smooth, 1, c).normal, corner_at(smooth, 1, b).normal) < 1e-6f);
    CHECK(glm::distance(corner_at(smooth, 0, a).normal, left) < 1e-6f);

    // A given one is made unit length; a corner not named keeps the triangle's.
    const Scene given = read(roof + sections + written_part("normals = \"n\"\n"));
    CHECK(corner_at(given, 0, a).normal == glm::vec3(0, -1, 0));
    CHECK(corner_at(given, 0, b).normal == left);
}

TEST_CASE("Given and averaged normals go with the object that is mirrored, turned and scaled") {
    // Flattened to half its height the roof's slopes fall by 1 in 2.
    const std::string model = "model = [{ scale = [1, 0.5, 1] }, { rotate_y = 1.5707964 }]\n";
    const Scene plain = read(roof + written_part("normals = \"averaged\"\n"));
    const Scene turned = read(roof + written_part("normals = \"averaged\"\n" + model));
    const glm::vec3 eave = turned.corner(0, 0).normal; // of A
    const float up = corner_at(plain, 0, b).normal.y;
    CHECK(glm::length(eave) == Approx(1.0));
    CHECK(std::abs(eave.y) == Approx(2.0 / std::sqrt(5.0)));
    CHECK(std::abs(eave.z) == Approx(1.0 / std::sqrt(5.0)));
    // The ridge stays level.
    CHECK(turned.corner(0, 2).normal.y == Approx(up));

    // Where the scene flips an axis, a given normal is flipped with the points.
    const std::string mirrored = roof + sections + written_part("normals = \"n\"\n") +
                                 "[transform]\nedge = 2\nmirror = [\"y\"]\n";
    const Scene scene = read(mirrored);
    CHECK(scene.corner(0, 0).normal == glm::vec3(0, 1, 0));
}

TEST_CASE("Materials and colours reach the corners") {
    const std::string paint = "[materials.paint]\ndiffuse = [0.1, 0.2, 0.3]\nspecular = 0.5\n"
                              "exponent = 20\n";
    const Scene scene =
        read(roof + sections + paint + written_part("material = \"paint\"\ncolours = \"c\"\n"));
    for (int t = 0; t < scene.triangle_count(); ++t) {
        for (int i = 0; i < triangle_corners; ++i) {
            const Vertex& corner = scene.corner(t, i);
            CHECK(corner.shine == Shine{glm::vec3(0.5f), 20.0f});
            CHECK(corner.reflectance == (corner.position == c ? glm::vec3(1.0f, 0.0f, 0.5f)
                                                              : glm::vec3(0.1f, 0.2f, 0.3f)));
        }
    }
    CHECK(scene.mesh.differences() == CornerDifferences{false, true});
    // Without a material a surface is white and does not shine.
    CHECK(read(roof + written_part("")).corner(0, 0).reflectance == glm::vec3(1.0f));
    CHECK(read(roof + written_part("")).corner(0, 0).shine == Shine{});
    const Scene lit = read(roof + written_part("") +
                           "[light]\nmodel = \"blinn_phong\"\n"
                           "place = \"camera\"\n");
    CHECK(lit.light.model == LightModel::blinn_phong);
    CHECK(lit.light.place == LampPlace::camera);
    const Scene pixels = read("name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = [1, 2]\n"
                              "B = [9, 2]\nC = [1, 9]\n[colours.c]\nB = [1, 0, 0]\n[[part]]\n"
                              "name = \"q\"\npoints = \"p\"\ncolours = \"c\"\n"
                              "triangles = [\"A B C\"]\n");
    CHECK(pixels.corner(0, 1).reflectance == glm::vec3(1, 0, 0));
}

TEST_CASE("Where the normals of a sheet cancel each triangle keeps its own") {
    const Scene sheet = read(roof + "[[part]]\nname = \"q\"\npoints = \"p\"\n"
                                    "normals = \"averaged\"\ntriangles = [\"A B C\", \"A C B\"]\n");
    CHECK(sheet.mesh.differences() == CornerDifferences{});
    CHECK(glm::length(sheet.corner(0, 0).normal) == Approx(1.0));
    CHECK(sheet.corner(0, 0).normal == -sheet.corner(1, 0).normal);
    // So does one whose corners are on a line, next to others.
    const Scene line = read(roof + "G = [-2, 1, 0]\n[[part]]\nname = \"q\"\npoints = \"p\"\n"
                                   "normals = \"averaged\"\ntriangles = [\"G A B\"]\n");
    CHECK(line.corner(0, 0).normal == glm::vec3(0.0f));
}

TEST_CASE("A broken surface is refused with its file, line and what is wrong") {
    using Catch::Matchers::StartsWith;
    struct Case {
        std::string text, begins;
    };
    const std::string in_part = roof + sections + written_part(""); // 18 lines
    const std::vector<Case> cases{
        {"materials = 3\n" + roof, "s.toml:1: 'materials' must be a table."},
        {roof + "[materials]\nm = 3\n", "s.toml:10: the material 'm' must be a table."},
        {roof + "[materials.m]\nshine = 3\n", "s.toml:10: the material 'm' has no 'shine'"},
        {roof + "[materials.m]\ndiffuse = 1.5\n",
         "s.toml:10: 'diffuse' of the material 'm' must be between 0 and 1."},
        {roof + "[materials.m]\nspecular = [1, nan, 0]\n",
         "s.toml:10: 'specular' of the material 'm' must be a finite number."},
        {roof + "[materials.m]\nexponent = -1\n",
         "s.toml:10: 'exponent' of the material 'm' must be between 0 and 10000."},
        {roof + "[materials.m]\nexponent = 1e6\n", "s.toml:10: 'exponent' of the material 'm'"},
        {roof + "[normals.n]\nA = [0, 0, 0]\n", "s.toml:10: the normal of 'A' has no direction."},
        {roof + "[normals.n]\nA = [0, inf, 0]\n",
         "s.toml:10: the normal of 'A' must be a finite number."},
        {roof + "[normals.n]\nA = 1\n", "s.toml:10: the normal of 'A' must be three numbers."},
        {roof + "[normals.averaged]\nA = [0, 1, 0]\n",
         "s.toml:9: a set of normals cannot be called 'averaged'."},
        {roof + "[colours.c]\nA = [2, 0, 0]\n", "s.toml:10: 'A' of the set of colours 'c' must be"},
        {roof + "[colours.c]\nA = \"red\"\n", "s.toml:10: 'A' of the set of colours 'c' must be"},
        {in_part + "material = \"wood\"\n", "s.toml:19: there is no material 'wood'."},
        {in_part + "material = \"m\"\nreflectance = 1\n",
         "s.toml:20: part 1 has either a material or a reflectance, not both."},
        {in_part + "material = 3\n", "s.toml:19: 'material' of part 1 must be text in quotes."},
        {in_part + "colours = \"d\"\n", "s.toml:19: there is no set 'd' in [colours]."},
        {in_part + "normals = \"round\"\n", "s.toml:19: 'normals' must be \"face\", \"averaged\" "
                                            "or a set in [normals], and there is no set 'round' in "
                                            "[normals]."},
        {roof + "[normals.n]\nZ = [0, 1, 0]\n" + written_part("normals = \"n\"\n"),
         "s.toml:15: the set 'n' in [normals] names 'Z', which is not a point of 'p'."},
        {roof + "[colours.c]\nZ = 1\n" + written_part("colours = \"c\"\n"),
         "s.toml:15: the set 'c' in [colours] names 'Z', which is not a point of 'p'."},
        {in_part + "[light]\nmodel = \"toon\"\n",
         "s.toml:20: 'model' of the light is lambert or blinn_phong, not 'toon'."},
        {in_part + "[light]\nplace = 3\n",
         "s.toml:20: 'place' of the light must be text in quotes."},
        {"name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = [1, 2]\n[normals.n]\nA = [0, 1, 0]\n",
         "s.toml:5: points in pixels cannot have normals."},
        {"name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = [1, 2]\n[[part]]\nname = \"q\"\n"
         "points = \"p\"\nnormals = \"averaged\"\ntriangles = [\"A A A\"]\n",
         "s.toml:8: points in pixels cannot have normals."},
    };
    for (const Case& one : cases) {
        INFO(one.text);
        CHECK_THAT(refusal_of(one.text), StartsWith(one.begins));
    }
}

TEST_CASE("A surface that is cut off anywhere is read or refused, but never crashes") {
    const std::string whole =
        roof + sections + written_part("material = \"m\"\ncolours = \"c\"\nnormals = \"n\"\n");
    int read_whole = 0;
    for (std::size_t length = roof.size(); length <= whole.size(); ++length)
        read_whole += refusal_of(whole.substr(0, length)) == "accepted" ? 1 : 0;
    CHECK(read_whole >= 2);
}

TEST_CASE("Every normal of the cylinder points straight out of it between two sides") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/cylinder.toml");
    int bent = 0;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const bool is_wall = part_name(scene, t) == "wall";
        CHECK(scene.mesh.differences(t).normals == is_wall);
        for (int i = 0; i < triangle_corners && is_wall; ++i) {
            const Vertex& corner = scene.corner(t, i);
            const glm::vec3 out = glm::normalize(corner.position * glm::vec3(1, 0, 1));
            CAPTURE(t, i);
            CHECK(glm::distance(corner.normal, out) < 1e-4f);
            ++bent;
        }
    }
    CHECK(bent == 72);
}
