#include "engines/engine_picture.h"

#include <cstddef>
#include <cstdint>

#include "pipeline/clearing.h"

namespace rasterwalk {

namespace {

/// Clearing a pixel and copying another into it is this many times the work of clearing it.
constexpr double copy_factor = 4.0;

} // namespace

void copy_picture(const FastPicture& picture, const Frame& frame, Framebuffer& planes) {
    begin_clearing(planes, frame);
    copy_rows(picture, {}, planes);
}

bool copy_rows(const FastPicture& picture, const WorkLimit& limit, Framebuffer& planes) {
    const auto rows = [&] {
        return static_cast<int>(planes.owner.size() / static_cast<std::size_t>(picture.size.width));
    };
    const int first = rows();
    const WorkLimit of_clearing{limit.at_once / copy_factor, limit.slice / copy_factor};
    const bool is_whole = clear_rows(planes, of_clearing);
    constexpr float largest_byte = 255.0f;
    for (int row = first; row < rows(); ++row) {
        const std::size_t from = picture.at(0, row), to = planes.at(0, row);
        for (std::size_t i = 0; i < static_cast<std::size_t>(picture.size.width); ++i) {
            const std::int32_t owner = picture.owner[from + i];
            if (owner < 0) continue;
            const std::uint32_t colour = picture.colour[from + i];
            const auto channel = [&](unsigned shift) {
                return static_cast<float>(colour >> shift & 255u) / largest_byte;
            };
            planes.colour[to + i] = {channel(16), channel(8), channel(0)};
            planes.depth[to + i] = picture.inv_z[from + i];
            planes.owner[to + i] = owner;
        }
    }
    return is_whole;
}

void copy_image(const FastPicture& picture, Image& image) {
    image.width = picture.size.width;
    image.height = picture.size.height;
    const auto width = static_cast<std::size_t>(image.width);
    image.rgba.resize(4 * width * static_cast<std::size_t>(image.height));
    for (int row = 0; row < image.height; ++row) {
        const std::uint32_t* const from = picture.colour.data() + picture.at(0, row);
        std::uint8_t* const to = image.rgba.data() + 4 * width * static_cast<std::size_t>(row);
        for (std::size_t i = 0; i < width; ++i) {
            to[4 * i + 0] = static_cast<std::uint8_t>(from[i] >> 16);
            to[4 * i + 1] = static_cast<std::uint8_t>(from[i] >> 8);
            to[4 * i + 2] = static_cast<std::uint8_t>(from[i]);
            to[4 * i + 3] = 255;
        }
    }
}

bool FastRun::draw(const std::shared_ptr<const Scene>& scene, const Settings& settings) {
    if (shows(scene, settings)) return false;
    settings_ = std::nullopt;
    if (scene_ != scene) {
        scene_ = nullptr; // in case memory runs out
        engine_.emplace(*scene, options_);
        scene_ = scene;
    }
    engine_->draw(settings, picture_);
    settings_ = settings;
    return true;
}

} // namespace rasterwalk
