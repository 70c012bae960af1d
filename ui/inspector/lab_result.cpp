#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/image_format.h"
#include "ui/actions/lab.h"
#include "ui/actions/view_files.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_intro(Ui& ui) {
    wrapped_text("My picture is wrong. Why?", ui.fonts.bold);
    wrapped_text(
        fmt::format("Choose a picture that your program saved ({}), or a text file with "
                    "the rows that it printed. You can also drop the file on the window or "
                    "type its path.",
                    exact_image_formats));
    register_widget(ui, "lab.intro", "What can be checked, and how.");
    ImGui::Spacing();
}

/// @param another true if a file was checked before
void draw_file(Ui& ui, bool another) {
    ImGui::Spacing();
    LabLook& lab = ui.lab;
    if (button(ui, "lab.choose", another ? "Another file …" : "Choose a file …",
               another ? Look::plain : Look::main,
               "Shows the folders and the files that can be checked. Your file is compared with "
               "the lab's room as the handout draws it, and every known mistake is tried to "
               "see which comes closest.")) {
        begin_choosing_result(ui);
    }
    const float width = button_width("check") + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - width, 60.0f));
    const bool entered = ImGui::InputTextWithHint("##path", "or its path", &lab.result_path,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    register_widget(ui, "lab.path",
                    "The picture, or a text file with lines like Start: (10,5). End: "
                    "(10,5).");
    ImGui::SameLine();
    ImGui::BeginDisabled(lab.result_path.empty());
    const bool pressed = button(ui, "lab.diagnose", "check", Look::plain,
                                "Checks the file with this path. Key: Enter");
    ImGui::EndDisabled();
    if ((entered || pressed) && !lab.result_path.empty()) diagnose_file(ui, lab.result_path);
}

/// How far the check is, in words; empty: not known yet.
std::string pictures_words(const LabLook& lab) {
    const PicturesDrawn drawn = lab.check ? lab.check->work->pictures() : PicturesDrawn{};
    return drawn.all == 0 ? "" : fmt::format("{} of {} pictures", drawn.done, drawn.all);
}

/// The part of the pictures that is drawn, 0..1.
float pictures_part(const LabLook& lab) {
    const PicturesDrawn drawn = lab.check ? lab.check->work->pictures() : PicturesDrawn{};
    return static_cast<float>(drawn.done) / static_cast<float>(std::max(drawn.all, 1));
}

bool is_stopping(const LabLook& lab) {
    return lab.check && lab.check->is_stopped;
}

const char* stop_help(const LabLook& lab) {
    return is_stopping(lab)
               ? "Discards what was found. Key: Esc"
               : "Stops the search and shows what was found so far. Esc discards that, too.";
}

constexpr const char* progress_help =
    "Pictures drawn so far, out of those known to be needed. The results may require more.";

/// How far the check is, and the button to stop it.
void draw_progress(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const LabLook& lab = ui.lab;
    const std::string drawn = pictures_words(lab);
    const std::string what = is_stopping(lab) ? "Looking at what was found" : "Trying each mistake";
    const std::string words = drawn.empty() ? what + " …" : what + ": " + drawn;
    text_in(p.dim, words);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, p.accent);
    ImGui::ProgressBar(pictures_part(lab), {-1.0f, 10.0f * ui.options.text_scale}, "");
    ImGui::PopStyleColor();
    register_widget(ui, "lab.progress", progress_help, words);
    if (button(ui, "lab.stop", "Stop", Look::plain, stop_help(lab))) stop_diagnosis(ui);
}

/// What is said about the file next to an answer: the longest form first.
std::vector<std::string> watch_forms(const LabLook& lab, bool is_checking) {
    const std::string file = std::filesystem::path(lab.watched_path).filename().string();
    if (is_checking) {
        const bool is_changed = lab.check && lab.check->subject.bytes != lab.answer->subject.bytes;
        const std::string what = is_stopping(lab) ? "Looking at what was found"
                                 : is_changed     ? "Your file has changed: checking"
                                                  : "Checking";
        const std::string drawn = pictures_words(lab);
        return {drawn.empty() ? what + " …" : what + ", " + drawn, what + " …", "Checking …"};
    }
    if (!lab.result_fault.empty()) {
        return {file + " cannot be read now; this is the previous answer.",
                "Cannot be read now; this is the previous answer.", "Cannot be read now."};
    }
    if (lab.is_given_up) {
        return {"The check was stopped; this is the previous answer.", "Stopped: previous answer."};
    }
    return {file + ": checked again whenever it changes", "Checked again whenever it changes",
            "Checked when it changes"};
}

/// What happens to the file: one line next to an answer that is always there, so that nothing
/// jumps.
void draw_watch_line(Ui& ui) {
    const LabLook& lab = ui.lab;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const bool is_checking = is_diagnosing(ui);
    const bool is_fault = !is_checking && !lab.result_fault.empty();
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4.0f * u, 0.0f));
    const float stop = is_checking ? button_width("Stop") + ImGui::GetStyle().ItemSpacing.x : 0.0f;
    const float left = ImGui::GetCursorScreenPos().x, room = right_end() - left - stop;
    const std::string words = first_fitting(watch_forms(lab, is_checking), room);
    text_in(is_fault ? colour_of(Meaning::fail, ui.options.theme) : p.dim, words);
    register_widget(ui, "lab.watch",
                    is_checking ? progress_help
                    : is_fault
                        ? lab.result_fault + "\nIt is tried again when the file changes."
                        : "The file is being watched. Save it again, and it is checked against "
                          "the same reference. " +
                              lab.watched_path,
                    words);
    const float bottom = ImGui::GetItemRectMax().y;
    if (is_checking) {
        ImGui::GetWindowDrawList()->AddRectFilled(
            {left, bottom}, {left + pictures_part(lab) * room, bottom + 2.0f * u},
            packed(p.accent));
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::SetCursorScreenPos({left + room, ImGui::GetCursorScreenPos().y});
        if (button(ui, "lab.stop", "Stop", Look::link, stop_help(lab))) stop_diagnosis(ui);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

/// The outcome of the last check of a file.
void draw_result_answer(Ui& ui) {
    const LabLook& lab = ui.lab;
    if (lab.answer) {
        draw_lab_answer(ui);
        return;
    }
    if (!lab.result_fault.empty()) {
        wrapped_text_in(colour_of(Meaning::fail, ui.options.theme), lab.result_fault);
        register_widget(
            ui, "lab.result.fault",
            "Why it could not be diagnosed. It will be tried again when the file changes.");
    }
    if (is_diagnosing(ui)) draw_progress(ui);
}

} // namespace

void draw_lab_result(Ui& ui) {
    const LabLook& lab = ui.lab;
    const bool is_asked = is_diagnosing(ui) || lab.answer || !lab.result_fault.empty();
    if (!is_asked) {
        draw_intro(ui);
        draw_file(ui, false);
        return;
    }
    // The answer is above the way to the next one, which stays in sight if there is room. So does
    // the line about the file, when the answer is scrolled.
    const auto draw_watch_line_if = [&](bool is_here) {
        if (lab.answer && is_here) draw_watch_line(ui);
    };
    draw_panel(ui, "result",
               {{[&] { draw_watch_line_if(!ui.inspector.has_card); }},
                {[&] { draw_result_answer(ui); }, true}},
               [&] {
                   draw_watch_line_if(ui.inspector.has_card);
                   draw_file(ui, true);
               });
}

} // namespace rasterwalk
