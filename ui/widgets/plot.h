#pragma once

#include <functional>
#include <string>
#include <vector>

#include <imgui.h>

#include "inspect/row_graph.h"

namespace rasterwalk {

struct Ui;

/// A curve of a plot: y for every whole x, starting with the first.
struct Curve {
    std::string label;
    ImVec4 colour;
    bool is_dashed = false;
    std::function<double(int index)> value;
};

/// What is drawn in a plot.
struct Plot {
    int first_x = 0; ///< at index 0
    int count = 0;   ///< at least 1
    std::vector<Curve> curves;
    int band_from = -1, band_to = -1; ///< the area between these curves is shaded; -1: none
    int marked = -1;                  ///< index of the current column; -1: none
    int valid_from = 0, valid_to = 0; ///< the x range of the picture; the rest is shaded
    std::string x_name;               ///< below the numbers of the x axis; empty: it has no numbers
};

/// The room that the numbers of the y axis take at this height, so that plots one above another can
/// begin at the same place.
float axis_width(Ui& ui, const Plot& plot, float height);

/// Draws axes with numbers, curves, band and marks. Enters the plot as a widget.
/// @param axis    room for the numbers of the y axis
/// @param pointed index of the column pointed at, here or in another plot; -1: none
/// @return the index under the pointer, or -1
int draw_plot(Ui& ui, const std::string& name, const Plot& plot, ImVec2 size, float axis,
              int pointed);

/// The names of the curves, each after a piece of its line and before its value at a column, as
/// many a line as fit; and the height of the band there.
void draw_legend(Ui& ui, const std::string& name, const Plot& plot, int index,
                 const std::string& tooltip);

} // namespace rasterwalk
