#pragma once

// Mistakes in the slot of stages/clip.h. In pixel space, where there is no view volume, each leaves
// the polygon unchanged; those that divide or use z also do so if clip space is not the lab's.

#include "stages/clip.h"

namespace rasterwalk {

/// B16: nothing is cut. A polygon with a corner outside the view is left out altogether.
Clipped drop_partly_outside(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                            ClipSink* sink = nullptr);

/// B31: the near plane with a wrong denominator. From the corner a behind it to the corner b in
/// front, t = (near - z_a) / z_b, instead of dividing by z_b - z_a.
Clipped clip_near_with_wrong_t(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                               ClipSink* sink = nullptr);

/// B32: first the division, then the cut by the four sides of the picture. Corners behind the
/// camera are mirrored by then, and the varyings, which are not divided, are cut as if they were
/// linear on the screen. Goes with is_in_front_unasked(): z is no longer checked.
Clipped clip_after_division(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                            ClipSink* sink = nullptr);

/// B33: no cut, but a clamp, z = max(z, near). Corners behind the near plane are moved straight
/// forward onto it, which bends the edges that end in them.
Clipped move_to_near_plane(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                           ClipSink* sink = nullptr);

/// B82: the near plane with the right t, but only the position is cut. The new corner has the
/// varyings of the corner that is cut off: its world position, normal, colour and texture
/// coordinates.
Clipped clip_near_with_uncut_varyings(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                                      ClipSink* sink = nullptr);

} // namespace rasterwalk
