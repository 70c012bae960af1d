#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "session/tabs.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_tab.h"
#include "ui/bars/bars.h"
#include "ui/bars/pixel_words.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Selects a triangle that has an edge sample outside its row table, and shows the table.
void show_sample_outside(Ui& ui, int triangle) {
    ui.session.selection.triangle = triangle;
    ui.session.selection.row = std::nullopt;
    open_tab(ui, "rows");
}

struct StatusWarning {
    std::string text;         ///< empty: there is none
    std::string in_short;     ///< the same where there is little room; or empty
    int triangle = -1;        ///< one that shows it; -1: none does
    std::vector<int> lessons; ///< numbers of the lessons that explain why it happens
};

/// "; lesson 12 explains why it happens": a clause, or nothing.
std::string lesson_words(const std::vector<int>& lessons) {
    if (lessons.empty()) return "";
    std::string words = lessons.size() == 1 ? "; lesson " : "; lessons ";
    for (std::size_t i = 0; i < lessons.size(); ++i)
        words += (i == 0                   ? ""
                  : i + 1 < lessons.size() ? ", "
                                           : " and ") +
                 std::to_string(lessons[i]);
    return words + (lessons.size() == 1 ? " explains why it happens" : " explain why it happens");
}

StatusWarning warnings_of(const Ui& ui) {
    if (!ui.session.notice.empty()) return {ui.session.notice, {}, -1, {}};
    if (!ui.fonts.notice.empty()) return {ui.fonts.notice, {}, -1, {}};
    if (is_working(ui.results)) return {work_words(ui.results), {}, -1, {}};
    // A message may give away the answer.
    if (hides_settings(ui.session)) return {};
    // Row tables are not mentioned before they exist, nor in a lesson that comes before them.
    const bool knows_rows = ui.results.a.frame.settings.stage >= Stage::rows &&
                            is_offered(ui.session, *find_tab("rows"));
    StatusWarning all;
    for (const Warning& warning : ui.results.a.warnings) {
        if (warning.is_of_rows && !knows_rows) continue;
        all.text += (all.text.empty() ? "" : "; ") + warning.sentence;
        all.in_short += (all.in_short.empty() ? "" : "; ") + warning.in_short;
        if (warning.triangle >= 0) all.triangle = warning.triangle;
        const bool is_new =
            std::find(all.lessons.begin(), all.lessons.end(), warning.lesson) == all.lessons.end();
        if (warning.lesson > 0 && is_new) all.lessons.push_back(warning.lesson);
    }
    if (all.text.empty()) return all;
    std::sort(all.lessons.begin(), all.lessons.end());
    // The panels, by contrast, show one triangle, and only as far as it is drawn.
    all.text = (ui.results.a.has_all_warnings ? "whole frame: " : "so far: ") + all.text;
    return all;
}

constexpr const char* show_label = "show one";

/// The width of the trouble in its short form, with the space before it; 0 without trouble.
float least_warning_width(const Ui& ui, const StatusWarning& warning) {
    if (warning.text.empty()) return 0.0f;
    const float u = ui.options.text_scale;
    const float link = warning.triangle >= 0 ? text_width(show_label) + 10.0f * u : 0.0f;
    return 24.0f * u + link +
           text_width(warning.in_short.empty() ? warning.text : warning.in_short);
}

/// At the right end of the line.
void draw_warning(Ui& ui, const Area& area, const StatusWarning& warning) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string action = warning.triangle >= 0 ? show_label : "";
    const float gap = action.empty() ? 0.0f : 10.0f * u;
    const float link = action.empty() ? 0.0f : text_width(action) + gap;
    const float left = ImGui::GetItemRectMax().x + 24.0f * u;
    const float right = area.position.x + area.size.x - 14.0f * u;
    const float room = right - link - left;
    const bool is_whole = warning.in_short.empty() || text_width(warning.text) <= room;
    const std::string words = shortened(is_whole ? warning.text : warning.in_short, room);
    const float width = text_width(words) + link;
    const float y = ImGui::GetItemRectMin().y;
    ImGui::SetCursorScreenPos({std::max(right - width, left), y});
    ImGui::PushClipRect({left, area.position.y}, {right, area.position.y + area.size.y}, true);
    // A guarded trouble is not the student's fault: only what could not be done stands out.
    const bool is_notice = !ui.session.notice.empty() || !ui.fonts.notice.empty();
    const ImVec4 colour = !is_notice ? p.dim
                          : is_fault(ui.session) || ui.session.notice.empty()
                              ? colour_of(Meaning::fail, ui.options.theme)
                              : p.text;
    text_in(colour, words);
    const std::string about =
        is_notice ? ""
        : is_working(ui.results)
            ? "\nThis is too much work for one frame of the window, so it is spread over several."
            : "\nThe program guards against this and goes on" + lesson_words(warning.lessons) + ".";
    register_widget(ui, "status.trouble", warning.text + about, words);
    if (!action.empty()) {
        const float x = ImGui::GetItemRectMax().x + gap;
        ImGui::SetCursorScreenPos({x, y});
        const ImVec2 size = ImGui::CalcTextSize(action.c_str());
        const bool pressed = ImGui::InvisibleButton("show", size);
        ImGui::GetWindowDrawList()->AddText({x, y}, packed(p.link), action.c_str());
        register_widget(
            ui, "status.show_outside",
            "Rounding carries the end of a line one row too far. The table has no entry for that "
            "row, so the sample is left out. With the lab's settings this is normal and does no "
            "harm. Click to select the first such triangle and see its row table.");
        if (pressed) show_sample_outside(ui, warning.triangle);
    }
    ImGui::PopClipRect();
}

} // namespace

bool spares_status_line(const Ui& ui) {
    return ui.options.is_lecture || is_low(ImGui::GetIO().DisplaySize, ui.options);
}

void draw_status_line(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.ground);
    ImGui::PushFont(ui.fonts.small);
    ImGui::Begin("status", nullptr, panel_flags);
    ImGui::SetCursorScreenPos({area.position.x + 14.0f * u,
                               area.position.y + 0.5f * (area.size.y - ImGui::GetFontSize())});
    const StatusWarning warning = warnings_of(ui);
    const float room = area.size.x - 28.0f * u - least_warning_width(ui, warning);
    const bool has_pixel = !spares_status_line(ui);
    text_in(p.dim, has_pixel ? pixel_words(ui, room) : std::string());
    if (has_pixel) {
        register_widget(ui, "status.pixel",
                        "The pixel under the pointer, or the one that is picked.");
    }
    if (!warning.text.empty()) draw_warning(ui, area, warning);
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
