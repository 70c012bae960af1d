#pragma once

// What falls on each pixel of a picture, and what other ways than the depth buffer make of it.

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/observer.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk::test {

/// The fragments of a picture with the depth buffer, by pixel, in the order of the scene's list.
class PixelFragments {
  public:
    struct Fragment {
        int triangle = 0; ///< of the scene
        double zinv = 0.0;
    };

    PixelFragments(const Scene& scene, Settings settings) {
        settings.hidden = Hidden::depth_buffer;
        settings.stage = Stage::depth;
        const Frame frame = prepare_frame(scene, settings);
        Framebuffer picture;
        clear(picture, frame);
        width = picture.size.width;
        height = picture.size.height;
        pixels.resize(picture.owner.size());
        const Observer gather{.fragment = [&](const FragmentEvent& event) {
            pixels[static_cast<std::size_t>(event.fragment.row * width + event.fragment.column)]
                .push_back({event.cursor.triangle, static_cast<double>(event.depth)});
        }};
        draw(frame, {}, picture, &gather);
    }

    /// The triangle that each pixel shows if the nearest fragment stays, and of equal ones the
    /// first; -1: none.
    std::vector<int> nearest() const {
        return shown(
            [](const Fragment& now, const Fragment& then) { return now.zinv > then.zinv; });
    }

    /// The same if a triangle covers whatever has a smaller place in the order, or the same place
    /// and an earlier one in the list.
    std::vector<int> painted(const std::vector<double>& place) const {
        return shown([&](const Fragment& now, const Fragment& then) {
            return place[static_cast<std::size_t>(now.triangle)] >=
                   place[static_cast<std::size_t>(then.triangle)];
        });
    }

    /// Pixels that show what the other picture shows neither there nor on a pixel next to it.
    int wrong(const std::vector<int>& picture, const std::vector<int>& right) const {
        int sum = 0;
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const int here = picture[static_cast<std::size_t>(row * width + column)];
                bool is_found = false;
                for (int i = 0; i < 9 && !is_found; ++i) {
                    const int y = row + i / 3 - 1, x = column + i % 3 - 1;
                    const bool is_inside = y >= 0 && y < height && x >= 0 && x < width;
                    is_found = is_inside && right[static_cast<std::size_t>(y * width + x)] == here;
                }
                sum += is_found ? 0 : 1;
            }
        }
        return sum;
    }

    int width = 0, height = 0;
    std::vector<std::vector<Fragment>> pixels;

  private:
    template <class Replaces>
    std::vector<int> shown(const Replaces& replaces) const {
        std::vector<int> picture;
        for (const std::vector<Fragment>& fragments : pixels) {
            const Fragment* last = nullptr;
            for (const Fragment& fragment : fragments) {
                if (last == nullptr || replaces(fragment, *last)) last = &fragment;
            }
            picture.push_back(last == nullptr ? -1 : last->triangle);
        }
        return picture;
    }
};

/// The triangle of the scene that each pixel of a drawn picture shows; -1: none.
inline std::vector<int> scene_triangles(const Frame& frame, const Framebuffer& picture) {
    std::vector<int> triangles = picture.owner;
    for (int& triangle : triangles)
        triangle = triangle < 0 ? -1 : scene_triangle(*frame.scene, triangle);
    return triangles;
}

} // namespace rasterwalk::test
