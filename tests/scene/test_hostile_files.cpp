// Damaged files that a model or scene names, once or often, or too many of them: each is tried
// once, its fault is reported once, and reading can be stopped at any of them.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/image.h"
#include "base/limits.h"
#include "scene/companion_file.h"
#include "scene/read_obj.h"
#include "scene/read_scene.h"
#include "scene/texture_files.h"
#include "support/limited_memory.h"
#include "support/made_images.h"
#include "support/random.h"
#include "support/temporary_folder.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::megabyte;

namespace {

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";

/// A model with so many materials, each with one image.
/// @param lines the statement of a material, with {} where its number belongs
std::string model_with_maps(const test::TemporaryFolder& folder, int count,
                            const std::string& lines) {
    std::string materials, faces = "mtllib m.mtl\n" + three_points;
    for (int i = 0; i < count; ++i) {
        materials += fmt::format("newmtl m{}\n", i) + fmt::format(fmt::runtime(lines), i) + "\n";
        faces += fmt::format("usemtl m{}\nf 1/1 2/2 3/3\n", i);
    }
    folder.write("m.mtl", materials);
    return folder.write("m.obj", faces);
}

/// Claims to have 4096 x 4096 pixels, and has the least number of bytes for that; but they are
/// no deflate data.
std::string damaged_png() {
    return test::png(4096, 4096, 8, "\x78\x01\x07" + std::string(66'000, 'x'));
}

std::string changed(std::string bytes, test::Random& random) {
    for (int n = random.integer(1, 8); n > 0; --n) {
        const int place = random.integer(0, static_cast<int>(bytes.size()) - 1);
        bytes[static_cast<std::size_t>(place)] = static_cast<char>(random.integer(0, 255));
    }
    return bytes;
}

} // namespace

TEST_CASE("A damaged image is tried once and reported once, whatever names it") {
    const test::TemporaryFolder folder;
    const std::string image = folder.write("c.png", damaged_png());
    for (const char* const lines : {"bump -bm {} c.png", "map_Kd c.png", "map_Kd {}.png"}) {
        INFO(lines);
        const std::string path = model_with_maps(folder, 200, lines);
        for (int i = 0; std::string_view(lines) == "map_Kd {}.png" && i < 200; ++i)
            std::filesystem::create_symlink("c.png", folder.file(fmt::format("{}.png", i)));
        const std::vector<std::string> reported = fault_lines(read_obj(path).report);
        REQUIRE(reported.size() == 1);
        CHECK(reported[0].find(": the picture cannot be read: its data is damaged.") !=
              std::string::npos);
    }
}

TEST_CASE("An image is unpacked once for all strengths of its heights") {
    const test::TemporaryFolder folder;
    write_png(test::many_colours(64, 64), folder.file("heights.png"));
    const ReadingWatch never;
    const WatchedSteps watched(never);
    std::vector<SharedTexture> textures;
    TextureFiles files(textures, watched);
    const std::string path = folder.file("heights.png");
    CHECK(files.read_heights(path, "h", 1.0f).index == 0);
    std::filesystem::remove(path);
    CHECK(files.read_heights(path, "h", 2.0f).index == 1);
    CHECK(files.read(path, "h").index == 2);
    CHECK(files.read_heights(path, "h", 1.0f).index == 0);
    // From 64 up, all are the same.
    CHECK(files.read_heights(path, "h", 64.0f).index == files.read_heights(path, "h", 65.0f).index);
}

TEST_CASE("Images unpacked in vain count toward the limit of texels") {
    const test::TemporaryFolder folder;
    for (const char* const name : {"0.png", "1.png", "2.png"})
        folder.write(name, damaged_png());
    const std::vector<std::string> reported =
        fault_lines(read_obj(model_with_maps(folder, 3, "map_Kd {}.png")).report);
    REQUIRE(reported.size() == 3);
    CHECK(reported[0].find("0.png: the picture cannot be read: ") != std::string::npos);
    for (std::size_t i = 1; i < reported.size(); ++i) {
        CHECK(
            reported[i].find(fmt::format("{}.png: all textures together have more than {} texels.",
                                         i, most_texels)) != std::string::npos);
    }
}

TEST_CASE("Files that a scene names are read up to a limit of bytes, one for each kind") {
    const test::TemporaryFolder folder;
    const std::string six = folder.write("six", "123456");
    CompanionBytes bytes(4 * megabyte, "all images");
    bytes.add(folder.write("much", std::string(4 * megabyte - 10, 'x')));
    bytes.add(six);
    CHECK_THROWS_WITH(bytes.add(six), six + ": with this file, all images exceed 4 MB in total.");
    bytes.add(folder.write("four", "1234"));

    // The same file under other names: as many times as it fits.
    std::string text = "newmtl a\nKd 1 0 0\n#";
    text.append(largest_material_file - text.size(), ' ');
    folder.write("0.mtl", text);
    std::string model = "mtllib 0.mtl\n";
    constexpr int fitting = static_cast<int>(most_material_bytes / largest_material_file);
    for (int i = 1; i <= fitting; ++i) {
        std::filesystem::create_symlink("0.mtl", folder.file(fmt::format("{}.mtl", i)));
        model += fmt::format("mtllib {}.mtl\n", i);
    }
    const std::string path = folder.write("m.obj", model + three_points + "f 1 2 3\n");
    const ObjModel read = read_obj(path);
    CHECK(read.materials.size() == fitting);
    CHECK(fault_lines(read.report) ==
          std::vector<std::string>{
              fmt::format("{}:{}: 'mtllib': {}: with this file, all material files exceed {} MB "
                          "in total. It is left out.",
                          path, fitting + 1, folder.file(fmt::format("{}.mtl", fitting)),
                          most_material_bytes >> 20)});
}

TEST_CASE("Reading can be stopped at materials and at images") {
    const test::TemporaryFolder folder;
    write_png(test::many_colours(2, 2), folder.file("p.png"));
    const bool has_images = GENERATE(false, true);
    const int count = has_images ? 10 : 3 * WatchedSteps::steps_between;
    const std::string path =
        model_with_maps(folder, count, has_images ? "bump -bm {} p.png" : "Kd 1 1 1");
    // A long model file would ask as often by its own lines, so this one is short.
    const std::string own = "mtllib m.mtl\n" + three_points + "usemtl m0\nf 1/1 2/2 3/3\n";
    if (!has_images) folder.write("m.obj", own);
    std::size_t asked = 0;
    const auto count_up = [&](const ReadingState&) { return ++asked > 0; };
    read_obj(path, {}, count_up);
    const std::size_t all = asked;
    CHECK(all >= (has_images ? 10 : 6));
    for (std::size_t last = 0; last < all; ++last) {
        INFO("stopped when asked for the time " << last);
        asked = 0;
        CHECK_THROWS_AS(read_obj(path, {}, [&](const ReadingState&) { return asked++ < last; }),
                        ReadingStopped);
        CHECK(asked == last + 1);
    }
}

TEST_CASE("Reading a scene reports its progress, and can be stopped") {
    constexpr int count = 5000;
    std::string text = "name = \"s\"\n[points.p]\nA = [0, 0, 1]\nB = [1, 0, 1]\nC = [0, 1, 1]\n"
                       "[[part]]\nname = \"q\"\npoints = \"p\"\ntriangles = [\n";
    for (int i = 0; i < count; ++i)
        text += "\"A B C\",\n";
    text += "]\n";
    std::vector<ReadingState> reported;
    const Scene scene = parse_scene(text, "s.toml", {}, [&](const ReadingState& state) {
        reported.push_back(state);
        return true;
    });
    CHECK(scene == parse_scene(text, "s.toml"));
    REQUIRE(reported.size() > 10);
    CHECK(reported.front().part == ReadingPart::bytes);
    CHECK(reported.front().all == std::ssize(text));
    CHECK(reported.back().part == ReadingPart::triangles);
    CHECK(reported.back().done > count / 2);
    CHECK(reported.back().all == count);
    for (std::size_t i = 1; i < reported.size(); ++i)
        if (reported[i].part == reported[i - 1].part)
            CHECK(reported[i].done >= reported[i - 1].done);
    for (std::size_t last = 0; last < reported.size(); ++last) {
        INFO("stopped when asked for the time " << last);
        std::size_t asked = 0;
        CHECK_THROWS_AS(
            parse_scene(text, "s.toml", {}, [&](const ReadingState&) { return asked++ < last; }),
            ReadingStopped);
        CHECK(asked == last + 1);
    }
}

TEST_CASE(
    "Models, materials and images with up to eight changed bytes name the file that is wrong") {
    const test::TemporaryFolder folder;
    write_png(test::many_colours(8, 8), folder.file("p.png"));
    const std::vector<std::string> names{"m.obj", "m.mtl", "p.png"};
    const std::string path = folder.write("m.obj", "mtllib m.mtl\n" + three_points +
                                                       "vn 0 0 1\nusemtl a\nf 1/1/1 2/2/1 3/3/1\n");
    folder.write("m.mtl",
                 "newmtl a\nKd 0.5 1 0.25\nNs 10\nd 0.5\nmap_Kd p.png\nbump -bm 2 p.png\n");
    test::Random random(1974);
    for (const std::string& name : names) {
        const std::string whole = test::bytes_of(folder.file(name));
        for (int i = 0; i < 100; ++i) {
            folder.write(name, changed(whole, random));
            const std::string said = test::output_within(100 * megabyte, [&] {
                std::string lines;
                try {
                    for (const std::string& line : fault_lines(read_obj(path).report))
                        lines += line + "\n";
                } catch (const InputError& error) {
                    lines = std::string(error.what()) + "\n";
                }
                return lines;
            });
            INFO("round " << i << " of " << name << ": " << said);
            for (std::size_t at = 0; at < said.size(); at = said.find('\n', at) + 1) {
                const std::string line = said.substr(at, said.find('\n', at) - at);
                CHECK((line.starts_with(path + ":") || line.starts_with(folder.file("m.mtl:"))));
                if (name == "p.png") CHECK(line.find(folder.file("p.png: ")) != line.npos);
                CHECK(line.ends_with('.'));
            }
        }
        folder.write(name, whole);
    }
}
