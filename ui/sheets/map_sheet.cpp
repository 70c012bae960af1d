#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "base/numbers.h"
#include "lessons/course.h"
#include "ui/actions/open_lesson.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook map_look{.sheet = Sheet::map,
                         .window = "map",
                         .widgets = "map",
                         .title = "Map of the course",
                         .close_help = "Closes the map. Key: Esc",
                         .size = {1400.0f, 640.0f}};

/// Design pixels: between the columns, where lines run; the height of a lesson's box, and from one
/// to the next; the number at the left of its title.
constexpr float gutter = 52.0f, box_height = 27.0f, box_step = 36.0f, number_room = 28.0f;

/// Design pixels: where more columns have no room, the map is wider than its window.
constexpr float least_column = 60.0f;

/// A lesson where the map draws it, screen pixels.
struct MapBox {
    const Lesson* lesson = nullptr;
    std::size_t track = 0;
    std::vector<std::size_t> needs; ///< indices of boxes
    ImVec2 low{0.0f, 0.0f}, high{0.0f, 0.0f};
};

/// The lessons of the course, each with those it builds on, and without places.
std::vector<MapBox> boxes_of(const Course& course, const std::vector<Lesson>& lessons) {
    std::vector<MapBox> boxes;
    for (const Lesson& lesson : lessons) {
        MapBox box;
        box.lesson = &lesson;
        box.track = place_in(course, lesson.id).track;
        for (const std::string& id : needs_of(course, lesson.id)) {
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                if (boxes[i].lesson->id == id) box.needs.push_back(i);
            }
        }
        boxes.push_back(std::move(box));
    }
    return boxes;
}

/// A column for each track, and its lessons in it from top to bottom.
void place_boxes(std::vector<MapBox>& boxes, ImVec2 start, float column_width, float u) {
    std::vector<int> rows;
    for (MapBox& box : boxes) {
        rows.resize(std::max(rows.size(), box.track + 1), 0);
        const float x =
            start.x + gutter * u + static_cast<float>(box.track) * (column_width + gutter * u);
        const float y = start.y + static_cast<float>(rows[box.track]++) * box_step * u;
        box.low = {std::round(x), std::round(y)};
        box.high = {std::round(x + column_width), std::round(y + box_height * u)};
    }
}

/// A lesson, and all that it builds on, directly or through others.
std::set<std::size_t> all_needs(const std::vector<MapBox>& boxes, std::size_t index) {
    std::set<std::size_t> found{index};
    // What a lesson needs comes before it, so one pass from the end finds all.
    for (std::size_t i = index + 1; i-- > 0;) {
        if (found.count(i) > 0) found.insert(boxes[i].needs.begin(), boxes[i].needs.end());
    }
    return found;
}

/// From the lesson that is needed to the one that needs it: straight down to the next one of the
/// column, in an arc at its left to a later one, and across from one column to another.
void draw_need(const MapBox& from, const MapBox& to, ImU32 colour, float thickness, float u) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float from_y = 0.5f * (from.low.y + from.high.y), to_y = 0.5f * (to.low.y + to.high.y);
    if (from.track != to.track) {
        const float bend = 0.8f * gutter * u;
        list->AddBezierCubic({from.high.x, from_y}, {from.high.x + bend, from_y},
                             {to.low.x - bend, to_y}, {to.low.x, to_y}, colour, thickness);
        return;
    }
    if (to.low.y - from.high.y < box_height * u) {
        const float x = from.low.x + 0.5f * number_room * u;
        list->AddLine({x, from.high.y}, {x, to.low.y}, colour, thickness);
        return;
    }
    const float rows = (to_y - from_y) / (box_step * u);
    const float bend = std::min(12.0f + 5.0f * rows, 46.0f) * u;
    list->AddBezierCubic({from.low.x, from_y}, {from.low.x - bend, from_y}, {to.low.x - bend, to_y},
                         {to.low.x, to_y}, colour, thickness);
}

std::string box_help(const std::vector<MapBox>& boxes, const MapBox& box) {
    std::string help =
        fmt::format("{}, {} min.\n{}", box.lesson->title, box.lesson->minutes, box.lesson->about);
    std::vector<std::string> needs;
    for (const std::size_t i : box.needs)
        needs.push_back(
            fmt::format("{} ({})", lesson_number(boxes[i].lesson->id), boxes[i].lesson->title));
    if (!needs.empty()) help += fmt::format("\nBuilds on {}.", fmt::join(needs, " and "));
    return help;
}

/// @return is the lesson chosen?
bool draw_box(Ui& ui, const MapBox& box, bool is_done, bool is_lit, const std::string& help) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string name = "map.lesson." + box.lesson->id;
    ImGui::SetCursorScreenPos(box.low);
    const bool is_pressed =
        ImGui::InvisibleButton(name.c_str(), {box.high.x - box.low.x, box.high.y - box.low.y});
    register_widget(ui, name, help, box.lesson->title);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(box.low, box.high, packed(is_lit ? p.row_lit : p.button), 4.0f * u);
    const bool is_open = box.lesson->id == ui.session.lesson;
    list->AddRect(box.low, box.high, packed(is_open ? p.link : p.line), 4.0f * u, 0,
                  is_open ? 2.0f : 1.0f);
    ImFont* const font = ui.fonts.text;
    const float y = std::round(0.5f * (box.low.y + box.high.y - font->FontSize));
    const std::string mark = is_done ? "✓" : std::to_string(lesson_number(box.lesson->id));
    list->AddText(font, font->FontSize, {box.low.x + 7.0f * u, y},
                  packed(is_done ? colour_of(Meaning::pass, ui.options.theme) : p.dim),
                  mark.c_str());
    const float left = box.low.x + number_room * u + 6.0f * u;
    const std::string title = shortened_to_words(box.lesson->title, box.high.x - left - 6.0f * u);
    list->AddText(font, font->FontSize, {left, y}, packed(p.text), title.c_str());
    return is_pressed;
}

/// @param columns one for each track; one more for lessons of no track
void draw_track_heads(Ui& ui, const Course& course, std::size_t columns, ImVec2 start,
                      float column_width) {
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImFont* const bold = ui.fonts.bold;
    ImFont* const small = ui.fonts.small;
    const Palette& p = palette(ui.options.theme);
    for (std::size_t i = 0; i < columns; ++i) {
        const float x = start.x + gutter * u + static_cast<float>(i) * (column_width + gutter * u);
        const bool is_track = i < course.tracks.size();
        const std::string title = is_track ? course.tracks[i].title : "Other lessons";
        list->AddText(bold, bold->FontSize, {x, start.y}, packed(p.text),
                      shortened(title, column_width).c_str());
        if (!is_track) continue;
        const TrackSize size = size_of_track(course, i, ui.lesson.lessons.all());
        const std::string words = fmt::format("{}, {}", counted(size.lessons, "lesson", "lessons"),
                                              hours_text(size.minutes));
        list->AddText(small, small->FontSize, {x, start.y + bold->FontSize + 2.0f * u},
                      packed(p.dim), words.c_str());
    }
}

/// The map, in the room of the current window; the id of the lesson chosen, or empty.
std::string draw_map(Ui& ui) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    const Course& course = ui.lesson.lessons.course();
    std::vector<MapBox> boxes = boxes_of(course, ui.lesson.lessons.all());
    if (boxes.empty()) {
        text_in(p.dim, "There are no lessons.");
        return {};
    }
    std::size_t columns = 1;
    for (const MapBox& box : boxes)
        columns = std::max(columns, box.track + 1);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - 2.0f * u;
    const float column_width =
        std::max(width / static_cast<float>(columns) - gutter * u, least_column * u);
    const float head = ui.fonts.bold->FontSize + ui.fonts.small->FontSize + 12.0f * u;
    if (!course.tracks.empty()) draw_track_heads(ui, course, columns, start, column_width);
    place_boxes(boxes, {start.x, start.y + head}, column_width, u);
    std::set<std::size_t> lit;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (ImGui::IsMouseHoveringRect(boxes[i].low, boxes[i].high) && ImGui::IsWindowHovered())
            lit = all_needs(boxes, i);
    }
    ImVec4 quiet = p.dim;
    quiet.w = 0.6f;
    // The lit lines come last, so that no other crosses them.
    for (const bool is_lit : {false, true}) {
        for (std::size_t to = 0; to < boxes.size(); ++to) {
            if ((lit.count(to) > 0) != is_lit) continue;
            for (const std::size_t from : boxes[to].needs) {
                // A line behind the boxes of another track would be hard to follow: only those of
                // the lesson that is pointed at are drawn.
                if (!is_lit && boxes[to].track > boxes[from].track + 1) continue;
                draw_need(boxes[from], boxes[to], packed(is_lit ? p.link : quiet),
                          (is_lit ? 2.5f : 1.5f) * u, u);
            }
        }
    }
    std::string chosen;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool is_done = ui.lesson.scores.of(i).is_done;
        if (draw_box(ui, boxes[i], is_done, lit.count(i) > 0, box_help(boxes, boxes[i])))
            chosen = boxes[i].lesson->id;
    }
    return chosen;
}

} // namespace

void draw_map_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.is_open(Sheet::map)) return;
    begin_sheet(ui, map_look, window);
    constexpr std::string_view hint =
        "Lines run from a lesson to those that build on it. Point at one to see all it needs.";
    ImGui::SameLine(0.0f, 24.0f * ui.options.text_scale);
    if (text_width(ui.fonts.small, hint) <= ImGui::GetContentRegionAvail().x)
        text_in(palette(ui.options.theme).dim, hint, ui.fonts.small);
    else
        ImGui::NewLine();
    ImGui::BeginChild("lessons", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
    const std::string chosen = draw_map(ui);
    ImGui::EndChild();
    end_sheet();
    if (chosen.empty()) return;
    ui.sheets.show(Sheet::map, false);
    open_lesson(ui, chosen, ui.lesson.progress.of(chosen).last_step);
}

} // namespace rasterwalk
