#include "inspect/triangle_report.h"

namespace rasterwalk {

TriangleReport triangle_report(const Frame& frame, int triangle, const Cursor& to) {
    TriangleReport report;
    report.triangle = triangle;
    report.left_out = frame.left_out[static_cast<std::size_t>(triangle)];
    const glm::mat3 rotation = camera_rotation(frame.settings.camera);
    const VertexRules vertex = vertex_rules(frame.settings, frame.scene->space);
    const Triangle& given = frame.scene->triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t v = 0; v < 3; ++v) {
        report.vertices[v] =
            frame.stages.vertex_shader(given.vertices[v], rotation, vertex, frame.stages);
    }
    if (!frame.is_drawn(triangle)) return report;
    report.rows = row_history(frame, triangle, to);
    const std::span<const Fragment> pixels = frame.triangle_vertices(triangle);
    for (std::size_t e = 0; e < 3; ++e) {
        report.edges[e].from = pixels[e];
        report.edges[e].to = pixels[(e + 1) % 3];
        report.edges[e].count = report.rows.edge_samples[e];
    }
    for (const EdgeSample& sample : edge_samples(frame, triangle, to))
        report.edges[static_cast<std::size_t>(sample.edge)].samples.push_back(sample);
    return report;
}

std::string_view write_name(const RowWrite& write) {
    if (!write.inside) return "outside";
    if (write.left && write.right) return "both";
    return write.left ? "left" : write.right ? "right" : "nothing";
}

std::string_view fault_name(VertexFault fault) {
    switch (fault) {
    case VertexFault::none:
        break;
    case VertexFault::not_finite:
        return "not_finite";
    case VertexFault::behind_camera:
        return "behind_camera";
    case VertexFault::too_far_out:
        return "too_far_out";
    case VertexFault::taken_for_behind:
        return "taken_for_behind";
    }
    return "none";
}

} // namespace rasterwalk
