#include "ui/canvas/side_row_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/element_names.h"
#include "base/numbers.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/marks.h"
#include "ui/ui.h"
#include "ui/widgets/code_entries.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What the table is drawn with.
struct Table {
    Ui& ui;
    const RowTableLayout& layout;
    ImDrawList* list;
    float left;        ///< of the table
    float top, bottom; ///< between which its lines are seen
    float scale;       ///< height of a line
    float u;

    float y_of(int row) const { return ui.canvas.place.origin.y + scale * static_cast<float>(row); }
    /// Is a line high enough for two lines of text?
    bool is_high() const {
        return scale >= layout.numbers->FontSize + 1.1f * ui.fonts.mono_small->FontSize + 2.0f * u;
    }
};

float header_height(const Ui& ui) {
    return ui.fonts.small->FontSize + 8.0f * ui.options.text_scale;
}

/// Text that ends at `right`.
/// @param middle of its line, screen pixels
void write(const Table& t, ImFont* font, const std::string& text, float right, float middle,
           const ImVec4& colour) {
    const float width = text_width(font, text);
    t.list->AddText(font, font->FontSize,
                    {std::round(right - width), std::round(middle - 0.5f * font->FontSize)},
                    packed(colour), text.c_str());
}

/// What values are weighted by.
std::string weight_word(const Table& t) {
    return std::string(weight_name(t.ui.results.a.frame));
}

/// One end of a row: its column in the colour of what wrote it, the name of that, and its weight.
void draw_end(const Table& t, int index, bool is_left) {
    const Palette& p = palette(t.ui.options.theme);
    const RowHistory& history = t.ui.results.a.rows;
    const auto i = static_cast<std::size_t>(index);
    const RowEnd& end = is_left ? history.rows.left[i] : history.rows.right[i];
    const EndWriter& writer = is_left ? history.left_by[i] : history.right_by[i];
    const int row = history.rows.first_row + index;
    const RowTableLayout::End& place = t.layout.ends[is_left ? 0 : 1];
    const bool is_set = writer.is_set();
    const bool is_extreme = end.column == empty_left || end.column == empty_right;
    // Coverage without samples sets ends that have no writer.
    const bool has_values = is_set || (!is_extreme && !walks_edges(t.ui.results.a.frame.stages));
    const Fonts& fonts = t.ui.fonts;

    const float top = t.y_of(row);
    const bool has_more = t.layout.has_writers ? !t.layout.is_flat && !t.layout.has_depths : true;
    const bool has_second = t.is_high() && has_more && (t.layout.has_writers ? has_values : is_set);
    const float second = 1.1f * fonts.mono_small->FontSize;
    const float middle = top + 0.5f * (t.scale - (has_second ? second : 0.0f));
    const float below = middle + 0.5f * (t.layout.numbers->FontSize + second);
    const float number = t.left + place.number;
    const std::string text = end_text(end, is_left);
    ImFont* const font = is_extreme && !t.layout.is_large ? fonts.mono_small : t.layout.numbers;
    const std::string by = is_set ? sample_text(writer.edge, writer.sample) : std::string();
    const std::string depth =
        has_values ? fixed(static_cast<double>(end.inv_w), 4) : std::string("—");
    // Half a line would be read as a different one.
    const float half = 0.5f * t.layout.numbers->FontSize;
    const float last = has_second ? below + 0.5f * fonts.mono_small->FontSize : middle + half;
    if (middle - half >= t.top && last <= t.bottom) {
        write(t, font, text, number, middle,
              is_set ? colour_of(edge_meaning(writer.edge), t.ui.options.theme) : p.dim);
        if (is_set && t.layout.has_writers)
            write(t, fonts.mono_small, by, t.left + place.writer, middle, p.dim);
        if (t.layout.has_depths) {
            write(t, fonts.mono_small, depth, t.left + place.depth, middle,
                  has_values ? p.text : p.dim);
        } else if (has_second) {
            write(t, fonts.mono_small, t.layout.has_writers ? weight_word(t) + " " + depth : by,
                  number, below, p.dim);
        }
    }

    const float low_y = std::max(top, t.top), high_y = std::min(top + t.scale, t.bottom);
    // On a low line a box is closer to the border, so it strikes nothing out.
    const float inset = std::clamp(0.5f * (t.scale - t.layout.numbers->FontSize), t.u, 3.0f * t.u);
    const ImVec2 low{t.left + place.left, top + inset};
    const ImVec2 high{t.left + place.right, top + t.scale - inset};
    const RowWrite write_now = just_written(t.ui, row);
    if (is_left ? write_now.left : write_now.right)
        draw_box_around(t.ui, t.list, low, high, p.changed);
    if (is_pointed_in_code(t.ui, row, is_left)) draw_box_around(t.ui, t.list, low, high, p.link);
    if (high_y - low_y < 1.0f) return;
    const float around = 4.0f * t.u; // the box around it lies within
    ImGui::SetCursorScreenPos({t.left + place.left - around, low_y});
    const std::string name = "canvas.rows." + std::to_string(row) + (is_left ? ".left" : ".right");
    const bool pressed = ImGui::InvisibleButton(
        name.c_str(), {place.right - place.left + 2.0f * around, high_y - low_y});
    register_widget(t.ui, name,
                    (has_values ? "x " + text +
                                      (t.layout.is_flat ? ""
                                                        : ", " + weight_word(t) + " " +
                                                              nine_digits_shown(end.inv_w)) +
                                      ". "
                                : std::string()) +
                        end_tooltip(t.ui, end, writer),
                    text);
    if (!pressed) return;
    t.ui.session.selection.row = row;
    if (is_set) go_to_sample(t.ui, writer.edge, writer.sample);
}

void draw_line(const Table& t, int index, std::optional<int> at_work, bool is_over) {
    const Palette& p = palette(t.ui.options.theme);
    const RowHistory& history = t.ui.results.a.rows;
    const int row = history.rows.first_row + index;
    const float top = t.y_of(row), bottom = top + t.scale;
    const float low_y = std::max(top, t.top), high_y = std::min(bottom, t.bottom);
    if (high_y - low_y < 1.0f || t.list->VtxBuffer.Size >= most_corners) return;
    const float mouse_y = ImGui::GetIO().MousePos.y;
    const bool is_hovered = is_over && mouse_y >= low_y && mouse_y < high_y;
    const bool is_lit = at_work == row || is_hovered || t.ui.session.selection.row == row ||
                        t.ui.inspector.hovered_row == row ||
                        (t.ui.canvas.hovered_pixel && t.ui.canvas.hovered_pixel->y == row);
    const float right = t.left + t.layout.width;
    if (is_lit) t.list->AddRectFilled({t.left, top}, {right, bottom}, packed(p.row_lit));
    t.list->AddLine({t.left, std::round(bottom)}, {right, std::round(bottom)}, packed(p.line));
    if (at_work == row) draw_current_bar(t.ui, t.list, {t.left, top + t.u}, bottom - t.u);
    if (is_hovered) t.ui.canvas.hovered_row = row;

    ImGui::SetCursorScreenPos({t.left, low_y});
    const std::string name = "canvas.rows." + std::to_string(row);
    if (overlapped_button(name.c_str(), {t.layout.width, high_y - low_y}))
        t.ui.session.selection.row = row;
    register_widget(t.ui, name,
                    "Row " + whole_text(row) + " of the picture: " +
                        element_name(entry_form, index) + " of leftPixels and rightPixels.");
    const std::string entry = "[" + std::to_string(index) + "]";
    register_text(t.ui, name, entry);
    ImFont* const font = t.layout.is_large ? t.layout.numbers : t.ui.fonts.mono_small;
    const float middle = 0.5f * (top + bottom), half = 0.5f * font->FontSize;
    if (middle - half >= t.top && middle + half <= t.bottom)
        write(t, font, entry, t.left + t.layout.entry, middle, at_work == row ? p.text : p.dim);
    draw_end(t, index, true);
    draw_end(t, index, false);
}

void draw_header(const Table& t, float canvas_top) {
    const Palette& p = palette(t.ui.options.theme);
    const Theme theme = t.ui.options.theme;
    const float middle = 0.5f * (canvas_top + t.top);
    const bool is_bare = !t.layout.has_writers;
    struct Title {
        const char* name;
        std::string text;
        float left, right;
        ImVec4 colour;
        const char* help;
    };
    const RowTableLayout::End &left = t.layout.ends[0], &right = t.layout.ends[1];
    const std::array titles{
        Title{"entry", "entry", 0.0f, t.layout.entry, p.dim,
              "The index i of leftPixels[i] and rightPixels[i]: the row of the picture minus the "
              "first row of the triangle."},
        Title{"left", is_bare ? "left" : "leftPixels", left.left, left.number,
              colour_of(Meaning::left_end, theme),
              "leftPixels[i].x: the column of the row's left end, and which sample wrote it: e1 "
              "[4] is edge 1, line[4]."},
        Title{"right", is_bare ? "right" : "rightPixels", right.left, right.number,
              colour_of(Meaning::right_end, theme),
              "rightPixels[i].x: the column of the row's right end, and which sample wrote it: e1 "
              "[4] is edge 1, line[4]."},
    };
    for (const Title& title : titles) {
        write(t, t.ui.fonts.small, title.text, t.left + title.right, middle, title.colour);
        ImGui::SetCursorScreenPos({t.left + title.left, canvas_top});
        ImGui::Dummy({title.right - title.left, t.top - canvas_top});
        register_widget(t.ui, std::string("canvas.rows.header.") + title.name, title.help);
    }
    if (t.layout.has_depths) {
        for (const RowTableLayout::End& end : t.layout.ends)
            write(t, t.ui.fonts.small, weight_word(t), t.left + end.depth, middle, p.dim);
    }
    t.list->AddLine({t.left, t.top}, {t.left + t.layout.width, t.top}, packed(p.line));
}

/// How many samples fell in none of the lines; below them, if there are any, and if there is room.
void draw_outside(const Table& t) {
    const RowHistory& history = t.ui.results.a.rows;
    const auto count = static_cast<std::int64_t>(history.outside.size());
    if (count == 0) return;
    const float below = t.y_of(history.rows.first_row + history.rows.size());
    ImFont* const font = t.ui.fonts.small;
    const float middle = below + font->FontSize;
    if (middle < t.top + font->FontSize || middle + font->FontSize > t.bottom) return;
    ImGui::PushFont(font);
    const std::string text = shortened(counted(count, "sample outside", "samples outside"),
                                       t.layout.width - 14.0f * t.u);
    ImGui::PopFont();
    t.list->AddText(font, font->FontSize,
                    {t.left + 8.0f * t.u, std::round(middle - 0.5f * font->FontSize)},
                    packed(colour_of(Meaning::fail, t.ui.options.theme)), text.c_str());
}

/// From left to right, screen pixels.
struct RowsReach {
    float left, right;
};

/// How much of the canvas the rows of the triangle shown take; none if no row is in view.
std::optional<RowsReach> reach_of_rows(const Ui& ui, const Pane& canvas) {
    const PicturePlace& place = ui.canvas.place;
    const PolygonRows& rows = ui.results.a.whole_rows;
    const auto index_at = [&](float y) {
        const float row = (y - place.origin.y) / place.scale - static_cast<float>(rows.first_row);
        return std::clamp(row, 0.0f, static_cast<float>(rows.size()));
    };
    const int first = static_cast<int>(index_at(canvas.low.y + header_height(ui)));
    const int end = static_cast<int>(std::ceil(index_at(canvas.high.y)));
    if (first >= end) return std::nullopt;
    float left = canvas.high.x, right = canvas.low.x;
    for (int i = first; i < end; ++i) {
        if (rows.is_empty_row(i)) continue;
        const auto at = static_cast<std::size_t>(i);
        const auto from = static_cast<float>(rows.left[at].column);
        const auto to = static_cast<float>(rows.right[at].column);
        left = std::min(left, place.origin.x + place.scale * from);
        right = std::max(right, place.origin.x + place.scale * (to + 1.0f));
    }
    return RowsReach{std::max(left, canvas.low.x), std::min(right, canvas.high.x)};
}

} // namespace

std::optional<SideRowTable>
place_row_table(const Ui& ui, const std::vector<RowTableLayout>& layouts, const Pane& canvas) {
    if (layouts.empty() || ui.canvas.place.scale < row_table_zoom(ui)) return std::nullopt;
    const std::optional<RowsReach> covered = reach_of_rows(ui, canvas);
    if (!covered) return std::nullopt;
    for (const RowTableLayout& layout : layouts) {
        for (const bool is_at_left : {false, true}) {
            const float left = std::round(is_at_left ? canvas.low.x : canvas.high.x - layout.width);
            // The row numbers are next to a table at the left.
            const float right = left + layout.width + (is_at_left ? ruler_size(ui).x : 0.0f);
            if (covered->left < right && left < covered->right) continue;
            return SideRowTable{layout, {left, left + layout.width, is_at_left}};
        }
    }
    return std::nullopt;
}

bool draw_side_row_table(Ui& ui, const SideRowTable& table, const Pane& canvas) {
    const RowTableLayout& layout = table.layout;
    const RowTablePlace& place = table.place;
    const Palette& p = palette(ui.options.theme);
    const PolygonRows& rows = ui.results.a.rows.rows;
    ImGui::SetCursorScreenPos({place.left, canvas.low.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, p.card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    const float height = std::max(canvas.high.y - canvas.low.y, 1.0f);
    ImGui::BeginChild("row table", {layout.width, height}, false,
                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                          ImGuiWindowFlags_NoScrollWithMouse);
    const Table t{ui,
                  layout,
                  ImGui::GetWindowDrawList(),
                  place.left,
                  canvas.low.y + header_height(ui),
                  canvas.high.y,
                  ui.canvas.place.scale,
                  ui.options.text_scale};
    const bool is_over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    const float first_y = (t.top - t.y_of(rows.first_row)) / t.scale;
    const float last_y = (t.bottom - t.y_of(rows.first_row)) / t.scale;
    const auto count = static_cast<float>(rows.size());
    const int first = static_cast<int>(std::clamp(std::floor(first_y), 0.0f, count));
    const int last = static_cast<int>(std::clamp(std::ceil(last_y), 0.0f, count));
    const std::optional<int> at_work = row_at_work(ui);
    ImGui::PushClipRect({place.left, t.top}, {place.right, t.bottom}, true);
    for (int i = first; i < last; ++i)
        draw_line(t, i, at_work, is_over);
    draw_outside(t);
    ImGui::PopClipRect();
    draw_header(t, canvas.low.y);
    const float border = place.is_at_left ? place.right - 0.5f : place.left + 0.5f;
    t.list->AddLine({border, canvas.low.y}, {border, canvas.high.y}, packed(p.line));
    ImGui::EndChild();
    register_widget(ui, "canvas.rows");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return is_over;
}

bool draw_row_table_for_inspector(Ui& ui, const Area& area) {
    if (!has_row_table_for_inspector(ui)) return false;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const std::optional<RowTableLayout> layout = large_row_table(ui, area.size.x - padding.x);
    const Pane canvas{{area.position.x, ui.canvas.frame_top},
                      {area.position.x + area.size.x, ui.canvas.frame_bottom}};
    if (!layout || !reach_of_rows(ui, canvas)) return false;
    ui.inspector.hovered_row = std::nullopt;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("inspector", nullptr,
                 panel_flags | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    draw_side_row_table(ui, {*layout, {area.position.x, area.position.x + layout->width, false}},
                        canvas);
    ImGui::End();
    return true;
}

} // namespace rasterwalk
