// Pictures in each format read, written here byte by byte, and the messages about others.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/image.h"
#include "tests/support/catch.h"
#include "tests/support/limited_memory.h"
#include "tests/support/made_images.h"
#include "tests/support/made_jpeg.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using test::byte;
using test::eight_alpha_bits;
using test::from_top;
using test::jpeg;
using test::megabyte;
using test::ramp;
using test::tga_head;
using test::two_bytes;

namespace {

using Rgba = std::array<int, 4>;

/// The colour of a pixel of the pictures below; all differ.
Rgba colour_at(int column, int row) {
    return {10 * column + row, 200 - 7 * row, 3 * column * column + row, 255 - 20 * column};
}

Rgba pixel_of(const Image& image, int column, int row) {
    Rgba pixel{};
    for (std::size_t c = 0; c < 4; ++c)
        pixel[c] = image.rgba[4 * static_cast<std::size_t>(row * image.width + column) + c];
    return pixel;
}

std::string blue_green_red(const Rgba& c) {
    return byte(c[2]) + byte(c[1]) + byte(c[0]);
}

/// 5 x 3, 24 bits, from the bottom.
std::string plain_tga() {
    std::string bytes = tga_head(2, 5, 3, 24, 0);
    for (int row = 2; row >= 0; --row) {
        for (int column = 0; column < 5; ++column)
            bytes += blue_green_red(colour_at(column, row));
    }
    return bytes;
}

/// 5 x 3, 32 bits, packed, from the top: four pixels one by one, then runs of one.
std::string packed_tga(int descriptor) {
    std::string bytes = tga_head(10, 5, 3, 32, descriptor);
    for (int row = 0; row < 3; ++row) {
        bytes += byte(3);
        for (int column = 0; column < 5; ++column) {
            if (column == 4) bytes += byte(0x80);
            const Rgba colour = colour_at(column, row);
            bytes += blue_green_red(colour) + byte(colour[3]);
        }
    }
    return bytes;
}

Image read_bytes(const std::string& bytes) {
    return parse_image(bytes, "x");
}

/// The message about a picture in a process with only this much memory; "" if it is read.
std::string refusal_within(std::size_t memory, const std::string& bytes) {
    return test::output_within(memory, [&]() -> std::string {
        try {
            parse_image(bytes, "x");
        } catch (const InputError& fault) {
            return fault.what();
        }
        return "";
    });
}

} // namespace

TEST_CASE("A TGA is read: plain from the bottom, packed from the top, with and without alpha") {
    const Image plain = read_bytes(plain_tga());
    const Image packed = read_bytes(packed_tga(from_top | eight_alpha_bits));
    // Many programs write a fourth byte without filling it, and say that no bit of it counts.
    const Image without_alpha = read_bytes(packed_tga(from_top));
    for (const Image* const image : {&plain, &packed, &without_alpha}) {
        REQUIRE(image->width == 5);
        REQUIRE(image->height == 3);
    }
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 5; ++column) {
            INFO(column << "," << row);
            Rgba colour = colour_at(column, row);
            CHECK(pixel_of(packed, column, row) == colour);
            colour[3] = 255;
            CHECK(pixel_of(plain, column, row) == colour);
            CHECK(pixel_of(without_alpha, column, row) == colour);
        }
    }
}

TEST_CASE("A TGA whose rows run from right to left is read the right way round") {
    constexpr int from_right = 16;
    for (const int width : {1, 2, 5}) {
        std::string bytes = tga_head(2, width, 3, 24, from_top | from_right);
        for (int row = 0; row < 3; ++row) {
            for (int column = width - 1; column >= 0; --column)
                bytes += blue_green_red(colour_at(column, row));
        }
        const Image image = read_bytes(bytes);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < width; ++column) {
                INFO(column << "," << row << " of a width of " << width);
                Rgba colour = colour_at(column, row);
                colour[3] = 255;
                CHECK(pixel_of(image, column, row) == colour);
            }
        }
    }
}

TEST_CASE("A BMP that would be read wrongly is refused with the reason") {
    std::string other = test::bmp(4, 4);
    for (const char way : {'\1', '\2', '\4', '\6'}) { // 6: plain, with a mask for alpha
        other[30] = way;
        // Packed pixels take fewer bytes than plain ones, so too few bytes is not the fault.
        for (const std::size_t length : {other.size(), std::size_t{60}}) {
            CHECK_THROWS_WITH(read_bytes(other.substr(0, length)),
                              "x: a picture of 4 x 4 pixels is a BMP of a kind that cannot be "
                              "read; save it as PNG.");
        }
    }
    const auto of_os2 = [](int bits, const std::string& behind) {
        const int begin = 26 + (bits <= 8 ? 3 * (1 << bits) : 0);
        return "BM" + std::string(8, '\0') + two_bytes(begin) + two_bytes(0) + two_bytes(12) +
               two_bytes(0) + two_bytes(1) + two_bytes(1) + two_bytes(1) + two_bytes(bits) + behind;
    };
    CHECK(read_bytes(of_os2(24, byte(3) + byte(2) + byte(1) + byte(0))) ==
          Image{1, 1, {1, 2, 3, 255}});
    CHECK_THROWS_WITH(read_bytes(of_os2(8, std::string(3 * 256 + 4, 'x'))),
                      "x: a picture of 1 x 1 pixels has an OS/2 header with a palette, which "
                      "cannot be read; save it as PNG.");
    // 16 bits are a colour, and need no palette.
    CHECK_THROWS_WITH(read_bytes(of_os2(16, byte(1) + byte(2) + byte(0) + byte(0))),
                      "x: a picture of 1 x 1 pixels is a BMP of a kind that cannot be read; save "
                      "it as PNG.");
}

TEST_CASE("A TGA is read with a palette, in grey and with 16 bits a pixel") {
    std::string indexed = tga_head(1, 3, 1, 8, from_top, 2, 24);
    indexed += byte(1) + byte(2) + byte(3) + byte(40) + byte(50) + byte(60);
    indexed += byte(1) + byte(0) + byte(1);
    const Image few = read_bytes(indexed);
    CHECK(pixel_of(few, 0, 0) == Rgba{60, 50, 40, 255});
    CHECK(pixel_of(few, 1, 0) == Rgba{3, 2, 1, 255});
    CHECK(pixel_of(few, 2, 0) == Rgba{60, 50, 40, 255});
    const Image grey = read_bytes(tga_head(3, 2, 1, 8, from_top) + byte(7) + byte(250));
    CHECK(pixel_of(grey, 0, 0) == Rgba{7, 7, 7, 255});
    CHECK(pixel_of(grey, 1, 0) == Rgba{250, 250, 250, 255});
    // Five bits a channel, red the highest: 31, 0, 1.
    const Image short_one = read_bytes(tga_head(2, 1, 1, 16, from_top) + two_bytes(31 << 10 | 1));
    CHECK(pixel_of(short_one, 0, 0) == Rgba{255, 0, 255 / 31, 255});
}

TEST_CASE("PPM and PGM are read, as text and as bytes, scaled by their largest sample") {
    const auto check = [](const std::string& bytes, bool is_grey, int largest) {
        INFO(bytes.substr(0, 2) << ", largest " << largest);
        const Image image = read_bytes(bytes);
        REQUIRE(image.width == 2);
        REQUIRE(image.height == 2);
        const int samples[]{0, 1, 5, 15, 9, 12, 3, 7, 2, 14, 8, 11};
        for (int i = 0; i < 4; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const int sample =
                    (is_grey ? samples[i] : samples[3 * i + static_cast<int>(c)]) * (largest / 15);
                const double wanted = 255.0 * sample / largest;
                CHECK(std::abs(pixel_of(image, i % 2, i / 2)[c] - wanted) <= 0.5);
            }
            CHECK(pixel_of(image, i % 2, i / 2)[3] == 255);
        }
    };
    check("P3\n# painted by hand\n2 2\n15 # the largest\n0 1 5  15 9 12\n3 7 2 # two\n14 8 11\n",
          false, 15);
    check("P2 2\t2\r\n15\n0 1 5 15", true, 15);
    check("P6\n2 2 15\n" + std::string("\0\1\5\17\11\14\3\7\2\16\10\13", 12), false, 15);
    check("P5 2 2 15 " + std::string("\0\1\5\17", 4), true, 15);
    std::string wide = "P5\n2 2\n65535\n";
    for (const int sample : {0, 1, 5, 15})
        wide += byte(sample * 4369 >> 8) + byte(sample * 4369 & 255);
    check(wide, true, 65535);
}

TEST_CASE("The samples of a PPM begin after one blank, or after the two bytes of a line's end") {
    const Image expected{1, 2, {10, 13, 7, 255, 1, 2, 3, 255}};
    const std::string samples = "\n\r\7\1\2\3";
    CHECK(read_bytes("P6\r\n1 2\r\n255\r\n" + samples) == expected);
    CHECK(read_bytes("P6\n1 2\n255\n" + samples) == expected);
    // Here the first sample is 10, which is also a line's end.
    CHECK(read_bytes("P6\r1 2\r255\r" + samples) == expected);
}

TEST_CASE("A JPG is read as accurately as it keeps its colours") {
    const std::vector<std::uint8_t> rgb = ramp(40, 30);
    for (const int quality : {85, 100}) {
        const Image image = read_bytes(jpeg(40, 30, quality, rgb));
        REQUIRE(image.width == 40);
        REQUIRE(image.height == 30);
        int farthest = 0;
        for (std::size_t i = 0; i < rgb.size() / 3; ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                farthest = std::max(farthest, std::abs(image.rgba[4 * i + c] - rgb[3 * i + c]));
            CHECK(image.rgba[4 * i + 3] == 255);
        }
        INFO("quality " << quality);
        CHECK(farthest <= 8);
    }
}

TEST_CASE("Where every pixel counts, a JPG is refused and a PPM is not") {
    CHECK_THROWS_WITH(parse_exact_image(jpeg(8, 8, 100, ramp(8, 8)), "x"),
                      "x: a JPG does not keep the exact colour of each pixel; save the picture as "
                      "PNG, TGA, BMP, PPM or PGM.");
    CHECK(parse_exact_image("P3 1 1 255 1 2 3", "x") == Image{1, 1, {1, 2, 3, 255}});
}

TEST_CASE("Unsupported formats are refused by name") {
    using namespace std::string_literals;
    const std::vector<std::array<std::string, 2>> cases{{"II*\0\10\0\0\0"s, "TIFF"},
                                                        {"MM\0*\0\0\0\10"s, "TIFF"},
                                                        {"DDS |\0\0\0"s, "DDS"},
                                                        {"RIFF\1\2\3\4WEBPVP8 "s, "WebP"},
                                                        {"\x76\x2f\x31\x01\2\0\0\0"s, "EXR"},
                                                        {"#?RADIANCE\nFORMAT"s, "Radiance HDR"},
                                                        {"GIF89a\1\0\1\0"s, "GIF"},
                                                        {"8BPS\0\1"s, "Photoshop"},
                                                        {"\0\0\0\x1c"
                                                         "ftypavif"s,
                                                         "AVIF"},
                                                        {"P4\n8 1\n"s, "PBM"}};
    for (const auto& [bytes, name] : cases) {
        CHECK_THROWS_WITH(read_bytes(bytes + std::string(40, '\1')),
                          "x: the picture is " + name + ", which cannot be read; save it as PNG.");
        CHECK_FALSE(is_image(bytes));
    }
    CHECK_THROWS_WITH(read_bytes("Start: (10,5). End: (10,5)."),
                      "x: the file is not a picture that can be read (PNG, JPG, TGA, BMP, PPM or "
                      "PGM).");
}

TEST_CASE("A picture that is cut off, or claims more than it has, is refused before memory is "
          "taken") {
    const auto said = [](const std::string& bytes) { return refusal_within(60 * megabyte, bytes); };
    const std::string vast = "x: a picture of 4096 x 4096 pixels is cut off.";
    CHECK(said(tga_head(2, 4096, 4096, 32, 0) + std::string(1000, 'x')) == vast);
    CHECK(said(tga_head(10, 4096, 4096, 32, 0) + std::string(1000, 'x')) == vast);
    CHECK(said("P6 4096 4096 255 xyz") == vast);
    CHECK(said("P3 4096 4096 255 1 2 3") == vast);
    CHECK(said("P6 100000 4 255 xyz") ==
          "x: a picture of 100000 x 4 pixels is too large: a side may have at most 4096.");
    CHECK(said("P6 0 4 255 xyz") == "x: a picture of 0 x 4 pixels is empty.");
    CHECK(said("P6 4 4 70000 xyz") ==
          "x: the picture cannot be read because it does not begin with its width, its height and "
          "its largest sample.");
    CHECK(said("P6 999999999999999999999 4 255 x") == said("P6 4 4 70000 xyz"));
    CHECK(said("P2 2 1 9 8 10") ==
          "x: the picture cannot be read: a sample is missing or too large.");
    std::string whole = jpeg(16, 16, 90, ramp(16, 16));
    const std::size_t frame = whole.find("\xff\xc0");
    REQUIRE(frame != whole.npos);
    std::string claims = whole;
    claims.replace(frame + 5, 4, std::string("\x10\0\x10\0", 4));
    CHECK(said(claims) == vast);
    CHECK(said(whole.substr(0, whole.size() - 2)) == "x: a picture of 16 x 16 pixels is cut off.");
    for (const std::string& of : {plain_tga(), packed_tga(from_top), whole}) {
        for (std::size_t length = 0; length < of.size(); length += 7) {
            INFO(length);
            try {
                read_bytes(of.substr(0, length));
            } catch (const InputError& fault) {
                CHECK(std::string(fault.what()).starts_with("x: "));
            }
        }
    }
}

TEST_CASE("A JPG whose tables are too large or missing never reaches the decoder") {
    const std::string whole = jpeg(16, 16, 90, ramp(16, 16));
    const std::string damaged = "x: a picture of 16 x 16 pixels is damaged.";
    const auto said = [](const std::string& bytes) { return refusal_within(60 * megabyte, bytes); };
    // 16 lengths with 32 values each: more than the decoder has room for.
    std::string large = whole;
    const std::size_t end = whole.find("\xff\xda");
    REQUIRE(end != whole.npos);
    large.insert(end, "\xff\xc4" + std::string("\2\x13", 2) + byte(0) + std::string(16, 32) +
                          std::string(512, 'x'));
    CHECK(said(large) == damaged);
    std::string none = whole;
    for (std::size_t table = none.find("\xff\xc4"); table != none.npos;
         table = none.find("\xff\xc4", table))
        none.replace(table, 2, "\xff\xfe"); // a comment in place of a table
    CHECK(said(none) == damaged);
    std::string many = whole.substr(0, whole.size() - 2);
    const std::string scan = many.substr(end);
    for (int i = 0; i < 200; ++i)
        many += scan;
    CHECK(said(many + "\xff\xd9") ==
          "x: a picture of 16 x 16 pixels has more scans than a picture needs.");
    std::string arithmetic = whole;
    arithmetic[whole.find("\xff\xc0") + 1] = '\xc9';
    CHECK(said(arithmetic) == "x: the picture is a JPG of a rare kind that cannot be read; save it "
                              "as an ordinary JPG or as PNG.");
}
