#include "ui/widgets/arrows.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

/// Size of an arrow's head, design pixels, and how much of the arrow it may take.
constexpr float head_length = 9.0f, head_width = 3.6f, largest_head = 0.4f;

} // namespace

void draw_arrow(ImDrawList* list, float u, ImVec2 from, ImVec2 to, const CasedColour& colours,
                float head) {
    const glm::vec2 delta(to.x - from.x, to.y - from.y);
    const float length = glm::length(delta);
    list->AddLine(from, to, colours.casing, 4.6f * u);
    list->AddLine(from, to, colours.colour, 2.2f * u);
    if (!(length > 0.0f)) return;
    const float size = std::min(head * head_length * u, largest_head * length);
    const glm::vec2 along = delta / length * size;
    const glm::vec2 across = glm::vec2(-along.y, along.x) * (head_width / head_length);
    list->AddTriangleFilled(to, {to.x - along.x + across.x, to.y - along.y + across.y},
                            {to.x - along.x - across.x, to.y - along.y - across.y}, colours.colour);
}

void draw_dashed(ImDrawList* list, float u, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
    for_each_dash(from, to, {5.0f * u, 200.0f},
                  [&](ImVec2 begin, ImVec2 end) { list->AddLine(begin, end, colour, width); });
}

void draw_haloed(ImDrawList* list, ImFont* font, float u, ImVec2 low, const std::string& text,
                 const CasedColour& colours) {
    const float far = halo_width * u, near = 1.0f * u;
    for (const ImVec2 aside :
         {ImVec2{far, 0.0f}, ImVec2{-far, 0.0f}, ImVec2{0.0f, far}, ImVec2{0.0f, -far},
          ImVec2{near, near}, ImVec2{-near, near}, ImVec2{near, -near}, ImVec2{-near, -near}}) {
        list->AddText(font, font->FontSize, {low.x + aside.x, low.y + aside.y}, colours.casing,
                      text.c_str());
    }
    list->AddText(font, font->FontSize, low, colours.colour, text.c_str());
}

} // namespace rasterwalk
