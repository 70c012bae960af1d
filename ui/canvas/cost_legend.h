#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// A count of the work of the frame, in words.
struct CostLine {
    std::string_view title;
    std::string count;
};

/// What drawing the picture of run A took, stage by stage, as far as it is counted. Without the
/// counts that are 0.
struct CostTable {
    std::vector<CostLine> lines;
    float least_column = 1.0f; ///< width of a column with its gap, screen pixels

    /// @param width of the table, screen pixels
    std::size_t columns(float width) const;
    std::size_t rows(float width) const;
};

/// Formats all counts: once for each time that the legend is drawn or measured is enough.
CostTable cost_table(const Ui& ui);

/// The same as lines of a tooltip, each after a line break; empty if there are no counts.
std::string tooltip_lines(const CostTable& table);

/// Draws the table, column by column.
/// @param width for which its columns and rows are counted, screen pixels
/// @param at    the upper left corner
/// @param right end of the last column
/// @param line  height of a row, screen pixels
void draw_cost_table(const Ui& ui, const CostTable& table, float width, ImVec2 at, float right,
                     float line);

} // namespace rasterwalk
