#pragma once

// The depth test of a fragment as formulas.

#include "explain/fragment_report.h"

namespace rasterwalk {

/// Appends depth.carried, where the row carries the buffer's value itself; depth, the value for the
/// buffer; and margin, how much nearer it is than what is stored. Formulas of 1/z and z come
/// before it: zinv, z.affine.
void add_depth_test(FragmentReport& report, const Frame& frame);

} // namespace rasterwalk
