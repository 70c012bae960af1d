#pragma once

// Arrows, dashes and names over a picture, cased so that they can be seen on every ground.

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

namespace rasterwalk {

/// The rim of a name, design pixels.
inline constexpr float halo_width = 1.4f;

/// A colour, and that of the rim around it.
struct CasedColour {
    ImU32 colour, casing;
};

/// @param u    design pixel
/// @param head size of its head, times the usual
void draw_arrow(ImDrawList* list, float u, ImVec2 from, ImVec2 to, const CasedColour& colours,
                float head = 1.0f);

/// How a line is dashed; gaps are as long as dashes.
struct Dashes {
    float length; ///< of a dash, screen pixels
    float most;   ///< a line of more dashes and gaps than this gets longer ones
};

/// Calls draw(from, to) for each dash of a line.
template <class Draw>
void for_each_dash(ImVec2 from, ImVec2 to, const Dashes& dashes, const Draw& draw) {
    const float x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    const float dash = std::max(dashes.length, length / dashes.most);
    for (float d = 0.0f; d < length; d += 2.0f * dash) {
        const float s = d / length, t = std::min((d + dash) / length, 1.0f);
        draw(ImVec2{from.x + s * x, from.y + s * y}, ImVec2{from.x + t * x, from.y + t * y});
    }
}

/// @param u     design pixel
/// @param width screen pixels
void draw_dashed(ImDrawList* list, float u, ImVec2 from, ImVec2 to, ImU32 colour, float width);

/// Text that can be read on any ground.
/// @param u   design pixel
/// @param low its upper left corner
void draw_haloed(ImDrawList* list, ImFont* font, float u, ImVec2 low, const std::string& text,
                 const CasedColour& colours);

} // namespace rasterwalk
