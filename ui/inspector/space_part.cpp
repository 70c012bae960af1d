#include "ui/inspector/space_part.h"

#include <algorithm>
#include <string>

#include "base/element_names.h"
#include "explain/conventions.h"
#include "explain/vertex_spaces.h"
#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "stages/orthographic.h"
#include "ui/inspector/chain_figure.h"
#include "ui/inspector/depth_ruler_part.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_order(Ui& ui) {
    const Setting& setting = *find_setting("matrix_order");
    for (std::size_t i = 0; i < enum_words<MatrixOrder>.size(); ++i) {
        const std::string word(enum_words<MatrixOrder>[i]);
        const auto order = static_cast<MatrixOrder>(i);
        const std::string label = choice_words(setting, word);
        if (i > 0) same_line_if_room(label);
        const bool is_chosen = ui.session.a.settings.matrix_order == order;
        if (button(ui, "vertices.matrix_order." + word, label,
                   is_chosen ? Look::chosen : Look::outline,
                   "Which side of the matrix the vector is on; the matrix for one side is the "
                   "transpose of the one for the other.")) {
            ui.session.a.settings.matrix_order = order;
        }
    }
}

/// The matrix as written in this order, number by number.
void draw_matrix(Ui& ui, const SpacePlace& place, MatrixOrder order) {
    const std::string name = std::string("vertices.").append(place.matrix_name);
    if (!ImGui::BeginTable(name.c_str(), 4, ImGuiTableFlags_SizingStretchSame)) return;
    ImGui::PushFont(ui.fonts.mono);
    for (int row = 0; row < 4; ++row) {
        ImGui::TableNextRow();
        for (int column = 0; column < 4; ++column) {
            ImGui::TableNextColumn();
            const double value = entry(*place.matrix, order, row, column);
            const bool is_plain = value == (row == column ? 1.0 : 0.0);
            right_aligned(fixed(value, ui.inspector.is_narrow ? 2 : 3),
                          is_plain ? palette(ui.options.theme).dim
                                   : palette(ui.options.theme).text);
        }
    }
    ImGui::PopFont();
    ImGui::EndTable();
}

void draw_place(Ui& ui, const SpacePlace& place, MatrixOrder order) {
    ImGui::Separator();
    put_text(place.space);
    register_widget(ui, std::string("vertices.space.").append(place.space), place.about);
    wrapped_text_in(palette(ui.options.theme).dim, place.about);
    if (place.matrix) {
        ImGui::BeginGroup();
        put_text(std::string(place.matrix_name) + " =");
        draw_matrix(ui, place, order);
        ImGui::EndGroup();
        register_widget(ui, std::string("vertices.matrix.").append(place.matrix_name), place.about);
    }
    ImGui::PushFont(ui.fonts.mono_small);
    for (int i = 0; i < 4; ++i) {
        const std::string& formula = place.formulas[static_cast<std::size_t>(i)];
        constexpr const char* axes[] = {"x = ", "y = ", "z = ", "w = "};
        wrapped_text(formula.empty() ? axes[i] + fixed(place.place[i], 4) : formula);
    }
    ImGui::PopFont();
}

/// Where the depth buffer has the vertex, among the depths that it can hold.
void draw_ruler_of_vertex(Ui& ui, const SpacesOfVertex& spaces) {
    const Frame& frame = ui.results.a.frame;
    const auto camera =
        std::find_if(spaces.places.begin(), spaces.places.end(),
                     [](const SpacePlace& place) { return place.space == "camera"; });
    if (camera == spaces.places.end()) return;
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const float depth = depth_at(static_cast<float>(camera->place.z), rules);
    draw_depth_ruler(ui, "vertices.",
                     {{camera->place.z, depth_in_buffer(depth, rules), vertex_name(spaces.vertex)}},
                     0);
}

void draw_conventions(Ui& ui, const Vertex& vertex) {
    const ConventionReport report =
        convention_report(ui.results.a.frame.settings.camera, vertex.position);
    ImGui::Separator();
    put_text("conventions");
    register_widget(ui, "vertices.conventions",
                    "The same point under the lab's projection, whatever is drawn, with one choice "
                    "made differently; in pixels from the middle.");
    const auto draw_line = [&](std::string_view name, const ConventionPlace& place) {
        wrapped_text(std::string(name) + ": " + fixed(place.picture.x, 1) + ", " +
                     fixed(place.picture.y, 1) + ", " + std::string(change_words(place.change)));
    };
    wrapped_text("as in the lab: " + fixed(report.lab.picture.x, 1) + ", " +
                 fixed(report.lab.picture.y, 1));
    for (std::size_t i = 0; i < convention_count; ++i)
        draw_line(convention_names()[i], report.alone[i]);
    for (const std::string& sentence : report.sentences)
        wrapped_text_in(palette(ui.options.theme).dim, sentence);
}

} // namespace

void draw_spaces(Ui& ui, int vertex) {
    const Frame& frame = ui.results.a.frame;
    const int triangle = *ui.results.a.triangle;
    const SpacesOfVertex spaces =
        spaces_of_vertex(frame, triangle, vertex, frame.settings.matrix_order);
    if (spaces.chain.empty()) return;
    ImGui::Separator();
    text_in(palette(ui.options.theme).dim, "Spaces of " + vertex_name(vertex));
    register_widget(ui, "vertices.spaces",
                    "The vertex in every space, and the matrix that took it there.");
    wrapped_text(spaces.chain);
    draw_order(ui);
    draw_chain_figure(ui, vertex);
    for (const SpacePlace& place : spaces.places) {
        draw_place(ui, place, spaces.order);
        if (place.space == "ndc") draw_ruler_of_vertex(ui, spaces);
    }
    draw_conventions(ui, frame.scene->corner(triangle, vertex));
}

} // namespace rasterwalk
