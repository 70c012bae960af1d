#include "explain/map_reading.h"

namespace rasterwalk {

std::vector<MapReading> map_readings(const FragmentReport& report) {
    std::vector<MapReading> readings;
    if (const std::optional<TextureReport>& texture = report.texture)
        readings.push_back({SurfaceMap::texture, texture->surface.texture, texture->place,
                            texture->carried, texture->taken, texture->colour});
    const std::optional<ParallaxReport>& parallax = report.parallax;
    if (const std::optional<BumpReport>& bump = report.bump)
        readings.push_back({SurfaceMap::normal_map, bump->map, bump->place,
                            parallax ? parallax->carried.texcoord : bump->place.texcoord,
                            bump->taken, bump->colour});
    if (parallax) {
        glm::vec3 mean{0.0f};
        for (const SampledTexel& texel : parallax->taken)
            mean += texel.weight * texel.colour;
        readings.push_back({SurfaceMap::height_map, parallax->heights.map, parallax->carried,
                            parallax->carried.texcoord, parallax->taken, mean});
    }
    return readings;
}

} // namespace rasterwalk
