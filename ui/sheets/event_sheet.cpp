#include <algorithm>
#include <string>

#include <imgui.h>

#include "base/numbers.h"
#include "session/walk.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook events_look{.sheet = Sheet::events,
                            .window = "moments",
                            .widgets = "events",
                            .title = "Moments",
                            .close_help = "Closes this sheet. Key: Esc",
                            .size = {740.0f, 480.0f},
                            .is_aside = true};

/// The last moment of the triangle shown that is done; -1 if none is.
int last_done(const Ui& ui, int triangle) {
    const RunResults& run = ui.results.a;
    if (!run.done || run.done->triangle != triangle) return -1;
    return Timeline(run.frame).ordinal(*run.done);
}

/// Lists the triangle shown, if a different one is listed or the search has changed.
void renew_list(const Ui& ui, const std::string& search, EventSheet& sheet) {
    const int triangle = ui.results.a.triangle.value_or(-1);
    const bool is_same_triangle =
        sheet.frame_number == ui.results.a.frame_number && sheet.list.triangle == triangle;
    if (!is_same_triangle) {
        sheet.list = list_events(ui.results.a.frame, triangle);
        sheet.frame_number = ui.results.a.frame_number;
    }
    const int first = std::max(last_done(ui, triangle), 0) / most_events * most_events;
    if (is_same_triangle && first == sheet.first && search == sheet.searched) return;
    sheet.first = first;
    sheet.searched = search;
    sheet.found = find_events(sheet.list, search, first, first + most_events);
}

void copy_events(Ui& ui) {
    const EventSheet& sheet = ui.sheets.events;
    std::string text;
    for (const int moment : sheet.found)
        text.append(event_text(sheet.list, moment)).append("\n");
    ImGui::SetClipboardText(text.c_str());
    show_info(ui.session,
              "Copied: " + counted(static_cast<int>(sheet.found.size()), "moment", "moments") +
                  ".");
}

void draw_event(Ui& ui, int index, int done) {
    const EventSheet& sheet = ui.sheets.events;
    const int moment = sheet.found[static_cast<std::size_t>(index)];
    ImGui::PushID(moment);
    const bool is_clicked =
        ImGui::Selectable(event_text(sheet.list, moment).c_str(), moment == done);
    ImGui::PopID();
    register_widget(ui, "events." + std::to_string(moment), "Goes to just after this moment.");
    if (!is_clicked) return;
    const Timeline timeline(ui.results.a.frame);
    go_to(ui.session, timeline,
          timeline.next(event_cursor(sheet.list, moment), Granularity::moment));
}

/// Brings the line of the last moment into view when time has moved.
void follow_line(const Ui& ui, int done) {
    const EventSheet& sheet = ui.sheets.events;
    const bool appears = ImGui::IsWindowAppearing();
    if (!(ui.follow_cursor || appears) || done < 0) return;
    const auto place = std::lower_bound(sheet.found.begin(), sheet.found.end(), done);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float y = line * static_cast<float>(place - sheet.found.begin());
    const float height = ImGui::GetWindowHeight();
    const bool is_seen = y >= ImGui::GetScrollY() && y + line <= ImGui::GetScrollY() + height;
    if (!is_seen) ImGui::SetScrollY(std::max(y - 0.4f * height, 0.0f));
}

void draw_event_lines(Ui& ui) {
    const EventSheet& sheet = ui.sheets.events;
    const Palette& p = palette(ui.options.theme);
    if (sheet.list.count() == 0) {
        text_in(p.dim, "This triangle is left out, so it has no moments.");
        return;
    }
    if (sheet.found.empty()) {
        text_in(p.dim, "No moment contains these words.");
        return;
    }
    const int done = last_done(ui, sheet.list.triangle);
    ImGui::PushFont(ui.fonts.mono);
    ImGui::BeginChild("events", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
    follow_line(ui, done);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(sheet.found.size()), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_event(ui, i, done);
    }
    ImGui::EndChild();
    ImGui::PopFont();
}

void draw_event_head(Ui& ui) {
    const EventSheet& sheet = ui.sheets.events;
    ImGui::SameLine();
    if (button(ui, "events.copy", "Copy", Look::plain, "Copies the lines that are listed.")) {
        copy_events(ui);
    }
    ImGui::PushFont(ui.fonts.mono);
    const int listed = static_cast<int>(sheet.found.size());
    text_in(palette(ui.options.theme).dim, "triangles[" + std::to_string(sheet.list.triangle) +
                                               "]: " + std::to_string(listed) + " of " +
                                               counted(sheet.list.count(), "moment", "moments"));
    ImGui::PopFont();
    register_widget(ui, "events.count",
                    "The triangle shown, and how many of its moments are listed. If there are very "
                    "many, only those around the cursor are.");
}

} // namespace

void draw_event_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.is_open(Sheet::events)) return;
    renew_list(ui, ui.sheets.search_of(Sheet::events), ui.sheets.events);
    begin_sheet(ui, events_look, window);
    draw_event_head(ui);
    draw_sheet_search(ui, events_look, "search: edge 1, row 12, left end",
                      "Lists only the moments whose line contains these words.");
    draw_event_lines(ui);
    end_sheet();
}

} // namespace rasterwalk
