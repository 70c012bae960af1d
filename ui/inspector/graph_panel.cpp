#include <algorithm>
#include <cmath>
#include <string>

#include "base/element_names.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const RowGraph& graph_of(const Ui& ui) {
    return *ui.results.a.inspected.graph;
}

Quantity chosen_quantity(const Ui& ui) {
    for (const QuantityInfo& info : shown_quantities(ui.results.a.frame)) {
        if (info.words.id == ui.inspector.chosen.graph_quantity) return info.quantity;
    }
    return Quantity::z;
}

/// The index in the row of the current or picked fragment; -1: it is elsewhere.
int marked_index(const Ui& ui) {
    const RowGraph& graph = graph_of(ui);
    const auto in_row = [&](const Cursor& cursor) {
        return cursor.phase == Phase::rows && cursor.triangle == graph.row.triangle &&
               cursor.index == graph.row.index;
    };
    const std::optional<FragmentReport>& fragment = ui.results.a.inspected.fragment;
    if (fragment && in_row(fragment->cursor)) return fragment->step;
    const bool done_here = ui.results.a.done && in_row(*ui.results.a.done);
    return done_here && has_fragments(ui.results.a.frame.settings.stage) ? ui.results.a.done->step
                                                                         : -1;
}

/// The quantities as a list: where lines are few they have no lines of their own.
void draw_quantity_list(Ui& ui, float width) {
    const Quantity chosen = chosen_quantity(ui);
    ImGui::SetNextItemWidth(width);
    const bool open =
        ImGui::BeginCombo("##quantity", std::string(quantity_info(chosen).words.name).c_str());
    register_widget(ui, "graph.quantity", "What the curves show along the row.");
    if (!open) return;
    for (const QuantityInfo& info : shown_quantities(ui.results.a.frame)) {
        if (list_entry(ui, "graph." + std::string(info.words.id), info.words.name,
                       info.quantity == chosen, info.words.help)) {
            ui.inspector.chosen.graph_quantity = info.words.id;
        }
    }
    ImGui::EndCombo();
}

/// The width that the longest name of a quantity needs.
float quantity_list_width(const Ui& ui) {
    float widest = 0.0f;
    for (const QuantityInfo& info : shown_quantities(ui.results.a.frame))
        widest = std::max(widest, button_width(info.words.name));
    return widest + ImGui::GetFrameHeight();
}

/// "row 21, column 398 at the fragment", and buttons to the rows above and below.
/// @param where says which column the numbers in the legends belong to
void draw_row_choice(Ui& ui, int index, const char* where) {
    const RowGraph& graph = graph_of(ui);
    const Palette& p = palette(ui.options.theme);
    const ImVec2 size{ImGui::GetFrameHeight(), 0};
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const bool is_low = ui.inspector.is_low;
    const float arrows = 2.0f * size.x + gap;
    const float list = is_low ? quantity_list_width(ui) : 0.0f;
    const std::string number = std::to_string(graph.first_column + index);
    const std::string row_words = "row " + std::to_string(graph.row.row);
    const std::string triangle = short_triangle_name(graph.row.triangle) + " · ";
    const std::string shortest = "x " + number;
    const float words = text_width(row_words) + gap + text_width(shortest) + gap;
    const float all = ImGui::GetContentRegionAvail().x;
    // In a narrow page the list has its own line.
    const bool has_list = is_low && words + list + gap + arrows <= all;
    const float width = arrows + (has_list ? list + gap : 0.0f);
    const bool names_triangle = is_low && text_width(triangle) + words + width <= all;
    ImGui::AlignTextToFramePadding();
    text_in(p.text, (names_triangle ? triangle : "") + row_words);
    register_widget(ui, "graph.row", "Row of the picture; choose another here or in the Rows tab.");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string column = "column " + number;
    text_in(p.dim, first_fitting({column + where, column, shortest},
                                 ImGui::GetContentRegionAvail().x - width - gap));
    register_widget(
        ui, "graph.where",
        "The column whose numbers are next to the curves' names: the one under the "
        "pointer, or else that of the current fragment, or else the one with the largest "
        "error.");
    ImGui::SameLine();
    const float room = ImGui::GetContentRegionAvail().x;
    if (room > width) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    if (has_list) {
        draw_quantity_list(ui, list);
        ImGui::SameLine();
    }
    const int top = graph.row.row - graph.row.index;
    const auto choose = [&](int row) {
        ui.session.selection.triangle = graph.row.triangle;
        ui.session.selection.row = std::clamp(row, top, top + graph.row.row_count - 1);
    };
    if (button(ui, "graph.row.previous", "↑", Look::plain, "The row above.", size)) {
        choose(graph.row.row - 1);
    }
    ImGui::SameLine();
    if (button(ui, "graph.row.next", "↓", Look::plain, "The row below.", size)) {
        choose(graph.row.row + 1);
    }
    if (is_low && !has_list) draw_quantity_list(ui, all);
}

void draw_quantities(Ui& ui) {
    const Quantity chosen = chosen_quantity(ui);
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(8.0f * ui.options.text_scale, 4.0f * ui.options.text_scale));
    const std::vector<QuantityInfo> shown = shown_quantities(ui.results.a.frame);
    std::vector<float> widths;
    for (const QuantityInfo& info : shown)
        widths.push_back(button_width(info.words.name));
    const float gap = 4.0f * ui.options.text_scale;
    const std::vector<FlowPlace> places = flow(widths, gap, ImGui::GetContentRegionAvail().x);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetFrameHeight() + gap;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const QuantityInfo& info = shown[i];
        const FlowPlace& place = places[i];
        ImGui::SetCursorScreenPos(
            {start.x + place.x, start.y + static_cast<float>(place.line) * line});
        if (button(ui, "graph." + std::string(info.words.id), info.words.name,
                   info.quantity == chosen ? Look::chosen : Look::plain, info.words.help)) {
            ui.inspector.chosen.graph_quantity = info.words.id;
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

Plot base_plot(const Ui& ui) {
    const RowGraph& graph = graph_of(ui);
    Plot plot;
    plot.first_x = graph.first_column;
    plot.count = graph.count();
    plot.marked = marked_index(ui);
    plot.valid_to = ui.results.a.frame.settings.viewport.width;
    return plot;
}

/// The quantity itself: the truth, the affine chord, and the error between.
Plot truth_plot(const Ui& ui, Quantity quantity) {
    const RowGraph& graph = graph_of(ui);
    const std::string name(quantity_in(ui.results.a.frame, quantity).words.name);
    Plot plot = base_plot(ui);
    plot.curves.push_back(
        {name, colour_of(Meaning::pass, ui.options.theme), false,
         [&graph, quantity](int i) -> double { return true_value(graph, quantity, i); }});
    plot.curves.push_back(
        {quantity == Quantity::zinv ? "1 / affine z" : "affine",
         colour_of(Meaning::fail, ui.options.theme), true,
         [&graph, quantity](int i) -> double { return affine_value(graph, quantity, i); }});
    plot.band_from = 0;
    plot.band_to = 1;
    return plot;
}

/// The straight lines that perspective-correct rows carry instead.
Plot carried_plot(const Ui& ui, Quantity quantity) {
    const RowGraph& graph = graph_of(ui);
    const Palette& p = palette(ui.options.theme);
    Plot plot = base_plot(ui);
    plot.x_name = "column";
    if (is_varying(quantity)) {
        plot.curves.push_back(
            {carried_name_in(ui.results.a.frame, quantity), p.text, false,
             [&graph, quantity](int i) -> double { return carried_value(graph, quantity, i); }});
    }
    plot.curves.push_back(
        {std::string(weight_name(ui.results.a.frame)), p.dim, is_varying(quantity),
         [&graph](int i) -> double { return true_value(graph, Quantity::zinv, i); }});
    return plot;
}

/// How the curves of a quantity are computed.
std::string truth_tooltip(const Ui& ui, Quantity quantity) {
    const Frame& frame = ui.results.a.frame;
    const VaryingComponent words = quantity_in(frame, quantity).words;
    const std::string weight(weight_name(frame));
    std::string text(words.help);
    if (quantity == Quantity::zinv) {
        return text + "\nSolid: " + weight + ". Dashed: from the z that is interpolated as it is.";
    }
    text += "\nSolid: the truth, " + std::string(words.name);
    if (is_varying(quantity))
        text += " = (" + carried_name_in(frame, quantity) + ") / (" + weight + ")";
    else if (weight == "1/z")
        text += " = 1 / (1/z)";
    return text + ". Dashed: interpolated as it is, along the edges and along the row.";
}

/// Goes to the fragment's moment, if there is one and it lies in the picture.
void go_to_column(Ui& ui, int index) {
    const RowGraph& graph = graph_of(ui);
    const Cursor cursor{graph.row.triangle, Phase::rows, graph.row.index, index};
    if (!Timeline(ui.results.a.frame).exists(cursor)) return;
    if (!has_fragments(ui.results.a.frame.settings.stage)) return;
    ui.session.selection.triangle = graph.row.triangle;
    ui.session.selection.row = graph.row.row;
    ui.session.selection.pixel = std::nullopt;
    go_to_source(ui, from_moment(cursor));
}

/// Both plots with their legends.
/// @param index   the column whose numbers the legends show
/// @param pointed the column of the crosshair; -1: none
/// @return the column under the pointer, or -1
int draw_plots(Ui& ui, int index, int pointed) {
    const Quantity quantity = chosen_quantity(ui);
    const bool has_carried = quantity != Quantity::zinv;
    Plot truth = truth_plot(ui, quantity);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const bool is_low = ui.inspector.is_low;
    const float seen = ImGui::GetContentRegionAvail().y;
    if (!is_low) draw_legend(ui, "graph.legend", truth, index, truth_tooltip(ui, quantity));
    const float width = ImGui::GetContentRegionAvail().x;
    const float left = ImGui::GetContentRegionAvail().y - (has_carried ? 1.5f * line : 0.0f);
    float room = std::clamp(left, 7.5f * line, std::max(1.7f * width, 7.5f * line));
    float high = has_carried ? 0.6f * room : room;
    if (is_low) {
        // The curve and its names fill what is seen at first; scrolling shows the rest.
        high = std::max(seen - 2.0f * line, 3.0f * line);
        room = 2.0f * high;
    }
    const Plot carried = carried_plot(ui, quantity);
    if (!has_carried) truth.x_name = "column";
    const float axis = std::max({axis_width(ui, truth, high), axis_width(ui, carried, room - high),
                                 ImGui::CalcTextSize("0.00").x});
    const int in_truth = draw_plot(ui, "graph.plot", truth, {width, high}, axis, pointed);
    bool clicked = ImGui::IsItemClicked();
    if (is_low) draw_legend(ui, "graph.legend", truth, index, truth_tooltip(ui, quantity));
    int in_carried = -1;
    if (has_carried) {
        draw_legend(ui, "graph.carried.legend", carried, index,
                    "What a perspective-correct row carries. Both are straight lines. The pixel "
                    "divides one by the other, and the quotient is the curve above.");
        in_carried = draw_plot(ui, "graph.carried", carried, {width, room - high}, axis,
                               in_truth >= 0 ? in_truth : pointed);
        clicked = clicked || ImGui::IsItemClicked();
    }
    const int hovered = std::max(in_truth, in_carried);
    if (clicked && hovered >= 0) go_to_column(ui, hovered);
    return hovered;
}

void draw_graph(Ui& ui) {
    const RowGraph& graph = graph_of(ui);
    // The numbers above the plots follow the pointer: they get its column a frame later.
    ImGuiStorage* const memory = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("graph.hovered");
    const int hovered = std::min(memory->GetInt(id, -1), graph.count() - 1);
    const int marked = marked_index(ui);
    const int worst = worst_index(graph, chosen_quantity(ui));
    if (hovered >= 0) {
        draw_row_choice(ui, hovered, ", under the pointer");
    } else if (marked >= 0) {
        draw_row_choice(ui, marked, ", at the fragment");
    } else {
        const Quantity quantity = chosen_quantity(ui);
        const bool is_off =
            affine_value(graph, quantity, worst) != true_value(graph, quantity, worst);
        draw_row_choice(ui, worst, is_off ? ", where it is farthest off" : ", nothing is off");
    }
    if (!ui.inspector.is_low) draw_quantities(ui);
    const int index = hovered >= 0 ? hovered : marked >= 0 ? marked : worst;
    const bool is_marked = hovered < 0 && marked >= 0;
    memory->SetInt(id, draw_plots(ui, index, is_marked ? -1 : index));
}

void draw_no_row(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    std::string words = "No row of this triangle lies in the picture.";
    if (frame.settings.stage < Stage::rows) {
        words = "This stage has no rows yet. They come with filled triangles.";
    } else if (!frame.is_drawn(*ui.results.a.triangle)) {
        words = "This triangle is left out, so it has no rows. The Vertices tab says why.";
    } else if (ui.session.selection.row) {
        words = "No edge sample reaches this row.";
    }
    wrapped_text_in(palette(ui.options.theme).dim, words);
    register_widget(ui, "graph.none");
    if (frame.settings.stage < Stage::rows &&
        button(ui, "graph.rows", "to Rows stage", Look::plain,
               "Draws the picture up to the rows of filled triangles.")) {
        set_step(ui.session.a.settings, {Stage::rows});
    }
}

} // namespace

void draw_graph_panel(Ui& ui) {
    if (!ui.results.a.triangle) {
        text_in(palette(ui.options.theme).dim, "The scene has no triangles.");
        return;
    }
    const bool has_graph = ui.results.a.inspected.graph.has_value();
    // Where lines are few the curve has them: its line also names the triangle.
    const bool is_title_last = ui.inspector.is_low && has_graph;
    if (!is_title_last) draw_triangle_title(ui);
    if (has_graph) {
        draw_graph(ui);
    } else {
        draw_no_row(ui);
    }
    if (is_title_last) draw_triangle_title(ui);
}

} // namespace rasterwalk
