#include "ui/canvas/pass_title.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/shadow_pass.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_pass_title(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const int pass = ui.results.a.frame.pass;
    if (pass == 0) return;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const char* const along = shadow_face_names[static_cast<std::size_t>(face_of_pass(pass))];
    const std::string words =
        fmt::format("p{}: what the lamp sees along {}", pass_number(pass), along);
    const std::string brief = fmt::format("p{}: {}", pass_number(pass), along);
    ImGui::PushFont(ui.fonts.small);
    const float padding = 8.0f * u, height = std::round(20.0f * u);
    const float room = canvas.high.x - canvas.low.x - 4.0f * padding;
    const std::string shown = first_fitting({words, brief}, room);
    const float width = text_width(shown) + 2.0f * padding;
    const ImVec2 low{std::round(canvas.low.x + padding), std::round(canvas.low.y + 5.0f * u)};
    ImVec4 ground = p.card;
    ground.w = 0.92f;
    list->AddRectFilled(low, {low.x + width, low.y + height}, packed(ground), 4.0f * u);
    list->AddText({low.x + padding, low.y + 0.5f * (height - ImGui::GetFontSize())}, packed(p.text),
                  shown.c_str());
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({width, height});
    register_widget(ui, "canvas.pass",
                    "A face of the shadow map: a depth buffer, drawn from where the lamp is. Its "
                    "colours are only shown to you; the map keeps the depths.",
                    words);
}

} // namespace rasterwalk
