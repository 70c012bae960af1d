#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace rasterwalk {

/// What a rung of the ladder draws.
struct LadderPicture {
    Viewport size{0, 0};
    std::vector<std::uint32_t> colour; ///< 0x00RRGGBB, row by row from the top; black: nothing
    std::vector<float> depth;          ///< 1/z; 0: nothing

    /// Black, and nothing in it. Its memory is reused.
    void clear(Viewport to) {
        size = to;
        const auto pixels =
            static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height);
        colour.assign(pixels, 0);
        depth.assign(pixels, 0.0f);
    }
};

} // namespace rasterwalk
