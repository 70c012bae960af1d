#pragma once

#include <string>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

struct Marks;

/// The name of a vertex on the picture, on a dark background.
struct VertexLabel {
    int vertex;
    std::string name;
    ImVec2 low, high; ///< of the background
    ImVec2 text;      ///< upper left corner of the letters
};

/// The names of the vertices of the triangle shown that are in view: outside the triangle, next to
/// the pixels of its rows and the lines of its edges, and never cut off. All of them are short if
/// one has no room, or would cover what is written in the cells; one that still has no room is left
/// out.
std::vector<VertexLabel> vertex_labels(const Marks& m);

} // namespace rasterwalk
