#include "inspect/edge_lines.h"

#include <algorithm>
#include <numeric>

#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

/// The pixels of the edges of a triangle.
class EdgePixels : public SampleSink {
  public:
    using Edges = std::vector<std::vector<glm::ivec2>>;

    EdgePixels(const Frame& frame, int triangle) {
        if (!frame.is_drawn(triangle)) return;
        const PolygonCorners vertices = frame.triangle_vertices(triangle);
        edges_.resize(vertices.size());
        // If coverage walks no edges, the edges are those of stage `edges`.
        const Stages walking = walking_edges(frame.stages);
        PolygonRows rows;
        walking.compute_polygon_rows(vertices, edge_rules(frame.settings, {}), walking, rows, this);
    }
    void edge_sample(const EdgeSample& sample) override {
        edges_[static_cast<std::size_t>(sample.edge)].emplace_back(sample.fragment.column,
                                                                   sample.fragment.row);
    }
    const Edges& edges() const { return edges_; }

  private:
    Edges edges_;
};

std::int64_t different(const std::vector<glm::ivec2>& a, const std::vector<glm::ivec2>& b) {
    const std::size_t both = std::min(a.size(), b.size());
    std::int64_t count = static_cast<std::int64_t>(std::max(a.size(), b.size()) - both);
    for (std::size_t i = 0; i < both; ++i)
        count += a[i] == b[i] ? 0 : 1;
    return count;
}

} // namespace

EdgeEnds count_edge_ends(const Frame& frame) {
    EdgeEnds ends;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const EdgePixels pixels(frame, t);
        for (std::size_t e = 0; e < pixels.edges().size(); ++e) {
            const PolygonCorners v = frame.triangle_vertices(t);
            const ScreenVertex& end = v[(e + 1) % v.size()];
            const std::vector<glm::ivec2>& edge = pixels.edges()[e];
            ++ends.edges;
            const bool arrives = !edge.empty() && edge.back() == glm::ivec2(end.column, end.row);
            ends.missed += arrives ? 0 : 1;
        }
    }
    return ends;
}

std::vector<std::int64_t> different_samples(const Frame& a, const Frame& b, int triangle) {
    const EdgePixels of_a(a, triangle), of_b(b, triangle);
    const std::size_t edges = std::max(of_a.edges().size(), of_b.edges().size());
    std::vector<std::int64_t> counts;
    for (std::size_t e = 0; e < edges; ++e) {
        static const std::vector<glm::ivec2> none;
        counts.push_back(different(e < of_a.edges().size() ? of_a.edges()[e] : none,
                                   e < of_b.edges().size() ? of_b.edges()[e] : none));
    }
    return counts;
}

std::int64_t different_samples(const Frame& a, const Frame& b) {
    std::int64_t sum = 0;
    for (int t = 0; t < std::min(a.triangle_count(), b.triangle_count()); ++t) {
        const std::vector<std::int64_t> counts = different_samples(a, b, t);
        sum += std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    }
    return sum;
}

} // namespace rasterwalk
