#include "ui/bars/moment_line.h"

#include <span>
#include <string>
#include <vector>

#include "pipeline/shadow_pass.h"
#include "session/moments.h"
#include "ui/actions/actions.h"
#include "ui/actions/outside.h"
#include "ui/bars/bars.h"
#include "ui/bars/pixel_words.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr const char* previous_change_label = "‹ pixel";
constexpr const char* next_change_label = "pixel ›";

/// Small, at the right end of the last line: next and previous change of the picked pixel.
void draw_change_buttons(Ui& ui, ImVec2 at) {
    const float u = ui.options.text_scale;
    const ImVec2 size{0, ImGui::GetFontSize() + 6.0f * u};
    const Look look = ui.results.history ? Look::plain : Look::quiet;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(10.0f * u, 2.0f * u));
    ImGui::SetCursorScreenPos({at.x, at.y - 3.0f * u});
    if (button(ui, "walk.previous_change", tr(previous_change_label), look,
               tooltip_of("walk.previous_change"), size)) {
        find_action("walk.previous_change").run(ui);
    }
    ImGui::SameLine(0.0f, 6.0f * u);
    if (button(ui, "walk.next_change", tr(next_change_label), look, tooltip_of("walk.next_change"),
               size)) {
        find_action("walk.next_change").run(ui);
    }
    ImGui::PopStyleVar();
}

float change_buttons_width(const Ui& ui) {
    return text_width(tr(previous_change_label)) + text_width(tr(next_change_label)) +
           46.0f * ui.options.text_scale;
}

/// In a lecture, where the canvas has no header, these are in the same place: how much of the
/// picture is seen.
struct ZoomButton {
    const char *name, *label, *action;
};
constexpr ZoomButton zoom_buttons[] = {{"canvas.fit", "fit", "view.fit"},
                                       {"canvas.zoom_triangle", "triangle", "view.zoom_selection"}};

/// The view from outside has no triangle to zoom to.
std::span<const ZoomButton> zoom_buttons_of(const Ui& ui) {
    const bool has_picture = shown_on_canvas(ui) != CanvasShows::outside;
    return std::span(zoom_buttons).first(has_picture ? 2 : 1);
}

void draw_zoom_buttons(Ui& ui, ImVec2 at) {
    const float u = ui.options.text_scale;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(10.0f * u, 2.0f * u));
    ImGui::SetCursorScreenPos({at.x, at.y - 3.0f * u});
    for (const ZoomButton& b : zoom_buttons_of(ui)) {
        if (&b != zoom_buttons) ImGui::SameLine(0.0f, 6.0f * u);
        if (button(ui, b.name, tr(b.label), Look::plain, tooltip_of(b.action),
                   {0, ImGui::GetFontSize() + 6.0f * u})) {
            find_action(b.action).run(ui);
        }
    }
    ImGui::PopStyleVar();
}

float zoom_buttons_width(const Ui& ui) {
    const float u = ui.options.text_scale;
    float width = -6.0f * u;
    for (const ZoomButton& b : zoom_buttons_of(ui))
        width += text_width(tr(b.label)) + 26.0f * u;
    return width;
}

/// What was drawn last, in words; from the longest form to the shortest.
std::vector<std::string> moment_forms(const Ui& ui) {
    if (!ui.results.a.done) return {tr("nothing is drawn yet"), tr("nothing yet")};
    const Cursor& done = *ui.results.a.done;
    const Frame& frame = ui.results.a.frame;
    const Language& language = current_language();
    const std::string whole = describe_moment(frame, done, language);
    const std::string name = moment_name(done, language);
    if (is_square(done))
        return {whole, describe_square_in_short(frame, done.square, language), name, to_text(done)};
    return {whole, name, moment_text(frame, done)};
}

/// What the diamonds above the time line mean, from the longest form to the shortest.
std::vector<std::string> marks_forms() {
    return {tr("the two runs differ here"), tr("the runs differ"), "A ≠ B"};
}

/// The same next to its mark, if there is room.
void draw_marks_key(Ui& ui, ImVec2 at, float room) {
    std::vector<std::string> said = marks_forms();
    said.emplace_back();
    const std::string words = first_fitting(said, room - difference_key_indent(ui));
    if (words.empty()) return;
    ImGui::SetCursorScreenPos(at);
    draw_difference_key(ui, words);
    register_widget(
        ui, "walk.differences",
        tr("Each diamond above the line is a place where the two runs do something different. "
           "Click one to go there; J and K go to the next one and the previous one."));
}

/// What the diamonds mean, if there are any, and the piece of work that comes next, if there is
/// room for it too.
void draw_next(Ui& ui, ImVec2 at, float room) {
    const Cursor& cursor = ui.results.a.cursor;
    const Frame& frame = ui.results.a.frame;
    const bool is_over = cursor == cursor_end && frame.pass < 0;
    const Language& language = current_language();
    const std::string moment = moment_name(cursor, language);
    const std::string next = is_over ? tr("{} is complete", pass_name(frame.pass, language))
                             : cursor == cursor_end ? moment
                                                    : tr("next {}", moment);
    const float width = text_width(next.c_str());
    const bool has_marks = !ui.transport.differences.marks.empty();
    const float key =
        group_gap(ui) + difference_key_indent(ui) + text_width(marks_forms().back().c_str());
    const bool shows_next = width + (has_marks ? key : 0.0f) <= room;
    if (has_marks) {
        const float used = shows_next ? width + group_gap(ui) : 0.0f;
        draw_marks_key(ui, {at.x + used, at.y}, room - used);
    }
    if (!shows_next) return;
    ImGui::SetCursorScreenPos(at);
    text_in(palette(ui.options.theme).dim, next);
    register_widget(ui, "walk.cursor",
                    tr("The cursor: the next piece of work. On the command line it is --to {}.",
                       moment_text(frame, cursor)));
}

/// The pixel under the pointer, if no other line describes it; small, to have room.
void draw_pixel(Ui& ui, ImVec2 at, float room) {
    const float line = ImGui::GetFontSize();
    ImGui::PushFont(ui.fonts.small);
    ImGui::SetCursorScreenPos({at.x, at.y + 0.5f * (line - ImGui::GetFontSize())});
    put_text(pixel_words(ui, room));
    register_widget(ui, "status.pixel", tr("The pixel under the pointer."));
    ImGui::PopFont();
}

} // namespace

float draw_done_moment(Ui& ui, ImVec2 at, float room) {
    const std::vector<std::string> said = moment_forms(ui);
    const std::string words = first_fitting(said, room);
    ImGui::SetCursorScreenPos(at);
    put_text(words);
    register_widget(ui, "walk.words",
                    words == said.front() ? tr("What was just drawn.")
                                          : said.front() + "\n" + tr("What was just drawn."));
    return text_width(words.c_str());
}

void draw_next_moment(Ui& ui, ImVec2 at, float room) {
    const float buttons = room - change_buttons_width(ui);
    draw_next(ui, at, buttons - group_gap(ui));
    if (!ui.options.is_lecture) draw_change_buttons(ui, {at.x + buttons, at.y});
}

void draw_moment_line(Ui& ui, ImVec2 at, float room) {
    const float gap = 18.0f * ui.options.text_scale;
    const bool is_lecture = ui.options.is_lecture;
    const float buttons = is_lecture ? zoom_buttons_width(ui) : change_buttons_width(ui);
    const float words = text_width(moment_forms(ui).front());
    const bool has_buttons = is_lecture || ui.results.history || words + gap + buttons <= room;
    const float rest = room - (has_buttons ? buttons + gap : 0.0f);
    if (spares_status_line(ui) && ui.canvas.hovered_pixel) {
        draw_pixel(ui, at, rest);
    } else {
        const float used = draw_done_moment(ui, at, rest) + gap;
        draw_next(ui, {at.x + used, at.y}, rest - used);
    }
    if (!has_buttons) return;
    const ImVec2 place{at.x + rest + gap, at.y};
    if (is_lecture) {
        draw_zoom_buttons(ui, place);
    } else {
        draw_change_buttons(ui, place);
    }
}

} // namespace rasterwalk
