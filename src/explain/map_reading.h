#pragma once

// The pictures that act at a fragment: its texture, its normal map, its height map. Where each is
// read, and which of its texels count.

#include <vector>

#include "base/enum_words.h"
#include "explain/fragment_report.h"

namespace rasterwalk {

/// What a picture on a surface is for.
enum class SurfaceMap : std::uint8_t {
    texture,    ///< its colours are seen
    normal_map, ///< its colours are arrows that bend the normal
    height_map, ///< its red is a height that shifts where the other two are read
};

/// One of them, as a fragment reads it.
struct MapReading {
    SurfaceMap use = SurfaceMap::texture;
    const Texture* map = nullptr; ///< belongs to the frame's scene; never null
    TexturePlace place;           ///< where it is read
    glm::vec2 carried{0.0f};      ///< u, v of the fragment, before a height map shifts them
    SampledTexels taken;
    glm::vec3 colour{0.0f}; ///< their weighted mean, red green blue
};

/// Those that act at the fragment of a report, in the order of SurfaceMap.
std::vector<MapReading> map_readings(const FragmentReport& report);

} // namespace rasterwalk
