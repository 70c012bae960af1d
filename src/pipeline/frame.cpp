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
    frame.vertices.reserve(3 * scene.triangles.size());
    frame.left_out.reserve(scene.triangles.size());
    const glm::mat3 rotation = camera_rotation(settings.camera);
    const VertexRules rules = vertex_rules(settings, scene.space);
    for (const Triangle& triangle : scene.triangles) {
        VertexFault fault = VertexFault::none;
        for (const Vertex& vertex : triangle.vertices) {
            const ShadedVertex shaded =
                frame.stages.vertex_shader(vertex, rotation, rules, frame.stages);
            if (fault == VertexFault::none) fault = shaded.fault;
            frame.vertices.push_back(shaded.pixel);
        }
        frame.left_out.push_back(fault);
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
