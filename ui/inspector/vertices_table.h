#pragma once

// The table of the Vertices tab: the numbers of a triangle's three vertices, space by space.

#include <span>

namespace rasterwalk {

struct Ui;

/// One line of the table: one number of the three vertices.
struct VertexLine {
    const char* space; ///< only on the first line of a space
    const char* coordinate;
    const char* id; ///< of the formula in the vertex report
    int digits;
    const char* help;
    bool is_light = false;     ///< only in the stages that compute light
    bool is_highlight = false; ///< and only with a model that has highlights
};

/// The lines of the table, from top to bottom.
std::span<const VertexLine> vertex_lines();

/// Does the camera look in a direction other than along z?
bool is_camera_turned(const Ui& ui);

/// Begins a table with the columns of words and numbers, over a width that the panel leaves for
/// them. The tables of the panel share them: numbers of a vertex are below its name.
/// @return whether it is drawn; only then must it be ended
bool begin_vertex_table(Ui& ui, const char* name, float width);
void end_vertex_table();

/// The names of the vertices, in such a table; a click on one chooses it.
/// @param chosen the vertex that is explained, 0..2
void draw_vertex_header(Ui& ui, int chosen);
/// The visible ones of the lines, in such a table; a click on a number chooses it.
void draw_vertex_lines(Ui& ui, int chosen, std::span<const VertexLine> shown);

} // namespace rasterwalk
