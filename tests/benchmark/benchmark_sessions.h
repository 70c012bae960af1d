#pragma once

// What the benchmarks open.

#include "session/session.h"

namespace rasterwalk {

/// The lab's room, 500 x 500 pixels.
Session room();

/// 200,000 made triangles on as many pixels: 50 of them each, far behind each other.
Session made();

/// A model of 200,000 triangles that cover a few pixels each.
Session knot();

/// The room on a picture of 4096 x 4096 pixels.
Session wide();

/// Run A next to one that differs in a setting, "name=value".
void compare_with_setting(Session& session, const char* assignment);

/// Beside one that interpolates without perspective.
void compare_with_affine(Session& session);

} // namespace rasterwalk
