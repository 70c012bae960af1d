#pragma once

namespace rasterwalk {

struct Ui;

/// Below the table of the vertices, if matrices do the work: a vertex in each space with the matrix
/// that took it there, the order of multiplication, and the conventions side by side.
/// @param vertex 0..2, of the triangle shown
void draw_spaces(Ui& ui, int vertex);

} // namespace rasterwalk
