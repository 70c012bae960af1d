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
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The pixel's colours in both runs, and how much they differ.
std::string colours_of_both(const Ui& ui, std::size_t at) {
    const RunResults& b = *ui.results.b;
    const ComparisonResults& comparison = ui.results.comparison;
    const auto colour = [&](const char* run, const Framebuffer& picture) {
        const glm::vec3& c = picture.colour[at];
        return fmt::format("   {} {:.3f} {:.3f} {:.3f}", run, c.r, c.g, c.b);
    };
    const float difference = comparison.difference_values[at];
    return fmt::format("{}{}   B − A {}{}", colour("A", *ui.results.a.framebuffer),
                       colour("B", *b.framebuffer), difference > 0.0f ? "+" : "",
                       fixed(static_cast<double>(difference), 4));
}

/// All that is known of the pixel under the pointer, or else of the one picked.
std::string describe_pixel(const Ui& ui) {
    const auto pixel =
        ui.canvas.hovered_pixel ? ui.canvas.hovered_pixel : ui.session.selection.pixel;
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    if (!pixel || !framebuffer.contains(pixel->x, pixel->y)) return "point at a pixel";
    const std::size_t at = framebuffer.at(pixel->x, pixel->y);
    std::string words = fmt::format("pixel ({}, {})", pixel->x, pixel->y);
    if (ui.results.b) return words + colours_of_both(ui, at);
    const int owner = framebuffer.owner[at];
    if (owner < 0) return words + "   not drawn";
    const glm::vec3& c = framebuffer.colour[at];
    words += fmt::format("   colour {:.3f} {:.3f} {:.3f}", c.r, c.g, c.b);
    const float depth = stored_depth(framebuffer, pixel->x, pixel->y);
    if (depth > 0.0f) {
        words += fmt::format("   1/z {:.4f}   z {:.4f}", depth, 1.0 / static_cast<double>(depth));
    }
    return fmt::format("{}   {}, {}   {}", words, triangle_name(owner),
                       part_name(*ui.results.a.scene, owner),
                       counted(framebuffer.overdraw[at], "fragment", "fragments"));
}

/// Selects the first triangle that has an edge sample outside its row table, and shows the table.
void show_sample_outside(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const std::vector<OutsideSample> outside = rows_at_cursor(frame, t, cursor_end).outside;
        if (outside.empty()) continue;
        ui.session.selection.triangle = t;
        ui.session.selection.row = std::nullopt;
        open_tab(ui, "rows");
        return;
    }
}

struct StatusTrouble {
    std::string text;                 ///< empty: there is none
    std::string in_short;             ///< the same where there is little room; or empty
    bool has_samples_outside = false; ///< which can be shown
};

StatusTrouble trouble_of(const Ui& ui) {
    if (!ui.session.notice.empty()) return {ui.session.notice, {}};
    if (!ui.fonts.notice.empty()) return {ui.fonts.notice, {}};
    if (is_working(ui.results)) return {work_words(ui.results), {}};
    // What a message says may be the answer.
    if (hides_settings(ui.session)) return {};
    // Of row tables nothing is told before there are any, nor in a lesson that comes before them.
    const bool knows_rows = ui.results.a.frame.settings.stage >= Stage::rows &&
                            is_offered(ui.session, *find_tab("rows"));
    StatusTrouble all;
    for (const Trouble& trouble : ui.results.a.troubles) {
        if (trouble.is_of_rows && !knows_rows) continue;
        all.text += (all.text.empty() ? "" : "; ") + trouble.sentence;
        all.in_short += (all.in_short.empty() ? "" : "; ") + trouble.in_short;
        all.has_samples_outside = all.has_samples_outside || trouble.is_of_samples_outside;
    }
    if (all.text.empty()) return all;
    // The panels tell of one triangle, and of it what is done so far.
    all.text = (ui.results.a.has_all_troubles ? "whole frame: " : "so far: ") + all.text;
    return all;
}

/// At the right end of the line.
void draw_trouble(Ui& ui, const Area& area, const StatusTrouble& trouble) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    // That it is nothing to be afraid of comes before the rest of the line is cut.
    const std::string action = trouble.has_samples_outside ? "harmless: show one" : "";
    const float gap = action.empty() ? 0.0f : 10.0f * u;
    const float link = action.empty() ? 0.0f : text_width(action) + gap;
    const float left = ImGui::GetItemRectMax().x + 24.0f * u;
    const float right = area.position.x + area.size.x - 14.0f * u;
    const float room = right - link - left;
    const bool is_whole = trouble.in_short.empty() || text_width(trouble.text) <= room;
    const std::string words = shortened(is_whole ? trouble.text : trouble.in_short, room);
    const float width = text_width(words) + link;
    const float y = ImGui::GetItemRectMin().y;
    ImGui::SetCursorScreenPos({std::max(right - width, left), y});
    ImGui::PushClipRect({left, area.position.y}, {right, area.position.y + area.size.y}, true);
    // What was caught is no fault of the student's: only what could not be done stands out.
    const bool is_notice = !ui.session.notice.empty() || !ui.fonts.notice.empty();
    const ImVec4 colour = !is_notice ? p.dim
                          : is_fault(ui.session) || ui.session.notice.empty()
                              ? colour_of(Meaning::fail, ui.options.theme)
                              : p.text;
    text_in(colour, words);
    const char* const about =
        is_notice ? ""
        : is_working(ui.results)
            ? "\nIt is too much work for one frame of the window, and goes on."
            : "\nThe program guards against this and goes on; lesson 12 tells why it happens.";
    name_widget(ui, "status.trouble", trouble.text + about);
    if (!action.empty()) {
        const float x = ImGui::GetItemRectMax().x + gap;
        ImGui::SetCursorScreenPos({x, y});
        const ImVec2 size = ImGui::CalcTextSize(action.c_str());
        const bool pressed = ImGui::InvisibleButton("show", size);
        ImGui::GetWindowDrawList()->AddText({x, y}, packed(p.link), action.c_str());
        name_widget(ui, "status.show_outside",
                    "Nothing is drawn wrong by them: a line that rounding carries one row too far "
                    "is cut off there. Selects the first such triangle, and shows its row table.");
        if (pressed) show_sample_outside(ui);
    }
    ImGui::PopClipRect();
}

} // namespace

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
    text_in(p.dim, ui.options.is_lecture ? std::string() : describe_pixel(ui));
    name_widget(ui, "status.pixel", "The pixel under the pointer, or the one that is picked.");
    const StatusTrouble trouble = trouble_of(ui);
    if (!trouble.text.empty()) draw_trouble(ui, area, trouble);
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
