#include "inspect/ray_stats.h"

#include <algorithm>

#include "pipeline/draw.h"

namespace rasterwalk {

std::optional<RayStats> ray_stats(const Frame& frame) {
    if (!rays_refuse(*frame.scene, frame.settings).empty()) return std::nullopt;
    Framebuffer planes;
    clear(planes, frame);
    RayDrawing drawing;
    drawing.begin(frame);
    drawing.advance({}, planes);
    return RayStats{drawing.count(), std::count(planes.owner.begin(), planes.owner.end(), -1)};
}

} // namespace rasterwalk
