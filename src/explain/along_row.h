#pragma once

// How a value gets to a fragment, as formulas: along its row from the row's two ends or, if edge
// functions find the pixels, from the corners by their weights.

#include <functional>
#include <string>

#include "explain/fragment_report.h"
#include "settings/choices.h"

namespace rasterwalk {

/// A fragment's place in its row, in words.
/// @param step its column in the row, from the row's left end
std::string column_words(int step);

/// One value of an end of a row, or of a corner.
using EndPart = std::function<float(const RowEnd&)>;

/// The value that the ends carry for a quantity: divided by z, if the row does that.
EndPart part_of_ends(Quantity quantity);

/// Appends the weights of the three corners; nothing if pixels are not found by edge functions. To
/// be called before along_row(), whose formulas refer to them.
/// @param made_of the edge that the weights are made from
void add_weights(FragmentReport& report, WeightEdge made_of);

/// How a value gets along a row: by the walk in use, as one formula of both ends; or, if edge
/// functions find the pixels, by the weights of the corners.
/// @param result the value in the drawing
Formula along_row(const FragmentReport& report, std::string id, std::string name, std::string help,
                  Interpolation way, const EndPart& part, float result);

/// The same if the row's ends are multiplied by 1/z a second time.
/// @param formula from along_row(), for the same part, under Interpolation::zinv_twice
Formula along_row_twice(const FragmentReport& report, Formula formula, const EndPart& part);

} // namespace rasterwalk
