#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "explain/test_formulas.h"
#include "inspect/cut_corners.h"
#include "inspect/pixel_tests.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Which side of a triangle an edge is on.
const char* side_of(const EdgeFunction& edge) {
    if (edge.direction.dy == 0) return edge.direction.dx > 0 ? "top" : "bottom";
    return edge.direction.dy < 0 ? "left" : "right";
}

std::string e_text(std::int64_t e) {
    return with_minus_signs(significant(in_square_pixels(e), 7));
}

/// The names of a fan triangle's corners.
std::array<std::string, edge_function_count>
corner_names_of(const Ui& ui, const TestedPolygon& polygon, const TestedTriangle& triangle) {
    const std::optional<ClipHistory>& clip = ui.results.a.inspected.clip;
    const std::vector<std::string> all = drawn_corner_names(
        clip ? &*clip : nullptr, static_cast<int>(polygon.corners.size()), false);
    std::array<std::string, edge_function_count> names;
    std::transform(triangle.corners.begin(), triangle.corners.end(), names.begin(),
                   [&](int corner) { return all[static_cast<std::size_t>(corner)]; });
    return names;
}

/// A number that shows how it was computed when it is clicked, and hides that when clicked again.
void draw_number_of_test(Ui& ui, const Formula& formula, const std::string& text,
                         const ImVec4& colour) {
    std::string& chosen = ui.inspector.chosen.test_number;
    const bool is_chosen = chosen == formula.id;
    if (number_cell(ui, "inside." + formula.id, text, colour, is_chosen,
                    formula.help + "\nClick to see how it was calculated."))
        chosen = is_chosen ? std::string() : formula.id;
}

void draw_dim_headers(Ui& ui, std::initializer_list<const char*> titles, int right_aligned_from) {
    ImGui::PushFont(ui.fonts.small);
    ImGui::TableNextRow();
    int column = 0;
    for (const char* const title : titles) {
        if (column >= ImGui::TableGetColumnCount()) break;
        ImGui::TableNextColumn();
        if (column++ < right_aligned_from)
            text_in(palette(ui.options.theme).dim, title);
        else
            right_aligned(title, palette(ui.options.theme).dim);
    }
    ImGui::PopFont();
}

/// Follows the sum of the three values.
constexpr const char* sum_words = "2 · area";

/// What the columns of the edges need with the space between them, screen pixels. It does not
/// depend on the numbers, so nothing jumps.
std::array<float, 6> widths_of_edges(const Ui& ui) {
    constexpr std::array<const char*, 6> titles{"edge",  "side",      "E",
                                                "needs", "one right", "one down"};
    constexpr std::array<const char*, 6> widest{"edge 0", "bottom",  "−0000000",
                                                "≥ 0 ✓",  "−000000", "−000000"};
    std::array<float, 6> widths{};
    for (std::size_t i = 0; i < widths.size(); ++i) {
        widths[i] =
            std::max(text_width(ui.fonts.small, titles[i]), text_width(ui.fonts.mono, widest[i])) +
            2.0f * ImGui::GetStyle().CellPadding.x;
    }
    widths[3] = std::max(widths[3], text_width(ui.fonts.small, sum_words) +
                                        2.0f * ImGui::GetStyle().CellPadding.x);
    return widths;
}

/// Each edge with its value and what it asks for; below them their sum.
void draw_edges_of_test(Ui& ui, const PixelTest& test, const TestedTriangle& triangle,
                        const std::vector<Formula>& formulas) {
    const Palette& p = palette(ui.options.theme);
    const Theme theme = ui.options.theme;
    const std::array<float, 6> widths = widths_of_edges(ui);
    const float needed = std::accumulate(widths.begin(), widths.end(), 0.0f);
    const bool has_steps = needed <= ImGui::CalcItemWidth();
    if (!begin_lined_table("inside.edges", has_steps ? 6 : 4, ImGuiTableFlags_SizingStretchProp,
                           {ImGui::CalcItemWidth(), 0.0f}))
        return;
    for (int i = 0; i < ImGui::TableGetColumnCount(); ++i)
        ImGui::TableSetupColumn("", 0, widths[static_cast<std::size_t>(i)]);
    draw_dim_headers(ui, {"edge", "side", "E", "needs", "one right", "one down"}, 2);
    ImGui::PushFont(ui.fonts.mono);
    for (std::size_t i = 0; i < edge_function_count; ++i) {
        const EdgeFunction& edge = triangle.edges[i];
        const bool is_inner = edge.number < 0;
        const ImVec4 colour = is_inner ? p.dim : colour_of(edge_meaning(edge.number), theme);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_in(colour, is_inner ? "inner" : tested_edge_name(edge.number));
        ImGui::TableNextColumn();
        text_in(p.dim, side_of(edge));
        ImGui::TableNextColumn();
        draw_number_of_test(ui, formulas[i], e_text(test.e[i]), colour);
        ImGui::TableNextColumn();
        right_aligned(fmt::format("{} 0 {}", edge.owns_points ? "≥" : ">",
                                  test.passes[i] ? passed_sign : failed_sign),
                      colour_of(test.passes[i] ? Meaning::pass : Meaning::fail, theme));
        register_widget(
            ui, fmt::format("inside.asks.{}", i),
            edge.owns_points
                ? "A point exactly on this edge belongs to the triangle, by the fill rule."
                : "A point exactly on this edge does not belong to the triangle, by the fill "
                  "rule.");
        if (!has_steps) continue;
        ImGui::TableNextColumn();
        right_aligned(e_text(edge.one_right()), p.dim);
        ImGui::TableNextColumn();
        right_aligned(e_text(edge.one_down()), p.dim);
    }
    const Formula& area = formulas[edge_function_count];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_in(p.dim, area.name);
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    draw_number_of_test(ui, area, e_text(triangle.area), p.text);
    ImGui::TableNextColumn();
    right_aligned(sum_words, p.dim, ui.fonts.small);
    ImGui::PopFont();
    ImGui::EndTable();
}

/// The weights of the corners, below their names, and what they add up to.
void draw_weights(Ui& ui, const PixelTest& test,
                  const std::array<std::string, edge_function_count>& corners,
                  const std::vector<Formula>& formulas) {
    const Palette& p = palette(ui.options.theme);
    if (!ImGui::BeginTable("inside.weights", 5, ImGuiTableFlags_SizingStretchProp,
                           {ImGui::CalcItemWidth(), 0.0f}))
        return;
    for (const float width : {60.0f, 80.0f, 80.0f, 80.0f, 80.0f})
        ImGui::TableSetupColumn("", 0, width);
    draw_dim_headers(ui, {"", corners[0].c_str(), corners[1].c_str(), corners[2].c_str(), "sum"},
                     1);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_in(p.dim, "weight", ui.fonts.small);
    ImGui::PushFont(ui.fonts.mono);
    float sum = 0.0f;
    for (std::size_t i = 0; i < edge_function_count; ++i) {
        ImGui::TableNextColumn();
        sum += test.weights[i];
        draw_number_of_test(ui, formulas[edge_function_count + 1 + i],
                            fixed(static_cast<double>(test.weights[i]), 4), p.text);
    }
    ImGui::TableNextColumn();
    right_aligned(fixed(static_cast<double>(sum), 4), p.dim);
    ImGui::PopFont();
    ImGui::EndTable();
}

/// Where in the pixel it is tested: after the answer, in fewer words if there is little room.
void draw_place_of_test(Ui& ui, PixelSample sample, const PixelTest& test) {
    const bool is_centre = sample == PixelSample::centre;
    const std::string word = is_centre ? "centre " : "corner ";
    const std::string place = is_centre ? fmt::format("({}.5, {}.5)", test.column, test.row)
                                        : fmt::format("({}, {})", test.column, test.row);
    const std::vector<std::string> forms{"tested at its " + word + place, "at its " + word + place,
                                         word + place, place};
    const float right = ImGui::GetCursorPosX() + ImGui::CalcItemWidth();
    ImGui::SameLine();
    const float room = right - ImGui::GetCursorPosX();
    if (room < text_width(place)) ImGui::NewLine();
    const float width = room < text_width(place) ? ImGui::CalcItemWidth() : room;
    text_in(palette(ui.options.theme).dim, first_fitting(forms, width));
}

/// If not all pixels of the box are tested, says which of the row are.
void draw_tested_columns(Ui& ui, const PixelTest& test, const TestedPolygon& polygon) {
    if (polygon.tested_columns == columns_of_box) return;
    const TestedTriangle& triangle = polygon.triangles[static_cast<std::size_t>(test.triangle)];
    const ColumnRange tested = polygon.tested_columns(triangle, test.row);
    const std::string columns = fmt::format("{} to {}", tested.first, tested.last);
    const std::vector<std::string> forms{
        fmt::format("row {}: columns {} are tested out of {} to {} in the box", test.row, columns,
                    triangle.box.left, triangle.box.right - 1),
        fmt::format("row {}: columns {} are tested", test.row, columns),
        fmt::format("columns {}", columns)};
    ImGui::PushFont(ui.fonts.small);
    text_in(palette(ui.options.theme).dim, first_fitting(forms, ImGui::CalcItemWidth()));
    ImGui::PopFont();
    register_widget(
        ui, "inside.interval",
        "The interval of this row between the places where the edges cross it. Only there "
        "can all three E be 0 or more, so only these pixels are tested.");
}

} // namespace

std::optional<PixelTest> shown_test(const Ui& ui) {
    const RunResults& a = ui.results.a;
    if (!a.triangle || !a.frame.is_drawn(*a.triangle) || !tests_pixels(a.frame.stages)) return {};
    const TestedPolygon& tested = a.rows.rows.tested;
    const bool is_at_test =
        a.done && a.done->triangle == *a.triangle && a.done->phase == Phase::tests;
    if (is_at_test) return test_at_step(tested, a.done->index, a.done->step, a.frame.stages);
    const std::optional<glm::ivec2>& pixel = ui.session.selection.pixel;
    if (!pixel) return {};
    return test_of_pixel(tested, *a.triangle, pixel->x, pixel->y, a.cursor, a.frame.stages);
}

void draw_pixel_test(Ui& ui, const PixelTest& test) {
    const TestedPolygon& polygon = ui.results.a.rows.rows.tested;
    const TestedTriangle& triangle = polygon.triangles[static_cast<std::size_t>(test.triangle)];
    const auto corners = corner_names_of(ui, polygon, triangle);
    const Settings& settings = ui.results.a.frame.settings;
    const std::vector<Formula> formulas = test_formulas(triangle, test, corners, settings);
    begin_card(ui);
    const Meaning answer = test.is_inside ? Meaning::pass : Meaning::fail;
    text_in(colour_of(answer, ui.options.theme),
            fmt::format("pixel ({}, {}): {}", test.column, test.row,
                        test.is_inside ? "inside" : "outside"));
    register_widget(ui, "inside.pixel",
                    with_minus_signs(pixel_test_text(test)) +
                        "\nA pixel is inside if it passes the test at all three edges.");
    draw_place_of_test(ui, settings.pixel_sample, test);
    draw_tested_columns(ui, test, polygon);
    draw_edges_of_test(ui, test, triangle, formulas);
    if (triangle.area != 0) draw_weights(ui, test, corners, formulas);
    if (const Formula* const formula = find_formula(formulas, ui.inspector.chosen.test_number)) {
        const std::optional<Source> clicked = draw_formula(ui, *formula, "inside.formula");
        if (clicked && clicked->kind == SourceKind::formula)
            ui.inspector.chosen.test_number = clicked->name;
    }
    end_card(ui);
}

} // namespace rasterwalk
