#pragma once

// What the parts of draw() share while they draw; of no use to anyone else.

#include <vector>

#include "pipeline/draw.h"
#include "pipeline/row_kernel.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// What is drawn with, and what is drawn into.
struct Drawing {
    const Frame& frame;
    const Stages& stages;
    DrawWindow window;
    Rectangle scissor; ///< what is drawn of the picture: the framebuffer, cut by the window's
    PixelRules pixels;
    SightRays rays;     ///< by which fragments are culled
    VaryingSet carried; ///< those that edges and rows carry
    DepthRules depth;
    bool is_depth_tested;
    bool all_have_cells;  ///< each pixel of the picture has a depth cell: nothing to ask
    bool culls_fragments; ///< each fragment is asked whether it shows a back
    bool shades_first;    ///< the pixel shader comes before the depth test
    bool draws_unset;     ///< rows that no edge sample has reached are drawn like the others
    bool skips_hidden; ///< rows that are completely hidden go without varyings: nothing reads them
    RowKernel row_kernel; ///< draws rows at a time; null: each fragment is drawn by itself
    Framebuffer& target;
    Observer* observer;
    PolygonRows rows;                  ///< the row table of the triangle
    std::vector<LineSample> fragments; ///< of the row, and room for those of longer ones
    DrawTally tally;
};

} // namespace rasterwalk
