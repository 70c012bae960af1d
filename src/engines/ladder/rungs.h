#pragma once

// The rungs of the ladder, each in the file of its namespace.

#include "engines/fast/worker_pool.h"
#include "engines/ladder/ladder_picture.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk::rungs {

/// Draws the scene from a black picture, with light at each pixel, or at the vertices if
/// `settings.shading` is gouraud. Only the shading, camera, light and viewport settings count.
/// ladder_refuses() must not name the scene.
using Draw = void(const Scene& scene, const Settings& settings, LadderPicture& picture);

namespace lab_loop {
Draw draw;
}
namespace kept_vectors {
Draw draw;
}
namespace no_vectors {
Draw draw;
}
namespace depth_first {
Draw draw;
}
namespace one_division {
Draw draw;
}
namespace edge_functions {
Draw draw;
}
namespace many_at_a_time {
Draw draw;
}
namespace bands {
/// @param pool the threads that share the rows
void draw(const Scene& scene, const Settings& settings, LadderPicture& picture, WorkerPool& pool);
} // namespace bands

// Wrong turnings.
namespace whole_box {
Draw draw;
}
namespace columns_first {
Draw draw;
}
namespace light_before_depth {
Draw draw;
}

namespace two_threads_one_buffer {
/// @param pool the threads that take the triangles in turn and share one depth buffer
void draw(const Scene& scene, const Settings& settings, LadderPicture& picture, WorkerPool& pool);
} // namespace two_threads_one_buffer

} // namespace rasterwalk::rungs
