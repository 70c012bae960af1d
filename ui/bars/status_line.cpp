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
void add_colours_of_both(std::vector<std::string>& facts, const Ui& ui, std::size_t at) {
    const auto colour = [&](const char* run, const Framebuffer& picture) {
        const glm::vec3& c = picture.colour[at];
        return fmt::format("{} {:.3f} {:.3f} {:.3f}", run, c.r, c.g, c.b);
    };
    const float difference = ui.results.comparison.difference_values[at];
    facts.push_back(colour("A", *ui.results.a.framebuffer));
    facts.push_back(colour("B", *ui.results.b->framebuffer));
    facts.push_back(fmt::format("B − A {}{}", difference > 0.0f ? "+" : "",
                                fixed(static_cast<double>(difference), 4)));
}

/// All that is known of the pixel under the pointer, or else of the one picked; what comes first
/// matters most.
std::vector<std::string> pixel_facts(const Ui& ui) {
    const auto pixel =
        ui.canvas.hovered_pixel ? ui.canvas.hovered_pixel : ui.session.selection.pixel;
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    if (!pixel || !framebuffer.contains(pixel->x, pixel->y)) return {"point at a pixel"};
    const std::size_t at = framebuffer.at(pixel->x, pixel->y);
    std::vector<std::string> facts{fmt::format("pixel ({}, {})", pixel->x, pixel->y)};
    if (ui.results.b) {
        add_colours_of_both(facts, ui, at);
        return facts;
    }
    const int owner = framebuffer.owner[at];
    if (owner < 0) {
        facts.emplace_back("not drawn");
        return facts;
    }
    const glm::vec3& c = framebuffer.colour[at];
    facts.push_back(fmt::format("colour {:.3f} {:.3f} {:.3f}", c.r, c.g, c.b));
    const float depth = stored_depth(framebuffer, pixel->x, pixel->y);
    if (depth > 0.0f) {
        facts.push_back(
            fmt::format("1/z {:.4f}   z {:.4f}", depth, 1.0 / static_cast<double>(depth)));
    }
    facts.push_back(triangle_name(owner) + ", " + part_name(*ui.results.a.scene, owner));
    facts.push_back(counted(framebuffer.overdraw[at], "fragment", "fragments"));
    return facts;
}

/// As many facts of the pixel as have room, but at least where it is.
std::string pixel_words(const Ui& ui, float room) {
    std::string words;
    for (const std::string& fact : pixel_facts(ui)) {
        const std::string longer = words.empty() ? fact : words + "   " + fact;
        if (!words.empty() && text_width(longer) > room) break;
        words = longer;
    }
    return words;
}

/// Selects a triangle that has an edge sample outside its row table, and shows the table.
void show_sample_outside(Ui& ui, int triangle) {
    ui.session.selection.triangle = triangle;
    ui.session.selection.row = std::nullopt;
    open_tab(ui, "rows");
}

struct StatusTrouble {
    std::string text;     ///< empty: there is none
    std::string in_short; ///< the same where there is little room; or empty
    int triangle = -1;    ///< that shows it; -1: none does
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
        if (trouble.triangle >= 0) all.triangle = trouble.triangle;
    }
    if (all.text.empty()) return all;
    // The panels tell of one triangle, and of it what is done so far.
    all.text = (ui.results.a.has_all_troubles ? "whole frame: " : "so far: ") + all.text;
    return all;
}

constexpr const char* show_label = "show one";

/// The width that the trouble takes in short, with the space before it; nothing without trouble.
float least_trouble_width(const Ui& ui, const StatusTrouble& trouble) {
    if (trouble.text.empty()) return 0.0f;
    const float u = ui.options.text_scale;
    const float link = trouble.triangle >= 0 ? text_width(show_label) + 10.0f * u : 0.0f;
    return 24.0f * u + link +
           text_width(trouble.in_short.empty() ? trouble.text : trouble.in_short);
}

/// At the right end of the line.
void draw_trouble(Ui& ui, const Area& area, const StatusTrouble& trouble) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string action = trouble.triangle >= 0 ? show_label : "";
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
        name_widget(
            ui, "status.show_outside",
            "Rounding carries the end of a line one row too far: the table has no entry "
            "for it, and the sample is left out. With the lab's settings that is usual, and "
            "harms nothing. Selects the first such triangle, and shows its row table.");
        if (pressed) show_sample_outside(ui, trouble.triangle);
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
    const StatusTrouble trouble = trouble_of(ui);
    const float room = area.size.x - 28.0f * u - least_trouble_width(ui, trouble);
    text_in(p.dim, ui.options.is_lecture ? std::string() : pixel_words(ui, room));
    name_widget(ui, "status.pixel", "The pixel under the pointer, or the one that is picked.");
    if (!trouble.text.empty()) draw_trouble(ui, area, trouble);
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
