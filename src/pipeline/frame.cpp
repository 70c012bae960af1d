#include "pipeline/frame.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings);
    if (replace) replace(stages);
    return stages;
}

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    frame.scene = &scene;
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, replace);
    frame.vertices.reserve(triangle_corners * scene.triangles.size());
    frame.polygons.reserve(scene.triangles.size());
    const glm::mat3 rotation = camera_rotation(settings.camera);
    const VertexRules rules = vertex_rules(settings, scene.space);
    for (const Triangle& triangle : scene.triangles) {
        Polygon polygon{static_cast<int>(frame.vertices.size()), triangle_corners, Rejection::none,
                        false};
        for (const Vertex& vertex : triangle.vertices) {
            const ClipVertex clip =
                frame.stages.vertex_shader(vertex, rotation, rules, frame.stages, nullptr);
            const ProjectedVertex projected =
                frame.stages.project(clip, rules, frame.stages, nullptr);
            if (polygon.rejection == Rejection::none) polygon.rejection = projected.rejection;
            frame.vertices.push_back(projected.pixel);
        }
        frame.polygons.push_back(polygon);
    }
    return frame;
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
