#include "stages/stages.h"

namespace rasterwalk {

const std::array<StageInfo, stage_count>& stage_list() {
    static constexpr std::array<StageInfo, stage_count> list{{
        {Stage::points, "points", "Points", "Every vertex, projected to one pixel.",
         "Every vertex, projected to one pixel.", "Drawing points"},
        {Stage::edges, "edges", "Edges", "The outline of every triangle, sample by sample.",
         "The outline of every triangle.", "Drawing edges"},
        {Stage::rows, "rows", "Rows", "Where every row of every triangle begins and ends.",
         "Where every row of every triangle begins and ends.", "Filled triangles"},
        {Stage::fill, "fill", "Fill",
         "Every row filled from its left to its right end; whoever comes last covers the rest.",
         "Every row filled; the last one drawn covers the rest.", "Filled triangles"},
        {Stage::depth, "depth", "Depth", "A fragment is drawn only if it is nearer: 1/z is larger.",
         "A fragment is drawn only if it is nearer.", "Depth buffer"},
        {Stage::vertex_light, "vertex_light", "Vertex light",
         "Light computed at the vertices and interpolated between them.",
         "Light at the vertices, interpolated between them.", "Light per vertex"},
        {Stage::pixel_light, "pixel_light", "Pixel light",
         "Light computed anew at every pixel, from its own place in the room.",
         "Light computed anew at every pixel.", "Light per pixel"},
    }};
    return list;
}

} // namespace rasterwalk
