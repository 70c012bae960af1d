#pragma once

// What a fragment does to its pixel as formulas: its depth test, and the blending after it.

#include <string>

#include "explain/fragment_report.h"
#include "stages/depth_test.h"

namespace rasterwalk {

/// The limit a margin must exceed for its fragment to be drawn, in the middle of a sentence: "0",
/// or "epsilon, 0.001,".
std::string margin_limit(const DepthRules& rules);

/// Appends depth.carried, if the row carries the buffer's value itself; depth, the value for the
/// buffer; and margin, how much nearer it is than the stored value. The formulas of 1/z and z, zinv
/// and z.affine, must come before.
void add_depth_test(FragmentReport& report, const Frame& frame);

/// Appends blend.red ..., how the pixel's new colour is mixed, if the fragment is blended. After
/// the colour of the fragment is known.
void add_blend(FragmentReport& report, const Frame& frame);

/// How the colours of the samples become the pixel's, if it has several.
void add_resolve(FragmentReport& report, const Frame& frame);

} // namespace rasterwalk
