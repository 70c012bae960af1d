#include "ui/widgets/picture_texture.h"

#include <algorithm>
#include <cmath>

#include "picture/resample.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Beyond this scale, one screen pixel more or less for a picture pixel is not noticeable.
constexpr float large_scale = 4.0f;

/// For a picture larger than this the texture holds only what is in view.
constexpr std::int64_t most_pixels = 3'000'000;

/// How much more it then holds on each side, so that it serves while the view is moved a little.
constexpr float share_around = 0.125f;

bool wants_resampling(float scale) {
    return scale < large_scale && (scale < 1.0f || scale != std::round(scale));
}

bool contains(const Rectangle& outer, const Rectangle& inner) {
    return outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right &&
           outer.bottom >= inner.bottom;
}

Rectangle common(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

Rectangle grown(const Rectangle& r) {
    const auto part = [](int from, int to) {
        return static_cast<int>(share_around * static_cast<float>(to - from));
    };
    const int x = part(r.left, r.right), y = part(r.top, r.bottom);
    return {r.left - x, r.top - y, r.right + x, r.bottom + y};
}

/// The part of the resampled picture that is in view.
/// @param scale of the resampling
Rectangle in_view(const PicturePlace& place, float scale, ImVec2 low, ImVec2 high) {
    // Far from the picture the numbers are too large for an int.
    const auto pixel = [&](float screen, float origin) {
        const float at = (screen - origin) / place.scale * scale;
        return static_cast<int>(std::floor(std::clamp(at, -1e8f, 1e8f)));
    };
    return {pixel(low.x, place.origin.x), pixel(low.y, place.origin.y),
            pixel(high.x, place.origin.x) + 1, pixel(high.y, place.origin.y) + 1};
}

/// The pixels of the resampled picture that cover any of these.
Rectangle resampled_pixels(const Rectangle& pixels, float scale) {
    const auto from = [&](int at) {
        return static_cast<int>(std::floor(static_cast<float>(at) * scale)) - 1;
    };
    const auto to = [&](int at) {
        return static_cast<int>(std::ceil(static_cast<float>(at) * scale)) + 1;
    };
    return {from(pixels.left), from(pixels.top), to(pixels.right), to(pixels.bottom)};
}

Image cut_out(const Image& image, const Rectangle& part) {
    Image result{part.right - part.left, part.bottom - part.top, {}};
    const auto width = static_cast<std::ptrdiff_t>(image.width);
    result.rgba.reserve(4 * static_cast<std::size_t>(result.width) *
                        static_cast<std::size_t>(result.height));
    for (int row = part.top; row < part.bottom; ++row) {
        const auto line = image.rgba.begin() + 4 * (row * width);
        result.rgba.insert(result.rgba.end(), line + 4 * static_cast<std::ptrdiff_t>(part.left),
                           line + 4 * static_cast<std::ptrdiff_t>(part.right));
    }
    return result;
}

} // namespace

void show_texture(Ui& ui, PictureTexture& texture, const NumberedPicture& picture,
                  const PicturePlace& place, ImVec2 low, ImVec2 high) {
    const Image& image = picture.image;
    const float scale = wants_resampling(place.scale) ? place.scale : 1.0f;
    const Rectangle whole{0, 0, resampled_side(image.width, scale),
                          resampled_side(image.height, scale)};
    Rectangle window = whole;
    if (static_cast<std::int64_t>(whole.right) * whole.bottom > most_pixels) {
        const Rectangle visible = common(in_view(place, scale, low, high), whole);
        if (is_empty(visible)) return;
        const bool serves = texture.scale == scale && contains(texture.window, visible) &&
                            contains(whole, texture.window);
        window = serves ? texture.window : common(grown(visible), whole);
    }
    const bool is_same_part = texture.scale == scale && texture.window == window;
    if (is_same_part && texture.number == picture.number) return;
    const bool is_known = is_same_part && picture.before != 0 && texture.number == picture.before;
    const Rectangle changed =
        is_known ? common(resampled_pixels(picture.changed, scale), window) : window;
    texture.number = picture.number;
    texture.scale = scale;
    texture.window = window;
    texture.corner = {static_cast<float>(window.left) / scale,
                      static_cast<float>(window.top) / scale};
    texture.size = {static_cast<float>(window.right - window.left) / scale,
                    static_cast<float>(window.bottom - window.top) / scale};
    if (is_empty(changed)) return;
    Image& kept = texture.resampled;
    if (scale == 1.0f) {
        kept = {};
        texture.id =
            ui.host.textures->upload(texture.id, window == whole ? image : cut_out(image, window));
        return;
    }
    kept.width = window.right - window.left;
    kept.height = window.bottom - window.top;
    kept.rgba.resize(4 * static_cast<std::size_t>(kept.width) *
                     static_cast<std::size_t>(kept.height));
    resample_part(image, scale, window, changed, kept);
    texture.id = ui.host.textures->upload(texture.id, kept);
}

void draw_texture(ImDrawList* list, const PictureTexture& texture, const PicturePlace& place) {
    if (texture.id == ImTextureID{}) return; // nothing of it was ever in view
    const ImVec2 low{place.origin.x + place.scale * texture.corner.x,
                     place.origin.y + place.scale * texture.corner.y};
    list->AddImage(texture.id, low,
                   {low.x + place.scale * texture.size.x, low.y + place.scale * texture.size.y});
}

} // namespace rasterwalk
