#include "ui/canvas/canvas_header.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "ui/actions/actions.h"
#include "ui/actions/outside.h"
#include "ui/actions/row_table_layout.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/overlay_legend.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A sign for the layers where there is no room for the word: a hatched square.
constexpr const char* layers_sign = "▨";

void draw_overlay_list(Ui& ui) {
    const float u = ui.options.text_scale;
    float widest = 0.0f;
    for (const OverlayInfo& info : overlay_list())
        widest = std::max(widest, ImGui::CalcTextSize(info.title.data()).x);
    const ImVec2 swatch = swatch_size(ui);
    for (const OverlayInfo& info : overlay_list()) {
        bool on = ui.session.overlays.has(info.overlay);
        const ImVec2 start = ImGui::GetCursorScreenPos();
        const std::string label = std::string(info.title).append("###overlay.").append(info.name);
        if (ImGui::Checkbox(label.c_str(), &on)) ui.session.overlays.set(info.overlay, on);
        register_widget(ui, std::string("overlay.").append(info.name), info.help);
        const float height = ImGui::GetFrameHeight();
        ImGui::SameLine();
        ImGui::SetCursorScreenPos({start.x + height + widest + 26.0f * u, start.y});
        ImGui::Dummy({swatch.x, height});
        draw_swatch(ui, ImGui::GetWindowDrawList(),
                    {ImGui::GetItemRectMin().x, std::round(start.y + 0.5f * (height - swatch.y))},
                    info.overlay);
    }
    if (button(ui, "overlay.none", "all off", Look::quiet, "Turns off every overlay.")) {
        ui.session.overlays = {};
    }
}

/// "24x and up", while the picture is smaller than that.
void draw_zoom_needed(const Ui& ui, float needed) {
    if (ui.canvas.place.scale >= needed) return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    text_in(palette(ui.options.theme).dim, decimals(static_cast<double>(needed), 0) + "x and up");
}

void draw_switch(Ui& ui, const char* name, const char* title, bool& on, float needed,
                 const char* help) {
    const std::string label = std::string(title) + "###" + name;
    ImGui::Checkbox(label.c_str(), &on);
    register_widget(ui, name, help);
    draw_zoom_needed(ui, needed);
}

/// What is written in the cells and next to them.
void draw_cell_list(Ui& ui) {
    CanvasView& canvas = ui.session.canvas;
    draw_switch(ui, "layers.row_table", "row table next to its rows", canvas.row_table,
                row_table_zoom(ui),
                "leftPixels and rightPixels of the triangle shown, each line next to the row of "
                "the picture that it describes.\nVisible only where it covers no part of the "
                "triangle; the Rows tab always has it.");
    const std::string fates = std::string("pass ") + passed_sign + " and fail " + failed_sign;
    draw_switch(ui, "layers.fates", fates.c_str(), canvas.fates, fates_zoom(ui),
                "What the depth test said about each fragment of the triangle shown, and about all "
                "fragments that fell on the picked pixel.");
    text_in(palette(ui.options.theme).dim, "in the cells");
    const bool has_tests = tests_pixels(ui.results.a.frame.stages);
    for (const CellNumbersInfo& info : cell_numbers_list()) {
        if (is_of_tests(info.numbers) && !has_tests && canvas.numbers != info.numbers) continue;
        const CellNumbersWords words =
            cell_numbers_words(info.numbers, depth_words(ui.results.a.frame));
        const std::string label = words.title + "###numbers." + std::string(info.name);
        if (ImGui::RadioButton(label.c_str(), canvas.numbers == info.numbers))
            canvas.numbers = info.numbers;
        register_widget(ui, std::string("layers.numbers.").append(info.name), words.help);
        draw_zoom_needed(ui, numbers_zoom(ui, info.numbers));
    }
}

/// The overlays and numbers switched on, in the order of the list.
std::vector<std::string> layers_on(const Ui& ui) {
    std::vector<std::string> names;
    for (const OverlayInfo& info : overlay_list()) {
        if (ui.session.overlays.has(info.overlay)) names.emplace_back(info.title);
    }
    const CellNumbers numbers = ui.session.canvas.numbers;
    if (numbers != CellNumbers::none) {
        names.push_back("in the cells: " +
                        cell_numbers_words(numbers, depth_words(ui.results.a.frame)).title);
    }
    return names;
}

/// "layers: 2 on"; where there is little room the sign and the number.
std::string button_label(std::size_t on, bool narrow) {
    const std::string name = narrow ? layers_sign : "layers";
    if (on == 0) return name;
    return narrow ? name + " " + std::to_string(on) : name + ": " + std::to_string(on) + " on";
}

float layers_button_width(const Ui&, bool narrow) {
    // With a number in any case, so that its neighbours do not jump.
    return button_width(button_label(8, narrow));
}

/// The button in the canvas header that opens the list of everything that can be drawn over the
/// picture or in and next to its cells.
/// @param narrow a sign in place of the word, for small windows
void draw_layers_button(Ui& ui, bool narrow) {
    const std::vector<std::string> on = layers_on(ui);
    std::string help =
        "What is drawn over the picture and in its cells: wireframe, owners, the row table, "
        "numbers ...";
    for (const std::string& name : on)
        help += (&name == on.data() ? "\nOn: " : ", ") + name;
    if (button(ui, "canvas.overlays", button_label(on.size(), narrow),
               on.empty() ? Look::quiet : Look::plain, help,
               {layers_button_width(ui, narrow), 0.0f})) {
        ImGui::OpenPopup("layers");
    }
    const float gap = 4.0f * ui.options.text_scale;
    const ImVec2 at{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + gap};
    ImGui::SetNextWindowPos(at);
    // In a low window the list scrolls.
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {FLT_MAX, std::max(ImGui::GetIO().DisplaySize.y - at.y - gap, 1.0f)});
    if (ImGui::BeginPopup("layers")) {
        begin_line_clip();
        draw_overlay_list(ui);
        ImGui::Separator();
        draw_cell_list(ui);
        end_line_clip();
        ImGui::EndPopup();
    }
}

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
    register_widget(ui, "canvas.view", "Which plane of the framebuffer is shown.");
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
        register_widget(ui, "canvas.shows", "What the canvas shows.");
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
