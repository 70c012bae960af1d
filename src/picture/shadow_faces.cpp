#include "picture/shadow_faces.h"

#include <algorithm>
#include <cstddef>

#include "picture/colour_map.h"

namespace rasterwalk {

namespace {

/// The texel that a pixel shows.
int shown_texel(int pixel, int side, int resolution) {
    const std::int64_t middle = 2 * std::int64_t{pixel} + 1, sides = 2 * std::int64_t{side};
    return static_cast<int>(middle * resolution / sides);
}

/// Calls `see` with the 1/z of each pixel of a face, row by row.
template <class See>
void for_pixels(const ShadowMap& map, const ShadowFace& face, int side, See see) {
    for (int row = 0; row < side; ++row) {
        const auto line = static_cast<std::size_t>(shown_texel(row, side, map.resolution)) *
                          static_cast<std::size_t>(map.resolution);
        for (int column = 0; column < side; ++column)
            see(face.inv_depth[line + static_cast<std::size_t>(
                                          shown_texel(column, side, map.resolution))]);
    }
}

} // namespace

ShadowFacePictures shadow_face_pictures(const ShadowMap& map, int side) {
    ShadowFacePictures pictures;
    if (map.resolution < 1) return pictures;
    side = std::clamp(side, 1, std::min(map.resolution, largest_face_side));
    float largest = 0.0f, smallest = 0.0f; // 1/z
    for (const ShadowFace& face : map.faces) {
        for_pixels(map, face, side, [&](float inv_z) {
            if (!(inv_z > 0.0f)) return;
            largest = std::max(largest, inv_z);
            smallest = smallest > 0.0f ? std::min(smallest, inv_z) : inv_z;
        });
    }
    if (largest > 0.0f) {
        pictures.nearest = 1.0f / largest;
        pictures.farthest = 1.0f / smallest;
    }
    const float range = pictures.farthest - pictures.nearest;
    for (std::size_t i = 0; i < pictures.faces.size(); ++i) {
        Image& image = pictures.faces[i];
        image.width = image.height = side;
        image.rgba.reserve(4 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        for_pixels(map, map.faces[i], side, [&](float inv_z) {
            glm::vec<3, std::uint8_t> colour{0, 0, 0};
            if (inv_z > 0.0f)
                colour = viridis(range > 0.0f ? (pictures.farthest - 1.0f / inv_z) / range : 1.0f);
            image.rgba.insert(image.rgba.end(), {colour.r, colour.g, colour.b, 255});
        });
    }
    return pictures;
}

} // namespace rasterwalk
