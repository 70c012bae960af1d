#pragma once

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

/// DejaVu in the sizes of the text scale, or the built-in font where it is not installed, in an
/// atlas that ImGui uses from now on. The last few atlases are kept for whoever asks for the same
/// sizes again. The host's texture stays the same and is to be filled anew. Not to be called within
/// a frame.
/// @param least no letters are smaller, screen pixels
Fonts load_fonts(float text_scale, float least = 0.0f);

} // namespace rasterwalk
