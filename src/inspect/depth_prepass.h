#pragma once

// A depth pre-pass: the frame is drawn twice. The first time only depth is found out and stored,
// and no colour is worked out; the second time only what is visible gets one.
//
// After the first drawing every pixel holds the depth of what it will show. To let just that pass,
// each depth is moved one float farther away: then the usual test, nearer than what is stored,
// lets the nearest fragment through, stores its depth, and so closes the pixel. Of several equally
// near fragments the first one stays, as without a pre-pass, so the picture has the same bits.
// Graphics cards test for equality instead, and of several equal ones the last one stays.
//
// Source: T. Akenine-Moeller, E. Haines, N. Hoffman, "Real-Time Rendering", 4th edition, 2018,
// section 18.4.5, z-prepass.

#include <cstdint>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/tally.h"

namespace rasterwalk {

/// Does a pre-pass leave the picture as it is? Only with a depth buffer whose test is right and has
/// no epsilon, one sample for each pixel, nothing half transparent, and no height map that moves
/// what is cut out.
bool can_have_prepass(const Frame& frame);

/// A frame that is drawn with a pre-pass. The frames refer to their scene, which must outlive them.
struct PrepassFrames {
    Frame depth;   ///< the same fragments, without light
    Frame picture; ///< the frame itself
};

/// What the two drawings did.
struct PrepassTally {
    DrawTally depth; ///< its `shaded` are fragments that were stored: none gets a colour
    DrawTally picture;
};

/// Prepares both, with the functions that were put in the frame's slots.
/// @param scene   the one that is given to prepare_frame()
PrepassFrames prepare_prepass(const Scene& scene, const Settings& settings,
                              const ReplaceStages& replace = nullptr);

/// Draws everything before `to`, twice. The frame must be one that can_have_prepass().
PrepassTally draw_with_prepass(const PrepassFrames& frames, const Cursor& to,
                               Framebuffer& framebuffer);

} // namespace rasterwalk
