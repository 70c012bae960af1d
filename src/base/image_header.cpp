#include "base/image_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <stb_image.h>

#include "base/error.h"

namespace rasterwalk {

namespace {

/// stb_image needs up to eight bytes a pixel at once, and twice as many with 16 bits a channel.
constexpr std::int64_t largest_pixel_count = std::int64_t{1} << 26;

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// One byte of deflate data never stands for more.
constexpr std::int64_t largest_deflate_ratio = 1032;

std::int64_t byte_at(std::string_view bytes, std::size_t place) {
    return place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0;
}

std::int64_t big_endian(std::string_view bytes, std::size_t place) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | byte_at(bytes, place + i);
    return value;
}

std::int64_t little_endian(std::string_view bytes, std::size_t place, std::size_t count) {
    std::int64_t value = 0;
    for (std::size_t i = count; i-- > 0;)
        value = value << 8 | byte_at(bytes, place + i);
    return value;
}

struct PictureSize {
    std::int64_t width, height;
};

[[noreturn]] void refuse(const std::string& path, PictureSize size, const char* why) {
    throw InputError(
        fmt::format("{}: a picture of {} x {} pixels {}", path, size.width, size.height, why));
}

void check_side(const std::string& path, PictureSize size, int side, int bits_per_channel) {
    const std::int64_t weight = bits_per_channel > 8 ? 2 : 1;
    if (size.width > side || size.height > side ||
        weight * size.width * size.height > largest_pixel_count) {
        refuse(path, size, "is too large.");
    }
}

// PNG: https://www.w3.org/TR/2003/REC-PNG-20031110/

struct PngHeader {
    PictureSize size{};
    int bits_per_channel = 0;
    int channels = 0; ///< 0: no colour type that there is
    bool is_interlaced = false;
};

std::optional<PngHeader> parse_png_header(std::string_view bytes) {
    if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR") return std::nullopt;
    constexpr std::array<int, 7> channels_of_type{1, 0, 3, 1, 2, 0, 4};
    const std::int64_t type = byte_at(bytes, 25);
    PngHeader header;
    header.size = {big_endian(bytes, 16), big_endian(bytes, 20)};
    header.bits_per_channel = static_cast<int>(byte_at(bytes, 24));
    if (type < 7) header.channels = channels_of_type[static_cast<std::size_t>(type)];
    header.is_interlaced = byte_at(bytes, 28) != 0;
    return header;
}

/// Bytes of the rows of so many pixels, each with the byte that names its filter.
std::int64_t bytes_of_rows(const PngHeader& header, PictureSize size) {
    if (size.width <= 0 || size.height <= 0) return 0;
    const std::int64_t bits = size.width * header.channels * header.bits_per_channel;
    return size.height * ((bits + 7) / 8 + 1);
}

/// Bytes of the whole picture when it is unpacked, before its filters are undone.
std::int64_t unpacked_bytes(const PngHeader& header) {
    if (!header.is_interlaced) return bytes_of_rows(header, header.size);
    struct Pass {
        int x, y, dx, dy;
    };
    constexpr std::array<Pass, 7> passes{{{0, 0, 8, 8},
                                          {4, 0, 8, 8},
                                          {0, 4, 4, 8},
                                          {2, 0, 4, 4},
                                          {0, 2, 2, 4},
                                          {1, 0, 2, 2},
                                          {0, 1, 1, 2}}};
    std::int64_t sum = 0;
    for (const Pass& pass : passes) {
        sum += bytes_of_rows(header, {(header.size.width - pass.x + pass.dx - 1) / pass.dx,
                                      (header.size.height - pass.y + pass.dy - 1) / pass.dy});
    }
    return sum;
}

/// The compressed data of all blocks, as far as they are there.
std::string png_data(std::string_view bytes) {
    constexpr std::size_t frame = 12; // length, name and check sum of a block
    std::string data;
    std::string_view rest = bytes.substr(png_signature.size());
    while (rest.size() >= frame) {
        const auto length = static_cast<std::size_t>(big_endian(rest, 0));
        const std::string_view name = rest.substr(4, 4);
        if (name == "IEND" || length > rest.size() - frame) break;
        if (name == "IDAT") data.append(rest.substr(8, length));
        rest.remove_prefix(frame + length);
    }
    return data;
}

void check_png(std::string_view bytes, const std::string& path, int side) {
    const std::optional<PngHeader> header = parse_png_header(bytes);
    if (!header) {
        throw InputError(path + ": the picture cannot be read: it does not begin with its size.");
    }
    check_side(path, header->size, side, header->bits_per_channel);
    const std::int64_t wanted = unpacked_bytes(*header);
    const std::string data = png_data(bytes);
    if (wanted / largest_deflate_ratio > static_cast<std::int64_t>(data.size())) {
        refuse(path, header->size, "is cut off.");
    }
    if (wanted <= 0) return;
    std::vector<char> room(static_cast<std::size_t>(wanted));
    const int count = stbi_zlib_decode_buffer(room.data(), static_cast<int>(room.size()),
                                              data.data(), static_cast<int>(data.size()));
    if (count < 0 && std::string_view(stbi_failure_reason()) == "output buffer limit") {
        refuse(path, header->size, "has data for more.");
    }
}

// BMP, with the headers that stb_image knows

void check_bmp(std::string_view bytes, const std::string& path, int side) {
    constexpr std::size_t file_header = 14;
    const std::int64_t header = little_endian(bytes, file_header, 4);
    const bool is_old = header == 12;
    const std::size_t word = is_old ? 2 : 4; // bytes of width and height
    const auto number = [&](std::size_t place) {
        const std::int64_t value = little_endian(bytes, place, word);
        return is_old ? value : std::int64_t{static_cast<std::int32_t>(value)};
    };
    // From the top where the height is negative.
    const PictureSize size{number(18), std::abs(number(18 + word))};
    const std::int64_t bits = little_endian(bytes, 20 + 2 * word, 2);
    check_side(path, size, side, 8);
    if (size.width <= 0 || size.height <= 0) return;
    const std::int64_t begin =
        std::max(little_endian(bytes, 10, 4), static_cast<std::int64_t>(file_header) + header);
    // The last row need not be filled up to four bytes.
    const std::int64_t row = (size.width * bits + 31) / 32 * 4;
    const std::int64_t end = begin + row * (size.height - 1) + (size.width * bits + 7) / 8;
    if (end > static_cast<std::int64_t>(bytes.size())) refuse(path, size, "is cut off.");
}

} // namespace

bool begins_as_png(std::string_view bytes) {
    return bytes.starts_with(png_signature);
}

bool begins_as_bmp(std::string_view bytes) {
    return bytes.starts_with("BM");
}

void check_image_size(std::string_view bytes, const std::string& path, int side) {
    if (begins_as_png(bytes)) check_png(bytes, path, side);
    if (begins_as_bmp(bytes)) check_bmp(bytes, path, side);
}

} // namespace rasterwalk
