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

void append_bytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Why stb_image could not do what it was asked for last. For some faults it gives no reason: there
/// is none then, or still that of a picture before. So that one is forgotten first.
class DecoderFailure {
  public:
    DecoderFailure() {
        int ignored = 0;
        stbi_info_from_memory(nullptr, 0, &ignored, &ignored, &ignored);
    }
    std::string_view reason() const {
        const char* const said = stbi_failure_reason();
        const std::string_view reason = said != nullptr ? said : "";
        constexpr std::string_view of_no_bytes = "unknown image type";
        return reason.empty() || reason == of_no_bytes ? "its data are damaged" : reason;
    }
    [[noreturn]] void refuse(const std::string& path) const {
        throw InputError(fmt::format("{}: the picture cannot be read: {}.", path, reason()));
    }
};

/// stb_image takes as much memory as the data unpack to, whatever the size of the picture.
void check_png_data(std::string_view bytes, const std::string& path, glm::ivec2 size) {
    const std::string data = png_data(bytes);
    std::vector<char> room(png_row_bytes(bytes));
    const DecoderFailure failure;
    if (stbi_zlib_decode_buffer(room.data(), static_cast<int>(room.size()), data.data(),
                                static_cast<int>(data.size())) >= 0)
        return;
    if (failure.reason() != "output buffer limit") failure.refuse(path);
    throw InputError(
        fmt::format("{}: a picture of {} x {} pixels has data for more.", path, size.x, size.y));
}

Image unpack(std::string_view bytes, const std::string& path, glm::ivec2 size) {
    if (begins_as_png(bytes)) check_png_data(bytes, path, size);
    Image image;
    int channels = 0;
    const DecoderFailure failure;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                              static_cast<int>(bytes.size()), &image.width, &image.height,
                              &channels, 4),
        stbi_image_free);
    if (!pixels) failure.refuse(path);
    image.rgba.assign(pixels.get(), pixels.get() + 4 * pixel_count(image));
    return image;
}

} // namespace

void write_png(const Image& image, const std::string& path) {
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != 4 * pixel_count(image)) {
        throw InputError(path + ": a picture without pixels cannot be written.");
    }
    // Flat colours are packed quickly so, and an interface into fewer bytes.
    stbi_write_force_png_filter = 0;
    stbi_write_png_compression_level = 5;
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

Image parse_image(std::string_view bytes, const std::string& path, int largest_side) {
    return unpack(bytes, path, stated_size(bytes, path, largest_side));
}

Image read_image(const std::string& path) {
    return parse_image(read_file(path, largest_image_file), path);
}

Image read_png(const std::string& path, int largest_side, const ImageSizeCheck& check) {
    const std::string bytes = read_file(path, largest_image_file);
    if (!begins_as_png(bytes)) throw InputError(path + ": the file is no PNG picture.");
    const glm::ivec2 size = stated_size(bytes, path, largest_side);
    if (check) check(size);
    return unpack(bytes, path, size);
}

} // namespace rasterwalk
