#pragma once

// The depths that the depth buffer can tell apart, as a ruler: z in front of the camera on one
// scale, what the buffer holds on another.
//
// Under perspective the buffer's values are linear in 1/z. Evenly spaced in the buffer, they are
// crowded just behind the near plane and sparse at the far one; floats add steps of their own,
// halved each time the value is. At one depth, the step is what decides: two surfaces closer
// together than that can get the same value, and which is in front is then left to chance.
//
// Source: K. Akeley, J. Su, "Minimum Triangle Separation for Correct z-Buffer Occlusion", Graphics
// Hardware 2006; E. Lapidous, G. Jiao, "Optimal Depth Buffer for Low-Cost Graphics Hardware",
// Graphics Hardware 1999, on reversed z.

#include <cstddef>
#include <optional>
#include <vector>

#include "inspect/row_graph.h"
#include "stages/depth_test.h"

namespace rasterwalk {

/// A value that the depth buffer can hold.
struct DepthStep {
    float stored = 0.0f;         ///< see ClipDepth
    std::optional<int> number{}; ///< which of the buffer's 2^bits values, from 0; none in floats
    double z = 0.0;              ///< where that is in front of the camera, world units; for a 1/z
                                 ///< of 0 infinite
};

/// A value in the buffer, and those next to it.
struct DepthWindow {
    std::vector<DepthStep> steps; ///< the nearest first
    std::size_t middle = 0;       ///< the one asked about
    std::vector<double> gaps;     ///< from each step to the one after it, world units; above 0

    const DepthStep& asked() const { return steps[middle]; }
    /// How much nearer or farther the next value is, world units; none if the buffer has no other.
    std::optional<double> gap_nearer() const;
    std::optional<double> gap_farther() const;
};

/// How many values the window has on each side of the one asked about, if there are so many.
inline constexpr int depth_window_reach = 2;

/// Around a value that the buffer holds; none if it is not finite, or not in front of the camera.
/// Values at which z is infinite or behind the camera are left out.
std::optional<DepthWindow> depth_window(float stored, const DepthRules& rules);

/// The ruler: the view from the near plane to the far one.
struct DepthRuler {
    DepthRules rules;
    bool is_logarithmic = false; ///< the scale of z is: if far is at least logarithmic_ratio times
                                 ///< near, and the rays are not parallel
    Interval z;                  ///< near and far, world units
    Interval stored;             ///< what the buffer holds at the near and at the far end of the
                                 ///< scale: low belongs to near, whichever is larger
    std::vector<double> round;   ///< round values of z in that range
    std::vector<DepthStep> told_apart; ///< the values that can be seen as ticks on the scale of z

    /// Where z lies on its scale, 0 at near and 1 at far; also beyond.
    double place(double z_world) const;
    /// Where a stored value lies on its scale, the same.
    double stored_place(double value) const;
};

/// If far is at least this many times near, the scale of z is logarithmic.
inline constexpr double logarithmic_ratio = 20.0;

/// None if the planes are not a view: not finite, or far not behind near.
/// @param least the smallest distance between neighbouring ticks, as a share of the scale, above 0;
///              costs at most 2 / least steps
std::optional<DepthRuler> depth_ruler(const DepthRules& rules, double least);

} // namespace rasterwalk
