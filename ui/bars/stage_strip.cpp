#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/keys.h"
#include "ui/bars/bars.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A button of the strip: a stage with its number, or a switch with its state.
struct StripItem {
    std::string name;    ///< of the widget, and of the action that it runs
    std::string first;   ///< shown first
    std::string second;  ///< shown after it
    bool first_is_main;  ///< the other one is quieter, or in the colour of a state
    bool chosen = false; ///< the stage on show
    bool is_on = false;  ///< switches
    bool is_switch = false;
    bool has_state = true;             ///< switches: says whether it is on
    bool matters = true;               ///< switches: does it change anything at this stage?
    const ComparePair* pair = nullptr; ///< two runs that a click compares; in small letters
};

/// How much the strip says; each form needs less room than the one before.
enum class Form : std::uint8_t {
    with_pairs, ///< the pairs of runs have a button each
    full,
    short_switches, ///< the switches are abbreviated
    few_names,      ///< and only the stage on show says its name
};

std::vector<StripItem> strip_items(const Ui& ui, Form form) {
    std::vector<StripItem> items;
    const Settings& settings = ui.session.a.settings;
    const StripStep here = step_of(settings);
    for (const StageInfo& info : stage_list()) {
        items.push_back({.name = "stage." + std::string(info.name),
                         .first = std::to_string(strip_place(info.step) + 1),
                         .second = form == Form::few_names && info.step != here
                                       ? std::string()
                                       : std::string(info.title),
                         .first_is_main = false,
                         .chosen = info.step == here});
    }
    const bool perspective = settings.interpolation == Interpolation::perspective;
    items.push_back({.name = "switch.perspective",
                     .first = form > Form::full ? "Persp." : "Perspective",
                     .second = perspective                                           ? "on"
                               : settings.interpolation == Interpolation::zinv_twice ? "twice"
                                                                                     : "off",
                     .first_is_main = true,
                     .is_on = perspective,
                     .is_switch = true,
                     .matters = settings.stage >= Stage::depth});
    const DepthTest depth = settings.depth_test;
    items.push_back({.name = "switch.depth_test",
                     .first = form > Form::full ? "Depth" : "Depth test",
                     .second = depth == DepthTest::off         ? "off"
                               : depth == DepthTest::inverse_z ? "1/z"
                               : depth == DepthTest::reversed  ? "reversed"
                                                               : "z",
                     .first_is_main = true,
                     .is_on = depth != DepthTest::off,
                     .is_switch = true,
                     .matters = settings.stage >= Stage::depth});
    if (hides_settings(ui.session)) {
        for (StripItem& item : items) {
            if (!item.is_switch) continue;
            item.second = "?";
            item.is_on = false;
        }
    }
    items.push_back({.name = "switch.compare",
                     .first = form > Form::full ? "A | B" : "Compare",
                     .second = "",
                     .first_is_main = true,
                     .chosen = ui.session.b.has_value(),
                     .is_switch = true,
                     .has_state = false});
    if (form == Form::with_pairs) {
        const ComparePair* const on_show = pair_on_show(ui.session);
        for (const ComparePair& pair : compare_pairs()) {
            items.push_back({.name = std::string("compare.strip.").append(pair.name),
                             .first = std::string(pair.left),
                             .second = "",
                             .first_is_main = true,
                             .chosen = on_show == &pair,
                             .is_switch = true,
                             .has_state = false,
                             .pair = &pair});
        }
        return items;
    }
    items.push_back({.name = "compare.pairs",
                     .first = "▾",
                     .second = "",
                     .first_is_main = true,
                     .is_switch = true,
                     .has_state = false});
    return items;
}

float text_width(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

/// Between the two texts of an item.
float between(const StripItem& item, float unit) {
    return item.second.empty() ? 0.0f : 7.0f * unit;
}

float item_width(const StripItem& item, float unit) {
    const float padding = (item.pair != nullptr ? 14.0f : 23.0f) * unit;
    return text_width(item.first) + between(item, unit) + text_width(item.second) + padding;
}

/// A pair stands close to what is left of it.
float gap_before(const StripItem& item, float gap) {
    return item.pair != nullptr ? 0.25f * gap : gap;
}

std::vector<float> item_widths(const Ui& ui, const std::vector<StripItem>& items) {
    const float unit = ui.options.text_scale;
    std::vector<float> widths;
    for (const StripItem& item : items) {
        if (item.pair != nullptr) {
            ImGui::PushFont(ui.fonts.small);
            widths.push_back(item_width(item, unit));
            ImGui::PopFont();
            continue;
        }
        // The widest common state counts, so that a switch does not shift its neighbours.
        StripItem usual = item;
        if (item.is_switch && item.has_state) usual.second = "off";
        widths.push_back(std::max(item_width(usual, unit), item_width(item, unit)));
    }
    return widths;
}

float gap(const Ui& ui) {
    return 8.0f * ui.options.text_scale;
}

int lines_of(const Ui& ui, Form form, float width) {
    const std::vector<float> widths = item_widths(ui, strip_items(ui, form));
    return line_count(flow(widths, gap(ui), width - 2.0f * bar_margin(ui)));
}

/// Between two stages that are joined by an arrow, beside the gap; design pixels.
constexpr float arrow_width = 12.0f;

/// What the items need on one line with arrows between the stages.
float wide_width(const Ui& ui, const std::vector<StripItem>& items) {
    const std::vector<float> widths = item_widths(ui, items);
    float total = stage_count * arrow_width * ui.options.text_scale;
    for (std::size_t i = 0; i < items.size(); ++i)
        total += widths[i] + gap_before(items[i], gap(ui));
    return total;
}

/// The first form that fits on one line; only small windows have no height to spare for a second.
Form strip_form(const Ui& ui, float width) {
    const float room = width - 2.0f * bar_margin(ui);
    if (wide_width(ui, strip_items(ui, Form::with_pairs)) < room) return Form::with_pairs;
    for (const Form form : {Form::full, Form::short_switches}) {
        if (lines_of(ui, form, width) == 1) return form;
    }
    return is_compact(ImGui::GetIO().DisplaySize, ui.options) ? Form::few_names
                                                              : Form::short_switches;
}

/// The pairs of runs that are often compared: a click each.
void draw_pairs(Ui& ui) {
    const float gap = 4.0f * ui.options.text_scale;
    ImGui::SetNextWindowPos({ImGui::GetItemRectMax().x, ImGui::GetItemRectMax().y + gap}, 0,
                            {1.0f, 0.0f});
    if (!ImGui::BeginPopup("compare pairs")) return;
    const ComparePair* const on_show = pair_on_show(ui.session);
    for (const ComparePair& pair : compare_pairs()) {
        const std::string label = std::string(pair.left)
                                      .append("  |  ")
                                      .append(pair.right)
                                      .append("###")
                                      .append(pair.name);
        if (ImGui::Selectable(label.c_str(), on_show == &pair)) start_pair(ui.session, pair);
        name_widget(ui, std::string("compare.pair.").append(pair.name), pair.help);
    }
    if (ImGui::IsKeyPressed(key::escape, false)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

std::string tooltip_of_item(const StripItem& item) {
    if (item.name == "compare.pairs") return "Which two runs are compared.";
    if (!item.matters) {
        return tooltip_of(item.name) + "\nAt this stage it changes nothing: it has no depth.";
    }
    if (item.pair == nullptr) return tooltip_of(item.name);
    std::string text = "Compares ";
    text.append(item.pair->left).append(" with ").append(item.pair->right);
    return text.append(". ").append(item.pair->help).append("\nAgain: back to one run.");
}

void draw_item(Ui& ui, const StripItem& item, ImVec2 at, ImVec2 size) {
    const bool is_list = item.name == "compare.pairs";
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetCursorScreenPos(at);
    const bool pressed = ImGui::InvisibleButton(item.name.c_str(), size);
    const bool hovered = ImGui::IsItemHovered();
    name_widget(ui, item.name, tooltip_of_item(item));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    const ImVec4& fill = item.chosen ? p.accent : hovered ? p.button_hovered : p.button;
    if (!item.is_switch || hovered || item.chosen)
        list->AddRectFilled(at, end, packed(fill), 5.0f * u);
    if (item.is_switch) list->AddRect(at, end, packed(p.dim, 0.6f), 5.0f * u);
    const ImVec4& main = item.chosen ? p.accent_text : item.matters ? p.text : p.dim;
    const ImVec4 state = !item.matters ? p.dim : item.is_on ? p.link : p.changed;
    const ImVec4& side = item.is_switch ? state : item.chosen ? p.accent_text : p.dim;
    if (item.pair != nullptr) ImGui::PushFont(ui.fonts.small);
    const float y = at.y + 0.5f * (size.y - ImGui::GetFontSize());
    const float content = text_width(item.first) + between(item, u) + text_width(item.second);
    const float x = at.x + 0.5f * (size.x - content);
    list->AddText({x, y}, packed(item.first_is_main ? main : side), item.first.c_str());
    list->AddText({x + text_width(item.first) + 7.0f * u, y},
                  packed(item.first_is_main ? side : main), item.second.c_str());
    if (item.pair != nullptr) {
        ImGui::PopFont();
        if (pressed && item.chosen) {
            end_comparison(ui.session);
        } else if (pressed && !hides_settings(ui.session)) {
            start_pair(ui.session, *item.pair);
        }
    } else if (is_list) {
        if (pressed && !hides_settings(ui.session)) ImGui::OpenPopup("compare pairs");
        draw_pairs(ui);
    } else if (pressed) {
        find_action(item.name).run(ui);
    }
}

void draw_chevron(Ui& ui, ImVec2 middle) {
    const float r = 3.0f * ui.options.text_scale;
    const ImVec2 points[] = {{middle.x - 0.5f * r, middle.y - r},
                             {middle.x + 0.5f * r, middle.y},
                             {middle.x - 0.5f * r, middle.y + r}};
    ImGui::GetWindowDrawList()->AddPolyline(points, 3, packed(palette(ui.options.theme).dim), 0,
                                            1.3f * ui.options.text_scale);
}

} // namespace

int stage_strip_lines(const Ui& ui, float width) {
    return lines_of(ui, strip_form(ui, width), width);
}

void draw_stage_strip(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.ground);
    ImGui::Begin("strip", nullptr, panel_flags);
    const std::vector<StripItem> items = strip_items(ui, strip_form(ui, area.size.x));
    const std::vector<float> widths = item_widths(ui, items);
    const float room = area.size.x - 2.0f * bar_margin(ui);
    // Where there is room the stages are joined by arrows and the switches stand at the right.
    const float arrow = arrow_width * u;
    const bool wide = wide_width(ui, items) < room;
    const std::vector<FlowPlace> places = flow(widths, wide ? gap(ui) + arrow : gap(ui), room);
    const float height = 34.0f * u;
    float switch_x = room;
    for (std::size_t i = stage_count; i < items.size(); ++i)
        switch_x -= widths[i] + gap_before(items[i], gap(ui));
    for (std::size_t i = 0; i < items.size(); ++i) {
        float x = places[i].x;
        if (wide && items[i].is_switch) {
            x = switch_x + gap_before(items[i], gap(ui));
            switch_x = x + widths[i];
        }
        const ImVec2 at{area.position.x + bar_margin(ui) + x,
                        area.position.y + 9.0f * u +
                            static_cast<float>(places[i].line) * 42.0f * u};
        draw_item(ui, items[i], at, {widths[i], height});
        if (wide && i + 1 < stage_count) {
            draw_chevron(ui, {at.x + widths[i] + 0.5f * (gap(ui) + arrow), at.y + 0.5f * height});
        }
    }
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float bottom = area.position.y + area.size.y - 0.5f;
    list->AddLine({area.position.x, bottom}, {area.position.x + area.size.x, bottom},
                  packed(p.line));
    ImGui::End();
    ImGui::PopStyleColor();
}

float bar_margin(const Ui& ui) {
    return 14.0f * ui.options.text_scale;
}

} // namespace rasterwalk
