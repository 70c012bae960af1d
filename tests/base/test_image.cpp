#include "base/image.h"

#include "base/error.h"
#include "tests/support/catch.h"
#include "tests/support/limited_memory.h"
#include "tests/support/made_images.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using test::big_endian;
using test::bmp;
using test::many_zeros;
using test::megabyte;
using test::png;
using test::png_block;

namespace {

Image pattern(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i) {
        image.rgba.push_back(static_cast<std::uint8_t>(i * 37 + i / 256));
    }
    return image;
}

/// The message about a picture; "" if it is read.
std::string complaint_about(const std::string& path) {
    try {
        read_image(path);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "";
}

/// The same in a process that can take only this many more bytes of memory.
std::string complaint_within(std::size_t memory, const std::string& path) {
    return test::output_within(memory, [&] { return complaint_about(path); });
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

TEST_CASE("Files that are not pictures are refused as bad input") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("x.png", "not a picture at all");
    CHECK_THROWS_WITH(read_image(path),
                      path + ": the file is not a picture that can be read (PNG, JPG, TGA, BMP, "
                             "PPM or PGM).");
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
    CHECK_THROWS_WITH(read_image(path),
                      path +
                          ": a picture of 60000 x 2 pixels is too large: a side may have at most "
                          "4096.");
}

TEST_CASE("A PNG that unpacks to more than its size is refused before memory is taken for it") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("bomb.png", png(2, 2, 8, many_zeros(200 * megabyte)));
    CHECK(complaint_within(60 * megabyte, path) ==
          path + ": a picture of 2 x 2 pixels contains too much data.");
    // The right amount: four pixels, and a filter for each row.
    CHECK(complaint_within(60 * megabyte, folder.write("x.png", png(2, 2, 8, many_zeros(1)))) ==
          folder.file("x.png") + ": the picture cannot be read: not enough pixels.");
}

TEST_CASE("A short file that says it is a large picture is refused before memory is taken") {
    const test::TemporaryFolder folder;
    const auto said = [&](const std::string& bytes) {
        const std::string path = folder.write("x", bytes);
        return complaint_within(60 * megabyte, path).substr(path.size());
    };
    CHECK(said(png(4096, 4096, 8, "")) == ": a picture of 4096 x 4096 pixels is cut off.");
    CHECK(said(png(4096, 4096, 16, "x")) == ": a picture of 4096 x 4096 pixels is cut off.");
    CHECK(said(png(4096, 4096, '\xff', std::string(2'200'000, 'x'))) ==
          ": a picture of 4096 x 4096 pixels has more than 16 bits per channel, which PNG does not "
          "allow.");
    std::string of_no_colours = png(4096, 4096, 8, "");
    of_no_colours[25] = '\5';
    CHECK(said(of_no_colours) ==
          ": a picture of 4096 x 4096 pixels has a colour type that does not exist in PNG.");
    CHECK(said(png(4097, 1, 8, "")) ==
          ": a picture of 4097 x 1 pixels is too large: a side may have at most 4096.");
    CHECK(said(png(0xffffffff, 0xffffffff, 16, "")) ==
          ": a picture of 4294967295 x 4294967295 pixels is too large: a side may have at most "
          "4096.");
    CHECK(said(bmp(4096, 4096).substr(0, 66)) == ": a picture of 4096 x 4096 pixels is cut off.");
    CHECK(said(bmp(6, 1029).substr(0, 62)) == ": a picture of 6 x 1029 pixels is cut off.");
}

TEST_CASE("A picture without pixels is refused, and so is a block beyond the end of the file") {
    const test::TemporaryFolder folder;
    const auto said = [&](const std::string& bytes) {
        const std::string path = folder.write("x", bytes);
        return complaint_within(60 * megabyte, path).substr(path.size());
    };
    CHECK(said(png(0, 2, 8, "x")) == ": a picture of 0 x 2 pixels is empty.");
    CHECK(said(png(2, 0, 8, "x")) == ": a picture of 2 x 0 pixels is empty.");
    CHECK(said(bmp(0, 2)) == ": a picture of 0 x 2 pixels is empty.");
    CHECK(said(bmp(2, 0)) == ": a picture of 2 x 0 pixels is empty.");
    CHECK(said(bmp(2, 2).replace(18, 4, 4, '\xff')) == ": a picture of -1 x 2 pixels is empty.");
    write_png(pattern(9, 7), folder.file("whole.png"));
    const std::string whole = test::bytes_of(folder.file("whole.png"));
    for (const char* const name : {"IDAT", "tEXt", "PLTE"}) {
        INFO(name);
        std::string vast = whole;
        vast.insert(33, std::string("\x7f\xff\xff\xf0", 4) + name);
        CHECK(said(vast) == ": a picture of 9 x 7 pixels is cut off.");
    }
    std::string of_apple = whole;
    of_apple.insert(33, png_block("CgBI", ""));
    CHECK(said(of_apple) == ": a picture of 9 x 7 pixels is a PNG in Apple's own variant.");
}

TEST_CASE(
    "If the decoder gives no reason for refusing a picture, the message is still a sentence") {
    const test::TemporaryFolder folder;
    // A last block of deflate's kind 3, which does not exist.
    const std::string path = folder.write("x.png", png(2, 2, 8, "\x78\x01\x07"));
    const std::string damaged = path + ": the picture cannot be read: its data is damaged.";
    CHECK(complaint_about(path) == damaged);
    // Nor is the reason left over from the previous picture.
    CHECK(complaint_about(folder.write("y.png", png(2, 2, 8, many_zeros(1)))) ==
          folder.file("y.png") + ": the picture cannot be read: not enough pixels.");
    CHECK(complaint_about(path) == damaged);
}

TEST_CASE("A BMP is refused wherever it is cut off") {
    const test::TemporaryFolder folder;
    for (const int height : {3, -3}) {
        const std::string whole = bmp(5, height);
        const Image image = read_image(folder.write("whole.bmp", whole));
        CHECK(image.width == 5);
        CHECK(image.height == 3);
        // The padding of the last row may be missing.
        CHECK(read_image(folder.write("x.bmp", whole.substr(0, whole.size() - 1))) == image);
        for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
            const std::string path = folder.write("cut.bmp", whole.substr(0, length));
            INFO(length);
            CHECK_THROWS_AS(read_image(path), InputError);
        }
    }
}

TEST_CASE("An interlaced PNG is read") {
    // 3 x 2 pixels, grey, Adam7: rows of 1, 1, 1, 3 pixels in passes 1, 4, 6 and 7, unpacked.
    const std::string rows("\0\x0a\0\x1e\0\x14\0\x28\x32\x3c", 10);
    const std::string data = std::string("\x78\x01\x01\x0a\x00\xf5\xff", 7) + rows + "????";
    const std::string head = big_endian(3) + big_endian(2) + std::string("\x08\0\0\0\1", 5);
    const test::TemporaryFolder folder;
    const Image image =
        read_image(folder.write("x.png", "\x89PNG\r\n\x1a\n" + png_block("IHDR", head) +
                                             png_block("IDAT", data) + png_block("IEND", "")));
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    const std::vector<int> expected{10, 20, 30, 40, 50, 60};
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(image.rgba[4 * i] == expected[i]);
}
