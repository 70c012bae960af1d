#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "engines/processor.h"
#include "ui/actions/actions.h"
#include "ui/actions/measure.h"
#include "ui/inspector/panels.h"
#include "ui/inspector/speed_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What is measured: the longest form first.
std::vector<std::string> subject_forms(const Session& session) {
    const Viewport size = session.a.settings.viewport;
    const std::string pixels = fmt::format("{} × {}", size.width, size.height);
    return {session.scene->name + ", " + pixels, pixels, ""};
}

/// Title, what is measured, and the button.
void draw_ladder_title(Ui& ui) {
    const bool is_running = is_measuring(ui);
    const bool is_possible = obstacle_to_measuring(ui).empty();
    const bool has_times = !shown_times(ui).rungs.empty();
    const char* const label = is_running ? "Stop" : has_times ? "Measure again" : "Measure";
    const float right = right_end();
    const float room = is_possible ? right - button_width(label) : right;
    ImGui::AlignTextToFramePadding();
    put_text("The ladder", ui.fonts.bold);
    ImGui::SameLine(0.0f, 10.0f * ui.options.text_scale);
    ImGui::AlignTextToFramePadding();
    const std::vector<std::string> forms = subject_forms(ui.session);
    const float left = room - ImGui::GetCursorScreenPos().x - ImGui::GetStyle().ItemSpacing.x;
    text_in(palette(ui.options.theme).dim, first_fitting(forms, left));
    register_widget(ui, "speed.subject", "The scene and the size of the picture: " + forms.front());
    if (!is_possible) return;
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({room, ImGui::GetCursorScreenPos().y});
    if (is_running) {
        if (button(ui, "speed.stop", label, Look::plain,
                   "Stops measuring. The times so far stay if each rung has been measured. Key: "
                   "Esc")) {
            stop_measuring(ui);
        }
    } else if (button(ui, "speed.measure", label, has_times ? Look::plain : Look::main,
                      fmt::format("Draws the picture {} times on each rung, taking turns, on this "
                                  "machine.",
                                  ui.ladder.rounds))) {
        measure_ladder(ui);
    }
}

/// How far the measurement is, or what the times are.
std::string status_words(const Ui& ui) {
    const LadderTimes& times = shown_times(ui);
    if (is_measuring(ui)) {
        return times.rungs.empty() || times.rungs.back().from_previous.pixels == 0
                   ? "Comparing the pictures …"
                   : fmt::format("Round {} of {}", std::min(times.rounds + 1, ui.ladder.rounds),
                                 ui.ladder.rounds);
    }
    if (!ui.ladder.fault.empty()) return ui.ladder.fault;
    if (times.rungs.empty())
        return "Not measured on this machine yet. Click a rung to see what it changes.";
    return "Bars show what each rung gained, by the median of " +
           counted(times.rounds, "round", "rounds") + ".";
}

void draw_status(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const std::string words = status_words(ui);
    wrapped_text_in(p.dim, words, ui.fonts.small);
    register_widget(ui, "speed.status",
                    "All rungs take turns, a picture each, so whatever else the machine does "
                    "affects all of them. The scale multiplies: bars of equal length are equal "
                    "factors.",
                    words);
    // The place of the bar stays when it is over, so that nothing jumps.
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = 3.0f * ui.options.text_scale;
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, height});
    if (!is_measuring(ui)) return;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(at, {at.x + width, at.y + height}, packed(p.line));
    list->AddRectFilled(at, {at.x + shown_times(ui).share * width, at.y + height},
                        packed(p.accent));
    register_widget(ui, "speed.progress", "How much of the measurement is done.");
}

/// Why it cannot be measured, and what to do about it.
void draw_obstacle(Ui& ui) {
    const std::string& obstacle = obstacle_to_measuring(ui);
    wrapped_text_in(palette(ui.options.theme).dim, obstacle);
    register_widget(ui, "speed.obstacle",
                    "The rungs are short, so they draw only triangles with one lamp's light.",
                    obstacle);
    if (ui.session.quiz || ui.session.a.settings.stage == Stage::shade) return;
    if (button(ui, "speed.light", "Draw with light", Look::plain,
               "Goes to the stage with light at each pixel, which the ladder draws.")) {
        set_step(ui.session.a.settings, {Stage::shade, Shading::phong});
    }
}

void draw_foot(Ui& ui, const LadderTimes& times) {
    if (times.rungs.empty()) return;
    ImGui::Spacing();
    const int count = processor_count();
    wrapped_text_in(palette(ui.options.theme).dim,
                    "Measured on " +
                        (ui.ladder.processor.empty() ? "this machine" : ui.ladder.processor) +
                        ". Other programs that run at the same time make it slower.",
                    ui.fonts.small);
    register_widget(ui, "speed.foot",
                    "This processor runs " + counted(count, "thread", "threads") +
                        " at the same time. A rung with one thread is timed by that thread's "
                        "processor time where the system has it, a rung with two by elapsed time.",
                    ui.ladder.processor);
}

void draw_heading(Ui& ui, const char* words, const char* name, const char* help) {
    ImGui::Spacing();
    text_in(palette(ui.options.theme).dim, words, ui.fonts.small);
    register_widget(ui, name, help);
    // Together with the first line below it.
    keep_beginning(ImGui::GetItemRectMin().y,
                   ImGui::GetCursorScreenPos().y + ImGui::GetTextLineHeight());
}

} // namespace

void draw_speed_panel(Ui& ui) {
    draw_ladder_title(ui);
    if (!obstacle_to_measuring(ui).empty()) {
        draw_obstacle(ui);
    } else {
        draw_status(ui);
    }
    const LadderTimes& times = shown_times(ui);
    std::vector<PanelBlock> blocks{{[&] { draw_time_scale(ui, times); }}};
    for (std::size_t i = 0; i < rung_count(); ++i) {
        if (i == ladder().size()) {
            blocks.push_back({[&] {
                draw_heading(ui, "Wrong turnings", "speed.wrong",
                             "Changes that look good and make a rung slower, or its picture "
                             "wrong.");
            }});
        }
        blocks.push_back({[&ui, &times, i] { draw_rung(ui, times, i); }, i == ui.ladder.chosen});
        if (i + 1 == ladder().size()) blocks.push_back({[&] { draw_all_rungs(ui, times); }});
    }
    blocks.push_back({[&] { draw_foot(ui, times); }});
    draw_panel(ui, "speed", blocks, [&] { draw_rung_card(ui, times); });
}

} // namespace rasterwalk
