#pragma once

// The values of a fragment as formulas: how each got along its row from the row's two ends or, if
// edge functions find the pixels, from the corners by their weights; and what the pixel recovers of
// it.

#include <functional>
#include <string>
#include <string_view>

#include "explain/fragment_report.h"

namespace rasterwalk {

/// Appends how each value of the fragment got along its row, and what is recovered of it, right and
/// wrong: weight.0 to q.off of the ids in fragment_report.h. Sets the report's varyings.
/// @param report with the fragment, its row and the interpolation in use
void add_values(FragmentReport& report, const Frame& frame);

/// One value of an end of a row, or of a corner.
using EndPart = std::function<float(const RowEnd&)>;

/// How a value gets along a row: by the walk in use, as one formula of both ends; or, if edge
/// functions find the pixels, by the weights of the corners, which must be among the report's
/// formulas.
/// @param result the value in the drawing
Formula along_row(const FragmentReport& report, std::string id, std::string_view name,
                  std::string_view help, Interpolation way, const EndPart& part, float result);

} // namespace rasterwalk
