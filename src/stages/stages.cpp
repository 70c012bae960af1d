#include "stages/stages.h"

namespace rasterwalk {

const std::array<StageInfo, stage_count>& stage_list() {
    static constexpr std::array<StageInfo, stage_count> list{{
        {{Stage::points},
         false,
         "points",
         "Points",
         "Every vertex, projected to one pixel.",
         "Every vertex, projected to one pixel.",
         "Drawing points",
         "vertices"},
        {{Stage::edges},
         false,
         "edges",
         "Edges",
         "The wireframe: the outline of every triangle, sample by sample.",
         "The wireframe: the outline of every triangle.",
         "Drawing edges",
         "microscope"},
        {{Stage::rows},
         false,
         "rows",
         "Rows",
         "Where every row of every triangle begins and ends.",
         "Where every row of every triangle begins and ends.",
         "Filled triangles",
         "rows"},
        {{Stage::fill},
         false,
         "fill",
         "Fill",
         "Every row filled from its left to its right end; the last triangle drawn covers the "
         "others.",
         "Every row filled; the last triangle drawn covers the others.",
         "Filled triangles",
         "rows"},
        {{Stage::depth},
         true,
         "depth",
         "Depth",
         "A fragment is drawn only if it is nearer, that is, if its 1/z is larger.",
         "A fragment is drawn only if it is nearer.",
         "Depth buffer",
         "history"},
        {StripStep::vertex_light, true, "vertex_light", "Vertex light",
         "Light computed at the vertices and interpolated between them.",
         "Light at the vertices, interpolated between them.", "Light per vertex", "fragment"},
        {StripStep::pixel_light, true, "pixel_light", "Pixel light",
         "Light computed at every pixel, from the pixel's own position in the room.",
         "Light computed at every pixel.", "Light per pixel", "fragment"},
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

bool is_of_use(const StageInfo& info, const Scene& scene) {
    return !info.needs_depth || scene.space == SceneSpace::world;
}

const StageInfo* find_stage(std::string_view name) {
    for (const StageInfo& info : stage_list()) {
        if (info.name == name) return &info;
    }
    return nullptr;
}

} // namespace rasterwalk
