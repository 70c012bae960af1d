#include "pipeline/frame.h"

#include <array>

namespace rasterwalk {

Stages stages_for(const Settings& settings, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings);
    if (replace) replace(stages);
    return stages;
}

namespace {

/// A vertex of the scene after the vertex shader, and projected as a corner that is not cut off.
struct MadeVertex {
    ClipVertex clip;
    ProjectedVertex projected;
};

/// The corners of one triangle of the scene.
using MadeCorners = std::array<const MadeVertex*, triangle_corners>;

/// What the vertices and the triangles of the scene go through before they are covered.
class PolygonMaker {
  public:
    PolygonMaker(const Scene& scene, const Settings& settings, const Stages& stages)
        : rotation_(camera_rotation(settings.camera)), rules_(vertex_rules(settings, scene.space)),
          stages_(stages), keeps_all_(stages.clip == clip_nothing && stages.cull == cull_nothing) {}

    /// Vertex shader and projection: once a vertex, however many triangles meet in it.
    MadeVertex make_vertex(const Vertex& vertex) const {
        MadeVertex made;
        made.clip = stages_.vertex_shader(vertex, rotation_, rules_, stages_, nullptr);
        made.projected = stages_.project(made.clip, rules_, stages_, nullptr);
        return made;
    }

    /// Clip and cull; appends the corners of what is left to `vertices`.
    Polygon make_polygon(const MadeCorners& triangle, std::vector<ScreenVertex>& vertices) {
        Polygon polygon{static_cast<int>(vertices.size()), 0, Rejection::none, false};
        if (!keeps_all_) clip_and_cull(triangle, polygon);
        if (polygon.is_cut) {
            for (const ClipVertex& corner : corners_)
                add_corner(stages_.project(corner, rules_, stages_, nullptr), polygon, vertices);
        } else {
            for (const MadeVertex* corner : triangle)
                add_corner(corner->projected, polygon, vertices);
        }
        return polygon;
    }

  private:
    void clip_and_cull(const MadeCorners& triangle, Polygon& polygon) {
        corners_.clear();
        for (const MadeVertex* corner : triangle)
            corners_.push_back(corner->clip);
        const Clipped clipped = stages_.clip(corners_, rules_);
        polygon.rejection = clipped.rejection;
        if (corners_.size() < least_corners) polygon.rejection = Rejection::clipped_away;
        // Of what is clipped away nothing is drawn: it is shown as the scene has it.
        if (polygon.rejection != Rejection::none) return;
        polygon.is_cut = clipped.is_cut;
        polygon.rejection = stages_.cull(corners_, rules_);
    }

    static void add_corner(const ProjectedVertex& corner, Polygon& polygon,
                           std::vector<ScreenVertex>& vertices) {
        if (polygon.rejection == Rejection::none) polygon.rejection = corner.rejection;
        vertices.push_back(corner.pixel);
        ++polygon.count;
    }

    static constexpr std::size_t least_corners = 3;

    glm::mat3 rotation_;
    VertexRules rules_;
    const Stages& stages_;
    bool keeps_all_; ///< no triangle is clipped or culled: their corners are not gathered
    std::vector<ClipVertex> corners_;
};

} // namespace

void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame) {
    frame.scene = &scene;
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, replace);
    frame.vertices.clear();
    frame.polygons.clear();
    frame.vertices.reserve(triangle_corners * scene.mesh.triangles().size());
    frame.polygons.reserve(scene.mesh.triangles().size());
    PolygonMaker maker(scene, settings, frame.stages);
    std::vector<MadeVertex> made;
    made.reserve(scene.mesh.vertices().size());
    for (const Vertex& vertex : scene.mesh.vertices())
        made.push_back(maker.make_vertex(vertex));
    const auto at = [&made](int index) { return &made[static_cast<std::size_t>(index)]; };
    for (const TriangleIndices& t : scene.mesh.triangles())
        frame.polygons.push_back(
            maker.make_polygon({at(t[0]), at(t[1]), at(t[2])}, frame.vertices));
}

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    prepare_frame(scene, settings, replace, frame);
    return frame;
}

std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle,
                                        const Settings& settings) {
    const Stages stages = stages_for(settings, frame.replace);
    PolygonMaker maker(*frame.scene, settings, stages);
    const std::array corners{maker.make_vertex(frame.scene->corner(triangle, 0)),
                             maker.make_vertex(frame.scene->corner(triangle, 1)),
                             maker.make_vertex(frame.scene->corner(triangle, 2))};
    std::vector<ScreenVertex> vertices;
    maker.make_polygon({&corners[0], &corners[1], &corners[2]}, vertices);
    return vertices;
}

void compute_rows(const Frame& frame, int triangle, PolygonRows& rows, SampleSink* sink,
                  VaryingSet carried) {
    frame.stages.compute_polygon_rows(frame.triangle_vertices(triangle),
                                      edge_rules(frame.settings, carried), frame.stages, rows,
                                      sink);
}

Rectangle drawn_area(const Frame& frame) {
    return frame.stages.drawn_area(frame.settings.viewport);
}

} // namespace rasterwalk
