#include "base/stb_decoder.h"

#include <climits>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <vector>

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

} // namespace

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

std::string decode_zlib(std::string_view data, std::size_t room) {
    forget_reason();
    std::vector<char> unpacked(room);
    const int count = stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()),
                                              data.data(), static_cast<int>(data.size()));
    return count >= 0 ? std::string() : last_reason();
}

} // namespace rasterwalk
