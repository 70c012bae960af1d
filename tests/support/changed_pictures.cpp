// Changed pictures.

#include <array>
#include <cstdint>
#include <string>

#include "base/image.h"
#include "support/changed_formats.h"
#include "support/made_images.h"
#include "support/made_jpeg.h"

namespace rasterwalk::test {

namespace {

/// Pixels without pattern, so that a byte that is lost moves all others.
std::string pixels(int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += byte((i * 73 + i / 5 * 11) & 255);
    return bytes;
}

/// Deflate data that hold the bytes uncompressed; there are fewer than 65536.
std::string stored(const std::string& bytes) {
    const int size = static_cast<int>(bytes.size());
    return "\x78\x01\x01" + two_bytes(size) + two_bytes(size ^ 0xffff) + bytes + "????";
}

/// @param kind the type of colour, followed by how rows are interlaced
std::string png_of(std::uint32_t width, std::uint32_t height, int bits, std::array<int, 2> kind,
                   const std::string& more_blocks, const std::string& data) {
    const std::string head = big_endian(width) + big_endian(height) + byte(bits) + byte(kind[0]) +
                             byte(0) + byte(0) + byte(kind[1]);
    return "\x89PNG\r\n\x1a\n" + png_block("IHDR", head) + more_blocks + png_block("IDAT", data) +
           png_block("IEND", "");
}

std::vector<std::string> png_seeds() {
    const TemporaryFolder folder;
    Image image{9, 7, {}};
    for (int i = 0; i < 9 * 7; ++i)
        for (const int channel : {i * 3, i % 7 * 20, 128, 255 - i})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    write_png(image, folder.file("written.png"));
    std::string rows; // each with its own filter
    for (int row = 0; row < 5; ++row)
        rows += byte(row) + pixels(12);
    // 5 x 3 pixels, Adam7: the rows of passes 1, 2, 4, 5, 6, 6 and 7.
    std::string passes;
    for (const int width : {1, 1, 1, 3, 2, 2, 5})
        passes += byte(0) + pixels(2 * width);
    const std::string palette = png_block("PLTE", pixels(30)) + png_block("tRNS", pixels(5));
    return {bytes_of(folder.file("written.png")),
            png_of(4, 5, 8, {2, 0}, png_block("tRNS", std::string(6, '\0')), stored(rows)),
            png_of(5, 3, 16, {0, 1}, "", stored(passes)),
            png_of(4, 2, 4, {3, 0}, palette, stored(byte(0) + "\x12\x34" + byte(0) + "\x50\x67")),
            png_of(9, 2, 1, {0, 0}, "", stored(byte(0) + "\xa5\x80" + byte(2) + "\x5a\x80"))};
}

std::vector<std::string> tga_seeds() {
    const std::string packed = byte(3) + pixels(16) + byte(0x87) + pixels(4) + byte(2) + pixels(12);
    return {tga_head(2, 5, 3, 24, 0) + pixels(45),
            tga_head(10, 5, 3, 32, from_top | eight_alpha_bits) + packed,
            tga_head(1, 4, 3, 8, 0, 5, 24) + pixels(15) +
                std::string("\0\1\2\3\4\0\1\2\3\4\0\1", 12),
            tga_head(9, 4, 2, 8, from_top, 3, 16) + pixels(6) + byte(0x85) + byte(2) + byte(1) +
                byte(0) + byte(1),
            tga_head(11, 6, 2, 8, 16) + byte(0x83) + byte(9) + byte(7) + pixels(8),
            tga_head(2, 3, 2, 16, 1) + pixels(12)};
}

/// A BMP of one of the kinds that have a palette or masks.
std::string bmp_of(int width, int height, int bits, int packing, const std::string& between,
                   const std::string& rows) {
    const auto word = [](int value) { return little_endian(static_cast<std::uint32_t>(value)); };
    const int begin = 54 + static_cast<int>(between.size());
    return "BM" + word(begin + static_cast<int>(rows.size())) + word(0) + word(begin) + word(40) +
           word(width) + word(height) + two_bytes(1) + two_bytes(bits) + word(packing) +
           std::string(20, '\0') + between + rows;
}

std::vector<std::string> bmp_seeds() {
    const std::string masks = little_endian(0xf800) + little_endian(0x07e0) + little_endian(0x001f);
    return {bmp(5, 3),
            bmp(5, -3),
            bmp_of(3, 2, 8, 0, pixels(4 * 256), pixels(8)),
            bmp_of(5, -2, 4, 0, pixels(4 * 16), pixels(8)),
            bmp_of(9, 2, 1, 0, pixels(8), pixels(8)),
            bmp_of(3, 2, 16, 3, masks, pixels(16)),
            bmp_of(3, 2, 32, 0, "", pixels(24))};
}

FileOutcome picture_outcome(const std::string& bytes, const TemporaryFolder&) {
    try {
        const Image image = parse_image(bytes, "x");
        const auto is_side = [](int side) { return side >= 1 && side <= largest_image_side; };
        const bool is_whole = is_side(image.width) && is_side(image.height) &&
                              image.rgba.size() == 4 * static_cast<std::size_t>(image.width) *
                                                       static_cast<std::size_t>(image.height);
        return {true, is_whole ? "" : "its pixels are not as many as its sides say."};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false, problem_of_refusal(said, said.starts_with("x: "))};
    }
}

const std::vector<std::string> binary_words{std::string(1, '\0'),
                                            std::string(4, '\0'),
                                            "\xff",
                                            "\xff\xff",
                                            "\xff\xff\xff\xff",
                                            "\x7f\xff\xff\xff",
                                            "\x80",
                                            "\1",
                                            std::string("\0\1", 2),
                                            "\x10"};

std::vector<std::string> with_binary_words(std::vector<std::string> words) {
    words.insert(words.end(), binary_words.begin(), binary_words.end());
    return words;
}

const std::vector<std::string> number_words{
    "0", "-1", "+", ".", "#", "\n", " ", "65536", "4097", "99999999999", "1e999", "nan", "\x80"};

} // namespace

std::vector<ChangedFormat> picture_formats() {
    const std::string samples = std::string("\0\1\5\17\11\14\3\7\2\16\10\13", 12);
    return {
        {"PNG", png_seeds(), with_binary_words({"IHDR", "PLTE", "tRNS", "IDAT", "IEND", "CgBI"}),
         picture_outcome},
        {"JPG",
         {jpeg(20, 12, 60, ramp(20, 12)), jpeg(9, 9, 95, ramp(9, 9)), progressive_jpeg()},
         with_binary_words({"\xff\xd8", "\xff\xd9", "\xff\xda", "\xff\xc4", "\xff\xc0", "\xff\xc2",
                            "\xff\xdb", "\xff\xdd", "\xff\xd0", "\xff\xfe"}),
         picture_outcome},
        {"TGA", tga_seeds(), binary_words, picture_outcome},
        {"BMP", bmp_seeds(), binary_words, picture_outcome},
        {"PPM",
         {"P6 2 2 15\n" + samples, "P6\r\n# a\r\n2 1\r\n65535\r\n" + samples,
          "P3\n# by hand\n2 2\n15\n0 1 5  15 9 12\n3 7 2 # two\n14 8 11\n"},
         number_words,
         picture_outcome},
        {"PGM",
         {"P5\n4 3\n255\n" + samples, "P2 2\t2\r\n15\n0 1 5 15"},
         number_words,
         picture_outcome},
    };
}

} // namespace rasterwalk::test
