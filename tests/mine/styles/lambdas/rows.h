#pragma once

#include <limits>
#include <vector>
#include "interpolation.h"

// The number of pixels on the line between two pixels.
inline int lengthOfLine(glm::ivec2 a, glm::ivec2 b) {
    const glm::ivec2 d = glm::abs(a - b);
    return std::max(d.x, d.y) + 1;
}

inline void ComputePolygonRows(const std::vector<Pixel>& vertexPixels,
                               std::vector<Pixel>& leftPixels,
                               std::vector<Pixel>& rightPixels) {
    int yMin = std::numeric_limits<int>::max();
    int yMax = std::numeric_limits<int>::lowest();
    for (const auto& p : vertexPixels) {
        yMin = std::min(yMin, p.pos.y);
        yMax = std::max(yMax, p.pos.y);
    }

    const Pixel farRight{{std::numeric_limits<int>::max(), 0}, 0, {}};
    const Pixel farLeft{{std::numeric_limits<int>::lowest(), 0}, 0, {}};
    leftPixels.assign(yMax - yMin + 1, farRight);
    rightPixels.assign(yMax - yMin + 1, farLeft);

    auto addEdge = [&](const Pixel& a, const Pixel& b) {
        std::vector<Pixel> edge(lengthOfLine(a.pos, b.pos));
        Interpolate(a, b, edge);
        for (const auto& p : edge) {
            auto& left = leftPixels.at(p.pos.y - yMin);
            auto& right = rightPixels.at(p.pos.y - yMin);
            if (p.pos.x < left.pos.x) left = p;
            if (p.pos.x > right.pos.x) right = p;
        }
    };

    for (std::size_t i = 1; i < vertexPixels.size(); ++i)
        addEdge(vertexPixels[i - 1], vertexPixels[i]);
    addEdge(vertexPixels.back(), vertexPixels.front());
}
