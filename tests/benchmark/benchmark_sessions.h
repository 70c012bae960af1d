#pragma once

// What the benchmarks open.

#include "session/session.h"

namespace rasterwalk {

/// The lab's room, 500 x 500 pixels.
Session room();

/// 200,000 made triangles of 50 pixels each, at very different depths, on 200,000 pixels.
Session made();

/// A model of 200,000 triangles that cover a few pixels each.
Session knot();

/// The room on a picture of 4096 x 4096 pixels.
Session wide();

/// Run A next to one that differs in a setting, "name=value".
void compare_with_setting(Session& session, const char* assignment);

/// Run A next to one that interpolates without perspective.
void compare_with_affine(Session& session);

} // namespace rasterwalk
