#include "ui/canvas/layers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "ui/actions/row_table_layout.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/overlays.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A sign for the layers where there is no room for the word: a hatched square.
constexpr const char* layers_sign = "▨";

void draw_overlay_list(Ui& ui) {
    const float u = ui.options.text_scale;
    float widest = 0.0f;
    for (const OverlayInfo& info : overlay_list())
        widest = std::max(widest, ImGui::CalcTextSize(info.title.data()).x);
    const ImVec2 swatch = swatch_size(ui);
    for (const OverlayInfo& info : overlay_list()) {
        bool on = ui.session.overlays.has(info.overlay);
        const ImVec2 start = ImGui::GetCursorScreenPos();
        const std::string label = std::string(info.title).append("###overlay.").append(info.name);
        if (ImGui::Checkbox(label.c_str(), &on)) ui.session.overlays.set(info.overlay, on);
        name_widget(ui, std::string("overlay.").append(info.name), info.help);
        const float height = ImGui::GetFrameHeight();
        ImGui::SameLine();
        ImGui::SetCursorScreenPos({start.x + height + widest + 26.0f * u, start.y});
        ImGui::Dummy({swatch.x, height});
        draw_swatch(ui, ImGui::GetWindowDrawList(),
                    {ImGui::GetItemRectMin().x, std::round(start.y + 0.5f * (height - swatch.y))},
                    info.overlay);
    }
    if (button(ui, "overlay.none", "all off", Look::quiet, "Turns off every overlay.")) {
        ui.session.overlays = {};
    }
}

/// "24x and up", while the picture is smaller than that.
void draw_zoom_needed(const Ui& ui, float needed) {
    if (ui.canvas.place.scale >= needed) return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    text_in(palette(ui.options.theme).dim, decimals(static_cast<double>(needed), 0) + "x and up");
}

void draw_switch(Ui& ui, const char* name, const char* title, bool& on, float needed,
                 const char* help) {
    const std::string label = std::string(title) + "###" + name;
    ImGui::Checkbox(label.c_str(), &on);
    name_widget(ui, name, help);
    draw_zoom_needed(ui, needed);
}

/// What is written in the cells and next to them.
void draw_cell_list(Ui& ui) {
    CanvasView& canvas = ui.session.canvas;
    draw_switch(ui, "layers.row_table", "row table next to its rows", canvas.row_table,
                row_table_zoom(ui),
                "leftPixels and rightPixels of the triangle shown, each line next to the row of "
                "the picture that it describes.\nVisible only where it covers no part of the "
                "triangle; the Rows tab always has it.");
    const std::string fates = std::string("pass ") + passed_sign + " and fail " + failed_sign;
    draw_switch(ui, "layers.fates", fates.c_str(), canvas.fates, fates_zoom(ui),
                "What the depth test said about each fragment of the triangle shown, and about all "
                "fragments that fell on the picked pixel.");
    text_in(palette(ui.options.theme).dim, "in the cells");
    const bool has_tests = tests_pixels(ui.results.a.frame.stages);
    for (const CellNumbersInfo& info : cell_numbers_list()) {
        if (is_of_tests(info.numbers) && !has_tests && canvas.numbers != info.numbers) continue;
        const CellNumbersWords words =
            cell_numbers_words(info.numbers, depth_words(ui.results.a.frame));
        const std::string label = words.title + "###numbers." + std::string(info.name);
        if (ImGui::RadioButton(label.c_str(), canvas.numbers == info.numbers))
            canvas.numbers = info.numbers;
        name_widget(ui, std::string("layers.numbers.").append(info.name), words.help);
        draw_zoom_needed(ui, numbers_zoom(ui, info.numbers));
    }
}

/// The overlays and numbers switched on, in the order of the list.
std::vector<std::string> layers_on(const Ui& ui) {
    std::vector<std::string> names;
    for (const OverlayInfo& info : overlay_list()) {
        if (ui.session.overlays.has(info.overlay)) names.emplace_back(info.title);
    }
    const CellNumbers numbers = ui.session.canvas.numbers;
    if (numbers != CellNumbers::none) {
        names.push_back("in the cells: " +
                        cell_numbers_words(numbers, depth_words(ui.results.a.frame)).title);
    }
    return names;
}

/// "layers: 2 on"; where there is little room the sign and the number.
std::string button_label(std::size_t on, bool narrow) {
    const std::string name = narrow ? layers_sign : "layers";
    if (on == 0) return name;
    return narrow ? name + " " + std::to_string(on) : name + ": " + std::to_string(on) + " on";
}

} // namespace

float layers_button_width(const Ui&, bool narrow) {
    // With a number in any case, so that its neighbours do not jump.
    return button_width(button_label(8, narrow));
}

void draw_layers_button(Ui& ui, bool narrow) {
    const std::vector<std::string> on = layers_on(ui);
    std::string help =
        "What is drawn over the picture and in its cells: wireframe, owners, the row table, "
        "numbers ...";
    for (const std::string& name : on)
        help += (&name == on.data() ? "\nOn: " : ", ") + name;
    if (button(ui, "canvas.overlays", button_label(on.size(), narrow),
               on.empty() ? Look::quiet : Look::plain, help,
               {layers_button_width(ui, narrow), 0.0f})) {
        ImGui::OpenPopup("layers");
    }
    const float gap = 4.0f * ui.options.text_scale;
    const ImVec2 at{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + gap};
    ImGui::SetNextWindowPos(at);
    // In a low window the list scrolls.
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {FLT_MAX, std::max(ImGui::GetIO().DisplaySize.y - at.y - gap, 1.0f)});
    if (ImGui::BeginPopup("layers")) {
        begin_whole_lines();
        draw_overlay_list(ui);
        ImGui::Separator();
        draw_cell_list(ui);
        end_whole_lines();
        ImGui::EndPopup();
    }
}

} // namespace rasterwalk
