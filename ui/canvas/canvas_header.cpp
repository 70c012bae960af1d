#include "ui/canvas/canvas_header.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "ui/actions/actions.h"
#include "ui/actions/outside.h"
#include "ui/canvas/layers.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The width of the switch that chooses what the canvas shows.
float shows_width(bool as_list) {
    if (as_list) return button_width("Outside ") + ImGui::GetFrameHeight();
    float width = 0.0f;
    for (const CanvasShowsInfo& info : canvas_shows_list())
        width += button_width(info.title);
    return width;
}

float view_selector_width() {
    return button_width("triangle  ") + ImGui::GetFrameHeight();
}

namespace {

/// The title of a view; for depth, what the buffer holds.
std::string view_title(const Ui& ui, const ViewInfo& info) {
    const DepthWords& depth = depth_words(ui.results.a.frame);
    const bool is_usual = info.view != View::depth || depth.kind == ClipDepth::inv_z;
    return std::string(is_usual ? info.title : depth.name);
}

} // namespace

void draw_view_selector(Ui& ui) {
    ImGui::SetNextItemWidth(view_selector_width());
    const std::string now = view_title(ui, view_list()[static_cast<std::size_t>(ui.session.view)]);
    const bool open = ImGui::BeginCombo("##view", now.c_str());
    name_widget(ui, "canvas.view", "Which plane of the framebuffer is shown.");
    if (!open) return;
    for (const ViewInfo& info : view_list()) {
        if (list_entry(ui, std::string("canvas.view.").append(info.title), view_title(ui, info),
                       info.view == ui.session.view, info.help)) {
            ui.session.view = info.view;
        }
    }
    ImGui::EndCombo();
}

/// What the canvas shows, as buttons side by side or as a list.
void draw_shows_switch(Ui& ui, bool as_list) {
    const CanvasShows chosen = shown_on_canvas(ui);
    const auto& list = canvas_shows_list();
    if (as_list) {
        const char* const title = list[static_cast<std::size_t>(chosen)].title.data();
        ImGui::SetNextItemWidth(shows_width(true));
        const bool open = ImGui::BeginCombo("##shows", title);
        name_widget(ui, "canvas.shows", "What the canvas shows.");
        if (!open) return;
        for (const CanvasShowsInfo& info : list) {
            if (list_entry(ui, std::string("canvas.shows.").append(info.name), info.title,
                           info.shows == chosen, info.help)) {
                show_on_canvas(ui, info.shows);
            }
        }
        ImGui::EndCombo();
        return;
    }
    for (const CanvasShowsInfo& info : list) {
        if (info.shows != CanvasShows::picture) ImGui::SameLine(0.0f, 0.0f);
        const std::string action = std::string("view.show_").append(info.name);
        if (button(ui, std::string("canvas.shows.").append(info.name), info.title,
                   info.shows == chosen ? Look::chosen : Look::plain, tooltip_of(action))) {
            show_on_canvas(ui, info.shows);
        }
    }
}

bool fits(const Ui& ui) {
    const OutsideView& outside = ui.session.canvas.outside;
    const bool picture = ui.session.canvas.zoom <= 0.0f;
    const bool all = outside.distance <= 0.0f && !outside.is_camera;
    switch (shown_on_canvas(ui)) {
    case CanvasShows::picture:
        return picture;
    case CanvasShows::outside:
        return all;
    case CanvasShows::both:
        return picture && all;
    }
    return picture;
}

/// A button at the right end of the header.
struct HeaderButton {
    const char *name, *label, *action;
    bool is_on;
};

} // namespace

bool is_in_canvas_header(std::string_view widget) {
    constexpr std::string_view beginnings[] = {"canvas.view", "canvas.shows", "canvas.grid",
                                               "canvas.overlays"};
    return std::any_of(std::begin(beginnings), std::end(beginnings),
                       [&](std::string_view beginning) { return widget.starts_with(beginning); });
}

void draw_canvas_header(Ui& ui, float right_edge) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const CanvasShows shows = shown_on_canvas(ui);
    const bool has_picture = shows != CanvasShows::outside;
    // In a lecture the first two are next to the time.
    const bool is_lecture = ui.options.is_lecture;
    std::vector<HeaderButton> buttons;
    if (!is_lecture) buttons.push_back({"canvas.fit", "fit", "view.fit", fits(ui)});
    if (has_picture) {
        if (!is_lecture) {
            buttons.push_back({"canvas.zoom_triangle", "triangle", "view.zoom_selection", false});
        }
        buttons.push_back({"canvas.grid", "grid", "view.grid", ui.session.canvas.grid});
    }
    const auto width_of_buttons = [&] {
        float width = -gap;
        for (const HeaderButton& b : buttons)
            width += button_width(b.label) + gap;
        return width;
    };
    const float left = ImGui::GetCursorScreenPos().x;
    const float planes =
        has_picture ? view_selector_width() + layers_button_width(ui, true) + 2.0f * gap : 0.0f;
    const float room = right_edge - left - planes - gap;
    const bool has_switch = ui.session.scene->space == SceneSpace::world;
    const bool as_list = has_switch && shows_width(false) > room - width_of_buttons();
    const float before = has_switch ? shows_width(as_list) : 0.0f;
    // Buttons without room are in the View menu.
    while (buttons.size() > 1 && before > room - width_of_buttons())
        buttons.pop_back();
    if (has_switch) {
        draw_shows_switch(ui, as_list);
        ImGui::SameLine();
    }
    const float start = right_edge - width_of_buttons();
    if (has_picture) {
        draw_view_selector(ui);
        ImGui::SameLine();
        const float rest = start - gap - ImGui::GetCursorScreenPos().x;
        draw_layers_button(ui, layers_button_width(ui, false) > rest);
        ImGui::SameLine();
        const float scale = ui.canvas.place.scale;
        const std::string zoom =
            decimals(static_cast<double>(scale), scale == std::round(scale) ? 0 : 2) + "x";
        const float label = ImGui::CalcTextSize("00.00x").x + gap;
        if (start - label > ImGui::GetCursorScreenPos().x) {
            ImGui::SetCursorScreenPos({start - label, ImGui::GetCursorScreenPos().y});
            ImGui::AlignTextToFramePadding();
            text_in(palette(ui.options.theme).dim, zoom);
            ImGui::SameLine();
        }
    }
    ImGui::SetCursorScreenPos(
        {std::max(start, ImGui::GetCursorScreenPos().x), ImGui::GetCursorScreenPos().y});
    for (const HeaderButton& b : buttons) {
        if (&b != buttons.data()) ImGui::SameLine();
        if (button(ui, b.name, b.label, b.is_on ? Look::plain : Look::quiet,
                   tooltip_of(b.action))) {
            find_action(b.action).run(ui);
        }
    }
}

} // namespace rasterwalk
