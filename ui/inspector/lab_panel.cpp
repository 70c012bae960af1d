#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "laboratory/bug_rule.h"
#include "text/markdown_text.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/inspector/lab_parts.h"
#include "ui/inspector/panels.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Everything there is to say about a mistake.
std::string page_of(Ui& ui, const Bug& bug) {
    return as_markdown(bug.sentence) + "\n\n**Symptom.** " + as_markdown(bug.symptom) + "\n\n" +
           remedy_of(ui, bug);
}

void draw_line(Ui& ui, const Bug& bug) {
    const Palette& p = palette(ui.options.theme);
    const bool on = is_on(ui.session, bug.id);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string name = "lab." + bug.id;
    if (ImGui::Selectable(("##" + name).c_str(), ui.lab.chosen == bug.id)) ui.lab.chosen = bug.id;
    // If the card opens below the line, the second click would fall on something else.
    const bool can_double = ui.inspector.has_card;
    const bool is_double = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    if (can_double && is_double) turn_on(ui, bug, false);
    const bool is_made = !on && is_made_by(bug, ui.session.a.settings);
    keep_selectable_whole();
    register_widget(ui, name,
                    bug.sentence +
                        (is_made ? "\nRun A makes this mistake with its current "
                                   "settings."
                                 : "") +
                        "\nClick to read about it." +
                        (!can_double ? ""
                         : is_made   ? " Double click to compare it with the cure."
                                     : " Double click to turn it on."));
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec4& ink = on ? colour_of(Meaning::fail, ui.options.theme) : p.dim;
    // The highlight behind the chosen line begins before its first letter.
    const float before = 4.0f * u;
    list->AddText(ui.fonts.mono, ui.fonts.mono->FontSize, {at.x + before, at.y}, packed(ink),
                  bug.id.c_str());
    const float left = at.x + before + 52.0f * u;
    const std::string state = on ? "on" : is_made ? "as it is" : "";
    const float width = ImGui::CalcTextSize(state.c_str()).x + before;
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    const float room = right - left - std::max(width, 26.0f * u) - 4.0f * u;
    list->AddText({left, at.y}, packed(p.text), shortened(bug.name, room).c_str());
    list->AddText({right - width, at.y}, packed(ink), state.c_str());
    register_text(ui, name, state);
}

/// The title of a section of the lab.
void draw_section(Ui& ui, const std::string& section) {
    text_in(palette(ui.options.theme).dim, section, ui.fonts.small);
    // Together with the first line below it.
    const float line = ImGui::GetTextLineHeight();
    keep_beginning(ImGui::GetItemRectMin().y, ImGui::GetCursorScreenPos().y + line);
}

/// In a low page the buttons come first: they must be in sight.
void draw_buttons(Ui& ui, const Bug& bug) {
    if (is_on(ui.session, bug.id)) {
        if (button(ui, "lab.off", "turn off", Look::main,
                   "Goes back to one run and to the previous settings.")) {
            end_comparison(ui.session);
        }
    } else {
        const bool is_made = is_made_by(bug, ui.session.a.settings);
        const char* const cure = ui.inspector.is_narrow ? "compare" : "compare with the cure";
        if (button(ui, "lab.on", is_made ? cure : "turn on", Look::plain,
                   is_made ? "Run A makes the mistake already; run B is the correct one."
                           : "Makes the mistake in run A, and compares it with the correct run "
                             "B.")) {
            turn_on(ui, bug, false);
        }
    }
    ImGui::SameLine();
    if (button(ui, "lab.scene", ui.inspector.is_narrow ? "its scene" : "on its own scene",
               Look::plain,
               "Opens the scene that shows it best, and turns it on there: " + bug.scene)) {
        turn_on(ui, bug, true);
    }
}

void draw_card(Ui& ui, const Bug& bug) {
    begin_card(ui);
    put_text(bug.id + "  " + bug.name, ui.fonts.bold);
    draw_buttons(ui, bug);
    if (!is_on(ui.session, bug.id) && is_made_by(bug, ui.session.a.settings)) {
        wrapped_text_in(palette(ui.options.theme).dim,
                        "Already on: the current settings make this mistake.");
        register_widget(ui, "lab.made", "Nothing needs to be turned on to see this mistake.");
    }
    const float width = ImGui::CalcItemWidth();
    const MarkdownEvents events =
        draw_markdown(ui, ui.lab.page, page_of(ui, bug), width, "lab.link.");
    answer_links(ui, document_of(*ui.lab.page), events);
    end_card(ui);
}

/// Shows a mistake that was turned on elsewhere, for example by the command line or by undo.
void follow_bug_on(Ui& ui) {
    const Session& session = ui.session;
    const std::string on = session.b && session.replaced ? session.replaced->bug : std::string();
    if (on != ui.lab.was_on && !on.empty()) ui.lab.chosen = on;
    ui.lab.was_on = on;
}

void draw_bugs(Ui& ui) {
    const std::vector<Bug>& bugs = lab_bugs(ui);
    follow_bug_on(ui);
    const Bug* const found = bug_of_id(bugs, ui.lab.chosen);
    const Bug& chosen = found != nullptr ? *found : bugs.front();
    // Where lines are few the list has the card in it: two scrolls would each show next to nothing.
    const float below = ui.inspector.has_card ? 0.0f : height_of_card_head();
    std::vector<PanelBlock> lines;
    for (std::size_t i = 0; i < bugs.size(); ++i) {
        const Bug& bug = bugs[i];
        if (i == 0 || bug.section != bugs[i - 1].section) {
            if (i > 0) lines.push_back({ImGui::Spacing});
            lines.push_back({[&ui, &bug] { draw_section(ui, bug.section); }});
        }
        const bool is_chosen = &bug == &chosen;
        const auto draw = [&ui, &bug, is_chosen, below] {
            draw_line(ui, bug);
            if (is_chosen) keep_in_sight(ui, bug, below);
        };
        lines.push_back({draw, is_chosen});
    }
    draw_panel(ui, "lab", lines, [&] { draw_card(ui, chosen); });
}

void draw_modes(Ui& ui) {
    const struct {
        LabMode mode;
        const char* name;
        const char* title;
        const char* help;
    } modes[] = {
        {LabMode::bugs, "lab.mode.bugs", "Make one",
         "The mistakes that rasterizers make, each to be turned on."},
        {LabMode::quiz, "lab.mode.quiz", "Guess one",
         "The program makes a mistake and hides the settings. You find out which one it is."},
        {LabMode::result, "lab.mode.result",
         ui.inspector.is_narrow ? "Check mine" : "Check my picture",
         "A picture or a printed row table of your own program, and what may be wrong with it."}};
    ImGui::PushFont(ui.fonts.small);
    for (const auto& mode : modes) {
        if (mode.mode != LabMode::bugs) ImGui::SameLine(0.0f, 0.0f);
        if (button(ui, mode.name, mode.title, ui.lab.mode == mode.mode ? Look::chosen : Look::plain,
                   mode.help)) {
            ui.lab.mode = mode.mode;
        }
    }
    ImGui::PopFont();
}

} // namespace

std::string remedy_of(Ui& ui, const Bug& bug) {
    std::string text = "**Where to look.** " + bug.look;
    if (!bug.code.empty()) text.append("\n\n```cpp\n").append(bug.code).append("\n```");
    text.append("\n\n**Cure.** ").append(as_markdown(bug.cure)).append("\n");
    const Lesson* const lesson = ui.lesson.lessons.find(bug.lesson);
    if (lesson == nullptr) return text;
    return text.append(
        fmt::format("\n**Lesson {}.** {}\n", lesson_number(lesson->id), link_to_lesson(*lesson)));
}

void keep_in_sight(Ui& ui, const Bug& chosen, float below) {
    LabLook& lab = ui.lab;
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    const bool is_new = lab.in_sight != chosen.id || lab.bottom != bottom;
    lab.in_sight = chosen.id;
    lab.bottom = bottom;
    const bool is_seen =
        ImGui::GetItemRectMin().y >= top && ImGui::GetItemRectMax().y + below <= bottom;
    if (!is_new || is_seen) return;
    if (below > 0.0f) {
        // Nothing of the line above remains visible.
        ImGui::SetScrollFromPosY(ImGui::GetItemRectMin().y - top, 0.0f);
    } else {
        scroll_here(0.8f);
    }
}

float height_of_card_head() {
    return 2.0f * ImGui::GetFrameHeightWithSpacing() + ImGui::GetFrameHeight();
}

void draw_lab_panel(Ui& ui) {
    if (lab_bugs(ui).empty()) {
        wrapped_text(ui.lab.fault.empty() ? "There are no mistakes to show." : ui.lab.fault);
        return;
    }
    // The list must not give away the answer of a running quiz.
    if (ui.session.quiz && ui.lab.mode == LabMode::bugs) ui.lab.mode = LabMode::quiz;
    draw_modes(ui);
    ImGui::Spacing();
    switch (ui.lab.mode) {
    case LabMode::bugs:
        draw_bugs(ui);
        break;
    case LabMode::quiz:
        draw_lab_quiz(ui);
        break;
    case LabMode::result:
        draw_lab_result(ui);
        break;
    }
}

} // namespace rasterwalk
