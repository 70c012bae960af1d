#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/actions/actions.h"
#include "ui/actions/lecture.h"
#include "ui/actions/open_tab.h"
#include "ui/bars/bars.h"
#include "ui/bars/menus.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A button at the right end of the menu.
struct Corner {
    const char* name;
    const char* label;
    const char* action;
    bool enabled;
    int rank; ///< 0 is the last to go; those of the same rank go together
};

std::array<Corner, 6> corners_of(const Ui& ui) {
    const Session& s = ui.session;
    return {{{"corner.back", "‹ back", "go.back", !s.places.past.empty(), 3},
             {"corner.forward", "forward ›", "go.forward", !s.places.future.empty(), 3},
             {"corner.undo", "undo", "edit.undo", !s.undo.past.empty(), 0},
             {"corner.redo", "redo", "edit.redo", !s.undo.future.empty(), 1},
             {"text.smaller", "A−", "view.smaller_text", true, 2},
             {"text.larger", "A+", "view.larger_text", true, 2}}};
}

/// If there is not room for all buttons, the most needed stay: undo before redo, and both before
/// the rest.
struct CornerRoom {
    int ranks = 0;      ///< shown
    float width = 0.0f; ///< of their buttons, screen pixels
};

CornerRoom fitting_corners(const Ui& ui, float room, int most_ranks) {
    CornerRoom fitting;
    for (; fitting.ranks < most_ranks; ++fitting.ranks) {
        float wider = fitting.width;
        for (const Corner& corner : corners_of(ui)) {
            if (corner.rank != fitting.ranks) continue;
            wider += button_width(tr(corner.label)) + ImGui::GetStyle().ItemSpacing.x;
        }
        if (wider > room) break;
        fitting.width = wider;
    }
    return fitting;
}

constexpr int all_ranks = 4;

/// Undo and redo, since the menus have the rest; on the start page, where no stages need the room,
/// the size of the text too.
int ranks_of_narrow(const Ui& ui) {
    return ui.start.is_open ? 3 : 2;
}

/// Draws them at the right end of the room left on the line.
void draw_corner_buttons(Ui& ui, int most_ranks) {
    const float room = ImGui::GetContentRegionAvail().x;
    const CornerRoom fitting = fitting_corners(ui, room, most_ranks);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - fitting.width);
    for (const Corner& corner : corners_of(ui)) {
        if (corner.rank >= fitting.ranks) continue;
        ImGui::BeginDisabled(!corner.enabled);
        if (button(ui, corner.name, tr(corner.label), Look::quiet, tooltip_of(corner.action))) {
            find_action(corner.action).run(ui);
        }
        ImGui::EndDisabled();
        ImGui::SameLine();
    }
}

/// How to leave a lecture, as long as there is room for it.
std::string leaving_words(float room) {
    for (const char* words : {tr("Esc ends the lecture"), tr("Esc ends it")}) {
        if (button_width(words) <= room) return words;
    }
    return tr("Esc");
}

float gear_width(const Ui& ui) {
    return std::round(44.0f * ui.options.text_scale);
}

/// The room that a narrow window has for the buttons between the gear and the stages (or the name
/// in their place), screen pixels.
float corner_room(const Ui& ui, float window_width) {
    const float strip =
        ui.start.is_open ? text_width(ui.fonts.bold, "Rasterwalk") : least_strip_width(ui);
    return window_width - menu_button_width(ui.options.text_scale) - gear_width(ui) - strip;
}

float corner_width(const Ui& ui, float window_width) {
    const float room = corner_room(ui, window_width);
    return ui.options.is_lecture
               ? button_width(leaving_words(room)) + ImGui::GetStyle().ItemSpacing.x
               : fitting_corners(ui, room, ranks_of_narrow(ui)).width;
}

/// A part of the top line, in its own window.
void begin_part(const Ui& ui, const char* name, const Area& area) {
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).bar);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin(name, nullptr, panel_flags);
    ImGui::PopStyleVar();
}

void end_part() {
    ImGui::End();
    ImGui::PopStyleColor();
}

/// A wheel with eight teeth.
void draw_wheel(ImVec2 middle, float radius, ImU32 colour) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    constexpr int teeth = 8;
    for (int i = 0; i < teeth; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / teeth;
        const ImVec2 direction{std::cos(angle), std::sin(angle)};
        list->AddLine(
            {middle.x + 0.7f * radius * direction.x, middle.y + 0.7f * radius * direction.y},
            {middle.x + 1.15f * radius * direction.x, middle.y + 1.15f * radius * direction.y},
            colour, 0.36f * radius);
    }
    list->AddCircle(middle, 0.72f * radius, colour, 0, 0.34f * radius);
}

/// Opens the settings, which lie over the inspector.
void draw_gear(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    begin_part(ui, "gear", area);
    const std::string name = std::string("tab.").append(settings_tab);
    if (ImGui::InvisibleButton(name.c_str(), area.size)) toggle_settings(ui);
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, name, tooltip_of("view.settings"));
    const bool open = is_settings_open(ui);
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    if (open || hovered) {
        ImGui::GetWindowDrawList()->AddRectFilled(area.position, end,
                                                  packed(open ? p.chosen : p.button_hovered));
    }
    draw_wheel({0.5f * (area.position.x + end.x), 0.5f * (area.position.y + end.y)},
               7.0f * ui.options.text_scale, packed(open || hovered ? p.text : p.dim));
    end_part();
}

/// Three bars that open the menus.
void draw_menu_button(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    begin_part(ui, "menu", area);
    const bool pressed = ImGui::InvisibleButton("menu", area.size);
    const bool hovered = ImGui::IsItemHovered();
    const bool open = ImGui::IsPopupOpen("menus");
    register_widget(ui, "menu", open ? "" : tr("All menus: files, views, scenes, lessons, help."));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 low = area.position;
    const ImVec2 high{low.x + area.size.x, low.y + area.size.y};
    if (open || hovered) {
        list->AddRectFilled(low, high, packed(open ? p.chosen : p.button_hovered));
    }
    const ImVec2 middle{0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
    const float half = 8.5f * u, thickness = std::max(std::round(2.0f * u), 1.0f);
    for (const float place : {-6.0f, 0.0f, 6.0f}) {
        const float y = std::round(middle.y + place * u - 0.5f * thickness);
        list->AddRectFilled({middle.x - half, y}, {middle.x + half, y + thickness}, packed(p.text));
    }
    if (pressed) ImGui::OpenPopup("menus");
    ImGui::SetNextWindowPos({low.x, high.y});
    if (ImGui::BeginPopup("menus")) {
        draw_menus(ui, 0.0f);
        ImGui::EndPopup();
    }
    end_part();
}

/// How to leave a lecture, in quiet letters.
void draw_exit_hint(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const std::string words = leaving_words(corner_room(ui, ImGui::GetIO().DisplaySize.x));
    ImGui::SetCursorScreenPos(area.position);
    const bool pressed = ImGui::InvisibleButton("lecture.leave", area.size);
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, "lecture.leave",
                    tr("Puts everything back as it was before the lecture.\nKey: Esc"));
    const ImVec2 text = ImGui::CalcTextSize(words.c_str());
    ImGui::GetWindowDrawList()->AddText({area.position.x + 0.5f * (area.size.x - text.x),
                                         area.position.y + 0.5f * (area.size.y - text.y)},
                                        packed(hovered ? p.text : p.dim), words.c_str());
    if (pressed) toggle_lecture(ui);
}

/// Undo, redo and whatever else has room; in a lecture, how to leave it.
void draw_narrow_corner(Ui& ui, const Area& area) {
    if (area.size.x < 1.0f) return;
    begin_part(ui, "corner", area);
    ImGui::SetCursorPosY(0.5f * (area.size.y - ImGui::GetFrameHeight()));
    if (ui.options.is_lecture) {
        draw_exit_hint(ui, area);
    } else {
        draw_corner_buttons(ui, ranks_of_narrow(ui));
    }
    end_part();
}

void draw_narrow_bar(Ui& ui, const Layout& layout) {
    const Area& whole = layout.menu;
    const float gear = gear_width(ui), height = whole.size.y;
    const float corner = layout.strip.position.x + layout.strip.size.x;
    draw_menu_button(ui, {whole.position, {layout.strip.position.x, height}});
    draw_narrow_corner(ui, {{corner, 0.0f}, {whole.size.x - gear - corner, height}});
    draw_gear(ui, {{whole.size.x - gear, 0.0f}, {gear, height}});
    if (!ui.start.is_open) return;
    begin_part(ui, "no stages", layout.strip);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::SetCursorPosY(0.5f * (height - ImGui::GetFontSize()));
    put_text("Rasterwalk");
    ImGui::PopFont();
    end_part();
}

void draw_wide_bar(Ui& ui, const Area& whole) {
    const float u = ui.options.text_scale;
    const float gear = gear_width(ui);
    const Area area{whole.position, {whole.size.x - gear, whole.size.y}};
    draw_gear(ui, {{whole.position.x + area.size.x, whole.position.y}, {gear, whole.size.y}});
    const auto push_style_of_line = [&] {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            ImVec2(9.0f * u, 0.5f * (area.size.y - ImGui::GetFontSize())));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0f * u, 8.0f * u));
    };
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).bar);
    push_style_of_line();
    ImGui::Begin("menu", nullptr, panel_flags | ImGuiWindowFlags_MenuBar);
    if (ImGui::BeginMenuBar()) {
        put_text("Rasterwalk", ui.fonts.bold);
        ImGui::PopStyleVar(2);
        ImGui::Dummy({4.0f * u, 0});
        draw_menus(ui, area.position.y + area.size.y);
        push_style_of_line();
        draw_corner_buttons(ui, all_ranks);
        ImGui::EndMenuBar();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

} // namespace

float menu_end_width(const Ui& ui, float window_width) {
    return std::round(gear_width(ui) + std::max(corner_width(ui, window_width), 0.0f));
}

void draw_menu_bar(Ui& ui, const Layout& layout) {
    if (layout.is_narrow) {
        draw_narrow_bar(ui, layout);
    } else {
        draw_wide_bar(ui, layout.menu);
    }
}

} // namespace rasterwalk
