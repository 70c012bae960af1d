// The textures that come with the program, computed, not taken from other pictures. With
// RASTERWALK_BLESS=1 in the environment this test writes them into lessons/scenes/textures instead
// of comparing.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/image.h"
#include "scene/texture_files.h"
#include "session/content.h"
#include "support/made_cobbles.h"
#include "support/painted.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::painted;
using test::Rgb;

namespace {

constexpr Rgb light{235, 232, 222}, dark{44, 66, 110};

/// A square a texel; the top left one is light.
Image checkerboard() {
    return painted(8, 8, [](int x, int y) { return (x + y) % 2 == 0 ? light : dark; });
}

/// It differs from itself turned or mirrored: an arrow up, and a corner of each colour.
Image corners() {
    return painted(16, 16, [](int x, int y) {
        const bool is_left = x<5, is_right = x> 10, is_top = y<5, is_bottom = y> 10;
        if (is_top && is_left) return Rgb{200, 60, 50};
        if (is_top && is_right) return Rgb{230, 180, 40};
        if (is_bottom && is_left) return Rgb{60, 150, 80};
        if (is_bottom && is_right) return Rgb{60, 110, 190};
        const int from_middle = x < 8 ? 7 - x : x - 8;
        const bool is_head = y >= 2 && y < 7 && from_middle <= y - 2;
        const bool is_shaft = y >= 7 && y < 14 && from_middle < 1;
        return is_head || is_shaft ? dark : light;
    });
}

/// Rows of bricks, each shifted by half a brick from the row above, with mortar between them.
Image bricks() {
    return painted(32, 32, [](int x, int y) {
        const int course = y / 8;
        const int along = (x + (course % 2) * 8) % 32;
        if (y % 8 == 7 || along % 16 == 15) return Rgb{196, 190, 178};
        const int shade = (course * 5 + along / 16 * 3) % 4 * 9;    // of the whole brick
        const int grain = (x * 13 + y * 7 + x * y % 5 * 3) % 5 * 4; // of the texel
        return Rgb{150 + shade + grain, 66 + shade / 2 + grain, 50 + grain};
    });
}

/// The same bricks as heights: they stick out from the mortar.
Image brick_heights() {
    return painted(32, 32, [](int x, int y) {
        const int along = (x + (y / 8 % 2) * 8) % 32;
        const int grey = y % 8 == 7 || along % 16 == 15 ? 0 : 255;
        return Rgb{grey, grey, grey};
    });
}

/// The same again with round edges, for parallax mapping.
Image round_brick_heights() {
    return painted(32, 32, [](int x, int y) {
        const int along = (x + (y / 8 % 2) * 8) % 32 % 16;
        const int from_mortar = std::min(std::min(along, 14 - along), std::min(y % 8, 6 - y % 8));
        const int grey = from_mortar < 0 ? 0 : from_mortar == 0 ? 190 : 255;
        return Rgb{grey, grey, grey};
    });
}

/// One stud: the cap of a ball of 16 texels, 12 texels around the middle, on a flat ground.
Image stud_normals() {
    return painted(32, 32, [](int x, int y) {
        constexpr double ball = 16.0, cap = 12.0;
        const double right = x + 0.5 - 16.0, up = 16.0 - (y + 0.5);
        const bool is_stud = right * right + up * up < cap * cap;
        const auto byte = [](double part) {
            return static_cast<int>(std::floor((part + 1.0) / 2.0 * 255.0 + 0.5));
        };
        if (!is_stud) return Rgb{byte(0.0), byte(0.0), byte(1.0)};
        return Rgb{byte(right / ball), byte(up / ball),
                   byte(std::sqrt(ball * ball - right * right - up * up) / ball)};
    });
}

} // namespace

TEST_CASE("The textures of the lessons are those made here") {
    const std::filesystem::path folder =
        std::filesystem::path(lessons_folder()) / "scenes/textures";
    const std::vector<std::pair<std::string, Image>> made{
        {"checkerboard.png", checkerboard()},
        {"corners.png", corners()},
        {"bricks.png", bricks()},
        {"bricks_normals.png", normals_of_heights(brick_heights(), 1.5f)},
        {"bricks_heights.png", round_brick_heights()},
        {"cobbles.png", test::cobbles()},
        {"cobbles_heights.png", test::cobble_heights()},
        {"cobbles_normals.png", normals_of_heights(test::cobble_heights(), 4.0f)},
        {"studs_normals.png", stud_normals()}};
    const bool writes = std::getenv("RASTERWALK_BLESS") != nullptr;
    if (writes) std::filesystem::create_directories(folder);
    for (const auto& [name, image] : made) {
        const std::string path = (folder / name).string();
        if (writes) write_png(image, path);
        INFO(path);
        CHECK(read_image(path) == image);
        CHECK(std::filesystem::file_size(path) < 16384);
    }
    std::size_t files = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder))
        files += file.path().extension() == ".png" ? 1 : 0;
    CHECK(files == made.size());
}
