#pragma once

// The state that the parts of draw() share. Private to draw().

#include <vector>

#include "pipeline/draw.h"
#include "pipeline/row_kernel.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The tools of a drawing, and its target.
struct Drawing {
    const Frame& frame;
    const Stages& stages;
    DrawWindow window;
    Rectangle scissor; ///< the part of the picture that is drawn: the framebuffer, cut by the
                       ///< window's
    PixelRules pixels;
    SightRays rays;     ///< for culling fragments
    VaryingSet carried; ///< those that edges and rows carry
    DepthRules depth;
    bool is_depth_tested;
    bool all_have_cells;  ///< each pixel of the picture has a depth cell: no check needed
    bool culls_fragments; ///< each fragment is tested for showing a back
    bool shades_first;    ///< the pixel shader comes before the depth test
    bool draws_empty;     ///< rows that no edge sample has reached are drawn like the others
    bool skips_hidden; ///< rows that are completely hidden go without varyings: nothing reads them
    RowKernel row_kernel; ///< draws a row at a time; null: each fragment is drawn separately
    Framebuffer& target;
    const Observer* observer;
    PolygonRows rows;                  ///< the row table of the triangle
    std::vector<LineSample> fragments; ///< of the row, and room for longer ones
    DrawTally tally;
};

} // namespace rasterwalk
