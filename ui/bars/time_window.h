#pragma once

#include <vector>

#include "pipeline/timeline.h"
#include "ui/bars/transport_state.h"

namespace rasterwalk {

/// Brings the window to the cursor if the cursor has moved out of it: page by page, so that the
/// window is still while time runs through it. A new frame begins with the triangle at work.
/// @param triangles of the frame, drawn or not
/// @param place     of the cursor, in triangles
/// @param usual     the window's width to begin with, in triangles
void follow_moment(TimeWindow& window, int triangles, double place, const Cursor& cursor,
                   double usual = 1.0);

/// Makes the window narrower (factor < 1) or wider; what is at `about` stays in place.
/// @param least width, in triangles
void zoom_window(TimeWindow& window, double factor, double about, double least);

/// Moves the window, in triangles.
void pan_window(TimeWindow& window, double by);

/// How the enlarged line spreads the moments of a triangle: every piece in proportion, but none so
/// small that it would be lost next to thousands of fragments.
struct TriangleScale {
    std::vector<int> ordinals;  ///< of the first moment of each piece; the count of all comes last
    std::vector<double> shares; ///< where these are, 0 to 1

    /// The position of a moment, 0 to 1.
    double share_of(int ordinal) const;
    /// The moment at a position from 0 to 1; at 1 the count of all.
    int ordinal_at(double share) const;
};

/// The pieces are the edges, and each of the other phases as a whole.
TriangleScale triangle_scale(const TriangleMoments& moments);

/// Makes the window as wide as usual, with this place in it: it holds the triangle there and
/// nothing else.
void show_triangle(TimeWindow& window, double place);

} // namespace rasterwalk
