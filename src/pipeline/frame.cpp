#include "pipeline/frame.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings);
    if (replace) replace(stages);
    return stages;
}

namespace {

/// What the triangles of a mesh go through before they are covered. Vertex shader and project run
/// once a vertex, however many triangles meet in it.
class PolygonMaker {
  public:
    PolygonMaker(const Mesh& mesh, const VertexRules& rules, const Stages& stages)
        : rules_(rules), stages_(stages) {
        const glm::mat3 rotation = camera_rotation(rules.camera);
        shaded_.reserve(mesh.vertices().size());
        projected_.reserve(mesh.vertices().size());
        for (const Vertex& vertex : mesh.vertices()) {
            shaded_.push_back(stages.vertex_shader(vertex, rotation, rules_, stages, nullptr));
            projected_.push_back(stages.project(shaded_.back(), rules_, stages, nullptr));
        }
    }

    /// Reject, clip, cull and project; appends the corners to `vertices`.
    Polygon make(const TriangleIndices& triangle, std::vector<ScreenVertex>& vertices) {
        Polygon polygon{static_cast<int>(vertices.size()), 0, Rejection::none, false};
        clip(triangle, polygon);
        if (polygon.rejection == Rejection::none)
            polygon.rejection = stages_.cull(corners_, rules_);
        if (polygon.is_cut) {
            for (const ClipVertex& corner : corners_)
                add(stages_.project(corner, rules_, stages_, nullptr), polygon, vertices);
        } else {
            for (const int index : triangle)
                add(projected_[static_cast<std::size_t>(index)], polygon, vertices);
        }
        return polygon;
    }

  private:
    void clip(const TriangleIndices& triangle, Polygon& polygon) {
        corners_.clear();
        for (const int index : triangle)
            corners_.push_back(shaded_[static_cast<std::size_t>(index)]);
        polygon.rejection = stages_.reject(corners_, rules_);
        if (polygon.rejection != Rejection::none) return;
        const Clipped clipped = stages_.clip(corners_, rules_);
        polygon.rejection = clipped.rejection;
        if (corners_.size() < least_corners) polygon.rejection = Rejection::clipped_away;
        // Of what nothing is drawn is shown as the scene has it.
        polygon.is_cut = clipped.is_cut && polygon.rejection == Rejection::none;
    }

    static void add(const ProjectedVertex& corner, Polygon& polygon,
                    std::vector<ScreenVertex>& vertices) {
        if (polygon.rejection == Rejection::none) polygon.rejection = corner.rejection;
        vertices.push_back(corner.pixel);
        ++polygon.count;
    }

    static constexpr std::size_t least_corners = 3;

    VertexRules rules_;
    const Stages& stages_;
    std::vector<ClipVertex> shaded_;         ///< of the mesh, in its order
    std::vector<ProjectedVertex> projected_; ///< the same, projected
    std::vector<ClipVertex> corners_;        ///< of the polygon on its way
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
    PolygonMaker maker(scene.mesh, vertex_rules(settings, scene.space), frame.stages);
    for (const TriangleIndices& triangle : scene.mesh.triangles())
        frame.polygons.push_back(maker.make(triangle, frame.vertices));
}

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    prepare_frame(scene, settings, replace, frame);
    return frame;
}

std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle,
                                        const Settings& settings) {
    const Stages stages = stages_for(settings, frame.replace);
    Mesh mesh;
    mesh.add_triangle_of(corners_of(*frame.scene, triangle));
    std::vector<ScreenVertex> vertices;
    PolygonMaker(mesh, vertex_rules(settings, frame.scene->space), stages)
        .make(mesh.triangles().front(), vertices);
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
