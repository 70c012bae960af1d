// Images of a model's materials: which are found, what is reported about the others, and whether
// each pixel has the texel that a ray finds, with v up as in the model's own axes.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <sys/stat.h>

#include "base/image.h"
#include "base/limits.h"
#include "pipeline/draw.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "support/ray_caster.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using test::many_colours;

namespace {

/// Three unit squares side by side, from x = 0 to 3, with materials a, b and c; the last has no
/// texture coordinates.
const std::string three_squares = "mtllib m.mtl\n"
                                  "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\n"
                                  "v 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                  "usemtl a\nf 1/1 2/2 6/3 5/4\n"
                                  "usemtl b\nf 2/1 3/2 7/3 6/4\n"
                                  "usemtl c\nf 3 4 8 7\n";

/// The colour of an image at u and v, v counted from below; nothing near the border of a texel.
std::optional<glm::dvec3> texel_counted_from_below(const Image& image, double u, double v) {
    const double column = u * image.width, row_from_below = v * image.height;
    if (std::abs(column - std::round(column)) < 0.02 ||
        std::abs(row_from_below - std::round(row_from_below)) < 0.02)
        return std::nullopt;
    const int row = image.height - 1 - static_cast<int>(row_from_below);
    const auto byte = 4 * static_cast<std::size_t>(row * image.width + static_cast<int>(column));
    return glm::dvec3(image.rgba[byte], image.rgba[byte + 1], image.rgba[byte + 2]) / 255.0;
}

} // namespace

TEST_CASE("Each material paints its faces with its own image, v up, where a ray finds the texel") {
    const test::TemporaryFolder folder;
    const Image first = many_colours(4, 3), second = many_colours(5, 2);
    std::filesystem::create_directory(folder.file("art"));
    write_png(first, folder.file("art/first.png"));
    write_png(second, folder.file("second.png"));
    folder.write("m.mtl", "newmtl a\nKd 0.5 1 0.25\nmap_Kd art\\first.png\n"
                          "newmtl b\nmap_Kd C:\\work\\second.png\nnewmtl c\nKd 0.1 0.2 0.3\n");
    const ObjModel model = read_obj(folder.write("m.obj", three_squares));
    CHECK(fault_lines(model.report).empty());
    CHECK(model.report.counts.textures == 2);
    const Scene scene = scene_of_model(model);
    REQUIRE(scene.textures.size() == 2);
    CHECK(*scene.textures[0] == make_texture("first.png", first));
    CHECK((*scene.textures[1]).name == "second.png");

    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    settings.coverage = Coverage::edge_functions;
    settings.snap = Snap::subpixel;
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer picture;
    clear(picture, frame);
    draw(frame, {}, picture);
    const test::RayCaster rays(scene, scene.camera, scene.light);
    int compared = 0;
    for (int row = 2; row < picture.size.height; row += 5) {
        for (int column = 2; column < picture.size.width; column += 5) {
            const glm::dvec2 place(column + 0.5 - 0.5 * picture.size.width,
                                   row + 0.5 - 0.5 * picture.size.height);
            const std::vector<test::RayHit> hits = rays.hits(place);
            if (hits.empty() || rays.distance_to_edges(place) < 1.0) continue;
            // The box from (0, 0) to (3, 1) is in the middle of the world, turned over, its
            // longer side 2.
            const glm::dvec3 world = hits.front().position_world;
            const double x = 1.5 * world.x + 1.5, y = 0.5 - 1.5 * world.y;
            const int square = static_cast<int>(x);
            std::optional<glm::dvec3> wanted = glm::dvec3(0.1, 0.2, 0.3);
            if (square < 2)
                wanted = texel_counted_from_below(square == 0 ? first : second, x - square, y);
            if (!wanted) continue;
            if (square == 0) *wanted *= glm::dvec3(0.5, 1.0, 0.25);
            ++compared;
            const glm::dvec3 off =
                glm::abs(glm::dvec3(picture.colour[picture.at(column, row)]) - *wanted);
            if (std::max({off.x, off.y, off.z}) > 1e-4)
                FAIL("pixel " << column << "," << row << " of square " << square << " at " << x
                              << ", " << y << " is off by " << off.x << " " << off.y << " "
                              << off.z);
        }
    }
    CHECK(compared > 500);
}

TEST_CASE(
    "An image that cannot be used is reported with file and line; its faces keep their colour") {
    const test::TemporaryFolder folder;
    write_png(many_colours(64, 64), folder.file("whole.png"));
    const std::string whole = test::bytes_of(folder.file("whole.png"));
    folder.write("text.png", "no picture\n");
    folder.write("cut.png", whole.substr(0, whole.size() / 2));
    std::string vast = whole; // says that it is 1,000,064 texels wide
    vast[17] = '\x0f';
    vast[18] = '\x42';
    folder.write("vast.png", vast);
    REQUIRE(mkfifo(folder.file("pipe.png").c_str(), 0600) == 0);
    REQUIRE(mkdir(folder.file("folder.png").c_str(), 0700) == 0);
    const std::string mtl = folder.file("m.mtl");
    const std::string path = folder.write("m.obj", three_squares);
    const std::vector<std::array<std::string, 2>> cases{
        {"none.png", "there is no file 'none.png'; the image is left out."},
        {"../none.png", "there is no file '../none.png'; the image is left out."},
        {"../../none.png", "there is no file '../../none.png' in its folder, below it or in a "
                           "folder next to it; the image is left out."},
        {"/dev/zero", "there is no file '/dev/zero' in its folder, below it or in a folder next to "
                      "it; the image is left out."},
        {"pipe.png", "'pipe.png' is a pipe or a device; the image is left out."},
        {"folder.png", "'folder.png' is a folder; the image is left out."},
        {"text.png", folder.file("text.png") + ": the file is not a picture that can be read (PNG, "
                                               "JPG, TGA, BMP, PPM or PGM). The image is left "
                                               "out."},
        {"cut.png", folder.file("cut.png") + ": "},
        {"vast.png", folder.file("vast.png") + ": a picture of "}};
    for (const auto& [name, begins] : cases) {
        INFO(name);
        folder.write("m.mtl", "newmtl a\nKd 0.5 0.5 0.5\nmap_Kd " + name +
                                  "\nnewmtl b\nmap_Kd whole.png\nnewmtl c\n");
        const ObjModel model = read_obj(path);
        const std::vector<std::string> reported = fault_lines(model.report);
        REQUIRE(reported.size() == 1);
        CHECK_THAT(reported[0], Catch::Matchers::StartsWith(mtl + ":3: 'map_Kd': " + begins));
        CHECK(model.report.counts.textures == 1);
        CHECK(model.parts[0].texture == -1);
        CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(0.5f));
        CHECK(model.parts[1].texture == 0);
    }
}

TEST_CASE("An image is read once, for a material that is drawn, and also from next to the model") {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("sub"));
    write_png(many_colours(2, 2), folder.file("p.png"));
    folder.write("broken.png", "x");
    folder.write("sub/m.mtl", "newmtl a\nmap_Kd p.png\nnewmtl b\nmap_Kd ../elsewhere/p.png\n"
                              "newmtl unused\nmap_Kd broken.png\n");
    std::string text = three_squares;
    text.replace(0, std::string("mtllib m.mtl").size(), "mtllib sub\\m.mtl");
    const ObjModel model = read_obj(folder.write("m.obj", text.substr(0, text.find("usemtl c"))));
    CHECK(fault_lines(model.report).empty());
    CHECK(model.textures.size() == 1);
    CHECK(model.parts.at(0).texture == 0);
    CHECK(model.parts.at(1).texture == 0);
}

TEST_CASE("Faces without texture coordinates keep their colour in a part of their own") {
    const test::TemporaryFolder folder;
    write_png(many_colours(2, 2), folder.file("p.png"));
    folder.write("m.mtl", "newmtl a\nmap_Kd p.png\n");
    const std::string path =
        folder.write("m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                              "f 1/1 2/1 3/1\nf 1 2 3\nf 1/1 2 3/1\nf 3/1 2/1 1/1\n");
    const ObjModel model = read_obj(path);
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{path + ":8: not every corner of 'f' has a texture coordinate, "
                                          "although the material 'a' has an image; such faces keep "
                                          "their colour."});
    std::vector<std::array<int, 3>> parts;
    for (const ObjPart& part : model.parts)
        parts.push_back({part.first_triangle, part.triangle_count, part.texture});
    CHECK(parts == std::vector<std::array<int, 3>>{{0, 1, 0}, {1, 2, -1}, {3, 1, 0}});
    CHECK(model.report.counts.parts == 3);
}

TEST_CASE("The number of a model's textures is limited") {
    const test::TemporaryFolder folder;
    std::string materials, faces = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    const int count = static_cast<int>(most_textures) + 2;
    write_png(many_colours(1, 1), folder.file("0.png"));
    const std::string bytes = test::bytes_of(folder.file("0.png"));
    for (int i = 0; i < count; ++i) {
        materials += fmt::format("newmtl {0}\nmap_Kd {0}.png\n", i);
        faces += fmt::format("usemtl {}\nf 1/1 2/1 3/1\n", i);
        folder.write(fmt::format("{}.png", i), bytes);
    }
    folder.write("m.mtl", materials);
    const ObjModel model = read_obj(folder.write("m.obj", faces));
    CHECK(model.textures.size() == most_textures);
    CHECK(fault_lines(model.report) ==
          std::vector<std::string>{
              fmt::format(
                  "{}:{}: 'map_Kd': {}: there are more than {} textures. The image is left out.",
                  folder.file("m.mtl"), 2 * count - 2, folder.file("256.png"), most_textures),
              fmt::format(
                  "{}:{}: 'map_Kd': {}: there are more than {} textures. The image is left out.",
                  folder.file("m.mtl"), 2 * count, folder.file("257.png"), most_textures)});
}

TEST_CASE("norm is a map of normals; bump is one of heights, or of normals if it looks so") {
    const test::TemporaryFolder folder;
    const Image arrows{2, 1, {128, 128, 255, 255, 150, 128, 250, 255}};
    const Image heights{2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
    write_png(arrows, folder.file("arrows.png"));
    write_png(heights, folder.file("heights.png"));
    folder.write("broken.png", "no image");
    folder.write("m.mtl", "newmtl a\nnorm arrows.png\nnewmtl b\nbump -bm 0.5 heights.png\n"
                          "newmtl c\nmap_Bump arrows.png\nnewmtl d\nmap_bump broken.png\n"
                          "newmtl e\nbump -bm 1e30 heights.png\n");
    std::string text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    for (const char* const name : {"a", "b", "c", "d", "e"})
        text += fmt::format("usemtl {}\nf 1/1 2/2 3/3\n", name);
    const ObjModel model = read_obj(folder.write("m.obj", text));
    const std::vector<std::string> reported = [&] {
        std::vector<std::string> lines;
        for (const ObjFault& fault : model.report.faults)
            lines.push_back(fault.sentence);
        return lines;
    }();
    REQUIRE(reported.size() == 2);
    const bool is_image_first = reported[0].starts_with("'bump': ");
    const std::string& image = reported[is_image_first ? 0 : 1];
    CHECK_THAT(image, Catch::Matchers::StartsWith("'bump': "));
    CHECK_THAT(image, Catch::Matchers::EndsWith("The image is left out."));
    CHECK(reported[is_image_first ? 1 : 0] ==
          "'1e30' is not a valid number for '-bm', which is left out.");
    REQUIRE(model.parts.size() == 5);
    CHECK(model.report.counts.textures == static_cast<std::int64_t>(model.textures.size()));
    const Scene scene = scene_of_model(model);
    const auto map_of = [&](int triangle) { return normal_map_of(scene, triangle)->base(); };
    CHECK(texture_of(scene, 0) == nullptr);
    CHECK(map_of(0) == make_texture("", arrows).base());
    CHECK(map_of(2) == map_of(0));
    CHECK(normal_map_of(scene, 3) == nullptr);
    // Half of 2/64 texels, and of a picture that repeats on both sides: flat everywhere.
    CHECK(map_of(1).at(0, 0) == glm::vec3(128, 128, 255) / 255.0f);
    CHECK(map_of(4).at(0, 0) == glm::vec3(128, 128, 255) / 255.0f);
    CHECK(has_normal_map(scene));
}

TEST_CASE("disp is a map of heights; -mm says how high, in the units of the model") {
    const test::TemporaryFolder folder;
    const Image heights{2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
    write_png(heights, folder.file("heights.png"));
    folder.write("broken.png", "no image");
    folder.write("m.mtl", "newmtl a\nmap_Kd heights.png\ndisp heights.png\n"
                          "newmtl b\ndisp -mm -0.25 0.5 heights.png\n"
                          "newmtl c\nDisp broken.png\n"
                          "newmtl d\ndisp -bm 3 heights.png\n");
    std::string text = "mtllib m.mtl\nv 0 0 0\nv 8 0 0\nv 0 4 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    for (const char* const name : {"a", "b", "c", "d"})
        text += fmt::format("usemtl {}\nf 1/1 2/2 3/3\n", name);
    const ObjModel model = read_obj(folder.write("m.obj", text));
    std::vector<std::string> reported;
    for (const ObjFault& fault : model.report.faults)
        reported.push_back(fault.sentence);
    REQUIRE(reported.size() == 1);
    CHECK_THAT(reported[0], Catch::Matchers::StartsWith("'disp': "));
    CHECK(model.report.faults[0].line == 7);
    const Scene scene = scene_of_model(model);
    REQUIRE(scene.parts.size() == 4);
    CHECK(has_height_map(scene));
    // Without a height of its own, that of a scene; otherwise scaled as the model is, by 1/4.
    REQUIRE(height_map_of(scene, 0) != nullptr);
    const HeightMap usual;
    CHECK(height_map_of(scene, 0)->scale == usual.scale);
    CHECK(height_map_of(scene, 0)->bias == usual.bias);
    CHECK(height_map_of(scene, 1)->scale == 0.125f);
    CHECK(height_map_of(scene, 1)->bias == -0.0625f);
    CHECK(height_map_of(scene, 2) == nullptr);
    CHECK(height_map_of(scene, 3)->scale == usual.scale);
    // The same file is read once, whatever it is for.
    CHECK(height_map_of(scene, 0)->texture == scene.parts[0].texture);
}

TEST_CASE("map_d gives a texture the alpha or the grey of another image") {
    const test::TemporaryFolder folder;
    write_png(many_colours(4, 2), folder.file("colours.png"));
    const Image grey{2, 1, {10, 20, 30, 255, 240, 240, 240, 255}};
    const Image alpha{2, 1, {9, 9, 9, 40, 9, 9, 9, 255}};
    write_png(grey, folder.file("grey.png"));
    write_png(alpha, folder.file("alpha.png"));
    write_png(Image{1, 1, {0, 0, 0, 255}}, folder.file("black.png"));
    folder.write("m.mtl", "newmtl a\nmap_Kd colours.png\nmap_d grey.png\n"
                          "newmtl b\nmap_d alpha.png\nmap_Kd colours.png\n"
                          "newmtl c\nmap_d alpha.png\n"
                          "newmtl d\nmap_Kd colours.png\nmap_d colours.png\n"
                          "newmtl e\nmap_Kd colours.png\nmap_d none.png\n"
                          "newmtl f\nmap_Kd colours.png\nmap_d black.png\n");
    std::string text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    for (const char* const name : {"a", "b", "c", "d", "e", "f"})
        text += fmt::format("usemtl {}\nf 1/1 2/2 3/3\n", name);
    const ObjModel model = read_obj(folder.write("m.obj", text));
    REQUIRE(model.parts.size() == 6);
    const auto base_of = [&](std::size_t part) {
        const int texture = model.parts[part].texture;
        REQUIRE(texture >= 0);
        return (*model.textures[static_cast<std::size_t>(texture)]).base();
    };
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 4; ++column) {
            INFO(column << "," << row);
            CHECK(base_of(0).alpha_at(column, row) == (column < 2 ? 20 : 240) / 255.0f);
            CHECK(base_of(1).alpha_at(column, row) == (column < 2 ? 40 : 255) / 255.0f);
            CHECK(base_of(0).at(column, row) == base_of(3).at(column, row));
            CHECK(base_of(5).alpha_at(column, row) == 0.0f); // named on purpose
        }
    }
    CHECK(base_of(2).width == 2);
    CHECK(base_of(2).at(0, 0) == glm::vec3(1.0f));
    CHECK(base_of(2).alpha_at(0, 0) == 40 / 255.0f);
    CHECK(base_of(3).alphas.empty());
    CHECK(base_of(4).alphas.empty());
    REQUIRE(model.report.faults.size() == 1);
    CHECK_THAT(model.report.faults[0].sentence, Catch::Matchers::StartsWith("'map_d': "));
}
