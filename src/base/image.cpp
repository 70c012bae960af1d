#include "base/image.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include <stb_image.h>
#include <stb_image_write.h>

#include "base/error.h"
#include "base/files.h"

namespace rasterwalk {

namespace {

constexpr int largest_side = 16384;
constexpr std::size_t largest_image_file = std::size_t{256} << 20;
constexpr std::size_t largest_pixel_count = std::size_t{1} << 26;

void append_bytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

bool begins_as_png(std::string_view bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

bool begins_as_image(std::string_view bytes) {
    return begins_as_png(bytes) || bytes.starts_with("BM");
}

/// The size that a PNG says it has; 0 x 0 if it says none. Beyond 2^24 pixels a side stb_image says
/// only that it does not know what it is.
std::array<std::uint32_t, 2> png_size(std::string_view bytes) {
    constexpr std::size_t place =
        16; // behind the signature, and length and name of the first block
    std::array<std::uint32_t, 2> size{};
    if (!begins_as_png(bytes) || bytes.size() < place + 8) return size;
    for (std::size_t i = 0; i < 8; ++i)
        size[i / 4] = size[i / 4] << 8 | static_cast<unsigned char>(bytes[place + i]);
    return size;
}

[[noreturn]] void refuse_size(const std::string& path, std::uint32_t width, std::uint32_t height) {
    throw InputError(path + ": a picture of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels is too large.");
}

/// Unpacks the bytes of a picture. The size that it says it has is looked at first.
Image unpack(std::string_view bytes, const std::string& path, int side) {
    const auto [said_width, said_height] = png_size(bytes);
    const auto most = static_cast<std::uint32_t>(side);
    if (said_width > most || said_height > most) refuse_size(path, said_width, said_height);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Image image;
    int channels = 0;
    const auto refuse = [&] {
        throw InputError(path + ": the picture cannot be read: " + stbi_failure_reason() + ".");
    };
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0) refuse();
    if (image.width < 1 || image.height < 1 || image.width > side || image.height > side ||
        pixel_count(image) > largest_pixel_count) {
        refuse_size(path, static_cast<std::uint32_t>(image.width),
                    static_cast<std::uint32_t>(image.height));
    }
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4),
        stbi_image_free);
    if (!pixels) refuse();
    image.rgba.assign(pixels.get(), pixels.get() + 4 * pixel_count(image));
    return image;
}

} // namespace

void write_png(const Image& image, const std::string& path) {
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != 4 * pixel_count(image)) {
        throw InputError(path + ": a picture without pixels cannot be written.");
    }
    std::string bytes;
    if (stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 4,
                               image.rgba.data(), 4 * image.width) == 0) {
        throw AccessError("cannot write '" + path + "': the picture could not be compressed.");
    }
    write_file(path, bytes);
}

bool is_image_file(const std::string& path) {
    // A pipe would be waited for.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::array<char, 8> head{};
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), head.size());
    return begins_as_image({head.data(), static_cast<std::size_t>(file.gcount())});
}

Image read_image(const std::string& path) {
    const std::string bytes = read_file(path, largest_image_file);
    if (!begins_as_image(bytes)) {
        throw InputError(path + ": the file is neither a PNG nor a BMP picture.");
    }
    return unpack(bytes, path, largest_side);
}

Image read_png(const std::string& path, int side) {
    const std::string bytes = read_file(path, largest_image_file);
    if (!begins_as_png(bytes)) throw InputError(path + ": the file is no PNG picture.");
    return unpack(bytes, path, side);
}

} // namespace rasterwalk
