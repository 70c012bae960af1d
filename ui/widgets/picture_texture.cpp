#include "ui/widgets/picture_texture.h"

#include <cmath>

#include "picture/resample.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// From here on a screen pixel more or less a picture pixel is no longer seen.
constexpr float large_scale = 4.0f;

/// A larger picture than this would cost too much at every change.
constexpr std::int64_t most_pixels = 3'000'000;

bool wants_resampling(const Image& image, float scale) {
    if (scale >= large_scale || (scale >= 1.0f && scale == std::round(scale))) return false;
    const std::int64_t pixels = static_cast<std::int64_t>(resampled_side(image.width, scale)) *
                                resampled_side(image.height, scale);
    return pixels <= most_pixels;
}

} // namespace

void show_texture(Ui& ui, PictureTexture& texture, const Image& image, std::uint64_t number,
                  float scale) {
    const float shown_scale = wants_resampling(image, scale) ? scale : 1.0f;
    if (texture.number == number && texture.scale == shown_scale) return;
    texture.number = number;
    texture.scale = shown_scale;
    if (shown_scale == 1.0f) {
        texture.id = ui.host.textures->upload(texture.id, image);
        texture.size = {static_cast<float>(image.width), static_cast<float>(image.height)};
        return;
    }
    const Image other = resampled(image, shown_scale);
    texture.id = ui.host.textures->upload(texture.id, other);
    texture.size = {static_cast<float>(other.width) / shown_scale,
                    static_cast<float>(other.height) / shown_scale};
}

void draw_texture(ImDrawList* list, const PictureTexture& texture, const PicturePlace& place) {
    list->AddImage(texture.id, place.origin,
                   {place.origin.x + place.scale * texture.size.x,
                    place.origin.y + place.scale * texture.size.y});
}

} // namespace rasterwalk
