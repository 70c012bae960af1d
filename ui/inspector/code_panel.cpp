#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/actions/code.h"
#include "ui/inspector/code_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr const char* calls_arrow = "›";

/// How many of the calls, from outside, are left out so that the others fit into a line.
std::size_t calls_left_out(const std::vector<std::string>& functions, float width, float gap) {
    std::size_t first = functions.size();
    float used = 0.0f;
    while (first > 0) {
        used += text_width(functions[first - 1]) + (first < functions.size() ? gap : 0.0f);
        // The others are behind an ellipsis.
        if (used + (first > 1 ? gap + text_width("…") : 0.0f) > width) break;
        --first;
    }
    return std::min(first, functions.size() - 1);
}

/// The functions that are being carried out, from outside to inside; a click shows one.
void draw_calls(Ui& ui) {
    CodeLook& look = ui.code;
    const Palette& p = palette(ui.options.theme);
    const CodeMachine& machine = look.walk.machine();
    const std::vector<CodeCall> calls = machine.calls();
    if (calls.empty()) {
        text_in(p.dim, "Every triangle is drawn.");
        register_widget(ui, "code.ended");
        return;
    }
    std::vector<std::string> functions;
    for (const CodeCall& call : calls)
        functions.push_back(
            machine.program().functions[static_cast<std::size_t>(call.function)].name);
    const std::size_t shown = std::min(look.call.value_or(calls.size() - 1), calls.size() - 1);
    const float space = 6.0f * ui.options.text_scale;
    const float gap = text_width(calls_arrow) + 2.0f * space;
    const std::size_t first =
        std::min(shown, calls_left_out(functions, 0.94f * ImGui::GetContentRegionAvail().x, gap));
    if (first > 0) {
        if (button(ui, "code.callers", "…", Look::link, "The function that called the next one."))
            look.call = first - 1;
    }
    for (std::size_t i = first; i < calls.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0.0f, space);
            text_in(p.dim, calls_arrow);
            ImGui::SameLine(0.0f, space);
        }
        const std::string name = fmt::format("code.call.{}", i);
        if (i == shown) {
            put_text(functions[i], ui.fonts.bold);
            register_widget(ui, name, "Its lines are shown.", functions[i]);
        } else if (button(ui, name, functions[i], Look::link,
                          i < shown ? "Called the next one. Click to see where."
                                    : "Is being carried out. Click to see its lines.")) {
            look.call = i;
        }
    }
}

/// Steps through the lines.
void draw_code_buttons(Ui& ui) {
    if (is_code_running(ui)) {
        if (button(ui, "code.stop", "Stop", Look::main, "Stops where the code is now. Key: Esc"))
            stop_code(ui);
        ImGui::SameLine();
        text_in(palette(ui.options.theme).dim, "Running …");
        return;
    }
    if (button(ui, "code.back", "‹ line", Look::plain, "Back to the previous line.")) {
        step_code_back(ui);
    }
    ImGui::SameLine();
    if (button(ui, "code.step", "line ›", Look::main, "On to the next line, into functions too."))
        step_code(ui, CodeGoal::line);
    same_line_if_room("over");
    if (button(ui, "code.over", "over", Look::plain,
               "On to the next line of this function: what it calls is carried out at once."))
        step_code(ui, CodeGoal::over);
    same_line_if_room("out");
    if (button(ui, "code.out", "out", Look::plain,
               "On until this function has returned to the one that called it."))
        step_code(ui, CodeGoal::out);
    if (ui.code.conditions.empty()) return;
    same_line_if_room("Run");
    if (button(ui, "code.run", "Run", Look::plain, "On until the condition of a line holds."))
        run_code_to(ui, 0);
}

/// The condition of the line whose number was clicked.
void draw_condition(Ui& ui) {
    CodeLook& look = ui.code;
    if (!look.edited) return;
    LineCondition edited = *look.edited;
    ImGui::Spacing();
    put_text(fmt::format("Stop at line {} when", number_in_file(look, edited.file, edited.line)),
             ui.fonts.small);
    const bool is_known =
        std::any_of(look.conditions.begin(), look.conditions.end(), [&](const LineCondition& one) {
            return one.file == edited.file && one.line == edited.line;
        });
    const char* const other = is_known ? "Remove" : "Cancel";
    const float room = ImGui::GetContentRegionAvail().x;
    const float buttons =
        button_width("Set") + button_width(other) + 2.0f * ImGui::GetStyle().ItemSpacing.x;
    ImGui::PushFont(ui.fonts.mono_small);
    ImGui::SetNextItemWidth(std::max(room - buttons, 80.0f));
    bool is_set =
        ImGui::InputText("##condition", &look.edited->text, ImGuiInputTextFlags_EnterReturnsTrue);
    edited = *look.edited;
    ImGui::PopFont();
    register_widget(ui, "code.condition",
                    "A condition in C++, with the variables that are known at the line.");
    ImGui::SameLine();
    is_set = button(ui, "code.set", "Set", Look::plain, "Run stops at the line when it holds.") ||
             is_set;
    ImGui::SameLine();
    if (button(ui, "code.remove", other, Look::plain, "The line has no condition.")) {
        edited.text.clear();
        is_set = true;
    }
    if (is_set) set_line_condition(ui, edited);
    if (is_set && edited.text.empty()) look.edited = std::nullopt;
    if (look.condition_fault.empty()) return;
    wrapped_text_in(colour_of(Meaning::fail, ui.options.theme), look.condition_fault,
                    ui.fonts.small);
    register_widget(ui, "code.condition_fault", {}, look.condition_fault);
}

/// Why there is no code to be seen.
void draw_no_code(Ui& ui) {
    const CodeLook& look = ui.code;
    if (!look.fault.empty()) {
        wrapped_text_in(colour_of(Meaning::fail, ui.options.theme), look.fault);
        register_widget(ui, "code.fault", {}, look.fault);
    } else if (!look.walk.missing().empty()) {
        const std::string words =
            "There is no code yet for this picture: \"" + look.walk.missing() + "\".";
        wrapped_text(words);
        register_widget(ui, "code.missing", {}, words);
    } else {
        text_in(palette(ui.options.theme).dim, "The picture is being drawn …");
    }
}

} // namespace

void draw_code_panel(Ui& ui) {
    if (!ui.code.is_ready) {
        draw_no_code(ui);
        return;
    }
    const float u = ui.options.text_scale;
    draw_calls(ui);
    const float below = ImGui::GetFrameHeightWithSpacing() + 8.0f * u +
                        (ui.code.edited ? 3.0f * ImGui::GetFrameHeightWithSpacing() : 0.0f);
    draw_code_lines(ui, std::max(ImGui::GetContentRegionAvail().y - below, 90.0f * u));
    ImGui::Spacing();
    draw_code_buttons(ui);
    draw_condition(ui);
}

std::string code_subject(const Ui& ui) {
    const std::string place = code_place_text(ui);
    return place.empty() ? "line by line" : place;
}

} // namespace rasterwalk
