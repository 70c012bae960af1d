#include "scene/texture.h"

#include <glm/common.hpp>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/error.h"
#include "base/image.h"
#include "base/limits.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"
#include "support/texture_oracle.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::many_colours;

namespace {

/// A scene of one part with two triangles; `lines` are those of its texture, starting at line 10.
std::string scene_with_lines(const std::string& lines) {
    return "name = \"s\"\n"
           "[points.p]\n"
           "A = [-1, -1, 2]\n"
           "B = [1, -1, 2]\n"
           "C = [1, 1, 2]\n"
           "[[part]]\n"
           "name = \"q\"\n"
           "points = \"p\"\n"
           "triangles = [\"A B C\", \"C B A\"]\n" +
           lines;
}

const std::string two_texcoords =
    "texcoords = [[[0, 0], [1, 0], [1, 1]], [[1, 1], [1, 0], [-2.5, 0]]]\n";

/// The sentence with which a scene in this folder is refused, without the folder's own name.
std::string refusal_in(const test::TemporaryFolder& folder, const std::string& lines) {
    const std::string path = folder.write("s.toml", scene_with_lines(lines));
    const std::string own = path.substr(0, path.size() - std::string("s.toml").size());
    std::string said = "accepted";
    try {
        read_scene(path);
    } catch (const InputError& error) {
        said = error.what();
    }
    for (std::size_t at = 0; (at = said.find(own)) != std::string::npos;)
        said.erase(at, own.size());
    return said;
}

} // namespace

TEST_CASE("A mip chain is what a second implementation in double makes of the same picture") {
    for (const Viewport size :
         {Viewport{1, 1}, {2, 2}, {8, 8}, {7, 7}, {13, 6}, {1, 5}, {9, 1}, {16, 3}, {31, 17}}) {
        const Image image = many_colours(size.width, size.height);
        const Texture texture = make_texture("made", image);
        const std::vector<test::OracleLevel> chain = test::oracle_chain(image);
        INFO(size.width << " x " << size.height);
        REQUIRE(texture.levels.size() == chain.size());
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const TextureLevel& level = texture.levels[i];
            REQUIRE(level.width == chain[i].width);
            REQUIRE(level.height == chain[i].height);
            REQUIRE(level.texels.size() == chain[i].texels.size());
            for (std::size_t t = 0; t < level.texels.size(); ++t) {
                INFO("level " << i << " texel " << t);
                CHECK(glm::distance(glm::dvec3(level.texels[t]), chain[i].texels[t]) < 1e-6);
            }
        }
        CHECK(texture.levels.back().texels.size() == 1);
    }
}

TEST_CASE("The last level of a mip chain is the mean of the whole picture, whatever its sides") {
    for (const Viewport size : {Viewport{64, 64}, {100, 37}, {5, 128}}) {
        const Image image = many_colours(size.width, size.height);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            sum += glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) / 255.0;
        const Texture texture = make_texture("made", image);
        const glm::dvec3 mean = sum / static_cast<double>(size.width * size.height);
        CHECK(glm::distance(glm::dvec3(texture.levels.back().at(0, 0)), mean) < 1e-6);
    }
}

TEST_CASE("A scene names a texture next to it, and where the corners of its triangles are") {
    const test::TemporaryFolder folder;
    const Image image = many_colours(5, 3);
    write_png(image, folder.file("painted.png"));
    const std::string painted = "texture = \"painted.png\"\n" + two_texcoords;
    const std::string path = folder.write(
        "s.toml",
        scene_with_lines(painted + "model = [{ scale = [-1, 1, 1] }]\n"
                                   "[[part]]\nname = \"bare\"\npoints = \"p\"\n"
                                   "triangles = [\"A B C\"]\n"
                                   "[[part]]\nname = \"again\"\npoints = \"p\"\n"
                                   "triangles = [\"A B C\"]\ntexture = \"./painted.png\"\n"
                                   "texcoords = [[[0, 0], [1, 0], [1, 1]]]\n"));
    const Scene scene = read_scene(path);
    REQUIRE(scene.textures.size() == 1); // once for two parts
    CHECK(*scene.textures.front() == make_texture("painted.png", image));
    CHECK(texture_of(scene, 0) == &*scene.textures.front());
    CHECK(texture_of(scene, 1) == &*scene.textures.front());
    CHECK(texture_of(scene, 2) == nullptr);
    const Scene copy = scene;
    CHECK(texture_of(copy, 0) == texture_of(scene, 0)); // shared
    CHECK(read_scene(path) == scene);                   // and compared by its texels
    CHECK(texture_of(scene, 3) == &*scene.textures.front());
    // Mirrored, the corners of a triangle change places, and their texcoords with them.
    CHECK(scene.corner(0, 1).position == glm::vec3(-1, 1, 2));
    CHECK(scene.corner(0, 1).texcoord == glm::vec2(1, 1));
    CHECK(scene.corner(0, 2).position == glm::vec3(-1, -1, 2));
    CHECK(scene.corner(0, 2).texcoord == glm::vec2(1, 0));
    CHECK(scene.corner(1, 1).position == glm::vec3(1, -1, 2));
    CHECK(scene.corner(1, 1).texcoord == glm::vec2(-2.5f, 0));
    CHECK(scene.corner(2, 0).texcoord == glm::vec2(0, 0));
}

TEST_CASE("Texcoords that do not fit the triangles are refused with file and line") {
    const test::TemporaryFolder folder;
    write_png(many_colours(2, 2), folder.file("p.png"));
    const std::string named = "texture = \"p.png\"\n";
    const std::vector<std::array<std::string, 2>> cases{
        {named, "s.toml:10: a part with a 'texture' needs 'texcoords'"},
        {two_texcoords, "s.toml:10: 'texcoords' are only allowed in a part with a 'texture', a "
                        "'normal_map' or a 'height_map'."},
        {named + "texcoords = []\n",
         "s.toml:11: there must be as many 'texcoords' as triangles, 2, but there are 0."},
        {named + "texcoords = [[[0, 0], [1, 0], [1, 1]]]\n",
         "s.toml:11: there must be as many 'texcoords' as triangles, 2, but there are 1."},
        {named + "texcoords = \"0 0\"\n", "s.toml:11: 'texcoords' of part 1 must be a list."},
        {named + "texcoords = [[0, 0], [1, 0]]\n",
         "s.toml:11: the texcoords of a triangle must be three pairs, one for each corner"},
        {named + "texcoords = [[0, 0, 1], [1, 0, 1]]\n",
         "s.toml:11: the texcoords of a triangle must be three pairs of u and v"},
        {named + "texcoords = [[[0, 0], [1, 0], [1, 1]],\n[[1, 1, 1], [1, 0], [0, 0]]]\n",
         "s.toml:12: the texcoords of a triangle must be three pairs of u and v"},
        {named + "texcoords = [[[0, 0], [1, 0], [1, 1]],\n[[1, nan], [1, 0], [0, 0]]]\n",
         "s.toml:12: the texcoords of a triangle must be a finite number."},
        {named + "texcoords = [[[0, 0], [1, 0], [1, 1]],\n[[1, 1e9], [1, 0], [0, 0]]]\n",
         "s.toml:12: the texcoords of a triangle must be between"},
        {named + "texcoords = [[[0, 0], [1, 0], [1, 1]],\n[[1, \"x\"], [1, 0], [0, 0]]]\n",
         "s.toml:12: the texcoords of a triangle must be a number."},
    };
    for (const auto& [lines, begins] : cases) {
        INFO(lines);
        CHECK_THAT(refusal_in(folder, lines), Catch::Matchers::StartsWith(begins));
    }
}

TEST_CASE("A height map that cannot be used is refused with file and line") {
    const test::TemporaryFolder folder;
    write_png(many_colours(2, 2), folder.file("p.png"));
    const std::string map = "height_map = \"p.png\"\n";
    const std::vector<std::array<std::string, 2>> cases{
        {map, "s.toml:10: a part with a 'height_map' needs 'texcoords'"},
        {"height_map = \"q.png\"\n" + two_texcoords,
         "s.toml:10: the height map 'q.png' cannot be used: "},
        {"height_scale = 0.1\n",
         "s.toml:10: 'height_scale' is only allowed in a part with a 'height_map'."},
        {"height_bias = 0.1\n",
         "s.toml:10: 'height_bias' is only allowed in a part with a 'height_map'."},
        {map + "height_scale = \"high\"\n" + two_texcoords,
         "s.toml:11: 'height_scale' of part 1 must be a number"},
        {map + "height_scale = nan\n" + two_texcoords,
         "s.toml:11: 'height_scale' of part 1 must be"},
        {map + "height_bias = 1e30\n" + two_texcoords,
         "s.toml:11: 'height_bias' of part 1 must be"},
    };
    for (const auto& [lines, begins] : cases) {
        INFO(lines);
        CHECK_THAT(refusal_in(folder, lines), Catch::Matchers::StartsWith(begins));
    }
}

TEST_CASE("A file that is not a texture is refused in a sentence, with file and line") {
    const test::TemporaryFolder folder;
    write_png(many_colours(64, 64), folder.file("whole.png"));
    const std::string whole = test::bytes_of(folder.file("whole.png"));
    folder.write("text.png", "no picture\n");
    folder.write("empty.png", "");
    folder.write("cut.png", whole.substr(0, whole.size() / 2));
    folder.write("head.png", whole.substr(0, 33));
    std::string vast = whole; // says that it is 1,000,064 texels wide
    vast[17] = '\x0f';
    vast[18] = '\x42';
    folder.write("vast.png", vast);
    std::string junk = whole;
    for (std::size_t i = 41; i < junk.size(); ++i)
        junk[i] = static_cast<char>(i * 31);
    folder.write("junk.png", junk);
    REQUIRE(mkfifo(folder.file("pipe.png").c_str(), 0600) == 0);
    REQUIRE(mkdir(folder.file("folder.png").c_str(), 0700) == 0);
    const std::vector<std::array<std::string, 2>> cases{
        {"none.png", "s.toml:10: the texture 'none.png' cannot be used: "},
        {"text.png", "s.toml:10: the texture 'text.png' cannot be used: text.png: the file is not "
                     "a picture that can be read (PNG, JPG, TGA, BMP, PPM or PGM)."},
        {"empty.png", "s.toml:10: the texture 'empty.png' cannot be used: "},
        {"cut.png", "s.toml:10: the texture 'cut.png' cannot be used: "},
        {"head.png", "s.toml:10: the texture 'head.png' cannot be used: "},
        {"vast.png", "s.toml:10: the texture 'vast.png' cannot be used: vast.png: a picture of "},
        {"junk.png", "s.toml:10: the texture 'junk.png' cannot be used: "},
        {"pipe.png", "s.toml:10: the texture 'pipe.png' cannot be used: "},
        {"folder.png", "s.toml:10: the texture 'folder.png' cannot be used: "},
        {"../none.png", "s.toml:10: the texture '../none.png' cannot be used: there is no file "
                        "'../none.png'."},
        {"/dev/zero", "s.toml:10: the texture '/dev/zero' cannot be used: there is no file "
                      "'/dev/zero' in its folder, below it or in a folder next to it."},
        {"", "s.toml:10: 'texture' of part 1 must not be empty."},
    };
    for (const auto& [name, begins] : cases) {
        INFO(name);
        CHECK_THAT(refusal_in(folder, "texture = \"" + name + "\"\n" + two_texcoords),
                   Catch::Matchers::StartsWith(begins));
    }
    CHECK(refusal_in(folder, "texture = \"whole.png\"\n" + two_texcoords) == "accepted");
    CHECK_THAT(refusal_in(folder, "texture = 3\n" + two_texcoords),
               Catch::Matchers::StartsWith("s.toml:10: 'texture' of part 1 must be text"));
}

TEST_CASE("A small PNG with any cut or a broken bit gives a picture or a sentence") {
    const test::TemporaryFolder folder;
    write_png(many_colours(3, 2), folder.file("small.png"));
    const std::string whole = test::bytes_of(folder.file("small.png"));
    const std::string lines = "texture = \"broken.png\"\n" + two_texcoords;
    test::Random random(23);
    int refused = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string broken = whole;
        if (i % 2 == 0)
            broken.resize(i);
        else
            broken[i] = static_cast<char>(broken[i] ^ (1 << random.integer(0, 7)));
        folder.write("broken.png", broken);
        const std::string said = refusal_in(folder, lines);
        if (said == "accepted") continue;
        ++refused;
        CHECK_THAT(said, Catch::Matchers::StartsWith("s.toml:10: the texture 'broken.png'"));
    }
    CHECK(refused > static_cast<int>(whole.size()) / 2);
}
