#include "pipeline/frame.h"

namespace rasterwalk {

Frame prepare_frame(const Scene& scene, const Settings& settings, const Stages& stages) {
    Frame frame;
    frame.scene = &scene;
    frame.stages = &stages;
    frame.settings = settings;
    frame.vertices.reserve(3 * scene.triangles.size());
    frame.left_out.reserve(scene.triangles.size());
    const glm::mat3 rotation = camera_rotation(settings.camera);
    const VertexRules rules = vertex_rules(settings, scene.space);
    for (const Triangle& triangle : scene.triangles) {
        VertexFault fault = VertexFault::none;
        for (const Vertex& vertex : triangle.vertices) {
            const ShadedVertex shaded = stages.vertex_shader(vertex, rotation, rules);
            if (fault == VertexFault::none) fault = shaded.fault;
            frame.vertices.push_back(shaded.pixel);
        }
        frame.left_out.push_back(fault);
    }
    return frame;
}

} // namespace rasterwalk
