#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "base/element_names.h"
#include "stages/project.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/panels.h"
#include "ui/inspector/space_part.h"
#include "ui/inspector/vertices_table.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// "floor would give 0, round would give 0"
std::string other_roundings(const VertexReport& vertex, std::string_view id,
                            VertexRounding in_force) {
    std::string text;
    for (const VertexRounding other :
         {VertexRounding::truncate, VertexRounding::floor, VertexRounding::round}) {
        if (other == in_force) continue;
        const ShadedVertex& shaded = vertex.by_rounding[static_cast<std::size_t>(other)];
        text.append(text.empty() ? "" : ", ").append(rounding_function(other));
        text.append(" would give ").append(shown(vertex_number(shaded, id)));
    }
    return text;
}

/// What R v in place of v R would give, or the other way round.
std::string other_convention(const VertexReport& vertex, const Formula& formula,
                             Rotation rotation) {
    const std::string convention =
        rotation == Rotation::row_vector ? "R v instead of v R" : "the correct v R";
    const bool is_of_pixel = !formula.id.starts_with("rotated.");
    if (is_of_pixel && vertex.transposed.rejection != Rejection::none) {
        return convention + " would leave the triangle out: " +
               std::string(words(vertex.transposed.rejection).detail);
    }
    const Number other = vertex_number(vertex.transposed, formula.id);
    if (other.value == formula.result.value) return convention + " would give the same";
    return convention + " would give " + shown(other);
}

void draw_what_else(Ui& ui, const VertexReport& vertex, const Formula& formula) {
    const Palette& p = palette(ui.options.theme);
    const Settings& settings = ui.results.a.frame.settings;
    ImGui::PushStyleColor(ImGuiCol_Text, p.dim);
    if (formula.id.starts_with("pixel.")) {
        wrapped_text(other_roundings(vertex, formula.id, settings.vertex_rounding));
        register_widget(ui, "vertices.other_roundings",
                        "The same number with the other roundings. int() cuts toward zero, so it "
                        "moves negative numbers in the opposite direction from positive ones.");
    }
    const bool has_camera = ui.results.a.scene->space == SceneSpace::world;
    // While nothing is turned there is no R to discuss.
    if (has_camera && is_camera_turned(ui) && depends_on_rotation(formula.id)) {
        wrapped_text(other_convention(vertex, formula, settings.rotation));
        register_widget(ui, "vertices.other_convention",
                        "A vector on the left or on the right of the matrix. One matrix is the "
                        "transpose of the other, and turns the camera the other way.");
    }
    ImGui::PopStyleColor();
}

void draw_vertex_card(Ui& ui, const VertexReport& vertex) {
    begin_card(ui);
    // A vertex behind the camera does not drop the triangle if it is clipped.
    const Rejection why = ui.results.a.frame.rejection(*ui.results.a.triangle);
    if (why != Rejection::none)
        wrapped_text("The triangle is left out: " + std::string(words(why).detail) + ".");
    const Formula* formula = find_formula(vertex.formulas, ui.inspector.chosen.vertex_number);
    if (formula == nullptr) formula = find_formula(vertex.formulas, "rotated.z");
    // Where lines are few the formula itself names its vertex.
    Formula said = *formula;
    if (ui.inspector.is_low) {
        said.name = short_vertex_name(vertex.vertex) + " " + said.name;
    } else {
        text_in(palette(ui.options.theme).dim, vertex_name(vertex.vertex) + ": " + formula->help);
        register_widget(ui, "vertices.formula", formula->help);
    }
    ImGui::PushFont(ui.inspector.is_low ? ui.fonts.small : ui.fonts.text);
    const std::optional<Source> clicked = draw_formula(ui, said, "vertices.formula");
    draw_what_else(ui, vertex, *formula);
    ImGui::PopFont();
    end_card(ui);
    if (!clicked) return;
    if (clicked->kind == SourceKind::formula) ui.inspector.chosen.vertex_number = clicked->name;
    go_to_source(ui, *clicked);
}

/// Scrolls to what was just drawn; if that is higher than the window, to its beginning.
/// @param top of it, screen pixels
void bring_into_sight(float top) {
    const float bottom = ImGui::GetItemRectMax().y;
    if (bottom - top <= ImGui::GetWindowHeight()) {
        scroll_here(1.0f);
    } else {
        ImGui::SetScrollFromPosY(std::floor(top - 2.0f - ImGui::GetWindowPos().y), 0.0f);
    }
}

/// Where lines are few: the names of the vertices stay, and everything else scrolls below them: the
/// numbers, and how the chosen one was computed right below its line. Clicking a number brings its
/// formula into view.
void draw_as_one_page(Ui& ui, int chosen, const VertexReport& vertex, bool has_spaces) {
    const auto number = [&] {
        return std::pair{ui.session.selection.vertex, ui.inspector.chosen.vertex_number};
    };
    const auto before = number();
    const std::span<const VertexLine> all = vertex_lines();
    const auto line = std::find_if(all.begin(), all.end(),
                                   [&](const VertexLine& one) { return one.id == before.second; });
    const auto above =
        line == all.end() ? all.size() : static_cast<std::size_t>(line - all.begin()) + 1;
    // Next to the scroll bar of what is below.
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    if (begin_vertex_table(ui, "vertices.head", width)) {
        draw_vertex_header(ui, chosen);
        end_vertex_table();
    }
    ImGui::BeginChild("vertices.body", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_line_clip();
    if (begin_vertex_table(ui, "vertices", width)) {
        draw_vertex_lines(ui, chosen, all.first(above));
        end_vertex_table();
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetCursorScreenPos().y - style.ItemSpacing.y -
                      2.0f * style.CellPadding.y - ui.fonts.text->FontSize;
    draw_vertex_card(ui, vertex);
    // The click was in the previous frame, where the formula was elsewhere.
    const int frame = ImGui::GetFrameCount();
    if (ui.inspector.formula_frame + 1 == frame) bring_into_sight(row);
    if (above < all.size() && begin_vertex_table(ui, "vertices below", width)) {
        draw_vertex_lines(ui, chosen, all.subspan(above));
        end_vertex_table();
    }
    if (number() != before) ui.inspector.formula_frame = frame;
    if (has_spaces) draw_spaces(ui, chosen);
    end_line_clip();
    ImGui::EndChild();
}

/// The vertex that is explained: the picked one, or else the one just projected.
int shown_vertex(const Ui& ui) {
    const std::optional<Cursor>& done = ui.results.a.done;
    const bool is_vertex =
        done && done->phase == Phase::vertices && done->triangle == *ui.results.a.triangle;
    const int followed = is_vertex ? done->index : 0;
    return std::clamp(ui.session.selection.vertex.value_or(followed), 0, triangle_corners - 1);
}

} // namespace

void draw_vertices_panel(Ui& ui) {
    const std::vector<VertexReport>& vertices = ui.results.a.inspected.vertices;
    if (!ui.results.a.triangle || vertices.empty()) {
        text_in(palette(ui.options.theme).dim, "The scene has no triangles.");
        return;
    }
    const int chosen = shown_vertex(ui);
    draw_triangle_title(ui);
    const VertexReport& vertex = vertices[static_cast<std::size_t>(chosen)];
    const bool has_spaces = ui.results.a.frame.settings.transform == Transform::matrices;
    if (!ui.inspector.has_card) {
        draw_as_one_page(ui, chosen, vertex, has_spaces);
        return;
    }
    const auto numbers = [&] {
        if (begin_vertex_table(ui, "vertices", ImGui::GetContentRegionAvail().x)) {
            draw_vertex_header(ui, chosen);
            draw_vertex_lines(ui, chosen, vertex_lines());
            end_vertex_table();
        }
        if (has_spaces) draw_spaces(ui, chosen);
    };
    draw_panel(ui, "vertices", {{numbers, true}}, [&] { draw_vertex_card(ui, vertex); });
}

} // namespace rasterwalk
