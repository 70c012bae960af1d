#include "ui/actions/row_table_layout.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <string>

#include "session/canvas_view.h"
#include "session/tabs.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_tab.h"
#include "ui/actions/outside.h"
#include "ui/ui.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The table takes no more than this part of the canvas; a table of numbers only may take more.
constexpr float largest_part = 0.42f;
constexpr float largest_bare_part = 0.52f;

/// The height of a line to be read from afar, in heights of its letters.
constexpr float large_line = 1.12f;

/// The widest texts of the table of the triangle shown, as they will be when it is complete.
struct Widest {
    float number = 0.0f, writer = 0.0f, entry = 0.0f;
};

/// What is shown of a table, and its letters.
struct TableForm {
    bool has_writers, has_depths, is_large;
    ImFont* numbers;
};

/// The letters of entries, and of ends that no sample has reached.
const ImFont* quiet_font(const Ui& ui, const TableForm& form) {
    return form.is_large ? form.numbers : ui.fonts.mono_small;
}

/// The height of a line to be read from afar.
float large_line_height(const ImFont* numbers) {
    return std::ceil(large_line * numbers->FontSize);
}

Widest widest_texts(const Ui& ui, const TableForm& form) {
    const RowHistory& history = ui.results.a.rows;
    int low = INT_MAX, high = INT_MIN;
    for (const ScreenVertex& vertex :
         ui.results.a.frame.triangle_vertices(*ui.results.a.triangle)) {
        low = std::min(low, vertex.column);
        high = std::max(high, vertex.column);
    }
    Widest widest;
    for (const int column : {low, high, 100})
        widest.number = std::max(widest.number, text_width(form.numbers, std::to_string(column)));
    const auto longest = std::max_element(history.edge_samples.begin(), history.edge_samples.end());
    const int samples = longest != history.edge_samples.end() ? *longest : 1;
    widest.writer = text_width(ui.fonts.mono_small, sample_text(0, std::max(samples - 1, 10)));
    widest.entry = std::max(
        text_width(ui.fonts.small, "entry"),
        text_width(quiet_font(ui, form), "[" + std::to_string(history.rows.size() - 1) + "]"));
    return widest;
}

/// Is 1/z the same at all vertices of the triangle shown? Then it says nothing about its rows.
bool has_one_depth(const Ui& ui) {
    const PolygonCorners vertices = ui.results.a.frame.triangle_vertices(*ui.results.a.triangle);
    return std::all_of(vertices.begin(), vertices.end(), [&](const ScreenVertex& vertex) {
        return vertex.inv_w == vertices[0].inv_w;
    });
}

RowTableLayout layout_of(const Ui& ui, const TableForm& form) {
    const auto [has_writers, has_depths, is_large, numbers] = form;
    const Widest widest = widest_texts(ui, form);
    const float u = ui.options.text_scale;
    const float gap = 9.0f * u, edge = 10.0f * u;
    RowTableLayout layout;
    layout.has_writers = has_writers;
    layout.has_depths = has_depths;
    layout.is_large = is_large;
    layout.numbers = numbers;
    layout.is_flat = has_one_depth(ui);
    layout.entry = edge + widest.entry;
    const std::array titles{has_writers ? "leftPixels" : "left",
                            has_writers ? "rightPixels" : "right"};
    float x = layout.entry;
    for (int i = 0; i < 2; ++i) {
        RowTableLayout::End& end = layout.ends[i];
        const float texts = widest.number + (has_writers ? widest.writer + gap : 0.0f);
        const float extreme = text_width(quiet_font(ui, form), "+INT_MAX");
        const float title = text_width(ui.fonts.small, titles[static_cast<std::size_t>(i)]);
        end.left = x + 1.6f * gap;
        end.number = end.left + std::max({texts, extreme, title});
        end.writer = end.number - widest.number - gap;
        end.depth = end.number;
        if (has_depths) end.depth += gap + text_width(ui.fonts.mono_small, "0.0000");
        end.right = x = end.depth;
    }
    layout.width = x + edge;
    return layout;
}

/// Moves the ends apart until the table is as wide.
void spread(RowTableLayout& layout, float width) {
    const float step = (width - layout.width) / 3.0f;
    for (int i = 0; i < 2; ++i) {
        RowTableLayout::End& end = layout.ends[i];
        const float shift = step * static_cast<float>(i + 1);
        for (float* const x : {&end.left, &end.right, &end.number, &end.writer, &end.depth})
            *x += shift;
    }
    layout.width = width;
}

} // namespace

bool is_lecture_of_rows(const Ui& ui) {
    return ui.options.is_lecture && tab_below(ui.session) == "rows" && !is_settings_open(ui) &&
           !is_drawer_open(ui);
}

bool wants_row_table(const Ui& ui) {
    const RunResults& a = ui.results.a;
    // Edge functions have no left and right ends.
    const bool has_ends = coverage_rule(a.frame.settings) != Coverage::edge_functions;
    return ui.session.canvas.row_table && has_ends && !is_comparing(ui) && a.triangle &&
           a.frame.settings.stage >= Stage::edges && a.frame.is_drawn(*a.triangle) &&
           a.rows.rows.size() > 0;
}

float row_table_zoom(const Ui& ui) {
    return std::max(cell_zoom, std::ceil(1.15f * ui.fonts.mono_small->FontSize));
}

bool has_row_table_for_inspector(const Ui& ui) {
    // A lesson that points at something around the table in the Rows tab wants that tab.
    return is_lecture_of_rows(ui) && wants_row_table(ui) &&
           shown_on_canvas(ui) == CanvasShows::picture &&
           !ui.lesson.pointed_at.starts_with("rows.");
}

float large_row_table_zoom(const Ui& ui) {
    return large_line_height(ui.fonts.mono_small);
}

std::optional<RowTableLayout> large_row_table(const Ui& ui, float width) {
    const float line = ui.canvas.place.scale;
    if (line < large_row_table_zoom(ui)) return {};
    ImFont* const numbers =
        line < large_line_height(ui.fonts.mono) ? ui.fonts.mono_small : ui.fonts.mono;
    for (const TableForm& form :
         {TableForm{true, true, true, numbers}, TableForm{true, false, true, numbers},
          TableForm{false, false, true, numbers}}) {
        if (form.has_depths && has_one_depth(ui)) continue;
        RowTableLayout layout = layout_of(ui, form);
        if (layout.width > width) continue;
        spread(layout, width);
        return layout;
    }
    return {};
}

std::vector<RowTableLayout> row_table_layouts(const Ui& ui, float canvas_width) {
    std::vector<RowTableLayout> layouts;
    if (!wants_row_table(ui) || is_lecture_of_rows(ui)) return layouts;
    const auto offer = [&](bool has_writers, bool has_depths, float largest) {
        RowTableLayout layout = layout_of(ui, {has_writers, has_depths, false, ui.fonts.mono});
        if (layout.width <= largest * canvas_width) layouts.push_back(layout);
    };
    if (!has_one_depth(ui)) offer(true, true, 0.75f * largest_part);
    offer(true, false, largest_part);
    offer(false, false, largest_bare_part);
    return layouts;
}

} // namespace rasterwalk
