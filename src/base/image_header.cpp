#include "base/image_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/image_format.h"
#include "base/jpeg_header.h"
#include "base/pnm.h"

namespace rasterwalk {

namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

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

[[noreturn]] void refuse(const std::string& path, PictureSize size, const std::string& why) {
    throw InputError(
        fmt::format("{}: a picture of {} x {} pixels {}", path, size.width, size.height, why));
}

void check_sides(const std::string& path, PictureSize size, int largest_side) {
    if (size.width <= 0 || size.height <= 0) refuse(path, size, "is empty.");
    if (size.width > largest_side || size.height > largest_side)
        refuse(path, size, fmt::format("is too large: a side may have at most {}.", largest_side));
}

// PNG: https://www.w3.org/TR/2003/REC-PNG-20031110/

struct PngHeader {
    PictureSize size{};
    int bits_per_channel = 0;
    int channels = 0; ///< 0: not a valid colour type
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

/// Bytes of the rows of a picture of this size, each with the byte that names its filter.
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

/// A block of a PNG: https://www.w3.org/TR/2003/REC-PNG-20031110/#5Chunk-layout
struct PngBlock {
    std::string_view name, data;
};

/// Walks over the blocks.
class PngBlocks {
  public:
    explicit PngBlocks(std::string_view bytes) : rest_(bytes.substr(png_signature.size())) {}

    /// The next block; nothing at the end of the picture, or if the file ends before that.
    std::optional<PngBlock> next() {
        constexpr std::size_t head = 8, check_sum = 4; // length and name
        if (rest_.size() < head) return std::nullopt;
        const auto length = static_cast<std::size_t>(big_endian(rest_, 0));
        PngBlock block{rest_.substr(4, 4), rest_.substr(head)};
        is_at_end_ = block.name == "IEND";
        if (is_at_end_ || length > block.data.size()) return std::nullopt;
        block.data = block.data.substr(0, length);
        rest_.remove_prefix(std::min(head + length + check_sum, rest_.size()));
        return block;
    }
    bool is_at_end() const { return is_at_end_; }

  private:
    std::string_view rest_;
    bool is_at_end_ = false;
};

glm::ivec2 png_size(std::string_view bytes, const std::string& path, int largest_side) {
    const std::optional<PngHeader> header = parse_png_header(bytes);
    if (!header) {
        throw InputError(path + ": the picture cannot be read because it does not begin with its "
                                "size.");
    }
    check_sides(path, header->size, largest_side);
    if (header->channels == 0)
        refuse(path, header->size,
               "has a colour type that does not exist "
               "in PNG.");
    if (header->bits_per_channel > 16)
        refuse(path, header->size, "has more than 16 bits per channel, which PNG does not allow.");
    std::int64_t size = 0;
    PngBlocks blocks(bytes);
    while (const std::optional<PngBlock> block = blocks.next()) {
        // Its data have a different form, and stb_image unpacks all there is of it.
        if (block->name == "CgBI") refuse(path, header->size, "is a PNG in Apple's own variant.");
        if (block->name == "IDAT") size += static_cast<std::int64_t>(block->data.size());
    }
    // One byte of deflate data never stands for more.
    constexpr std::int64_t largest_deflate_ratio = 1032;
    if (!blocks.is_at_end() || unpacked_bytes(*header) / largest_deflate_ratio > size)
        refuse(path, header->size, "is cut off.");
    return {header->size.width, header->size.height};
}

// BMP, with the headers that stb_image knows

glm::ivec2 bmp_size(std::string_view bytes, const std::string& path, int largest_side) {
    constexpr std::size_t file_header = 14;
    const std::int64_t header = little_endian(bytes, file_header, 4);
    const bool is_old = header == 12;
    const std::size_t word = is_old ? 2 : 4; // bytes of width and height
    const auto number = [&](std::size_t place) {
        const std::int64_t value = little_endian(bytes, place, word);
        return is_old ? value : std::int64_t{static_cast<std::int32_t>(value)};
    };
    // From the top if the height is negative.
    const PictureSize size{number(18), std::abs(number(18 + word))};
    const std::int64_t bits = std::max<std::int64_t>(little_endian(bytes, 20 + 2 * word, 2), 1);
    check_sides(path, size, largest_side);
    // stb_image loses its last colours.
    if (is_old && bits <= 8) {
        refuse(path, size,
               "has an OS/2 header with a palette, which cannot be read; save it as PNG.");
    }
    constexpr std::int64_t with_masks = 3; // plain, with masks for the bits of red, green and blue
    const std::int64_t packing = is_old ? 0 : little_endian(bytes, 30, 4);
    if ((is_old && bits < 24) || (packing != 0 && packing != with_masks))
        refuse(path, size, "is a BMP of a kind that cannot be read; save it as PNG.");
    const std::int64_t begin =
        std::max(little_endian(bytes, 10, 4), static_cast<std::int64_t>(file_header) + header);
    // The last row need not be filled up to four bytes.
    const std::int64_t row = (size.width * bits + 31) / 32 * 4;
    const std::int64_t end = begin + row * (size.height - 1) + (size.width * bits + 7) / 8;
    if (end > static_cast<std::int64_t>(bytes.size())) refuse(path, size, "is cut off.");
    return {size.width, size.height};
}

// TGA: Truevision TGA File Format Specification, version 2.0, 1991

glm::ivec2 tga_size(std::string_view bytes, const std::string& path, int largest_side) {
    constexpr std::int64_t header = 18, packed = 8, longest_packet = 128;
    const PictureSize size{little_endian(bytes, 12, 2), little_endian(bytes, 14, 2)};
    check_sides(path, size, largest_side);
    std::int64_t palette = 0;
    if (byte_at(bytes, 1) == 1) {
        // stb_image skips as many bytes as there are colours before the first one.
        if (little_endian(bytes, 3, 2) != 0)
            refuse(path, size, "has a palette that does not begin at 0; save it as PNG.");
        palette = little_endian(bytes, 5, 2) * ((byte_at(bytes, 7) + 7) / 8);
    }
    const std::int64_t pixel = (byte_at(bytes, 16) + 7) / 8, count = size.width * size.height;
    const bool is_packed = (byte_at(bytes, 2) & packed) != 0;
    const std::int64_t data =
        is_packed ? (count + longest_packet - 1) / longest_packet * (1 + pixel) : count * pixel;
    if (header + byte_at(bytes, 0) + palette + data > static_cast<std::int64_t>(bytes.size()))
        refuse(path, size, "is cut off.");
    return {size.width, size.height};
}

glm::ivec2 jpeg_size(std::string_view bytes, const std::string& path, int largest_side) {
    const JpegHeader header = parse_jpeg_header(bytes);
    const PictureSize size{header.size.x, header.size.y};
    if (header.size == glm::ivec2(0)) throw InputError(path + ": the picture " + header.problem);
    check_sides(path, size, largest_side);
    if (!header.problem.empty()) refuse(path, size, header.problem);
    // A block of 8 x 8 pixels takes at least one bit.
    if (size.width * size.height / 512 > static_cast<std::int64_t>(bytes.size()))
        refuse(path, size, "is cut off.");
    return header.size;
}

glm::ivec2 pnm_size(std::string_view bytes, const std::string& path, int largest_side) {
    const std::optional<PnmHeader> header = parse_pnm_header(bytes);
    if (!header) {
        throw InputError(path + ": the picture cannot be read because it does not begin with its "
                                "width, its height and its largest sample.");
    }
    const PictureSize size{header->size.x, header->size.y};
    check_sides(path, size, largest_side);
    if (header->begin + header->fewest_bytes() > bytes.size()) refuse(path, size, "is cut off.");
    return header->size;
}

} // namespace

glm::ivec2 stated_size(std::string_view bytes, const std::string& path, int largest_side) {
    switch (image_format(bytes)) {
    case ImageFormat::png:
        return png_size(bytes, path, largest_side);
    case ImageFormat::bmp:
        return bmp_size(bytes, path, largest_side);
    case ImageFormat::jpeg:
        return jpeg_size(bytes, path, largest_side);
    case ImageFormat::tga:
        return tga_size(bytes, path, largest_side);
    case ImageFormat::pnm:
        return pnm_size(bytes, path, largest_side);
    case ImageFormat::none:
        break;
    }
    const std::string_view known = unread_image_format(bytes);
    if (known.empty()) {
        throw InputError(fmt::format("{}: the file is not a picture that can be read ({}).", path,
                                     image_formats_read));
    }
    throw InputError(
        fmt::format("{}: the picture is {}, which cannot be read; save it as PNG.", path, known));
}

std::string png_data(std::string_view bytes) {
    std::string data;
    PngBlocks blocks(bytes);
    while (const std::optional<PngBlock> block = blocks.next())
        if (block->name == "IDAT") data.append(block->data);
    return data;
}

std::size_t png_row_bytes(std::string_view bytes) {
    return static_cast<std::size_t>(unpacked_bytes(parse_png_header(bytes).value()));
}

} // namespace rasterwalk
