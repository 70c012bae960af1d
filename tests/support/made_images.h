#pragma once

// Files of pictures, byte by byte.

#include <cstdint>
#include <cstdlib>
#include <string>

namespace rasterwalk::test {

inline std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift);
    return bytes;
}

/// stb_image looks at no check sums.
inline std::string png_block(const char* name, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + "????";
}

inline std::string png(std::uint32_t width, std::uint32_t height, char bits,
                       const std::string& data) {
    const std::string head =
        big_endian(width) + big_endian(height) + bits + std::string("\6\0\0\0", 4);
    return "\x89PNG\r\n\x1a\n" + png_block("IHDR", head) + png_block("IDAT", data) +
           png_block("IEND", "");
}

/// Compressed data that unpacks to so many zeros: a zero, then lengths of 258 bytes, each of 13
/// bits in deflate's fixed code.
inline std::string many_zeros(std::size_t count) {
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

inline std::string little_endian(std::uint32_t value) {
    std::string bytes = big_endian(value);
    return {bytes.rbegin(), bytes.rend()};
}

/// A BMP of 24 bits a pixel, whole.
inline std::string bmp(int width, int height) {
    const int row = (3 * width + 3) / 4 * 4;
    const auto word = [](int value) { return little_endian(static_cast<std::uint32_t>(value)); };
    return "BM" + word(54 + row * std::abs(height)) + word(0) + word(54) + word(40) + word(width) +
           word(height) + std::string("\1\0\x18\0", 4) + word(0) + word(0) + word(0) + word(0) +
           word(0) + word(0) + std::string(static_cast<std::size_t>(row * std::abs(height)), 'x');
}

inline std::string byte(int value) {
    return std::string(1, static_cast<char>(value));
}
inline std::string two_bytes(int value) {
    return byte(value & 255) + byte(value >> 8);
}

/// The first 18 bytes of a TGA.
/// @param kind       1: with a palette, 2: colours, 3: grey; 8 more: packed
/// @param descriptor from_top, and how many bits are alpha
inline std::string tga_head(int kind, int width, int height, int bits, int descriptor,
                            int colours = 0, int colour_bits = 0) {
    return byte(0) + byte(colours > 0) + byte(kind) + two_bytes(0) + two_bytes(colours) +
           byte(colour_bits) + two_bytes(0) + two_bytes(0) + two_bytes(width) + two_bytes(height) +
           byte(bits) + byte(descriptor);
}

inline constexpr int from_top = 32, eight_alpha_bits = 8;

} // namespace rasterwalk::test
