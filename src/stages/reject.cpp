#include "stages/reject.h"

namespace rasterwalk {

Outcode outcode(const ClipVertex& vertex, const ClipPlanes& planes) {
    unsigned code = 0;
    for (std::size_t i = 0; i < planes.size(); ++i)
        code |= inner_distance(planes[i], vertex) < 0.0f ? 1u << i : 0u;
    return static_cast<Outcode>(code);
}

Rejection reject_by_outcodes(std::span<const ClipVertex> corners, const ViewVolume& volume) {
    if (volume.rules.space == SceneSpace::pixels) return Rejection::none;
    Outcode common = 0xff;
    for (const ClipVertex& corner : corners)
        common &= outcode(corner, volume.outer);
    return common != 0 ? Rejection::outside : Rejection::none;
}

} // namespace rasterwalk
