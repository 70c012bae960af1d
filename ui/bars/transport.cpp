#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ui/actions/actions.h"
#include "ui/bars/bars.h"
#include "ui/bars/moment_line.h"
#include "ui/bars/speed_dial.h"
#include "ui/bars/time_strips.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

enum class Icon { first, back, play, pause, step, last };

void draw_icon(ImDrawList* list, Icon icon, ImVec2 c, float r, ImU32 colour) {
    const auto right = [&](float x) {
        list->AddTriangleFilled({x - 0.55f * r, c.y - r}, {x + 0.75f * r, c.y},
                                {x - 0.55f * r, c.y + r}, colour);
    };
    const auto left = [&](float x) {
        list->AddTriangleFilled({x + 0.55f * r, c.y - r}, {x + 0.55f * r, c.y + r},
                                {x - 0.75f * r, c.y}, colour);
    };
    const auto bar = [&](float x) {
        list->AddRectFilled({x - 0.16f * r, c.y - r}, {x + 0.16f * r, c.y + r}, colour);
    };
    switch (icon) {
    case Icon::first:
        bar(c.x - 0.85f * r);
        left(c.x + 0.2f * r);
        break;
    case Icon::back:
        left(c.x);
        break;
    case Icon::play:
        right(c.x);
        break;
    case Icon::pause:
        bar(c.x - 0.4f * r);
        bar(c.x + 0.4f * r);
        break;
    case Icon::step:
        right(c.x - 0.2f * r);
        bar(c.x + 0.85f * r);
        break;
    case Icon::last:
        right(c.x - 0.55f * r);
        right(c.x + 0.45f * r);
        bar(c.x + 1.25f * r);
        break;
    }
}

void icon_button(Ui& ui, const char* action, Icon icon, ImVec2 at, ImVec2 size, bool accent) {
    const Palette& p = palette(ui.options.theme);
    ImGui::SetCursorScreenPos(at);
    const bool pressed = ImGui::InvisibleButton(action, size);
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, action, tooltip_of(action));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec4& fill = accent ? p.accent : hovered ? p.button_hovered : p.button;
    list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, packed(fill),
                        5.0f * ui.options.text_scale);
    draw_icon(list, icon, {at.x + 0.5f * size.x, at.y + 0.5f * size.y}, 0.19f * size.y,
              packed(accent ? p.accent_text : p.text));
    if (pressed) find_action(action).run(ui);
}

struct StepChoice {
    Granularity granularity;
    const char* name;
    const char* help;
};

std::vector<StepChoice> step_choices(const Ui& ui) {
    if (ui.results.a.frame.squares != nullptr) {
        return {{Granularity::moment, tr("square"), tr("A step is one square, divided or not.")},
                {Granularity::line, tr("parts"), tr("A step is a square with all its parts.")},
                {Granularity::triangle, tr("quarter"), tr("A step is a quarter of the picture.")},
                {Granularity::phase, tr("outer"),
                 tr("A step is all that is left of the square that this one is a part of.")}};
    }
    const bool fragments = has_fragments(ui.session.a.settings.stage);
    return {
        {Granularity::code, tr("line"),
         tr("A step is one line of the lab's code, in the Code tab.")},
        {Granularity::moment, tr(fragments ? "fragment" : "sample"),
         tr("A step is the smallest piece of work: one vertex, one edge at a clipping plane, one "
            "edge sample, one fragment.")},
        {Granularity::line, tr(fragments ? "row" : "edge"),
         tr("A step is one clipping plane, one edge or one row.")},
        {Granularity::triangle, tr("triangle"), tr("A step is one triangle.")},
        {Granularity::phase, tr("phase"),
         tr("A step is one phase of a triangle: its vertices, clipping, culling, its edges, its "
            "rows.")}};
}

/// How the groups of the transport are arranged: buttons, size of a step, dial, time lines.
enum class Arrangement {
    compact,      ///< a small window: the size of a step is a list, and one time line is in the row
    stacked,      ///< the time lines have the full width, below
    side_by_side, ///< the time lines are to the right of everything else
};

/// Widths of the groups, screen pixels, and what follows from them.
struct Groups {
    Arrangement arrangement;
    DialForm dial;
    std::vector<float> widths; ///< of the groups that flow
    float icon, play;
    float strips; ///< width of the time lines
};

/// The least width of the time lines next to something else, design pixels.
constexpr float least_strips = 340.0f;
constexpr float least_compact_strip = 140.0f;

/// The room for a name: what a step is called depends on the stage, and nothing should move when
/// that changes.
float choice_width(const Ui& ui, const StepChoice& choice) {
    if (ui.results.a.frame.squares != nullptr) return text_width(choice.name);
    if (choice.granularity == Granularity::moment) return text_width(tr("fragment"));
    return text_width(choice.granularity == Granularity::line ? tr("row") : choice.name);
}

float step_choice_width(const Ui& ui) {
    const float u = ui.options.text_scale;
    float width = 2.0f * u;
    for (const StepChoice& choice : step_choices(ui))
        width += choice_width(ui, choice) + 24.0f * u;
    return width;
}

Groups measure(const Ui& ui, float width) {
    const float u = ui.options.text_scale;
    Groups g{};
    const bool compact = is_compact(ImGui::GetIO().DisplaySize, ui.options);
    g.dial = compact ? DialForm::small : DialForm::large;
    g.icon = (compact ? 32.0f : 38.0f) * u;
    g.play = (compact ? 42.0f : 56.0f) * u;
    const float others = ui.options.is_lecture ? 2.0f : 4.0f;
    g.widths.push_back(others * (g.icon + 6.0f * u) + g.play);
    g.widths.push_back(compact ? text_width(tr("fragment")) + 52.0f * u : step_choice_width(ui));
    g.widths.push_back(speed_dial_size(ui, g.dial).x);
    float rest = width;
    for (const float group : g.widths)
        rest -= group + group_gap(ui);
    if (compact) {
        g.arrangement = Arrangement::compact;
        g.strips = rest >= least_compact_strip * u ? rest : width;
        g.widths.push_back(g.strips);
    } else {
        g.arrangement = rest >= least_strips * u ? Arrangement::side_by_side : Arrangement::stacked;
        g.strips = g.arrangement == Arrangement::side_by_side ? rest : width;
        if (g.arrangement == Arrangement::stacked) g.dial = DialForm::medium;
    }
    return g;
}

std::vector<FlowPlace> places_of(const Ui& ui, const Groups& groups, float width) {
    return flow(groups.widths, group_gap(ui), width + 1.0f);
}

/// Design pixels: the height of a line of groups, and of what surrounds the lines.
constexpr float line_height = 42.0f;
constexpr float side_by_side_height = 96.0f;
constexpr float margins_and_words = 38.0f;
constexpr float stacked_gap = 4.0f; ///< extra, where the time lines have the full width

std::string step_name(const StepChoice& choice) {
    return std::string("step.").append(word_of(choice.granularity));
}

void draw_step_list(Ui& ui, ImVec2 at, ImVec2 size) {
    ImGui::SetCursorScreenPos({at.x, at.y + 0.5f * (size.y - ImGui::GetFrameHeight())});
    ImGui::SetNextItemWidth(size.x);
    const std::vector<StepChoice> choices = step_choices(ui);
    const auto now = std::find_if(choices.begin(), choices.end(), [&](const StepChoice& one) {
        return one.granularity == ui.session.play.granularity;
    });
    const bool open =
        ImGui::BeginCombo("##step", (now == choices.end() ? choices.front() : *now).name);
    register_widget(ui, "step.list", tr("The size of a step."));
    if (!open) return;
    for (const StepChoice& choice : choices) {
        const bool chosen = ui.session.play.granularity == choice.granularity;
        if (list_entry(ui, step_name(choice), choice.name, chosen, choice.help)) {
            ui.session.play.granularity = choice.granularity;
        }
    }
    ImGui::EndCombo();
}

void draw_step_choice(Ui& ui, ImVec2 at, ImVec2 size) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, packed(p.button), 5.0f * u);
    float x = at.x;
    for (const StepChoice& choice : step_choices(ui)) {
        const float width = choice_width(ui, choice) + 24.0f * u;
        const bool chosen = ui.session.play.granularity == choice.granularity;
        ImGui::SetCursorScreenPos({x, at.y});
        const std::string name = step_name(choice);
        if (ImGui::InvisibleButton(name.c_str(), {width, size.y})) {
            ui.session.play.granularity = choice.granularity;
        }
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, name, choice.help);
        if (chosen || hovered) {
            list->AddRectFilled({x, at.y}, {x + width, at.y + size.y},
                                packed(chosen ? p.chosen : p.button_hovered), 5.0f * u);
        }
        list->AddText({x + 0.5f * (width - text_width(choice.name)),
                       at.y + 0.5f * (size.y - ImGui::GetFontSize())},
                      packed(p.text), choice.name);
        x += width;
    }
}

void draw_buttons(Ui& ui, ImVec2 at, const Groups& g, float height) {
    struct Entry {
        const char* action;
        Icon icon;
        bool wide;
        bool is_in_lecture; ///< a lecture has fewer
    };
    const Entry entries[] = {
        {"walk.first", Icon::first, false, false},
        {"walk.back", Icon::back, false, true},
        {"walk.play", ui.session.play.running ? Icon::pause : Icon::play, true, true},
        {"walk.step", Icon::step, false, true},
        {"walk.last", Icon::last, false, false}};
    for (const Entry& entry : entries) {
        if (ui.options.is_lecture && !entry.is_in_lecture) continue;
        const float width = entry.wide ? g.play : g.icon;
        icon_button(ui, entry.action, entry.icon, at, {width, height}, entry.wide);
        at.x += width + 6.0f * ui.options.text_scale;
    }
}

/// The groups that flow.
/// @param corner of the first line
void draw_groups(Ui& ui, ImVec2 corner, const Groups& g, float room) {
    const float u = ui.options.text_scale;
    const float height = 34.0f * u;
    const std::vector<FlowPlace> places = places_of(ui, g, room);
    const auto place = [&](std::size_t group) {
        return ImVec2{corner.x + places[group].x,
                      corner.y + line_height * u * static_cast<float>(places[group].line)};
    };
    draw_buttons(ui, place(0), g, height);
    if (g.arrangement == Arrangement::compact) {
        draw_step_list(ui, place(1), {g.widths[1], height});
        draw_time_strips(ui, place(3), g.strips, false);
    } else {
        draw_step_choice(ui, place(1), {g.widths[1], height});
    }
    draw_speed_dial(ui, place(2), g.dial);
}

void draw_side_by_side(Ui& ui, ImVec2 corner, const Groups& g, float room) {
    const float u = ui.options.text_scale;
    draw_groups(ui, {corner.x, corner.y + 14.0f * u}, g, room);
    const float left = corner.x + room - g.strips, last = corner.y + 70.0f * u;
    const float words = g.widths[0] + g.widths[1] + group_gap(ui);
    draw_done_moment(ui, {corner.x, last - 2.0f * u}, words);
    draw_time_strips(ui, {left, corner.y + 5.0f * u}, g.strips, true);
    draw_next_moment(ui, {left, last}, g.strips);
}

} // namespace

float group_gap(const Ui& ui) {
    return 14.0f * ui.options.text_scale;
}

float transport_height(const Ui& ui, float width) {
    const float u = ui.options.text_scale;
    const float room = width - 2.0f * bar_margin(ui);
    const Groups g = measure(ui, room);
    if (g.arrangement == Arrangement::side_by_side) return side_by_side_height * u;
    const int lines = line_count(places_of(ui, g, room));
    const float groups = (margins_and_words + line_height * static_cast<float>(lines)) * u;
    return g.arrangement == Arrangement::stacked
               ? groups + time_strips_height(ui, true) + stacked_gap * u
               : groups;
}

void draw_transport(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.bar);
    ImGui::Begin("transport", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    const float room = area.size.x - 2.0f * bar_margin(ui);
    const Groups g = measure(ui, room);
    const ImVec2 corner{area.position.x + bar_margin(ui), area.position.y};
    if (g.arrangement == Arrangement::side_by_side) {
        draw_side_by_side(ui, corner, g, room);
    } else {
        float y = corner.y + 10.0f * u;
        draw_groups(ui, {corner.x, y}, g, room);
        y += line_height * u * static_cast<float>(line_count(places_of(ui, g, room)));
        if (g.arrangement == Arrangement::stacked) {
            draw_time_strips(ui, {corner.x, y - 5.0f * u}, room, true);
            y += time_strips_height(ui, true) + stacked_gap * u;
        }
        draw_moment_line(ui, {corner.x, y - 2.0f * u}, room);
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
