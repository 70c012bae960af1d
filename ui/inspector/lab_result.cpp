#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/image_format.h"
#include "settings/value_words.h"
#include "text/markdown_text.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/view_files.h"
#include "ui/inspector/lab_parts.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_intro(Ui& ui) {
    ImGui::PushFont(ui.fonts.bold);
    wrapped_text("My picture is wrong: why?");
    keep_text_whole(ui);
    ImGui::PopFont();
    wrapped_text(fmt::format("Choose a picture that your program saved ({}), or the rows that it "
                             "printed, as text. You can also drop the file on the window, or type "
                             "its path.",
                             exact_image_formats));
    keep_text_whole(ui);
    name_widget(ui, "lab.intro", "What can be checked, and how.");
    ImGui::Spacing();
}

/// @param another a file was checked already
void draw_file(Ui& ui, bool another) {
    ImGui::Spacing();
    LabLook& lab = ui.lab;
    if (button(ui, "lab.choose", another ? "Another file …" : "Choose a file …",
               another ? Look::plain : Look::main,
               "Shows the folders and the files that can be checked. What is chosen is held "
               "against the lab's room as the handout draws it, and every mistake is carried out "
               "to see which comes nearest.")) {
        begin_choosing_result(ui);
    }
    keep_item_whole(ui);
    const float width = button_width("check") + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - width, 60.0f));
    const bool entered = ImGui::InputTextWithHint("##path", "or its path", &lab.result_path,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    name_widget(ui, "lab.path", "The picture, or a text with lines as Start: (10,5). End: (10,5).");
    keep_item_whole(ui);
    ImGui::SameLine();
    ImGui::BeginDisabled(lab.result_path.empty());
    const bool pressed = button(ui, "lab.diagnose", "check", Look::plain,
                                "Checks the file with this path. Key: Enter");
    ImGui::EndDisabled();
    if ((entered || pressed) && !lab.result_path.empty()) diagnose_file(ui, lab.result_path);
}

/// Settings as the command line writes them, "line_walk=exact", in the words of the screen.
std::string in_words(const std::string& text) {
    std::string result;
    std::size_t done = 0;
    for (std::size_t equals = text.find('='); equals != text.npos;
         equals = text.find('=', equals + 1)) {
        const std::size_t blank = text.find_last_of(" (", equals);
        const std::size_t first = blank == text.npos ? 0 : blank + 1;
        std::size_t last = std::min(text.find_first_of(" ,)", equals), text.size());
        if (text[last - 1] == '.') --last; // of the sentence
        const Setting* const setting = find_setting(text.substr(first, equals - first));
        if (setting == nullptr || first < done) continue;
        const std::string value =
            said_word(*setting, std::string_view(text).substr(equals + 1, last - equals - 1));
        result += text.substr(done, first - done) + "“" + std::string(setting->title) + ": " +
                  value + "”";
        done = last;
    }
    return result + text.substr(done);
}

/// What is most likely, in a sentence.
std::string verdict_words(const LabLook& lab) {
    if (!lab.diagnosis->is_same()) return in_words(lab.diagnosis->verdict);
    return lab.is_picture ? "Your picture is the reference, pixel for pixel."
                          : "Your rows are those of the reference, end for end.";
}

/// The mistakes of a candidate, and what it is assumed with.
std::string candidate_words(const Candidate& candidate) {
    std::string names;
    for (std::size_t i = 0; i < candidate.ids.size(); ++i) {
        const bool is_bug = candidate.ids[i].starts_with('B');
        names += (i > 0 ? " or " : "") + (is_bug ? candidate.ids[i] + " " : std::string()) +
                 candidate.names[i];
    }
    if (!candidate.remark.empty()) names += ", " + candidate.remark;
    return in_words(names);
}

/// The mistake of the laboratory that a candidate names first; null: it names none.
const Bug* bug_of(Ui& ui, const Candidate& candidate) {
    for (const std::string& id : candidate.ids) {
        for (const Bug& bug : lab_bugs(ui)) {
            if (bug.id == id) return &bug;
        }
    }
    return nullptr;
}

/// What the likely mistake is, and how it is mended.
void draw_remedy(Ui& ui, const Diagnosis& diagnosis) {
    const Candidate* const likely = likely_candidate(diagnosis);
    const Bug* const bug = likely == nullptr ? nullptr : bug_of(ui, *likely);
    if (bug == nullptr) return;
    const std::string text = as_markdown(bug->sentence) + "\n\n" + remedy_of(ui, *bug);
    const MarkdownEvents events =
        draw_markdown(ui, ui.lab.remedy, text, ImGui::CalcItemWidth(), "lab.remedy.");
    name_widget(ui, "lab.remedy", "What the likely mistake is, and how it is mended.");
    note_text(ui, "lab.remedy", text);
    answer_links(ui, document_of(*ui.lab.remedy), events);
}

/// What the result was held against, and the other choice. Returns true if that is asked for.
bool draw_reference(Ui& ui) {
    const LabLook& lab = ui.lab;
    const std::string held = "Held against " + lab.held_against + ".";
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    wrapped_text(held);
    name_widget(ui, "lab.held_against", "The reference: what the right program makes.");
    note_text(ui, "lab.held_against", held);
    keep_item_whole(ui);
    ImGui::PopStyleColor();
    const bool is_set = lab.holds_against_set;
    const bool pressed = button(
        ui, "lab.other_reference",
        is_set ? "Hold it against the handout's picture" : "Hold it against what is set",
        Look::link,
        is_set ? "The lab's room with the camera, light and stage of the handout."
               : "The scene that is open, with the camera, light and stage that are set now. For a "
                 "picture of another scene, or from another place.");
    keep_item_whole(ui);
    return pressed;
}

/// One candidate: how much of the difference it explains, as a bar and a number, and its name.
void draw_candidate(Ui& ui, const Candidate& candidate, int index) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const Bug* const bug = bug_of(ui, candidate);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(ui.fonts.mono);
    right_aligned(explained_text(candidate.explained, 1), p.text);
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetItemRectMin();
    const float bottom = ImGui::GetItemRectMax().y + 2.0f * u;
    const float full = ImGui::GetItemRectSize().x;
    const auto part = static_cast<float>(std::clamp(candidate.explained, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, bottom},
                                              {low.x + part * full, bottom + 2.0f * u},
                                              packed(colour_of(Meaning::pass, ui.options.theme)));
    ImGui::TableNextColumn();
    wrapped_text(candidate_words(candidate));
    keep_text_whole(ui);
    const std::string name = "lab.candidate." + std::to_string(index);
    name_widget(ui, name,
                "With this " + grouped(candidate.different) +
                    " still differ from your result; mean distance " +
                    fixed(candidate.distance, 3) + " steps of 255.");
    note_text(ui, name, candidate.ids.front());
    keep_item_whole(ui);
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

/// All that may be wrong, the likeliest first.
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

/// How much differs, and where; empty: nothing.
std::string difference_words(const LabLook& lab) {
    const Diagnosis& diagnosis = *lab.diagnosis;
    if (diagnosis.is_same()) return "";
    const bool is_one = diagnosis.different == 1;
    const Candidate* const likely = likely_candidate(diagnosis);
    const std::string assumed =
        likely == nullptr || likely->remark.empty() ? ". " : " " + in_words(likely->remark) + ". ";
    const char* const what =
        lab.is_picture
            ? (is_one ? " pixel looks different from the right picture"
                      : " pixels look different from the right picture")
            : (is_one ? " row differs from the reference" : " rows differ from the reference");
    return grouped(diagnosis.different) + what + assumed + diagnosis.place;
}

void draw_diagnosis(Ui& ui) {
    const LabLook& lab = ui.lab;
    const Diagnosis& diagnosis = *lab.diagnosis;
    const std::string verdict = verdict_words(lab);
    begin_card(ui);
    ImGui::PushFont(ui.fonts.bold);
    wrapped_text(verdict);
    ImGui::PopFont();
    name_widget(ui, "lab.diagnosis", "What is most likely.");
    keep_item_whole(ui);
    note_text(ui, "lab.diagnosis", verdict);
    const std::string where = difference_words(lab);
    if (lab.is_picture) {
        draw_lab_pictures(ui, {"Where it is not right", diagnosis.is_same()
                                                            ? "The very same."
                                                            : "Orange: not as it should be."});
    }
    if (!where.empty()) {
        wrapped_text(where);
        name_widget(ui, "lab.difference", "How much is not right, and where.");
        note_text(ui, "lab.difference", where);
        keep_item_whole(ui);
        ImGui::Spacing();
    }
    draw_remedy(ui, diagnosis);
    const bool wants_other = draw_reference(ui);
    end_card(ui);
    draw_candidates(ui, diagnosis);
    if (wants_other) hold_result_against(ui, !lab.holds_against_set); // the diagnosis is gone then
}

/// How far the check is, and the way to stop it.
void draw_progress(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const PicturesDrawn drawn = ui.lab.work ? ui.lab.work->pictures() : PicturesDrawn{};
    const std::string words =
        drawn.all == 0
            ? "Each mistake is tried …"
            : fmt::format("Each mistake is tried: {} of {} pictures", drawn.done, drawn.all);
    text_in(p.dim, words);
    keep_item_whole(ui);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, p.accent);
    ImGui::ProgressBar(static_cast<float>(drawn.done) / static_cast<float>(std::max(drawn.all, 1)),
                       {-1.0f, 10.0f * ui.options.text_scale}, "");
    ImGui::PopStyleColor();
    name_widget(ui, "lab.progress",
                "How many of the pictures are drawn that are known to be needed; what they show "
                "may lead to more.");
    note_text(ui, "lab.progress", words);
    keep_item_whole(ui);
    if (button(ui, "lab.stop", "Stop", Look::plain, "Stops checking the file. Key: Esc"))
        stop_diagnosis(ui);
    keep_item_whole(ui);
}

/// What came of the file that was checked last.
void draw_result_answer(Ui& ui) {
    const LabLook& lab = ui.lab;
    if (!lab.result_fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Meaning::fail, ui.options.theme));
        wrapped_text(lab.result_fault);
        ImGui::PopStyleColor();
        name_widget(ui, "lab.result.fault", "Why it could not be diagnosed.");
    }
    if (is_diagnosing(ui)) draw_progress(ui);
    if (lab.diagnosis) draw_diagnosis(ui);
}

} // namespace

void draw_lab_result(Ui& ui) {
    const LabLook& lab = ui.lab;
    const bool is_asked = is_diagnosing(ui) || lab.diagnosis || !lab.result_fault.empty();
    // The answer stands above the way to the next one, which stays in sight where there is room.
    if (!is_asked) {
        draw_intro(ui);
        draw_file(ui, false);
    } else if (!ui.inspector.has_card) {
        draw_result_answer(ui);
        draw_file(ui, true);
    } else {
        draw_with_card(
            ui, "result", [&] { draw_result_answer(ui); }, [&] { draw_file(ui, true); });
    }
}

} // namespace rasterwalk
