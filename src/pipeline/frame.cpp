#include "pipeline/frame.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings);
    if (replace) replace(stages);
    return stages;
}

namespace {

/// Vertex shader and projection, once a vertex, however many triangles meet in it.
std::vector<ProjectedVertex> project_vertices(const Mesh& mesh, const VertexRules& rules,
                                              const Stages& stages) {
    const glm::mat3 rotation = camera_rotation(rules.camera);
    std::vector<ProjectedVertex> projected;
    projected.reserve(mesh.vertices().size());
    for (const Vertex& vertex : mesh.vertices()) {
        const ClipVertex clip = stages.vertex_shader(vertex, rotation, rules, stages, nullptr);
        projected.push_back(stages.project(clip, rules, stages, nullptr));
    }
    return projected;
}

} // namespace

void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame) {
    frame.scene = &scene;
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, replace);
    const std::vector<ProjectedVertex> projected =
        project_vertices(scene.mesh, vertex_rules(settings, scene.space), frame.stages);
    frame.vertices.clear();
    frame.polygons.clear();
    frame.vertices.reserve(triangle_corners * scene.mesh.triangles().size());
    frame.polygons.reserve(scene.mesh.triangles().size());
    for (const TriangleIndices& triangle : scene.mesh.triangles()) {
        Polygon polygon{static_cast<int>(frame.vertices.size()), triangle_corners, Rejection::none,
                        false};
        for (const int index : triangle) {
            const ProjectedVertex& corner = projected[static_cast<std::size_t>(index)];
            if (polygon.rejection == Rejection::none) polygon.rejection = corner.rejection;
            frame.vertices.push_back(corner.pixel);
        }
        frame.polygons.push_back(polygon);
    }
}

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    prepare_frame(scene, settings, replace, frame);
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
