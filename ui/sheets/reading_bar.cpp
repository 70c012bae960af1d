#include <algorithm>
#include <filesystem>
#include <string>

#include "base/quoted.h"
#include "ui/actions/reading.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_reading_bar(Ui& ui, ImVec2 window) {
    if (!is_reading(ui)) return;
    const float u = ui.options.text_scale;
    const ReadingState state = ui.reading.now->state();
    const std::string name =
        visible_line(std::filesystem::path(ui.reading.now->path()).filename().string());
    constexpr float width = 420.0f, height = 10.0f;
    const float bar = std::min(width * u, window.x - 4.0f * ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * u);
    ImGui::Begin("reading", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    put_text(shortened("Reading " + name, bar));
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, palette(ui.options.theme).accent);
    ImGui::ProgressBar(share_of(state), {bar, height * u}, "");
    ImGui::PopStyleColor();
    const std::string words = reading_words(state);
    register_widget(ui, "reading.bar", "What is open now stays open until the file has been read.",
                    words);
    ImGui::AlignTextToFramePadding();
    text_in(palette(ui.options.theme).dim, words.empty() ? "..." : words);
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x + bar - button_width("Stop"));
    if (button(ui, "reading.stop", "Stop", Look::plain,
               "Stops reading; what was open before stays open.")) {
        stop_reading(ui);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
