#pragma once

namespace rasterwalk {

struct Ui;

/// The part of the triangle shown as wires, in any space of the chain of matrices or between two of
/// them, with a slider. It changes nothing but the figure itself.
/// @param vertex 0..2, of the triangle shown, which is marked
void draw_chain_figure(Ui& ui, int vertex);

} // namespace rasterwalk
