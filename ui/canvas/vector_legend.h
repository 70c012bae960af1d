#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "explain/vectors.h"

namespace rasterwalk {

struct Ui;

/// A vector in the legend: "n normal, length 1".
struct VectorEntry {
    VectorName name{};
    std::string symbol, words;
    float width = 0.0f; ///< with the space around it, screen pixels
};

/// The vectors that are shown, in the font of legends; empty if there are none.
std::vector<VectorEntry> vector_entries(const Ui& ui);

/// Whose vectors they are: "at the picked pixel", "of triangles[3]"; or why there are none.
std::string vector_subject(const Ui& ui);

/// The same as lines of a tooltip, each after a line break.
std::string tooltip_lines(const std::vector<VectorEntry>& entries);

/// How many lines the entries take at this width, screen pixels.
std::size_t vector_rows(const std::vector<VectorEntry>& entries, float width);

/// Draws the entries one after another, in the colours of the arrows.
/// @param at    the upper left corner
/// @param line  height of a row, screen pixels
void draw_vector_entries(const Ui& ui, const std::vector<VectorEntry>& entries, float width,
                         ImVec2 at, float line);

/// What the overlay looks like, on the ground of a swatch.
/// @param size of the swatch, screen pixels
void draw_vector_swatch(const Ui& ui, ImDrawList* list, ImVec2 at, ImVec2 size);

} // namespace rasterwalk
