#pragma once

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

/// DejaVu in the sizes of the text scale, or the built-in font if it is not installed, in an atlas
/// that ImGui uses from now on. The last few atlases are kept in case the same sizes are requested
/// again. The host's texture stays the same and must be filled again. Not to be called within a
/// frame.
/// @param least no letters are smaller, screen pixels
Fonts load_fonts(float text_scale, float least = 0.0f);

} // namespace rasterwalk
