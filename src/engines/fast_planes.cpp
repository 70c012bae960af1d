#include "engines/fast_planes.h"

#include "pipeline/clearing.h"

namespace rasterwalk {

void advance_fast_planes(const std::shared_ptr<const Scene>& scene, const Frame& frame,
                         const WorkLimit& limit, FastPlanes& fast) {
    if (fast.is_whole) return;
    if (!fast.engine.shows(scene, frame.settings)) begin_clearing(fast.planes, frame);
    fast.engine.draw(scene, frame.settings);
    fast.is_whole = copy_rows(fast.engine.picture(), limit, fast.planes);
}

} // namespace rasterwalk
