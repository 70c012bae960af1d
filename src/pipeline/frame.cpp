#include "pipeline/frame.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings);
    if (replace) replace(stages);
    return stages;
}

namespace {

/// What a triangle of the scene goes through before it is covered, with room for its corners.
class PolygonMaker {
  public:
    PolygonMaker(const Scene& scene, const Settings& settings, const Stages& stages)
        : rotation_(camera_rotation(settings.camera)), rules_(vertex_rules(settings, scene.space)),
          stages_(stages) {}

    /// Vertex shader, clip, cull and project; appends the corners to `vertices`.
    Polygon make(const Triangle& triangle, std::vector<ScreenVertex>& vertices) {
        shade(triangle);
        Polygon polygon{static_cast<int>(vertices.size()), 0, Rejection::none, false};
        clip(triangle, polygon);
        if (polygon.rejection == Rejection::none)
            polygon.rejection = stages_.cull(corners_, rules_);
        project(polygon, vertices);
        return polygon;
    }

  private:
    void shade(const Triangle& triangle) {
        corners_.clear();
        for (const Vertex& vertex : triangle.vertices)
            corners_.push_back(stages_.vertex_shader(vertex, rotation_, rules_, stages_, nullptr));
    }

    void clip(const Triangle& triangle, Polygon& polygon) {
        const Clipped clipped = stages_.clip(corners_, rules_);
        polygon.rejection = clipped.rejection;
        polygon.is_cut = clipped.is_cut;
        if (corners_.size() < least_corners) polygon.rejection = Rejection::clipped_away;
        if (!polygon.is_cut || polygon.rejection == Rejection::none) return;
        // Nothing is drawn of it: it is shown as the scene has it.
        shade(triangle);
        polygon.is_cut = false;
    }

    void project(Polygon& polygon, std::vector<ScreenVertex>& vertices) {
        for (const ClipVertex& corner : corners_) {
            const ProjectedVertex projected = stages_.project(corner, rules_, stages_, nullptr);
            if (polygon.rejection == Rejection::none) polygon.rejection = projected.rejection;
            vertices.push_back(projected.pixel);
            ++polygon.count;
        }
    }

    static constexpr std::size_t least_corners = 3;

    glm::mat3 rotation_;
    VertexRules rules_;
    const Stages& stages_;
    std::vector<ClipVertex> corners_;
};

} // namespace

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    frame.scene = &scene;
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, replace);
    frame.vertices.reserve(triangle_corners * scene.triangles.size());
    frame.polygons.reserve(scene.triangles.size());
    PolygonMaker maker(scene, settings, frame.stages);
    for (const Triangle& triangle : scene.triangles)
        frame.polygons.push_back(maker.make(triangle, frame.vertices));
    return frame;
}

std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle,
                                        const Settings& settings) {
    const Stages stages = stages_for(settings, frame.replace);
    std::vector<ScreenVertex> vertices;
    PolygonMaker(*frame.scene, settings, stages)
        .make(frame.scene->triangles[static_cast<std::size_t>(triangle)], vertices);
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
