#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "session/moment_text.h"
#include "session/walk.h"
#include "ui/actions/actions.h"
#include "ui/bars/bars.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
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
    name_widget(ui, action, tooltip_of(action));
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

std::array<StepChoice, 4> step_choices(Stage stage) {
    const bool fragments = has_fragments(stage);
    return {{{Granularity::moment, fragments ? "fragment" : "sample",
              "A step is the smallest piece of work: one vertex, one edge sample, one fragment."},
             {Granularity::line, fragments ? "row" : "edge", "A step is one edge or one row."},
             {Granularity::triangle, "triangle", "A step is one triangle."},
             {Granularity::phase, "phase",
              "A step is one phase of a triangle: its vertices, its edges, its rows."}}};
}

float text_width(const char* text) {
    return ImGui::CalcTextSize(text).x;
}

/// Widths of the groups: buttons, size of a step, speed, scrub bar. In a small window the size of a
/// step is a list, and the speed is left to its keys.
struct Groups {
    std::vector<float> widths;
    float icon, play;
    bool compact;
};

Groups measure(const Ui& ui, float width) {
    const float u = ui.options.text_scale;
    Groups g;
    g.compact = is_compact(ImGui::GetIO().DisplaySize, ui.options);
    g.icon = (g.compact ? 32.0f : 38.0f) * u;
    g.play = (g.compact ? 42.0f : 56.0f) * u;
    g.widths.push_back(4.0f * (g.icon + 6.0f * u) + g.play);
    if (g.compact) {
        g.widths.push_back(text_width("fragment") + 52.0f * u);
    } else {
        float choices = 2.0f * u;
        for (const char* name : {"fragment", "row", "triangle", "phase"}) {
            choices += text_width(name) + 24.0f * u;
        }
        g.widths.push_back(choices);
        g.widths.push_back(text_width("99.9 steps/s") + 24.0f * u);
    }
    const float gap = 14.0f * u;
    float used = 0.0f;
    for (const float group : g.widths)
        used += group + gap;
    const float least = (g.compact ? 140.0f : 220.0f) * u;
    g.widths.push_back(width - used >= least ? width - used : width);
    return g;
}

std::string step_name(const StepChoice& choice) {
    return std::string("step.").append(word_of(choice.granularity));
}

void draw_step_list(Ui& ui, ImVec2 at, ImVec2 size) {
    ImGui::SetCursorScreenPos({at.x, at.y + 0.5f * (size.y - ImGui::GetFrameHeight())});
    ImGui::SetNextItemWidth(size.x);
    const auto choices = step_choices(ui.session.a.settings.stage);
    const auto now = static_cast<std::size_t>(ui.session.play.granularity);
    const bool open = ImGui::BeginCombo("##step", choices[now].name);
    name_widget(ui, "step.list", "How far a step goes.");
    if (!open) return;
    for (const StepChoice& choice : choices) {
        const bool chosen = ui.session.play.granularity == choice.granularity;
        if (ImGui::Selectable(choice.name, chosen)) {
            ui.session.play.granularity = choice.granularity;
        }
        name_widget(ui, step_name(choice), choice.help);
    }
    ImGui::EndCombo();
}

void draw_step_choice(Ui& ui, ImVec2 at, ImVec2 size) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, packed(p.button), 5.0f * u);
    float x = at.x;
    for (const StepChoice& choice : step_choices(ui.session.a.settings.stage)) {
        const float slack = choice.granularity == Granularity::moment
                                ? text_width("fragment") - text_width(choice.name)
                            : choice.granularity == Granularity::line
                                ? text_width("row") - text_width(choice.name)
                                : 0.0f;
        const float width = text_width(choice.name) + slack + 24.0f * u;
        const bool chosen = ui.session.play.granularity == choice.granularity;
        ImGui::SetCursorScreenPos({x, at.y});
        const std::string name = step_name(choice);
        if (ImGui::InvisibleButton(name.c_str(), {width, size.y})) {
            ui.session.play.granularity = choice.granularity;
        }
        const bool hovered = ImGui::IsItemHovered();
        name_widget(ui, name, choice.help);
        if (chosen || hovered) {
            list->AddRectFilled({x, at.y}, {x + width, at.y + size.y},
                                packed(chosen ? p.accent : p.button_hovered), 5.0f * u);
        }
        list->AddText({x + 0.5f * (width - text_width(choice.name)),
                       at.y + 0.5f * (size.y - ImGui::GetFontSize())},
                      packed(chosen ? p.accent_text : p.text), choice.name);
        x += width;
    }
}

void draw_speed(Ui& ui, ImVec2 at, ImVec2 size) {
    ImGui::SetCursorScreenPos({at.x, at.y + 0.5f * (size.y - ImGui::GetFrameHeight())});
    ImGui::SetNextItemWidth(size.x);
    ImGui::DragFloat("##speed", &ui.session.play.speed, 0.05f * ui.session.play.speed, slowest_play,
                     fastest_play, ui.session.play.speed < 10.0f ? "%.1f steps/s" : "%.0f steps/s",
                     ImGuiSliderFlags_AlwaysClamp);
    name_widget(ui, "walk.speed",
                "How many steps a second the play takes. Drag, or double click to type.");
}

void draw_scrub_bar(Ui& ui, ImVec2 at, ImVec2 size) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const Timeline timeline(ui.results.a.frame);
    ImGui::SetCursorScreenPos(at);
    ImGui::InvisibleButton("scrub", size);
    if (ImGui::IsItemActive()) {
        const float along = (ImGui::GetIO().MousePos.x - at.x) / std::max(size.x, 1.0f);
        scrub_to(ui.session, timeline.at_place(along));
    }
    name_widget(ui, "walk.scrub",
                "The whole frame from its first vertex to its last fragment; a tick a triangle. "
                "Drag to go to any moment.");
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float middle = at.y + 0.5f * size.y;
    const float half = 7.0f * u;
    const float x = at.x + size.x * static_cast<float>(timeline.place(ui.results.a.cursor));
    list->AddRectFilled({at.x, middle - half}, {at.x + size.x, middle + half}, packed(p.button),
                        3.0f * u);
    list->AddRectFilled({at.x, middle - half}, {x, middle + half}, packed(p.accent), 3.0f * u);
    const int triangles = ui.results.a.frame.triangle_count();
    if (static_cast<float>(triangles) * 4.0f * u < size.x) {
        for (int t = 1; t < triangles; ++t) {
            const float tick =
                at.x + size.x * static_cast<float>(t) / static_cast<float>(triangles);
            list->AddLine({tick, middle - half}, {tick, middle + half}, packed(p.ground, 0.7f));
        }
    }
    list->AddRectFilled({x - 1.5f * u, middle - half - 4.0f * u},
                        {x + 1.5f * u, middle + half + 4.0f * u}, packed(p.text), 1.0f * u);
}

constexpr const char* previous_change_label = "‹ pixel";
constexpr const char* next_change_label = "pixel ›";

/// Small, at the right end of the last line: next and previous change of the picked pixel.
void draw_change_buttons(Ui& ui, ImVec2 at) {
    const float u = ui.options.text_scale;
    const ImVec2 size{0, ImGui::GetFontSize() + 6.0f * u};
    const Look look = ui.results.history ? Look::plain : Look::quiet;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(10.0f * u, 2.0f * u));
    ImGui::SetCursorScreenPos({at.x, at.y - 3.0f * u});
    if (button(ui, "walk.previous_change", previous_change_label, look,
               tooltip_of("walk.previous_change"), size)) {
        find_action("walk.previous_change").run(ui);
    }
    ImGui::SameLine(0.0f, 6.0f * u);
    if (button(ui, "walk.next_change", next_change_label, look, tooltip_of("walk.next_change"),
               size)) {
        find_action("walk.next_change").run(ui);
    }
    ImGui::PopStyleVar();
}

/// Where the cursor stands, in words and as text; and, with a pixel picked or room to spare, the
/// buttons for its changes.
void draw_words(Ui& ui, ImVec2 at, float room) {
    const float u = ui.options.text_scale;
    const float gap = 18.0f * u;
    const std::string words = ui.results.a.done
                                  ? describe_moment(ui.results.a.frame, *ui.results.a.done)
                                  : "nothing is drawn yet";
    const float words_width = text_width(words.c_str());
    const float buttons =
        text_width(previous_change_label) + text_width(next_change_label) + 46.0f * u;
    const bool has_buttons = ui.results.history || words_width + gap + buttons <= room;
    const float right = at.x + room - (has_buttons ? buttons + gap : 0.0f);
    ImGui::PushClipRect({at.x, at.y - 4.0f * u}, {right, at.y + 2.0f * ImGui::GetFontSize()}, true);
    ImGui::SetCursorScreenPos(at);
    ImGui::TextUnformatted(words.c_str());
    name_widget(ui, "walk.words",
                words_width > right - at.x ? words + "\nWhat was just drawn."
                                           : "What was just drawn.");
    ImGui::PopClipRect();
    const std::string next = ui.results.a.cursor == cursor_end
                                 ? "end of the frame"
                                 : "next " + to_text(ui.results.a.cursor);
    ImGui::PushFont(ui.fonts.mono);
    if (at.x + words_width + gap + text_width(next.c_str()) <= right) {
        ImGui::SameLine(0.0f, gap);
        text_in(palette(ui.options.theme).dim, next);
        name_widget(ui, "walk.cursor",
                    "The cursor: the next piece of work. The same text goes with --to.");
    }
    ImGui::PopFont();
    if (has_buttons) draw_change_buttons(ui, {right + gap, at.y});
}

} // namespace

int transport_lines(const Ui& ui, float width) {
    const float u = ui.options.text_scale;
    const Groups g = measure(ui, width - 2.0f * bar_margin(ui));
    return line_count(flow(g.widths, 14.0f * u, width - 2.0f * bar_margin(ui) + 1.0f));
}

void draw_transport(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.bar);
    ImGui::Begin("transport", nullptr, panel_flags);
    const float room = area.size.x - 2.0f * bar_margin(ui);
    const Groups g = measure(ui, room);
    const std::vector<FlowPlace> places = flow(g.widths, 14.0f * u, room + 1.0f);
    const float height = 34.0f * u;
    const auto place = [&](int group) {
        return ImVec2{area.position.x + bar_margin(ui) + places[group].x,
                      area.position.y + 10.0f * u +
                          42.0f * u * static_cast<float>(places[group].line)};
    };
    ImVec2 at = place(0);
    struct Entry {
        const char* action;
        Icon icon;
        bool wide;
    };
    const Entry entries[] = {
        {"walk.first", Icon::first, false},
        {"walk.back", Icon::back, false},
        {"walk.play", ui.session.play.running ? Icon::pause : Icon::play, true},
        {"walk.step", Icon::step, false},
        {"walk.last", Icon::last, false}};
    for (const Entry& entry : entries) {
        const float width = entry.wide ? g.play : g.icon;
        icon_button(ui, entry.action, entry.icon, at, {width, height}, entry.wide);
        at.x += width + 6.0f * u;
    }
    const int last = static_cast<int>(g.widths.size()) - 1;
    if (g.compact) {
        draw_step_list(ui, place(1), {g.widths[1], height});
    } else {
        draw_step_choice(ui, place(1), {g.widths[1], height});
        draw_speed(ui, place(2), {g.widths[2], height});
    }
    draw_scrub_bar(ui, place(last), {g.widths[last], height});

    const float y = place(last).y + height + 6.0f * u;
    draw_words(ui, {area.position.x + bar_margin(ui), y}, room);
    ImGui::End();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
