#include "ui/inspector/vertices_table.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/element_names.h"
#include "session/tabs.h"
#include "stages/project.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const VertexLine line_list[] = {
    {"world", "x", "world.x", 3, "The vertex where the scene has it. x points right."},
    {"", "y", "world.y", 3, "y points down."},
    {"", "z", "world.z", 3, "z points into the picture."},
    {"− camera", "x", "minus_camera.x", 3,
     "The world moved so that the camera is at the origin: P − C."},
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
    {"normal", "x", "normal.x", 3, "Perpendicular to the surface, of unit length.", true},
    {"", "y", "normal.y", 3, "Perpendicular to the surface, of unit length.", true},
    {"", "z", "normal.z", 3, "Perpendicular to the surface, of unit length.", true},
    {"shine", "n·h", "light.n_dot_h", 3,
     "How close the normal is to halfway between lamp and eye: 1 at the mirror image of the lamp.",
     true, true},
    {"", "(n·h)^e", "light.power", 3,
     "The larger the exponent, the faster the highlight falls off.", true, true},
    {"", "S red", "light.S.red", 3, "The highlight, which is added on top.", true, true},
    {"", "S green", "light.S.green", 3, "The highlight, which is added on top.", true, true},
    {"", "S blue", "light.S.blue", 3, "The highlight, which is added on top.", true, true},
    {"light", "red", "light.R.red", 3, "The light that this vertex reflects: R = ρ (D + N).", true},
    {"", "green", "light.R.green", 3, "The light that this vertex reflects: R = ρ (D + N).", true},
    {"", "blue", "light.R.blue", 3, "The light that this vertex reflects: R = ρ (D + N).", true},
};

/// Is the projection anything but perspective? Then w is not z.
bool is_mixed(const Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    return vertex_rules(frame.settings, frame.scene->space).projection.mix > 0.0f;
}

/// The name of a line's number.
const char* coordinate_of(const Ui& ui, const VertexLine& line) {
    return is_mixed(ui) && std::string_view(line.id) == "zinv" ? "1/w" : line.coordinate;
}

/// Do mistakes of the camera or of the projection change what a line shows?
bool has_mistake(const Ui& ui, const VertexLine& line) {
    const Settings& settings = ui.results.a.frame.settings;
    const std::string_view id = line.id;
    const bool is_of_camera = id.starts_with("minus_camera.") || id.starts_with("rotated.");
    if (is_of_camera) return camera_move_rule(settings) != CameraMove::subtracted;
    return (id == "zinv" && divided_by_rule(settings) != DividedBy::z) ||
           (id.starts_with("projected.") && settings.image_axes == ImageAxes::exchanged);
}

/// What a line shows, as its formula says it.
std::string formula_help(const Ui& ui, const VertexLine& line) {
    for (const VertexReport& vertex : ui.results.a.inspected.vertices) {
        if (const Formula* const formula = find_formula(vertex.formulas, line.id))
            return formula->help;
    }
    return line.help;
}

/// The space a line belongs to, before its coordinate.
const char* space_of(const Ui& ui, const VertexLine& line) {
    if (std::string_view(line.id) != "minus_camera.x") return line.space;
    switch (camera_move_rule(ui.results.a.frame.settings)) {
    case CameraMove::subtracted:
        break;
    case CameraMove::added:
        return "+ camera";
    case CameraMove::rotated_first:
        return "v R";
    }
    return line.space;
}

/// What a line shows; how a number becomes whole depends on the settings.
std::string help_of(const Ui& ui, const VertexLine& line) {
    const std::string_view id = line.id;
    if (is_mixed(ui) && id.starts_with("projected."))
        return "Pixels from the middle of the picture, before rounding.";
    if (is_mixed(ui) && id == "zinv")
        return "The weight used for interpolation; it is the same at all vertices if the rays are "
               "parallel.";
    if (id == "zinv" && depth_kind(ui.results.a.frame) != ClipDepth::inv_z)
        return "The weight used for interpolation; the depth buffer holds " +
               std::string(depth_words(ui.results.a.frame).name) + ".";
    if (!id.starts_with("pixel."))
        return has_mistake(ui, line) ? formula_help(ui, line) : line.help;
    return how_rounded(ui.results.a.frame.settings, ui.results.a.scene->space);
}

/// A narrow column has fewer digits; the formula below has them all.
/// @param column the room for a number, screen pixels
int digits_of(const Ui& ui, const VertexLine& line, float column) {
    const bool has_room = text_width(ui.fonts.mono, "−000.000") <= column;
    if (!ui.inspector.is_narrow || has_room || line.digits == 0) return line.digits;
    return std::string_view(line.space) == "projected" || line.id == std::string_view("projected.y")
               ? 1
               : line.digits - 1;
}

/// Does the line's space have the same numbers as the previous one, at all three vertices? It does
/// if the camera is at the origin, or looks along z.
bool repeats_space_before(const Ui& ui, const VertexLine& line) {
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

/// Is a line of the table shown? Where lines are few, a space that repeats the previous one is not.
/// A lesson that hides tabs keeps to its subject: light has no lines before it is one, and
/// "rotated" has none while the camera is not turned.
bool is_shown(const Ui& ui, const VertexLine& line) {
    const bool keeps_short = hides_tabs(ui.session);
    if (line.is_highlight && ui.results.a.frame.settings.light.model == LightModel::lambert)
        return false;
    if (line.is_light) {
        return shading_rule(ui.results.a.frame.settings) != Shading::unlit &&
               (!keeps_short || is_offered(ui.session, *find_tab("fragment")));
    }
    if (ui.inspector.is_low && repeats_space_before(ui, line)) return false;
    const bool is_rotated = std::string_view(line.id).starts_with("rotated.");
    return !is_rotated || !keeps_short || is_camera_turned(ui);
}

/// How many columns of words come before the numbers.
int label_columns(const Ui& ui) {
    return ui.inspector.is_narrow ? 1 : 2;
}

/// The words before the numbers of a line; in a narrow page all in one column.
void draw_labels(Ui& ui, const VertexLine& line) {
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
        const std::string space = is_pixel || *line.space == '\0' ? "" : space_of(ui, line);
        ImGui::PushFont(ui.fonts.small);
        const std::string coordinate = coordinate_of(ui, line);
        right_aligned(space.empty() ? coordinate : space + " " + coordinate, p.dim);
        ImGui::PopFont();
        register_widget(ui, name, help_of(ui, line));
        return;
    }
    if (*line.space != '\0') {
        put_text(space_of(ui, line));
        register_widget(ui, name + ".space", help_of(ui, line));
    }
    ImGui::TableNextColumn();
    text_in(p.dim, coordinate_of(ui, line));
    register_widget(ui, name, help_of(ui, line));
}

void draw_cell(Ui& ui, const VertexLine& line, int v, int chosen) {
    const Palette& p = palette(ui.options.theme);
    const Formula* const formula = find_formula(
        ui.results.a.inspected.vertices[static_cast<std::size_t>(v)].formulas, line.id);
    const bool is_chosen = v == chosen && ui.inspector.chosen.vertex_number == line.id;
    const std::string name =
        std::string("vertices.").append(line.id).append(".v").append(std::to_string(v));
    if (formula == nullptr) {
        right_aligned("—", p.dim);
        register_widget(ui, name, "This vertex has no pixel.");
        return;
    }
    const float column = ImGui::GetContentRegionAvail().x;
    const std::string text =
        fixed(static_cast<double>(formula->result.value), digits_of(ui, line, column));
    if (number_cell(ui, name, text, v == chosen ? p.text : p.dim, is_chosen,
                    help_of(ui, line) + "\nClick to see how it was calculated.")) {
        ui.session.selection.vertex = v;
        ui.inspector.chosen.vertex_number = line.id;
    }
}

} // namespace

std::span<const VertexLine> vertex_lines() {
    return line_list;
}

bool is_camera_turned(const Ui& ui) {
    return camera_rotation(ui.results.a.frame.settings.camera) != glm::mat3(1.0f);
}

void draw_vertex_header(Ui& ui, int chosen) {
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

bool begin_vertex_table(Ui& ui, const char* name, float width) {
    const float padding = (ui.inspector.is_narrow ? 2.0f : 6.0f) * ui.options.text_scale;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
    if (!ImGui::BeginTable(name, label_columns(ui) + triangle_corners,
                           ImGuiTableFlags_SizingFixedFit, {width, 0.0f})) {
        ImGui::PopStyleVar();
        return false;
    }
    // The numbers share the width that the words leave.
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

void draw_vertex_lines(Ui& ui, int chosen, std::span<const VertexLine> shown) {
    for (const VertexLine& line : shown) {
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

} // namespace rasterwalk
