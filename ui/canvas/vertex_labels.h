#pragma once

#include <string>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

struct Marks;

/// The name of a vertex or a vector on the picture.
struct CanvasLabel {
    std::string name;
    ImVec2 low, high; ///< of the dark background or the rim
    ImVec2 text;      ///< upper left corner of the letters
};

/// The names of the vertices of the triangle shown that are in view: outside the triangle, next to
/// the pixels of its rows and the lines of its edges, and never cut off. All of them are short if
/// one has no room, or would cover what is written in the cells; one that still has no room is left
/// out.
std::vector<CanvasLabel> vertex_labels(const Marks& m);

/// Does a rectangle of the screen overlap one of the labels? Touching it does not count.
bool is_under_label(ImVec2 low, ImVec2 high, const std::vector<CanvasLabel>& labels);

} // namespace rasterwalk
