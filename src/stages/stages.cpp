#include "stages/stages.h"

namespace rasterwalk {

const std::array<StageInfo, stage_count>& stage_list() {
    static constexpr std::array<StageInfo, stage_count> list{{
        {{Stage::points},
         "points",
         "Points",
         "Every vertex, projected to one pixel.",
         "Every vertex, projected to one pixel.",
         "Drawing points"},
        {{Stage::edges},
         "edges",
         "Edges",
         "The outline of every triangle, sample by sample.",
         "The outline of every triangle.",
         "Drawing edges"},
        {{Stage::rows},
         "rows",
         "Rows",
         "Where every row of every triangle begins and ends.",
         "Where every row of every triangle begins and ends.",
         "Filled triangles"},
        {{Stage::fill},
         "fill",
         "Fill",
         "Every row filled from its left to its right end; whoever comes last covers the rest.",
         "Every row filled; the last one drawn covers the rest.",
         "Filled triangles"},
        {{Stage::depth},
         "depth",
         "Depth",
         "A fragment is drawn only if it is nearer: 1/z is larger.",
         "A fragment is drawn only if it is nearer.",
         "Depth buffer"},
        {StripStep::vertex_light, "vertex_light", "Vertex light",
         "Light computed at the vertices and interpolated between them.",
         "Light at the vertices, interpolated between them.", "Light per vertex"},
        {StripStep::pixel_light, "pixel_light", "Pixel light",
         "Light computed anew at every pixel, from its own place in the room.",
         "Light computed anew at every pixel.", "Light per pixel"},
    }};
    return list;
}

int strip_place(const StripStep& step) {
    int place = 0;
    for (int i = 0; i < stage_count; ++i) {
        const StripStep& one = stage_list()[static_cast<std::size_t>(i)].step;
        if (one == step) return i;
        if (one.stage == step.stage) place = i;
    }
    return place;
}

const StageInfo* find_stage(std::string_view name) {
    for (const StageInfo& info : stage_list()) {
        if (info.name == name) return &info;
    }
    return nullptr;
}

} // namespace rasterwalk
