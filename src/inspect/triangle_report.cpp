#include "inspect/triangle_report.h"

namespace rasterwalk {

namespace {

/// How many samples of the triangle come before the moment.
int samples_until(const Frame& frame, int triangle, const Cursor& to) {
    if (to < Cursor{triangle, Phase::edges, 0, 0}) return 0;
    if (to >= Cursor{triangle, Phase::rows, 0, 0}) return INT_MAX;
    return samples_before(frame.triangle_vertices(triangle), edge_rules(frame.settings), to.index,
                          to.step);
}

EdgeReport edge_report(const Fragment& from, const Fragment& to, const EdgeRules& rules, int edge,
                       int samples, PolygonRows& rows) {
    EdgeReport report{from, to, edge_sample_count(from, to, rules.samples), {}};
    for (LineWalker walker = walk_edge(from, to, rules); !walker.done() && walker.index() < samples;
         walker.advance()) {
        const Fragment& sample = walker.sample();
        report.samples.push_back(
            {edge, walker.index(), walker.x(), walker.y(), sample, add_edge_sample(sample, rows)});
    }
    return report;
}

} // namespace

TriangleReport triangle_report(const Frame& frame, int triangle, const Cursor& to) {
    TriangleReport report;
    report.triangle = triangle;
    report.left_out = frame.left_out[static_cast<std::size_t>(triangle)];
    const glm::mat3 rotation = camera_rotation(frame.settings.camera);
    const VertexRules vertex = vertex_rules(frame.settings, frame.scene->space);
    const Triangle& given = frame.scene->triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t v = 0; v < 3; ++v) {
        report.vertices[v] = frame.stages->vertex_shader(given.vertices[v], rotation, vertex);
    }
    if (!frame.is_drawn(triangle)) return report;
    const std::span<const Fragment> pixels = frame.triangle_vertices(triangle);
    const EdgeRules rules = edge_rules(frame.settings);
    const int samples = samples_until(frame, triangle, to);
    report.rows = row_history(pixels, rules, samples);
    PolygonRows rows;
    begin_polygon_rows(pixels, rules, rows);
    int left = samples;
    for (std::size_t e = 0; e < 3; ++e) {
        report.edges[e] =
            edge_report(pixels[e], pixels[(e + 1) % 3], rules, static_cast<int>(e), left, rows);
        left -= static_cast<int>(report.edges[e].samples.size());
    }
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
