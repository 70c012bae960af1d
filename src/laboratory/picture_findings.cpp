#include "laboratory/picture_findings.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/enumerated.h"
#include "base/numbers.h"
#include "laboratory/image_variant.h"

namespace rasterwalk {

namespace {

/// The largest part of all pixels that rounding alone may have made.
constexpr double rounding_part = 0.002;

const std::uint8_t* pixel_of(const Image& image, std::size_t i) {
    return image.rgba.data() + 4 * i;
}

/// In what way the wrong pixels are wrong.
struct Kinds {
    std::int64_t missing = 0, extra = 0, other_hue = 0, brightness = 0;
};

std::string first_stage(const Kinds& kinds) {
    if (kinds.missing + kinds.extra > 0) {
        std::vector<std::string> what;
        if (kinds.missing > 0) {
            what.push_back(counted(kinds.missing, "pixel is", "pixels are") +
                           " black but should not be");
        }
        if (kinds.extra > 0) {
            what.push_back(counted(kinds.extra, "pixel is", "pixels are") +
                           " not black but should be");
        }
        return enumerated(what) +
               ". Look first at the pixels that triangles cover (points, edges, rows), then at the "
               "depth test, then at light that may be 0.";
    }
    if (kinds.other_hue > 0) {
        return "Every pixel that should be covered is covered, but " +
               counted(kinds.other_hue, "pixel has", "pixels have") +
               " a different hue, so either a different surface is in front there or the surface "
               "has a different colour.";
    }
    return "Every pixel shows a surface of the right hue. Only brightness differs, so look at the "
           "light first.";
}

/// Pixels of a part or a triangle in the right picture, and how many of them are wrong.
struct Share {
    std::int64_t all = 0, wrong = 0;
};

using Shares = std::map<int, Share>;

/// Those with wrong pixels, the most first.
std::vector<std::pair<int, Share>> by_wrong(const Shares& shares) {
    std::vector<std::pair<int, Share>> sorted;
    for (const auto& [number, share] : shares) {
        if (share.wrong > 0) sorted.emplace_back(number, share);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.wrong > b.second.wrong; });
    return sorted;
}

} // namespace

std::vector<std::string> findings_of(const KeptPicture& right, const Image& picture,
                                     const Scene& scene, int parts_of_side) {
    Kinds kinds;
    std::vector<Share> of_triangle(static_cast<std::size_t>(scene.triangle_count()));
    const std::size_t count = picture.rgba.size() / 4;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t *should = pixel_of(right.image, i), *is = pixel_of(picture, i);
        const bool is_wrong = !is_same_pixel(should, is);
        const int owner =
            right.owners[i] < 0 ? -1 : right.owners[i] / (parts_of_side * parts_of_side);
        if (owner >= 0) {
            Share& share = of_triangle[static_cast<std::size_t>(owner)];
            ++share.all;
            share.wrong += is_wrong ? 1 : 0;
        }
        if (!is_wrong) continue;
        if (is_black(is) && !is_black(should)) {
            ++kinds.missing;
        } else if (owner < 0 && !is_black(is)) {
            ++kinds.extra;
        } else if (!has_same_hue(is, should)) {
            ++kinds.other_hue;
        } else {
            ++kinds.brightness;
        }
    }
    if (kinds.missing + kinds.extra + kinds.other_hue + kinds.brightness == 0) return {};

    Shares parts, triangles;
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
        if (of_triangle[t].all == 0) continue;
        const int triangle = static_cast<int>(t);
        triangles[triangle] = of_triangle[t];
        Share& part = parts[part_of(scene, triangle)];
        part.all += of_triangle[t].all;
        part.wrong += of_triangle[t].wrong;
    }
    std::vector<std::string> findings{first_stage(kinds)};
    constexpr std::size_t most_named = 3;
    std::vector<std::string> names;
    for (const auto& [part, share] : by_wrong(parts)) {
        if (names.size() == most_named || part < 0) break;
        names.push_back(fmt::format("{} ({} of {})",
                                    scene.parts[static_cast<std::size_t>(part)].name, share.wrong,
                                    share.all));
    }
    if (!names.empty())
        findings.push_back("Parts with the most wrong pixels: " + enumerated(names) + ".");
    names.clear();
    for (const auto& [triangle, share] : by_wrong(triangles)) {
        if (names.size() == most_named) break;
        names.push_back(fmt::format("{} ({})", triangle_name(triangle), share.wrong));
    }
    if (!names.empty()) findings.push_back("Triangles with the most: " + enumerated(names) + ".");
    names.clear();
    for (const auto& [part, share] : parts) {
        if (part >= 0 && share.wrong == 0)
            names.push_back(scene.parts[static_cast<std::size_t>(part)].name);
    }
    if (!names.empty()) findings.push_back("Correct to the last pixel: " + enumerated(names) + ".");
    return findings;
}

bool is_rounding(const Image& right, const Image& picture,
                 bool (*is_same_surface)(const std::uint8_t*, const std::uint8_t*)) {
    const std::size_t count = picture.rgba.size() / 4;
    const auto most = static_cast<std::int64_t>(rounding_part * static_cast<double>(count));
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_same_pixel(pixel_of(right, i), pixel_of(picture, i))) continue;
        if (++wrong > most) return false;
        const int column = static_cast<int>(i % static_cast<std::size_t>(picture.width));
        const int row = static_cast<int>(i / static_cast<std::size_t>(picture.width));
        bool is_of_neighbour = false;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, picture.height - 1); ++y) {
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, picture.width - 1);
                 ++x) {
                const auto there =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                    static_cast<std::size_t>(x);
                is_of_neighbour |= is_same_surface(pixel_of(right, there), pixel_of(picture, i));
            }
        }
        if (!is_of_neighbour) return false;
    }
    return true;
}

} // namespace rasterwalk
