#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/view_files.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_file(Ui& ui) {
    LabLook& lab = ui.lab;
    ImGui::PushFont(ui.fonts.bold);
    wrapped_text("My picture is wrong: why?");
    ImGui::PopFont();
    wrapped_text("Choose a picture that your program saved (PNG or BMP), or the rows that it "
                 "printed, as text. You can also drop the file on the window, or type its path.");
    ImGui::Spacing();
    if (button(ui, "lab.choose", "Choose a file …", Look::main,
               "Shows the folders and the files that can be checked. What is chosen is held "
               "against the lab's rules with the camera, light and stage that are set, and every "
               "mistake is carried out to see which comes nearest.")) {
        begin_choosing_result(ui);
    }
    const float width = button_width("check") + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - width, 60.0f));
    const bool entered = ImGui::InputTextWithHint("##path", "or its path", &lab.result_path,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    name_widget(ui, "lab.path", "The picture, or a text with lines as Start: (10,5). End: (10,5).");
    ImGui::SameLine();
    ImGui::BeginDisabled(lab.result_path.empty());
    const bool pressed = button(ui, "lab.diagnose", "check", Look::plain,
                                "Checks the file with this path. Key: Enter");
    ImGui::EndDisabled();
    if ((entered || pressed) && !lab.result_path.empty()) diagnose_file(ui, lab.result_path);
}

/// One candidate: how much of the difference it explains, as a bar and a number, and its name.
void draw_candidate(Ui& ui, const Candidate& candidate, int index) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    std::string names;
    const Bug* bug = nullptr;
    for (std::size_t i = 0; i < candidate.ids.size(); ++i) {
        const bool is_bug = candidate.ids[i].starts_with('B');
        names += (i > 0 ? " or " : "") + (is_bug ? candidate.ids[i] + " " : std::string()) +
                 candidate.names[i];
        for (const Bug& known : lab_bugs(ui)) {
            if (bug == nullptr && known.id == candidate.ids[i]) bug = &known;
        }
    }
    if (!candidate.remark.empty()) names += ", " + candidate.remark;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(ui.fonts.mono);
    right_aligned(fmt::format("{:.1f} %", 100.0 * candidate.explained), p.text);
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetItemRectMin();
    const float bottom = ImGui::GetItemRectMax().y + 2.0f * u;
    const float full = ImGui::GetItemRectSize().x;
    const auto part = static_cast<float>(std::clamp(candidate.explained, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, bottom},
                                              {low.x + part * full, bottom + 2.0f * u},
                                              packed(colour_of(Meaning::pass, ui.options.theme)));
    ImGui::TableNextColumn();
    wrapped_text(names);
    const std::string name = "lab.candidate." + std::to_string(index);
    name_widget(ui, name,
                "With this " + grouped(candidate.different) +
                    " still differ from your result; mean distance " +
                    fixed(candidate.distance, 3) + " steps of 255.");
    note_text(ui, name, candidate.ids.front());
    ImGui::TableNextColumn();
    if (bug == nullptr) return;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4.0f * u, 0.0f));
    if (button(ui, "lab.show." + std::to_string(index), "show", Look::link,
               "Turns this mistake on, and compares it with the correct run.")) {
        turn_on(ui, *bug, false);
    }
    ImGui::PopStyleVar();
}

} // namespace

void draw_lab_result(Ui& ui) {
    LabLook& lab = ui.lab;
    draw_file(ui);
    ImGui::Spacing();
    if (!lab.result_fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Meaning::fail, ui.options.theme));
        wrapped_text(lab.result_fault);
        ImGui::PopStyleColor();
        name_widget(ui, "lab.result.fault", "Why it could not be diagnosed.");
    }
    if (lab.frames_to_result > 0) {
        text_in(palette(ui.options.theme).dim, "It is held against every mistake …");
    }
    if (!lab.diagnosis) return;
    const Diagnosis& diagnosis = *lab.diagnosis;
    begin_card(ui);
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    wrapped_text("Held against " + lab.held_against + ":");
    ImGui::PopStyleColor();
    ImGui::PushFont(ui.fonts.bold);
    wrapped_text(diagnosis.verdict);
    ImGui::PopFont();
    name_widget(ui, "lab.diagnosis", "What is most likely.");
    note_text(ui, "lab.diagnosis", diagnosis.verdict);
    if (!diagnosis.is_same()) {
        text_in(palette(ui.options.theme).dim,
                grouped(diagnosis.different) + " differ from the reference");
    }
    end_card(ui);
    if (diagnosis.candidates.empty()) return;
    if (!ImGui::BeginTable("candidates", 3, ImGuiTableFlags_BordersInnerH)) return;
    const float u = ui.options.text_scale;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 70.0f * u);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 46.0f * u);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.fonts.small);
    ImGui::TableNextColumn();
    right_aligned("explains", palette(ui.options.theme).dim);
    name_widget(ui, "lab.header.explains",
                "How much of the difference from the reference is gone with this mistake.");
    ImGui::TableNextColumn();
    text_in(palette(ui.options.theme).dim, "mistake");
    name_widget(ui, "lab.header.mistake", "What may have been done; the likeliest first.");
    ImGui::PopFont();
    for (std::size_t i = 0; i < diagnosis.candidates.size(); ++i)
        draw_candidate(ui, diagnosis.candidates[i], static_cast<int>(i));
    ImGui::EndTable();
}

} // namespace rasterwalk
