#include "ui/bars/speed_dial.h"

#include <algorithm>
#include <string>
#include <vector>

#include "session/speed.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Where the line is in the box, and the space at both ends for its knob, design pixels.
constexpr float dial_line = 27.0f;
constexpr float knob_radius = 5.0f;

void draw_dial_words(const Ui& ui, ImVec2 at, float width, const Speed& meant, DialForm form) {
    const bool is_small = form == DialForm::small;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::string words = speed_text(meant, current_language());
    ImFont* const small = ui.fonts.small;
    ImFont* const font = is_small ? small : ui.fonts.text;
    const float x = is_small ? at.x + 0.5f * (width - text_width(font, words))
                             : at.x + width - text_width(font, words);
    list->AddText(font, font->FontSize, {x, at.y + (is_small ? 2.0f : 0.0f) * u}, packed(p.text),
                  words.c_str());
    if (is_small) return;
    if (text_width(small, tr("speed")) + 8.0f * u < x - at.x) {
        list->AddText(small, small->FontSize, {at.x, at.y + 2.0f * u}, packed(p.dim), tr("speed"));
    }
    if (form == DialForm::medium) return;
    const float y = at.y + 38.0f * u;
    list->AddText(small, small->FontSize, {at.x, y}, packed(p.dim), tr("1 step/s"));
    list->AddText(small, small->FontSize, {at.x + width - text_width(small, tr("no limit")), y},
                  packed(p.dim), tr("no limit"));
}

void draw_dial_line(const Ui& ui, ImVec2 left, float length, const Speed& meant, double steps,
                    bool is_lit) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float knob = left.x + length * static_cast<float>(dial_place(meant, steps));
    const float half = 1.5f * u;
    list->AddRectFilled({left.x, left.y - half}, {left.x + length, left.y + half},
                        packed(p.button_hovered), half);
    list->AddRectFilled({left.x, left.y - half}, {knob, left.y + half}, packed(p.dim), half);
    const std::vector<Speed> dial = speed_dial(steps);
    const bool is_dense = length < 6.0f * u * static_cast<float>(dial.size());
    for (std::size_t i = 0; i < dial.size(); ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(dial.size() - 1);
        if (dial[i] != Speed{} && is_dense) continue;
        const float reach = (dial[i] == Speed{} ? 6.0f : 3.5f) * u;
        const float x = left.x + length * share;
        list->AddLine({x, left.y - reach}, {x, left.y + reach},
                      packed(dial[i] == Speed{} ? p.text : p.dim, 0.7f), u);
    }
    list->AddRectFilled({knob - knob_radius * u, left.y - 8.0f * u},
                        {knob + knob_radius * u, left.y + 8.0f * u},
                        packed(is_lit ? p.link : p.text), 3.0f * u);
}

} // namespace

ImVec2 speed_dial_size(const Ui& ui, DialForm form) {
    const float u = ui.options.text_scale;
    return {(form == DialForm::small ? 112.0f : 172.0f) * u,
            (form == DialForm::large ? 56.0f : 34.0f) * u};
}

void draw_speed_dial(Ui& ui, ImVec2 at, DialForm form) {
    const float u = ui.options.text_scale;
    const ImVec2 size = speed_dial_size(ui, form);
    Play& play = ui.session.play;
    const double steps = ui.results.length.of(play.granularity);
    const ImVec2 left{at.x + knob_radius * u, at.y + dial_line * u};
    const float length = std::max(size.x - 2.0f * knob_radius * u, 1.0f);

    ImGui::SetCursorScreenPos(at);
    ImGui::InvisibleButton("##speed", size);
    const bool is_hovered = ImGui::IsItemHovered();
    const bool is_held = ImGui::IsItemActive();
    const ImGuiIO& io = ImGui::GetIO();
    // Not while it is merely held: a double click sets something else.
    const bool is_turned = ImGui::IsItemActivated() || (is_held && io.MouseDelta.x != 0.0f);
    if (is_turned) play.speed = speed_at((io.MousePos.x - left.x) / length, steps);
    if (is_hovered && io.MouseWheel != 0.0f) {
        play.speed = io.MouseWheel > 0.0f ? faster(play.speed, steps) : slower(play.speed, steps);
    }
    if (is_hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) play.speed = Speed{};
    const Speed meant = speed_in(play.speed, steps);
    register_widget(
        ui, "walk.speed",
        tr("How fast time runs: from one step a second, through the whole frame in a given "
           "time, to as fast as it can be drawn. Drag it or scroll; a double click "
           "sets it back to the whole frame in 15 s."),
        speed_text(meant, current_language()));
    const int more = take_arrows(ui, "walk.speed").more();
    if (more > 0) play.speed = faster(play.speed, steps);
    if (more < 0) play.speed = slower(play.speed, steps);
    draw_dial_words(ui, at, size.x, meant, form);
    draw_dial_line(ui, left, length, meant, steps, is_hovered || is_held);
}

} // namespace rasterwalk
