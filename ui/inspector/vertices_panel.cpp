#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "base/element_names.h"
#include "session/depth_view.h"
#include "session/tabs.h"
#include "stages/project.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/panels.h"
#include "ui/inspector/space_part.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// One line of the table: one number of the three vertices.
struct Line {
    const char* space; ///< only on the first line of a space
    const char* coordinate;
    const char* id; ///< of the formula in the vertex report
    int digits;
    const char* help;
    bool is_light = false; ///< only in the stages that compute light
};

const Line lines[] = {
    {"world", "x", "world.x", 3, "The vertex where the scene has it. x points right."},
    {"", "y", "world.y", 3, "y points down."},
    {"", "z", "world.z", 3, "z points into the picture."},
    {"− camera", "x", "minus_camera.x", 3,
     "The world moved so that the camera stands at the origin: P − C."},
    {"", "y", "minus_camera.y", 3, "P − C."},
    {"", "z", "minus_camera.z", 3, "P − C."},
    {"rotated", "x", "rotated.x", 3, "Turned so that the camera looks along +z: (P − C) R."},
    {"", "y", "rotated.y", 3, "(P − C) R."},
    {"", "z", "rotated.z", 3, "How far in front of the camera."},
    {"projected", "x", "projected.x", 3,
     "f x / z: pixels from the middle of the picture, before rounding."},
    {"", "y", "projected.y", 3, "f y / z: pixels from the middle of the picture, before rounding."},
    {"pixel", "column", "pixel.column", 0, ""}, // see help_of()
    {"", "row", "pixel.row", 0, ""},
    {"", "1/z", "zinv", 5, "What the depth buffer will hold: larger is nearer."},
    {"normal", "x", "normal.x", 3, "Across the surface, of unit length.", true},
    {"", "y", "normal.y", 3, "Across the surface, of unit length.", true},
    {"", "z", "normal.z", 3, "Across the surface, of unit length.", true},
    {"light", "red", "light.R.red", 3, "The light that this vertex gives back: R = ρ (D + N).",
     true},
    {"", "green", "light.R.green", 3, "The light that this vertex gives back: R = ρ (D + N).",
     true},
    {"", "blue", "light.R.blue", 3, "The light that this vertex gives back: R = ρ (D + N).", true},
};

/// Is the projection another than perspective? Then w is not z.
bool is_mixed(const Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    return vertex_rules(frame.settings, frame.scene->space).projection.mix > 0.0f;
}

/// The name of a line's number.
const char* coordinate_of(const Ui& ui, const Line& line) {
    return is_mixed(ui) && std::string_view(line.id) == "zinv" ? "1/w" : line.coordinate;
}

/// What a line shows; how a number becomes whole depends on what is set.
std::string help_of(const Ui& ui, const Line& line) {
    const std::string_view id = line.id;
    if (is_mixed(ui) && id.starts_with("projected."))
        return "Pixels from the middle of the picture, before rounding.";
    if (is_mixed(ui) && id == "zinv")
        return "By this values are weighed; the same at all vertices where rays are parallel.";
    if (id == "zinv" && depth_kind(ui.results.a.frame) != ClipDepth::inv_z)
        return "By this values are weighed; the depth buffer holds " +
               std::string(depth_words(ui.results.a.frame).name) + ".";
    if (!std::string_view(line.id).starts_with("pixel.")) return line.help;
    return how_made_whole(ui.results.a.frame.settings, ui.results.a.scene->space);
}

/// A narrow column has fewer digits; the formula below has them all.
/// @param column the room for a number, screen pixels
int digits_of(const Ui& ui, const Line& line, float column) {
    const bool has_room = text_width(ui.fonts.mono, "−000.000") <= column;
    if (!ui.inspector.is_narrow || has_room || line.digits == 0) return line.digits;
    return std::string_view(line.space) == "projected" || line.id == std::string_view("projected.y")
               ? 1
               : line.digits - 1;
}

/// Does the camera look another way than along z?
bool is_turned(const Ui& ui) {
    return camera_rotation(ui.results.a.frame.settings.camera) != glm::mat3(1.0f);
}

/// Has the line's space the same numbers as the one before it, at all three vertices? So it is
/// where the camera stands at the origin, or looks along z.
bool repeats_space_before(const Ui& ui, const Line& line) {
    const std::string_view id = line.id;
    const std::string space(id.substr(0, id.find('.')));
    if (space != "minus_camera" && space != "rotated") return false;
    const std::string before = space == "rotated" ? "minus_camera" : "world";
    for (const VertexReport& vertex : ui.results.a.inspected.vertices) {
        for (const char* const axis : {".x", ".y", ".z"}) {
            const Formula* const here = find_formula(vertex.formulas, space + axis);
            const Formula* const there = find_formula(vertex.formulas, before + axis);
            if (here == nullptr || there == nullptr) return false;
            if (here->result.value != there->result.value) return false;
        }
    }
    return true;
}

/// Is a line of the table shown? Where lines are few, a space that repeats the one before it is
/// not. A lesson that hides tabs keeps to what it speaks of: before light
/// is a subject there is none, and as long as the camera is not turned, it is not "rotated".
bool is_shown(const Ui& ui, const Line& line) {
    const bool keeps_short = hides_tabs(ui.session);
    if (line.is_light) {
        return shading_rule(ui.results.a.frame.settings) != Shading::unlit &&
               (!keeps_short || is_offered(ui.session, *find_tab("fragment")));
    }
    if (ui.inspector.is_low && repeats_space_before(ui, line)) return false;
    const bool is_rotated = std::string_view(line.id).starts_with("rotated.");
    return !is_rotated || !keeps_short || is_turned(ui);
}

/// How many columns of words stand before the numbers.
int label_columns(const Ui& ui) {
    return ui.inspector.is_narrow ? 1 : 2;
}

void draw_header(Ui& ui, int chosen) {
    ImGui::TableNextRow();
    for (int v = 0; v < triangle_corners; ++v) {
        ImGui::TableSetColumnIndex(label_columns(ui) + v);
        std::string label = vertex_name(v);
        const bool has_room =
            ImGui::CalcTextSize(label.c_str()).x <= ImGui::GetContentRegionAvail().x;
        if (ui.inspector.is_narrow || !has_room) label = short_vertex_name(v);
        const std::string name = "vertices.v" + std::to_string(v);
        if (number_cell(ui, name, label, palette(ui.options.theme).dim, v == chosen,
                        "Shows this vertex's formula below.")) {
            ui.session.selection.vertex = v;
        }
    }
}

/// The words before the numbers of a line; in a narrow page all in one column.
void draw_labels(Ui& ui, const Line& line) {
    const Palette& p = palette(ui.options.theme);
    const std::string name = std::string("vertices.").append(line.id);
    ImGui::TableNextColumn();
    if (*line.space != '\0') {
        const float y = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().CellPadding.y;
        const float x = ImGui::GetWindowPos().x;
        ImGui::GetWindowDrawList()->AddLine({x, y}, {x + ImGui::GetWindowWidth(), y},
                                            packed(p.line));
    }
    if (ui.inspector.is_narrow) {
        const bool is_pixel = std::string_view(line.space) == "pixel";
        const std::string space = is_pixel || *line.space == '\0' ? "" : line.space;
        ImGui::PushFont(ui.fonts.small);
        const std::string coordinate = coordinate_of(ui, line);
        right_aligned(space.empty() ? coordinate : space + " " + coordinate, p.dim);
        keep_item_whole(ui);
        ImGui::PopFont();
        name_widget(ui, name, help_of(ui, line));
        return;
    }
    if (*line.space != '\0') {
        ImGui::TextUnformatted(line.space);
        keep_item_whole(ui);
        name_widget(ui, name + ".space", help_of(ui, line));
    }
    ImGui::TableNextColumn();
    text_in(p.dim, coordinate_of(ui, line));
    keep_item_whole(ui);
    name_widget(ui, name, help_of(ui, line));
}

void draw_cell(Ui& ui, const Line& line, int v, int chosen) {
    const Palette& p = palette(ui.options.theme);
    const Formula* const formula = find_formula(
        ui.results.a.inspected.vertices[static_cast<std::size_t>(v)].formulas, line.id);
    const bool is_chosen = v == chosen && ui.inspector.chosen.vertex_number == line.id;
    const std::string name =
        std::string("vertices.").append(line.id).append(".v").append(std::to_string(v));
    if (formula == nullptr) {
        right_aligned("—", p.dim);
        name_widget(ui, name, "This vertex has no pixel.");
        return;
    }
    const float column = ImGui::GetContentRegionAvail().x;
    const std::string text =
        fixed(static_cast<double>(formula->result.value), digits_of(ui, line, column));
    if (number_cell(ui, name, text, v == chosen ? p.text : p.dim, is_chosen,
                    help_of(ui, line) + "\nClick: how it came to be.")) {
        ui.session.selection.vertex = v;
        ui.inspector.chosen.vertex_number = line.id;
    }
}

/// The columns of words and numbers, over a width that the panel leaves for them. The tables of the
/// panel share them: numbers of a vertex stand below its name.
bool begin_vertex_table(Ui& ui, const char* name, float width) {
    const float padding = (ui.inspector.is_narrow ? 2.0f : 6.0f) * ui.options.text_scale;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
    if (!ImGui::BeginTable(name, label_columns(ui) + triangle_corners,
                           ImGuiTableFlags_SizingFixedFit, {width, 0.0f})) {
        ImGui::PopStyleVar();
        return false;
    }
    // The numbers share what the words leave.
    float room = width;
    const auto add_words = [&](ImFont* font, const char* widest) {
        const float words = text_width(font, widest);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, words);
        room -= words;
    };
    if (ui.inspector.is_narrow) {
        add_words(ui.fonts.small, "− camera x ");
    } else {
        add_words(ui.fonts.text, "− camera ");
        add_words(ui.fonts.text, "column ");
    }
    for (int v = 0; v < triangle_corners; ++v) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                                std::max((room - 9.0f * padding) / triangle_corners, 1.0f));
    }
    return true;
}

void end_vertex_table() {
    ImGui::EndTable();
    ImGui::PopStyleVar();
}

void draw_lines(Ui& ui, int chosen, std::span<const Line> shown) {
    for (const Line& line : shown) {
        if (!is_shown(ui, line)) continue;
        ImGui::TableNextRow();
        draw_labels(ui, line);
        ImGui::PushFont(ui.fonts.mono);
        for (int v = 0; v < triangle_corners; ++v) {
            ImGui::TableSetColumnIndex(label_columns(ui) + v);
            draw_cell(ui, line, v, chosen);
        }
        ImGui::PopFont();
    }
}

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

/// What R v in place of v R would make of it, or the other way round.
std::string other_convention(const VertexReport& vertex, const Formula& formula,
                             Rotation rotation) {
    const std::string way =
        rotation == Rotation::row_vector ? "R v instead of v R" : "v R, which is right,";
    const bool is_of_pixel = !formula.id.starts_with("rotated.");
    if (is_of_pixel && vertex.transposed.rejection != Rejection::none) {
        return way + " would leave the triangle out: " +
               std::string(words(vertex.transposed.rejection).detail);
    }
    const Number other = vertex_number(vertex.transposed, formula.id);
    if (other.value == formula.result.value) return way + " would give the same";
    return way + " would give " + shown(other);
}

void draw_what_else(Ui& ui, const VertexReport& vertex, const Formula& formula) {
    const Palette& p = palette(ui.options.theme);
    const Settings& settings = ui.results.a.frame.settings;
    ImGui::PushStyleColor(ImGuiCol_Text, p.dim);
    if (formula.id.starts_with("pixel.")) {
        wrapped_text(other_roundings(vertex, formula.id, settings.vertex_rounding));
        keep_text_whole(ui);
        name_widget(ui, "vertices.other_roundings",
                    "The same number made whole in the other ways. int() cuts toward zero, so it "
                    "moves negative numbers the other way than positive ones.");
    }
    const bool has_camera = ui.results.a.scene->space == SceneSpace::world;
    // As long as nothing is turned there is no R to speak of.
    if (has_camera && is_turned(ui) && depends_on_rotation(formula.id)) {
        wrapped_text(other_convention(vertex, formula, settings.rotation));
        keep_text_whole(ui);
        name_widget(ui, "vertices.other_convention",
                    "A vector before the matrix or behind it: one is the transpose of the other, "
                    "and turns the camera the other way.");
    }
    ImGui::PopStyleColor();
}

void draw_formula_card(Ui& ui, const VertexReport& vertex) {
    begin_card(ui);
    // A vertex behind the camera does not leave the triangle out where it is cut.
    const Rejection why = ui.results.a.frame.rejection(*ui.results.a.triangle);
    if (why != Rejection::none) {
        wrapped_text("The triangle is left out: " + std::string(words(why).detail) + ".");
    }
    const Formula* formula = find_formula(vertex.formulas, ui.inspector.chosen.vertex_number);
    if (formula == nullptr) formula = find_formula(vertex.formulas, "rotated.z");
    // Where lines are few the formula itself says whose it is.
    Formula said = *formula;
    if (ui.inspector.is_low) {
        said.name = short_vertex_name(vertex.vertex) + " " + said.name;
    } else {
        text_in(palette(ui.options.theme).dim, vertex_name(vertex.vertex) + ": " + formula->help);
        name_widget(ui, "vertices.formula", formula->help);
        keep_text_whole(ui);
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

/// Scrolls to what was just drawn; of what is higher than the window the beginning is seen.
/// @param top of it, screen pixels
void bring_into_sight(float top) {
    const float bottom = ImGui::GetItemRectMax().y;
    if (bottom - top <= ImGui::GetWindowHeight()) {
        ImGui::SetScrollHereY(1.0f);
    } else {
        ImGui::SetScrollFromPosY(std::floor(top - 2.0f - ImGui::GetWindowPos().y), 0.0f);
    }
}

/// Where lines are few: the names of the vertices stay, and below them scrolls all the rest: the
/// numbers, and how the chosen one came to be right below its line. A number that is clicked brings
/// its formula into view.
void draw_as_one_page(Ui& ui, int chosen, const VertexReport& vertex, bool has_spaces) {
    const auto number = [&] {
        return std::pair{ui.session.selection.vertex, ui.inspector.chosen.vertex_number};
    };
    const auto before = number();
    const std::span<const Line> all(lines);
    const auto line = std::find_if(all.begin(), all.end(),
                                   [&](const Line& one) { return one.id == before.second; });
    const auto above =
        line == all.end() ? all.size() : static_cast<std::size_t>(line - all.begin()) + 1;
    // Beside the scroll bar of what is below.
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    if (begin_vertex_table(ui, "vertices.head", width)) {
        draw_header(ui, chosen);
        end_vertex_table();
    }
    ImGui::BeginChild("vertices.body", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_whole_lines(ui);
    if (begin_vertex_table(ui, "vertices", width)) {
        draw_lines(ui, chosen, all.first(above));
        end_vertex_table();
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetCursorScreenPos().y - style.ItemSpacing.y -
                      2.0f * style.CellPadding.y - ui.fonts.text->FontSize;
    draw_formula_card(ui, vertex);
    // The click has been in the frame before: there the formula stood elsewhere.
    const int frame = ImGui::GetFrameCount();
    if (ui.inspector.formula_frame + 1 == frame) bring_into_sight(row);
    if (above < all.size() && begin_vertex_table(ui, "vertices below", width)) {
        draw_lines(ui, chosen, all.subspan(above));
        end_vertex_table();
    }
    if (number() != before) ui.inspector.formula_frame = frame;
    if (has_spaces) draw_spaces(ui, chosen);
    end_whole_lines(ui);
    ImGui::EndChild();
}

/// The vertex that is explained: the one picked, or else the one just projected.
int vertex_on_show(const Ui& ui) {
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
    const int chosen = vertex_on_show(ui);
    draw_triangle_title(ui);
    const VertexReport& vertex = vertices[static_cast<std::size_t>(chosen)];
    const bool has_spaces = ui.results.a.frame.settings.transform == Transform::matrices;
    if (!ui.inspector.has_card) {
        draw_as_one_page(ui, chosen, vertex, has_spaces);
        return;
    }
    draw_with_card(
        ui, "vertices",
        [&] {
            if (begin_vertex_table(ui, "vertices", ImGui::GetContentRegionAvail().x)) {
                draw_header(ui, chosen);
                draw_lines(ui, chosen, lines);
                end_vertex_table();
            }
            if (has_spaces) draw_spaces(ui, chosen);
        },
        [&] { draw_formula_card(ui, vertex); });
}

} // namespace rasterwalk
