#include "base/image.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

Image pattern(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i) {
        image.rgba.push_back(static_cast<std::uint8_t>(i * 37 + i / 256));
    }
    return image;
}

} // namespace

TEST_CASE("A picture written as PNG is read back with the same bytes") {
    const test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{100, 60}}) {
        const Image image = pattern(width, height);
        write_png(image, folder.file("x.png"));
        const Image read = read_image(folder.file("x.png"));
        INFO(width << " x " << height);
        CHECK(read.width == width);
        CHECK(read.height == height);
        CHECK(read.rgba == image.rgba);
    }
}

TEST_CASE("A picture without pixels, or with too few bytes, is not written") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_AS(write_png({}, folder.file("x.png")), InputError);
    CHECK_THROWS_AS(write_png({2, 2, {0, 0, 0, 0}}, folder.file("x.png")), InputError);
    CHECK(folder.file_count() == 0);
}

TEST_CASE("A picture cannot be written where there is no folder") {
    CHECK_THROWS_AS(write_png(pattern(2, 2), "/nowhere/x.png"), AccessError);
}

TEST_CASE("Files that are no pictures are refused as bad input") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("x.png", "not a picture at all");
    CHECK_THROWS_WITH(read_image(path), path + ": the file is neither a PNG nor a BMP picture.");
    folder.write("x.png", "");
    CHECK_THROWS_AS(read_image(path), InputError);
    CHECK_THROWS_AS(read_image(folder.file("none.png")), AccessError);
}

TEST_CASE("A PNG cut off anywhere is read or refused, but never crashes") {
    const test::TemporaryFolder folder;
    write_png(pattern(20, 20), folder.file("whole.png"));
    const std::string whole = test::bytes_of(folder.file("whole.png"));
    int refused = 0;
    for (std::size_t length = 0; length < whole.size(); length += 11) {
        const std::string path = folder.write("cut.png", whole.substr(0, length));
        try {
            read_image(path);
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused > 10);
}

TEST_CASE("A PNG that claims to be 60000 pixels wide is refused before memory is taken") {
    const test::TemporaryFolder folder;
    write_png(pattern(2, 2), folder.file("x.png"));
    std::string bytes = test::bytes_of(folder.file("x.png"));
    bytes[18] = '\xea'; // width, 32 bits from byte 16: 0x0000ea60
    bytes[19] = '\x60';
    const std::string path = folder.write("x.png", bytes);
    CHECK_THROWS_WITH(read_image(path), path + ": a picture of 60000 x 2 pixels is too large.");
}
