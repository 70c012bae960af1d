#include "inspect/triangle_report.h"

namespace rasterwalk {

TriangleReport triangle_report(const Frame& frame, int triangle, const Cursor& to) {
    TriangleReport report;
    report.triangle = triangle;
    report.rejection = frame.rejection(triangle);
    const glm::mat3 rotation = camera_rotation(frame.settings.camera);
    const VertexRules vertex = vertex_rules(frame);
    for (const Vertex& corner : corners_of(*frame.scene, triangle))
        report.vertices.push_back(shade_vertex(corner, rotation, vertex, frame.stages));
    report.clip = clip_history(frame, triangle);
    if (!frame.is_drawn(triangle)) return report;
    report.rows = row_history(frame, triangle, to);
    const PolygonCorners pixels = frame.triangle_vertices(triangle);
    report.edges.resize(pixels.size());
    for (std::size_t e = 0; e < pixels.size(); ++e) {
        report.edges[e].from = pixels[e];
        report.edges[e].to = pixels[(e + 1) % pixels.size()];
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

} // namespace rasterwalk
