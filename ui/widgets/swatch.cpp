#include "ui/widgets/swatch.h"

#include "picture/view_image.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

ImU32 screen_colour(const Ui& ui, const glm::vec3& colour, float opacity) {
    const glm::vec3 cut = shown_colour(colour, ui.results.a.frame.stages.screen);
    return packed({cut.r, cut.g, cut.b, 1.0f}, opacity);
}

void draw_swatch(const Ui& ui, ImVec2 at, float width, const glm::vec3& colour, float opacity,
                 float border) {
    const ImVec2 end{at.x + width, at.y + ImGui::GetTextLineHeight()};
    const float corner = 2.0f * ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(at, end, screen_colour(ui, colour, opacity), corner);
    list->AddRect(at, end, packed(palette(ui.options.theme).dim, border), corner);
}

} // namespace rasterwalk
