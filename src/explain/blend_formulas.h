#pragma once

namespace rasterwalk {

struct FragmentReport;
struct Frame;

/// "blend.red", "blend.green", "blend.blue": the colour that a half-transparent fragment and its
/// pixel make together. Only if the surface is blended and the fragment is drawn.
void add_blend(FragmentReport& report, const Frame& frame);

} // namespace rasterwalk
