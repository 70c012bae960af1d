#pragma once

// How a value gets to a fragment, as formulas: along its row from the row's two ends, or from the
// corners, by their weights, where edge functions find the pixels.

#include <functional>
#include <string>

#include "explain/fragment_report.h"
#include "settings/choices.h"

namespace rasterwalk {

/// Which fragment of its row it is, in words.
/// @param step its column in the row, from the row's left end
std::string column_words(int step);

/// One value of an end of a row, or of a corner.
using EndPart = std::function<float(const RowEnd&)>;

/// The value that the ends carry of a quantity: divided by z, if the row does so.
EndPart part_of_ends(Quantity quantity);

/// Appends the weights of the three corners; nothing where pixels are not found by edge functions.
/// It comes before along_row(), whose formulas refer to them.
/// @param made_of of which edge the weights are made
void add_weights(FragmentReport& report, WeightEdge made_of);

/// How a value gets along a row: by the walk that is in force, as one formula of both ends; or,
/// where edge functions find the pixels, by the weights of the corners.
/// @param result the value as the drawing had it
Formula along_row(const FragmentReport& report, std::string id, std::string name, std::string help,
                  Interpolation way, const EndPart& part, float result);

/// The same where the row's ends are multiplied by 1/z once more.
/// @param formula from along_row(), of the same part, under Interpolation::zinv_twice
Formula along_row_twice(const FragmentReport& report, Formula formula, const EndPart& part);

} // namespace rasterwalk
