#include "scene/image.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include <stb_image.h>
#include <stb_image_write.h>

#include "scene/error.h"
#include "scene/read_text.h"

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

bool begins_as_image(std::string_view bytes) {
    constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
    return bytes.starts_with(png_signature) || bytes.starts_with("BM");
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
    const std::string_view text = bytes;
    if (!begins_as_image(text)) {
        throw InputError(path + ": the file is neither a PNG nor a BMP picture.");
    }
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Image image;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0) {
        throw InputError(path + ": the picture cannot be read: " + stbi_failure_reason() + ".");
    }
    if (image.width < 1 || image.height < 1 || image.width > largest_side ||
        image.height > largest_side || pixel_count(image) > largest_pixel_count) {
        throw InputError(path + ": a picture of " + std::to_string(image.width) + " x " +
                         std::to_string(image.height) + " pixels is too large.");
    }
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4),
        stbi_image_free);
    if (!pixels) {
        throw InputError(path + ": the picture cannot be read: " + stbi_failure_reason() + ".");
    }
    image.rgba.assign(pixels.get(), pixels.get() + 4 * pixel_count(image));
    return image;
}

} // namespace rasterwalk
