#include <algorithm>
#include <string>

#include "scene/error.h"
#include "session/lesson_link.h"
#include "ui/actions.h"
#include "ui/markdown.h"
#include "ui/panels/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace rasterwalk {

namespace {

/// A widget that has not been drawn for so many frames is not on the screen.
constexpr int frames_to_appear = 3;

/// The tab of the inspector in which a widget stands; empty if it stands elsewhere.
std::string tab_of(std::string_view widget) {
    struct Place {
        std::string_view start, tab;
    };
    static constexpr Place places[] = {{"rows.", "rows"},        {"bench.", "rows"},
                                       {"triangle.", "rows"},    {"vertices.", "vertices"},
                                       {"setting.", "settings"}, {"settings.", "settings"},
                                       {"reset.", "settings"}};
    for (const Place& place : places) {
        if (widget.starts_with(place.start)) return std::string(place.tab);
    }
    return {};
}

/// Points at a widget; where its tab is closed, at the tab. A click opens the tab.
void show_widget(Ui& ui, const std::string& widget, bool is_click) {
    LessonView& lesson = ui.lesson;
    const std::string tab = tab_of(widget);
    if (is_click && !tab.empty()) ui.session.tab = tab;
    const bool is_closed = !tab.empty() && ui.session.tab != tab;
    const std::string target = is_closed ? "tab." + tab : widget;
    if (lesson.pointed_at != target) lesson.frames_unseen = 0;
    lesson.pointed_at = target;
    lesson.is_held = lesson.is_held || is_click;
}

void follow_link(Ui& ui, const std::string& target) {
    try {
        const LessonLink link = parse_lesson_link(target);
        ui.session.notice.clear();
        follow_lesson_link(ui.session, ui.results.frame, link);
        if (link.kind == LessonLink::Kind::show) show_widget(ui, link.argument, true);
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

/// A link that points at something does so while the pointer rests on it.
void hover_link(Ui& ui, const std::string& target) {
    try {
        const LessonLink link = parse_lesson_link(target);
        if (link.kind == LessonLink::Kind::show) show_widget(ui, link.argument, false);
    } catch (const Error&) {
        // Said when the link is followed.
    }
}

/// Ends the pointing: where a link only was hovered at once, else with the next click or key.
void release_pointer(Ui& ui, bool is_hovered) {
    LessonView& lesson = ui.lesson;
    if (lesson.pointed_at.empty()) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_key =
        std::any_of(std::begin(io.KeysDown), std::end(io.KeysDown), [](bool down) { return down; });
    if (lesson.is_held && (ImGui::IsMouseClicked(0) || is_key)) lesson.is_held = false;
    if (++lesson.frames_unseen > frames_to_appear && lesson.is_held) {
        ui.session.notice = "'" + lesson.pointed_at.substr(0, 60) + "' is not on the screen now.";
        lesson.is_held = false;
    }
    if (!lesson.is_held && !is_hovered) lesson.pointed_at.clear();
}

void go_to_stage(Ui& ui, int stage) {
    find_action("stage." + std::string(stage_list()[static_cast<std::size_t>(stage)].name)).run(ui);
}

void draw_heading(Ui& ui, const StageInfo& info) {
    ImGui::PushFont(ui.fonts.small);
    text_in(palette(ui.options.theme).dim,
            "Stage " + std::to_string(static_cast<int>(info.stage) + 1) + " of " +
                std::to_string(stage_count) + " · lab: " + std::string(info.section));
    ImGui::PopFont();
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
}

/// The stage's own title and summary, where its note cannot be read.
void draw_missing(Ui& ui, const StageInfo& info, const StageNote& note) {
    ImGui::PushFont(ui.fonts.title);
    wrapped_text(info.title);
    ImGui::PopFont();
    ImGui::Spacing();
    wrapped_text(info.summary);
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    wrapped_text("The page about it is missing: " + note.fault);
    ImGui::PopStyleColor();
}

void draw_text(Ui& ui, const StageInfo& info, float width) {
    LessonView& lesson = ui.lesson;
    const StageNote& note = lesson.notes.find(note_name(ui.session));
    if (lesson.path != note.path) {
        ImGui::SetScrollY(0.0f);
        lesson.path = note.path;
    }
    draw_heading(ui, info);
    int hovered = -1;
    if (!note.fault.empty()) {
        draw_missing(ui, info, note);
    } else {
        const MarkdownEvents events =
            draw_markdown(ui, lesson.page, note.text, width, "lesson.link.");
        const std::vector<std::string>& links = document_of(*lesson.page).links;
        hovered = events.hovered;
        if (hovered >= 0) hover_link(ui, links[static_cast<std::size_t>(hovered)]);
        if (events.followed >= 0) follow_link(ui, links[static_cast<std::size_t>(events.followed)]);
    }
    release_pointer(ui, hovered >= 0);
    ImGui::Dummy({0.0f, 10.0f * ui.options.text_scale});
}

float footer_height(const Ui& ui) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y +
           26.0f * ui.options.text_scale;
}

/// A bar a stage, lit up to the one on show.
void draw_bars(Ui& ui, int stage, float width) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float gap = 6.0f * u;
    const float bar = (width - gap * (stage_count - 1)) / stage_count;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = 16.0f * u;
    for (int i = 0; i < stage_count; ++i) {
        const float x = start.x + static_cast<float>(i) * (bar + gap);
        ImGui::SetCursorScreenPos({x, start.y});
        const StageInfo& info = stage_list()[static_cast<std::size_t>(i)];
        const std::string name = "lesson.bar." + std::string(info.name);
        if (ImGui::InvisibleButton(name.c_str(), {std::max(bar, 1.0f), height})) {
            go_to_stage(ui, i);
        }
        const bool hovered = ImGui::IsItemHovered();
        name_widget(ui, name, info.title);
        const float half = (hovered ? 3.5f : 2.0f) * u;
        const float middle = start.y + 0.5f * height;
        ImGui::GetWindowDrawList()->AddRectFilled({x, middle - half}, {x + bar, middle + half},
                                                  packed(i <= stage ? p.link : p.button), half);
    }
    ImGui::SetCursorScreenPos({start.x, start.y + height});
}

/// "‹ Edges" at the left, "Fill ›" at the right.
void draw_neighbours(Ui& ui, int stage, float width) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    if (stage > 0) {
        const StageInfo& previous = stage_list()[static_cast<std::size_t>(stage - 1)];
        if (button(ui, "lesson.previous", "‹  " + std::string(previous.title), Look::plain,
                   "To the stage before.")) {
            go_to_stage(ui, stage - 1);
        }
    }
    if (stage + 1 < stage_count) {
        const StageInfo& next = stage_list()[static_cast<std::size_t>(stage + 1)];
        const std::string label = std::string(next.title) + "  ›";
        ImGui::SetCursorScreenPos({start.x + width - button_width(label), start.y});
        if (button(ui, "lesson.next", label, Look::plain, "To the next stage.")) {
            go_to_stage(ui, stage + 1);
        }
    }
}

void draw_footer(Ui& ui, const StageInfo& info, float width) {
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    draw_bars(ui, static_cast<int>(info.stage), width);
    ImGui::SetCursorScreenPos({start.x, start.y + 24.0f * u});
    draw_neighbours(ui, static_cast<int>(info.stage), width);
}

/// Text that goes on below the edge fades out there.
void draw_fade(const Ui& ui, float width) {
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) return;
    const ImVec4& ground = palette(ui.options.theme).ground;
    const ImVec2 low = ImGui::GetWindowPos();
    const float bottom = low.y + ImGui::GetWindowHeight();
    const float top = bottom - 30.0f * ui.options.text_scale;
    const ImU32 clear = packed(ground, 0.0f), full = packed(ground);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor({low.x, top}, {low.x + width, bottom},
                                                        clear, clear, full, full);
}

/// @param gutter space for the scroll bar at the right of the text
void draw_page(Ui& ui, float gutter) {
    const StageInfo& info = stage_list()[static_cast<std::size_t>(ui.session.settings.stage)];
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float width = std::max(room.x - gutter, 1.0f);
    // In a low window the footer scrolls with the text.
    const bool is_low = room.y < 4.5f * footer_height(ui);
    const float height = is_low ? room.y : room.y - footer_height(ui);
    ImGui::BeginChild("lesson.text", {room.x, std::max(height, 1.0f)}, false,
                      ImGuiWindowFlags_NoNav);
    draw_text(ui, info, width);
    if (is_low) draw_footer(ui, info, width);
    draw_fade(ui, width);
    ImGui::EndChild();
    if (!is_low) draw_footer(ui, info, width);
}

} // namespace

void draw_lesson_column(Ui& ui, const Area& area) {
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const float padding = ImGui::GetStyle().WindowPadding.x;
    // The scroll bar stands in the column's right margin.
    ImGui::SetNextWindowContentSize({area.size.x - padding, 0.0f});
    ImGui::Begin("lesson", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    draw_page(ui, padding);
    ImGui::End();
}

void draw_lesson_page(Ui& ui) {
    draw_page(ui, ImGui::GetStyle().ScrollbarSize + 2.0f * ui.options.text_scale);
}

} // namespace rasterwalk
