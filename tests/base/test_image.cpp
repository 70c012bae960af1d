#include "base/image.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "tests/support/catch.h"
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

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift);
    return bytes;
}

/// stb_image looks at no check sums.
std::string png_block(const char* name, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + "????";
}

std::string png(std::uint32_t width, std::uint32_t height, char bits, const std::string& data) {
    const std::string head =
        big_endian(width) + big_endian(height) + bits + std::string("\6\0\0\0", 4);
    return "\x89PNG\r\n\x1a\n" + png_block("IHDR", head) + png_block("IDAT", data) +
           png_block("IEND", "");
}

/// Compressed data that unpacks to so many zeros: a zero, then lengths of 258 bytes, each of 13
/// bits in deflate's fixed code.
std::string many_zeros(std::size_t count) {
    std::string data("\x78\x01");
    unsigned bits = 0;
    int filled = 0;
    const auto put = [&](unsigned value, int length) { // the lowest bit first
        bits |= value << filled;
        for (filled += length; filled >= 8; filled -= 8, bits >>= 8)
            data += static_cast<char>(bits & 255u);
    };
    put(1, 1);    // the last block
    put(1, 2);    // of the fixed code
    put(0x0c, 8); // a zero: 00110000, the highest bit first
    for (std::size_t i = 1; i < count; i += 258) {
        put(0xa3, 8); // 258 bytes: 11000101
        put(0, 5);    // from one byte before
    }
    put(0, 7); // end
    put(0, 7);
    return data;
}

/// What is said about a picture by a process that may take only this much more memory, bytes; "" if
/// it is read.
std::string complaint_within([[maybe_unused]] std::size_t memory, const std::string& path) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
#if !defined(__SANITIZE_ADDRESS__)
        long pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t most = static_cast<rlim_t>(pages) * 4096 + memory;
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_AS, &limit);
#endif
        std::string said;
        try {
            read_image(path);
        } catch (const std::exception& fault) {
            said = fault.what();
        }
        if (::write(ends[1], said.data(), said.size()) < 0) ::_exit(1);
        ::_exit(0);
    }
    ::close(ends[1]);
    std::string said(4096, '\0');
    const ssize_t count = ::read(ends[0], said.data(), said.size());
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(status == 0);
    said.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return said;
}

constexpr std::size_t megabyte = std::size_t{1} << 20;

std::string little_endian(std::uint32_t value) {
    std::string bytes = big_endian(value);
    return {bytes.rbegin(), bytes.rend()};
}

/// A BMP of 24 bits a pixel, whole.
std::string bmp(int width, int height) {
    const int row = (3 * width + 3) / 4 * 4;
    const auto word = [](int value) { return little_endian(static_cast<std::uint32_t>(value)); };
    return "BM" + word(54 + row * std::abs(height)) + word(0) + word(54) + word(40) + word(width) +
           word(height) + std::string("\1\0\x18\0", 4) + word(0) + word(0) + word(0) + word(0) +
           word(0) + word(0) + std::string(static_cast<std::size_t>(row * std::abs(height)), 'x');
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

TEST_CASE("A PNG that unpacks to more than its size is refused before memory is taken for it") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("bomb.png", png(2, 2, 8, many_zeros(200 * megabyte)));
    CHECK(complaint_within(60 * megabyte, path) ==
          path + ": a picture of 2 x 2 pixels has data for more.");
    // As much as belongs to it: four pixels, and a filter for each row.
    CHECK(complaint_within(60 * megabyte, folder.write("x.png", png(2, 2, 8, many_zeros(1)))) ==
          folder.file("x.png") + ": the picture cannot be read: not enough pixels.");
}

TEST_CASE("A short file that says it is a large picture is refused before memory is taken") {
    const test::TemporaryFolder folder;
    const auto said = [&](const std::string& bytes) {
        const std::string path = folder.write("x", bytes);
        return complaint_within(60 * megabyte, path).substr(path.size());
    };
    CHECK(said(png(8192, 8192, 8, "")) == ": a picture of 8192 x 8192 pixels is cut off.");
    CHECK(said(png(5792, 5792, 16, "x")) == ": a picture of 5792 x 5792 pixels is cut off.");
    CHECK(said(png(8192, 8192, 16, "")) == ": a picture of 8192 x 8192 pixels is too large.");
    CHECK(said(png(16384, 16384, 8, "")) == ": a picture of 16384 x 16384 pixels is too large.");
    CHECK(said(png(0xffffffff, 0xffffffff, 16, "")) ==
          ": a picture of 4294967295 x 4294967295 pixels is too large.");
    CHECK(said(bmp(8192, 8192).substr(0, 66)) == ": a picture of 8192 x 8192 pixels is cut off.");
    CHECK(said(bmp(6, 1029).substr(0, 62)) == ": a picture of 6 x 1029 pixels is cut off.");
}

TEST_CASE("A BMP that is cut off is refused, at whichever byte") {
    const test::TemporaryFolder folder;
    for (const int height : {3, -3}) {
        const std::string whole = bmp(5, height);
        const Image image = read_image(folder.write("whole.bmp", whole));
        CHECK(image.width == 5);
        CHECK(image.height == 3);
        // The filling of the last row may be missing.
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
