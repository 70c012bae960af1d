#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <imgui.h>

#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/inspector/lab_parts.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A named sentence that wraps; nothing if it is empty.
void draw_sentence(Ui& ui, const std::string& name, const std::string& words,
                   const std::string& help) {
    if (words.empty()) return;
    wrapped_text(words);
    register_widget(ui, name, help, words);
}

void draw_headline(Ui& ui, const LabAnswer& answer) {
    const LabHeadline headline = headline_of(answer);
    std::string all;
    ImGui::BeginGroup();
    ImGui::PushFont(ui.fonts.bold);
    for (const std::string& name : headline.names) {
        wrapped_text(name);
        all += (all.empty() ? "" : " ") + name;
    }
    ImGui::PopFont();
    if (!headline.rest.empty()) {
        wrapped_text(headline.rest);
        all += " " + headline.rest;
    }
    ImGui::EndGroup();
    register_widget(ui, "lab.diagnosis", "The most likely cause.", all);
}

void draw_pictures(Ui& ui, const LabAnswer& answer) {
    if (!answer.subject.is_picture) return;
    const Diagnosis& diagnosis = answer.diagnosis;
    draw_lab_pictures(ui, ui.lab.pictures, "lab",
                      {"Where it is wrong", !diagnosis.is_same() ? "Orange: wrong."
                                            : diagnosis.findings.empty()
                                                ? "Exactly the same."
                                                : "Orange: only rounding."});
}

/// How much differs and where, and what else can be said about it.
void draw_findings(Ui& ui, const LabAnswer& answer) {
    const Diagnosis& diagnosis = answer.diagnosis;
    draw_sentence(
        ui, "lab.difference", difference_words(answer),
        "How much is wrong, and where. A single step of 255 does not count, because a byte may be "
        "truncated or rounded.");
    draw_sentence(ui, "lab.rules", rules_words(diagnosis),
                  "Rules and numbers that differ from the handout's; none of them is wrong, so "
                  "they are not counted.");
    for (std::size_t i = 0; i < diagnosis.findings.size(); ++i) {
        draw_sentence(ui, "lab.finding." + std::to_string(i), diagnosis.findings[i],
                      "What the wrong pixels have in common.");
    }
    if (!diagnosis.is_complete) {
        draw_sentence(ui, "lab.incomplete", "The search was stopped before everything was tried.",
                      "The answer is the most likely of what was tried so far.");
    }
    ImGui::Spacing();
}

/// What the likely mistakes are, and how to fix them.
void draw_remedy(Ui& ui, const Diagnosis& diagnosis) {
    const std::string text = remedy_words(ui, diagnosis);
    if (text.empty()) return;
    const MarkdownEvents events =
        draw_markdown(ui, ui.lab.remedy, text, ImGui::CalcItemWidth(), "lab.remedy.");
    register_widget(ui, "lab.remedy", "What is likely wrong, and how to fix it.", text);
    ImGui::Spacing();
    answer_links(ui, document_of(*ui.lab.remedy), events);
}

/// What the result was compared with, and the other choice. Returns true if that is chosen.
bool draw_reference(Ui& ui, const LabAnswer& answer) {
    const bool is_set = answer.subject.against.is_set;
    const bool is_unsure =
        !answer.diagnosis.is_same() && likely_candidate(answer.diagnosis) == nullptr;
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    draw_sentence(ui, "lab.held_against", "Compared with " + answer.subject.compared_with + ".",
                  "The reference, that is, what a correct program makes.");
    ImGui::PopStyleColor();
    if (answer.subject.is_picture && is_unsure && !is_set) {
        draw_sentence(ui, "lab.lamp_and_camera",
                      "If your lamp or camera differs from the handout's and was not found, set it "
                      "here and compare your picture with that.",
                      "The arrows move and turn the camera; W, A, S, D, Q and E move the lamp.");
    }
    const bool pressed = button(
        ui, "lab.other_reference",
        is_set ? "Compare it with the handout's picture" : "Compare it with the current settings",
        Look::link,
        is_set ? "The lab's room with the camera, light and stage of the handout."
               : "The open scene with the current camera, light and stage. Use this for a picture "
                 "of another scene, or from another place.");
    return pressed;
}

/// One candidate: how much of the difference it explains, as a bar and a number, and its name.
void draw_candidate(Ui& ui, const Candidate& candidate, int index) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const Bug* const bug = bug_of(ui, candidate);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    right_aligned(explained_text(candidate.explained, 1), p.text, ui.fonts.mono);
    const ImVec2 low = ImGui::GetItemRectMin();
    const float bottom = ImGui::GetItemRectMax().y + 2.0f * u;
    const float full = ImGui::GetItemRectSize().x;
    const auto part = static_cast<float>(std::clamp(candidate.explained, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, bottom},
                                              {low.x + part * full, bottom + 2.0f * u},
                                              packed(colour_of(Meaning::pass, ui.options.theme)));
    ImGui::TableNextColumn();
    wrapped_text(candidate_words(candidate));
    clip_to_lines();
    const std::string name = "lab.candidate." + std::to_string(index);
    register_widget(ui, name,
                    "With this mistake, " + grouped(candidate.different) +
                        " still differ from your result; the mean distance is " +
                        fixed(candidate.distance, 3) + " steps of 255.",
                    candidate.ids().front());
    ImGui::TableNextColumn();
    if (bug == nullptr) return;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4.0f * u, 0.0f));
    if (button(ui, "lab.show." + std::to_string(index), "show", Look::link,
               "Turns this mistake on as it was tried on your file, and compares it with the "
               "reference.")) {
        show_candidate(ui, *bug, candidate);
    }
    ImGui::PopStyleVar();
}

/// Everything that may be wrong, the likeliest first.
void draw_candidates(Ui& ui, const Diagnosis& diagnosis) {
    if (diagnosis.candidates.empty()) return;
    if (!begin_lined_table("candidates", 3)) return;
    const float u = ui.options.text_scale;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 70.0f * u);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 46.0f * u);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.fonts.small);
    ImGui::TableNextColumn();
    right_aligned("explains", palette(ui.options.theme).dim);
    register_widget(ui, "lab.header.explains",
                    "How much of the difference from the reference this mistake explains.");
    ImGui::TableNextColumn();
    text_in(palette(ui.options.theme).dim, "mistake");
    register_widget(ui, "lab.header.mistake", "What may have gone wrong, likeliest first.");
    ImGui::PopFont();
    for (std::size_t i = 0; i < diagnosis.candidates.size(); ++i)
        draw_candidate(ui, diagnosis.candidates[i], static_cast<int>(i));
    ImGui::EndTable();
}

} // namespace

void draw_lab_answer(Ui& ui) {
    const LabAnswer& answer = *ui.lab.answer;
    begin_card(ui);
    draw_headline(ui, answer);
    draw_pictures(ui, answer);
    draw_findings(ui, answer);
    draw_remedy(ui, answer.diagnosis);
    const bool wants_other = draw_reference(ui, answer);
    end_card(ui);
    draw_candidates(ui, answer.diagnosis);
    if (wants_other) compare_result_with(ui, !answer.subject.against.is_set);
}

} // namespace rasterwalk
