#include "base/image.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_format.h"
#include "base/image_header.h"
#include "base/pnm.h"

// stb_image, compiled for hostile files: memory starts as zeros, so a picture whose data end early
// is the same each time, and a check that fails inside it throws instead of ending the program.

namespace {

void check_in_decoder(bool is_right) {
    if (!is_right) throw std::logic_error("its data is damaged");
}

} // namespace

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(room, size) std::realloc(room, size)
#define STBI_FREE(room) std::free(room)
#define STBI_ASSERT(is_right) check_in_decoder(is_right)
// Its sums can overflow if a file is damaged; the result is only a colour.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((no_sanitize("undefined"))), apply_to = function)
#include <stb_image.h>
#pragma clang attribute pop
#else
#include <stb_image.h>
#endif

namespace rasterwalk {

namespace {

/// For some faults stb_image gives no reason: then there is none, or still an earlier picture's. So
/// the old reason is cleared first.
void forget_reason() {
    int ignored = 0;
    stbi_info_from_memory(nullptr, 0, &ignored, &ignored, &ignored);
}

std::string last_reason() {
    const char* const said = stbi_failure_reason();
    const std::string_view reason = said != nullptr ? said : "";
    // Its words for no bytes at all, or for bytes of another format, are not a reason.
    for (const std::string_view none : {"", "unknown image type", "bad png sig", "no SOI"})
        if (reason == none) return "its data is damaged";
    return std::string(reason);
}

/// Unpacks a PNG, BMP, TGA or JPG for which stated_size() has not thrown (image_header.h).
/// @return why it could not: "bad huffman code"; empty if it could
std::string decode_image(std::string_view bytes, Image& image) {
    forget_reason();
    if (bytes.size() > static_cast<std::size_t>(INT_MAX)) return "its file is too large";
    try {
        int channels = 0;
        const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
            stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                  static_cast<int>(bytes.size()), &image.width, &image.height,
                                  &channels, 4),
            stbi_image_free);
        if (!pixels) return last_reason();
        image.rgba.assign(pixels.get(), pixels.get() + 4 * static_cast<std::size_t>(image.width) *
                                                           static_cast<std::size_t>(image.height));
    } catch (const std::logic_error& fault) {
        return fault.what();
    }
    return {};
}

/// What decode_zlib() returns if there is no room for all of it.
constexpr std::string_view zlib_has_more = "output buffer limit";

/// Unpacks zlib data into `room` bytes, and discards them.
/// @return why it could not; empty if it could
std::string decode_zlib(std::string_view data, std::size_t room) {
    forget_reason();
    std::vector<char> unpacked(room);
    const int count = stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()),
                                              data.data(), static_cast<int>(data.size()));
    return count >= 0 ? std::string() : last_reason();
}

void append_bytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw InputError(fmt::format("{}: the picture cannot be read: {}.", path, reason));
}

/// stb_image allocates as much memory as the data unpack to, whatever the size of the picture.
void check_png_data(std::string_view bytes, const std::string& path, glm::ivec2 size) {
    const std::string problem = decode_zlib(png_data(bytes), png_row_bytes(bytes));
    if (problem.empty()) return;
    if (problem != zlib_has_more) refuse(path, problem);
    throw InputError(fmt::format("{}: a picture of {} x {} pixels contains too much data.", path,
                                 size.x, size.y));
}

/// The byte of a TGA that says how its pixels are stored.
constexpr std::size_t tga_descriptor = 17;

/// Many programs leave the opacity of a TGA empty; the header says how many of its bits count.
void ignore_empty_alpha(std::string_view bytes, Image& image) {
    constexpr int alpha_bits = 15;
    if ((bytes[tga_descriptor] & alpha_bits) != 0) return;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
}

/// The header of a TGA may say that its rows run from right to left; stb_image ignores that.
void turn_rows_round(std::string_view bytes, Image& image) {
    constexpr int from_right = 16;
    if ((bytes[tga_descriptor] & from_right) == 0) return;
    for (int row = 0; row < image.height; ++row) {
        for (int left = 0, right = image.width - 1; left < right; ++left, --right) {
            const auto pixel = [&](int column) {
                return image.rgba.begin() + 4 * (std::ptrdiff_t{row} * image.width + column);
            };
            std::swap_ranges(pixel(left), pixel(left) + 4, pixel(right));
        }
    }
}

Image unpack(std::string_view bytes, const std::string& path, glm::ivec2 size) {
    const ImageFormat format = image_format(bytes);
    if (format == ImageFormat::pnm) {
        std::optional<Image> image = parse_pnm(bytes, parse_pnm_header(bytes).value());
        if (image) return std::move(*image);
        refuse(path, "a sample is missing or too large");
    }
    if (format == ImageFormat::png) check_png_data(bytes, path, size);
    Image image;
    const std::string problem = decode_image(bytes, image);
    if (!problem.empty()) refuse(path, problem);
    if (format == ImageFormat::tga) {
        ignore_empty_alpha(bytes, image);
        turn_rows_round(bytes, image);
    }
    return image;
}

} // namespace

std::string png_bytes(const Image& image) {
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != 4 * pixel_count(image))
        throw InputError("a picture without pixels cannot be written.");
    // This packs flat colours quickly, and an interface into fewer bytes.
    stbi_write_force_png_filter = 0;
    stbi_write_png_compression_level = 5;
    std::string bytes;
    if (stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 4,
                               image.rgba.data(), 4 * image.width) == 0)
        throw AccessError("the picture could not be compressed.");
    return bytes;
}

void write_png(const Image& image, const std::string& path) {
    try {
        write_file(path, png_bytes(image));
    } catch (const InputError& fault) {
        throw InputError(path + ": " + fault.what());
    }
}

bool is_image(std::string_view bytes) {
    return image_format(bytes) != ImageFormat::none;
}

bool is_image_file(const std::string& path) {
    // Reading a pipe would wait.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::array<char, image_head_size> head{};
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), head.size());
    return is_image({head.data(), static_cast<std::size_t>(file.gcount())});
}

Image parse_image(std::string_view bytes, const std::string& path, int largest_side) {
    return unpack(bytes, path, stated_size(bytes, path, largest_side));
}

Image parse_exact_image(std::string_view bytes, const std::string& path) {
    if (image_format(bytes) == ImageFormat::jpeg) {
        throw InputError(fmt::format("{}: a JPG does not keep the exact colour of each pixel; save "
                                     "the picture as {}.",
                                     path, exact_image_formats));
    }
    return parse_image(bytes, path);
}

Image read_image(const std::string& path, int largest_side, const ImageSizeCheck& check) {
    const std::string bytes = read_file(path, largest_image_file);
    const glm::ivec2 size = stated_size(bytes, path, largest_side);
    if (check) check(size);
    return unpack(bytes, path, size);
}

Image read_png(const std::string& path, int largest_side) {
    const std::string bytes = read_file(path, largest_image_file);
    if (image_format(bytes) != ImageFormat::png)
        throw InputError(path + ": the file is not a PNG picture.");
    return parse_image(bytes, path, largest_side);
}

} // namespace rasterwalk
