#include "base/image.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_header.h"

namespace rasterwalk {

namespace {

constexpr int largest_side = 16384;

void append_bytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

Image unpack(std::string_view bytes, const std::string& path, int side) {
    check_image_size(bytes, path, side);
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                              static_cast<int>(bytes.size()), &image.width, &image.height,
                              &channels, 4),
        stbi_image_free);
    if (!pixels) {
        throw InputError(
            fmt::format("{}: the picture cannot be read: {}.", path, stbi_failure_reason()));
    }
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

bool is_image(std::string_view bytes) {
    return begins_as_png(bytes) || begins_as_bmp(bytes);
}

bool is_image_file(const std::string& path) {
    // A pipe would be waited for.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::array<char, 8> head{};
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), head.size());
    return is_image({head.data(), static_cast<std::size_t>(file.gcount())});
}

Image parse_image(std::string_view bytes, const std::string& path) {
    if (!is_image(bytes)) {
        throw InputError(path + ": the file is neither a PNG nor a BMP picture.");
    }
    return unpack(bytes, path, largest_side);
}

Image read_image(const std::string& path) {
    return parse_image(read_file(path, largest_image_file), path);
}

Image read_png(const std::string& path, int side) {
    const std::string bytes = read_file(path, largest_image_file);
    if (!begins_as_png(bytes)) throw InputError(path + ": the file is no PNG picture.");
    return unpack(bytes, path, side);
}

} // namespace rasterwalk
