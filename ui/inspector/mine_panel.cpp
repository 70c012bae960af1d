#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/numbers.h"
#include "base/quoted.h"
#include "mine/compile/project_folder.h"
#include "mine/program_check.h"
#include "ui/actions/mine.h"
#include "ui/actions/view_files.h"
#include "ui/inspector/mine_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void introduce_check(Ui& ui) {
    wrapped_text("What is wrong with my program?", ui.fonts.bold);
    wrapped_text("Choose the .cpp file of your rasterizer, as it is. Rasterwalk compiles it, runs "
                 "it with the lab's room, and asks each of its functions our questions. Each time "
                 "you save it, it is checked again.");
    register_widget(ui, "mine.intro", "What can be checked, and how.");
    ImGui::Spacing();
    wrapped_text_in(palette(ui.options.theme).dim,
                    "It runs guarded: without a network, without writing files, and for a limited "
                    "time. To begin a new one: rasterwalk mine --new FOLDER",
                    ui.fonts.small);
    register_widget(ui, "mine.guarded",
                    "No view, lesson or link starts a program; only you do, and saving a program "
                    "that you have checked.");
    ImGui::Spacing();
}

/// The program of the last time: only a click starts it again.
void offer_last(Ui& ui) {
    const std::string path = visible_line(ui.options.program);
    if (path.empty()) return;
    const std::string label =
        shortened("Check " + file_name(path) + " again", ImGui::GetContentRegionAvail().x);
    if (button(ui, "mine.last", label, Look::main, "Checks " + path + "."))
        check_my_program(ui, std::string(ui.options.program));
}

/// The way to a program: a sheet, or its path.
/// @param another true if a program was checked before
void draw_choice(Ui& ui, bool another) {
    MineLook& mine = ui.mine;
    if (button(ui, "mine.choose", another ? "Another program …" : "Choose a program …",
               another || !ui.options.program.empty() ? Look::plain : Look::main,
               "Shows the folders and the files that can be checked.")) {
        begin_choosing_result(ui);
    }
    if (another) return;
    const float width = button_width("check") + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - width, 60.0f));
    const bool entered =
        ImGui::InputTextWithHint("##path", "or its path, or its folder's", &mine.typed,
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    register_widget(ui, "mine.path", "A .cpp file, or a folder with one program in it.");
    ImGui::SameLine();
    ImGui::BeginDisabled(mine.typed.empty());
    const bool pressed =
        button(ui, "mine.check", "check", Look::plain, "Checks this program. Key: Enter");
    ImGui::EndDisabled();
    if ((entered || pressed) && !mine.typed.empty()) check_my_program(ui, mine.typed);
}

std::string seconds_words(std::chrono::milliseconds time) {
    return decimals(static_cast<double>(time.count()) / 1000.0, 1) + " s";
}

/// What happens at the moment, in one line.
std::string doing_words(const MineLook& mine) {
    if (!mine.check && mine.is_wanted) return "Beginning …";
    if (mine.check) {
        const std::string doing = mine.check->doing();
        return (doing.empty() ? "Beginning" : doing) + " …";
    }
    if (!mine.fault.empty()) return "Not checked. Tried again when you save it.";
    if (mine.is_given_up) return "Stopped. Checked again when you save it.";
    if (mine.checked_at.empty()) return "Watching.";
    return fmt::format("Watching. Checked at {}.", mine.checked_at);
}

/// The program's name, what is being done, and how long it took.
void draw_program_name(Ui& ui) {
    const MineLook& mine = ui.mine;
    const Palette& p = palette(ui.options.theme);
    const std::string name = visible_line(file_name(mine.path));
    put_text(shortened(name, ImGui::GetContentRegionAvail().x), ui.fonts.bold);
    register_widget(ui, "mine.name", mine.path, name);
    ImGui::PushFont(ui.fonts.small);
    const std::string words = doing_words(mine);
    text_in(mine.check ? p.link : p.dim, words);
    register_widget(ui, "mine.state",
                    "The files of the program are watched: save one, and it is checked again.",
                    words);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(4.0f * ui.options.text_scale, ui.options.text_scale));
    ImGui::SameLine();
    if (is_checking_program(ui)) {
        if (button(ui, "mine.stop", "Stop", Look::link,
                   "Stops the check; what was found so far stays. Key: Esc")) {
            stop_program_check(ui);
        }
    } else if (button(ui, "mine.again", "Check again", Look::link,
                      "Compiles and runs the program once more.")) {
        check_my_program_again(ui);
    }
    ImGui::PopStyleVar();
    if (mine.last && mine.last->run && !mine.checked_at.empty() && !ui.inspector.is_low) {
        const std::string times = fmt::format(
            "compiled by {} in {}, ran for {}", mine.last->compiled.compiler,
            seconds_words(mine.last->compiled.time), seconds_words(mine.last->run->time));
        text_in(p.dim, shortened(times, ImGui::GetContentRegionAvail().x));
        register_widget(ui, "mine.times", "How long the last check took.", times);
    }
    ImGui::PopFont();
    ImGui::Spacing();
}

/// What has changed since the check before; what is wrong now that was right comes first.
void draw_changes(Ui& ui) {
    const MineLook& mine = ui.mine;
    if (mine.changes.empty()) return;
    for (std::size_t i = 0; i < mine.changes.size(); ++i) {
        const LineChange& change = mine.changes[i];
        wrapped_text_in(
            colour_of(change.is_better ? Meaning::pass : Meaning::fail, ui.options.theme),
            (change.is_better ? passed_sign : failed_sign) + (" " + change.text));
        register_widget(ui, fmt::format("mine.change.{}", i),
                        "What has changed since the check before this one.", change.text);
    }
    ImGui::Spacing();
}

/// The sign of a line, with its colour.
struct LineSign {
    const char* sign;
    ImVec4 ink;
};

LineSign sign_of(const Ui& ui, const CheckLine& line) {
    const Palette& p = palette(ui.options.theme);
    switch (line.state) {
    case CheckLineState::right:
        return {passed_sign, colour_of(Meaning::pass, ui.options.theme)};
    case CheckLineState::wrong:
        return {failed_sign, colour_of(Meaning::fail, ui.options.theme)};
    case CheckLineState::open:
        return {"–", p.dim};
    case CheckLineState::waiting:
        break;
    }
    return {"·", p.dim};
}

std::string line_name(const CheckLine& line) {
    std::string name = "mine.line." + line.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

void draw_check(Ui& ui, const CheckLine& line, bool is_chosen) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string name = line_name(line);
    if (ImGui::Selectable(("##" + name).c_str(), is_chosen)) ui.mine.chosen = line.name;
    const LineSign sign = sign_of(ui, line);
    register_widget(ui, name,
                    (line.words.empty() ? "" : line.words + "\n") +
                        std::string("Click to read what was found."),
                    line.count);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float right = at.x + ImGui::GetContentRegionAvail().x - 4.0f * u;
    const float left = at.x + 26.0f * u;
    list->AddText({at.x + 4.0f * u, at.y}, packed(sign.ink), sign.sign);
    const bool is_code = line.kind == CheckLineKind::function;
    ImFont* const font = is_code ? ui.fonts.mono : ui.fonts.text;
    const bool is_dim = line.state == CheckLineState::open || line.state == CheckLineState::waiting;
    const float width = text_width(line.count);
    ImGui::PushFont(font);
    const std::string shown = shortened(line.name, right - width - left - 8.0f * u);
    ImGui::PopFont();
    list->AddText(font, font->FontSize, {left, at.y}, packed(is_dim ? p.dim : p.text),
                  shown.c_str());
    const ImVec4& ink = line.state == CheckLineState::wrong ? sign.ink : p.dim;
    list->AddText({right - width, at.y}, packed(ink), line.count.c_str());
}

/// The line whose card is shown: the one that was clicked, or the first that is wrong.
std::size_t chosen_line(const MineLook& mine) {
    const auto found = std::find_if(mine.lines.begin(), mine.lines.end(),
                                    [&](const auto& line) { return line.name == mine.chosen; });
    if (found != mine.lines.end()) return static_cast<std::size_t>(found - mine.lines.begin());
    return first_wrong(mine.lines);
}

/// Scrolls a line to the top when it becomes the chosen one: its card is below it.
void bring_up(Ui& ui, const CheckLine& line) {
    MineLook& mine = ui.mine;
    const std::string now = line.name + (line.state == CheckLineState::wrong ? "!" : "");
    if (mine.brought_up == now) return;
    mine.brought_up = now;
    // Where nothing is wrong, the list itself is the answer.
    if (line.state != CheckLineState::wrong && mine.chosen.empty()) return;
    ImGui::SetScrollFromPosY(ImGui::GetItemRectMin().y - ImGui::GetWindowPos().y, 0.0f);
}

/// The list, and what is known of the chosen line: below the list, or, where lines are few, below
/// that line.
void draw_checks(Ui& ui) {
    const MineLook& mine = ui.mine;
    const std::size_t chosen = chosen_line(mine);
    const bool is_inside = !ui.inspector.has_card;
    for (std::size_t i = 0; i < mine.lines.size(); ++i) {
        draw_check(ui, mine.lines[i], i == chosen);
        if (i != chosen || !is_inside) continue;
        bring_up(ui, mine.lines[i]);
        draw_line_card(ui, *mine.last, mine.lines[i]);
    }
    ImGui::Spacing();
    if (!is_inside) draw_line_card(ui, *mine.last, mine.lines[chosen]);
}

/// Nothing was found, and everything has been looked at.
void draw_praise(Ui& ui) {
    const MineLook& mine = ui.mine;
    if (!mine.is_whole || !mine.last->is_right()) return;
    const std::string words(right_words);
    wrapped_text_in(colour_of(Meaning::pass, ui.options.theme), words, ui.fonts.bold);
    register_widget(ui, "mine.right",
                    "What is not written yet is not wrong. What is equally right, such as another "
                    "way to round, is not wrong either.",
                    words);
    ImGui::Spacing();
}

void draw_fault(Ui& ui) {
    const MineLook& mine = ui.mine;
    if (mine.fault.empty()) return;
    wrapped_text_in(colour_of(Meaning::fail, ui.options.theme), mine.fault);
    register_widget(ui, "mine.fault", "It is tried again when a file of the program changes.",
                    mine.fault);
    ImGui::Spacing();
}

} // namespace

void draw_mine_panel(Ui& ui) {
    const MineLook& mine = ui.mine;
    if (ui.host.is_browser) {
        wrapped_text("A browser has no compiler, so your own program can only be checked in "
                     "Rasterwalk on the desktop. A picture that it saved, or rows that it "
                     "printed, can be checked here, under Mistakes.");
        register_widget(ui, "mine.browser");
        return;
    }
    if (mine.path.empty()) {
        introduce_check(ui);
        offer_last(ui);
        draw_choice(ui, false);
        return;
    }
    draw_program_name(ui);
    draw_fault(ui);
    if (mine.last) {
        draw_changes(ui);
        draw_praise(ui);
        draw_checks(ui);
    }
    draw_choice(ui, true);
}

} // namespace rasterwalk
