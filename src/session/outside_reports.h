#pragma once

#include <optional>

#include "explain/fragment_report.h"
#include "explain/vectors.h"
#include "inspect/cut_corners.h"
#include "outside/outside_marks.h"
#include "outside/world_clipping.h"

namespace rasterwalk {

/// The clipping of a triangle as the view from outside shows it: whole, or as far as it has got if
/// it is what was just done.
/// @param done   the moment just done, if there is one
/// @param chosen the plane to show, unless clipping is at work on another
WorldClipping clipping_outside(const Frame& frame, const ClipHistory& history,
                               const std::optional<Cursor>& done, std::optional<ClipPlane> chosen);

/// The way from the fragment shown to the lamp, as the view from outside draws it, with what is in
/// between, or what the lamp saw there; none if shadows were not tested.
std::optional<LampRay> lamp_ray_outside(const Frame& frame,
                                        const std::optional<FragmentReport>& fragment);

/// What a height map does at the fragment shown; none if none acts there.
std::optional<SightShift> sight_shift_outside(const std::optional<FragmentReport>& fragment);

/// The overlay of vectors for an eye; the numbers of arrows are VectorName.
/// @param report none: nothing is shown
/// @param length of a direction of length 1 seen face on, pixels of the eye
/// @param angle  side of the right-angle sign, pixels of the eye
OutsideVectors vectors_outside(const std::optional<VectorReport>& report, const OutsideEye& eye,
                               double length, double angle);
/// The pixel of the fragment shown, if that fragment shows a texture.
std::optional<TexturedPixel> textured_pixel_outside(const std::optional<FragmentReport>& fragment);

} // namespace rasterwalk
