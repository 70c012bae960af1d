#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ui/inspector/fragment_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// One number of the table: a click shows its formula below.
void draw_number(Ui& ui, const std::string& id, const std::string& cell, int digits,
                 const ImVec4& colour) {
    const Formula* const formula = find_formula(report_of(ui).formulas, id);
    if (formula == nullptr) return;
    const std::string name = "fragment." + cell;
    if (number_cell(ui, name, fixed(static_cast<double>(formula->result.value), digits), colour,
                    ui.inspector.chosen.fragment_number == id,
                    formula->help + "\nClick to see how it was calculated.")) {
        ui.inspector.chosen.fragment_number = id;
    }
}

/// Between the columns of a narrow table, design pixels on each side.
constexpr float narrow_padding = 2.0f;

/// An error beyond this, in world units or parts of full light, is visible.
constexpr float visible_error = 0.1f;

void draw_error(Ui& ui, const QuantityInfo& info) {
    const Palette& p = palette(ui.options.theme);
    if (info.quantity == Quantity::zinv) {
        right_aligned("0", p.dim);
        register_widget(ui, "fragment.zinv.off",
                        std::string(info.words.name) + " is interpolated the same way in both.");
        return;
    }
    const std::string id = std::string(info.words.id) + ".off";
    const Formula* const formula = find_formula(report_of(ui).formulas, id);
    const float error = formula->result.value;
    const ImVec4 colour = error >= visible_error ? colour_of(Meaning::fail, ui.options.theme)
                          : error >= 0.00005f    ? p.text
                                                 : p.dim;
    draw_number(ui, id, id, 4, colour);
}

/// The quantities that have a line in the table.
std::vector<QuantityInfo> listed_quantities(const Ui& ui) {
    std::vector<QuantityInfo> listed = shown_quantities(ui.results.a.frame);
    if (shows_vertex_light(ui)) return listed;
    const int light = varying_index(&Varyings::illumination);
    std::erase_if(listed, [&](const QuantityInfo& info) { return info.varying == light; });
    return listed;
}

/// A column of the table.
struct ValueColumn {
    const char* name;
    std::vector<std::string> titles; ///< from the longest form to the shortest
    const char* help;
    bool in_force = false;
    float cells = 0.0f; ///< the width of its numbers or names, screen pixels

    float width_with(const ImFont* font, const std::string& title) const {
        return std::max(cells, text_width(font, title));
    }
};

/// What is said about the column with the wrong values.
struct WrongRule {
    std::vector<std::string> titles;
    const char *help, *off_help;
};

/// @param is_mixed w is not z
WrongRule wrong_rule_words(Interpolation rule, bool is_mixed) {
    switch (rule) {
    case Interpolation::perspective:
    case Interpolation::affine:
        break;
    case Interpolation::mixed:
        return {{"mixed"},
                is_mixed ? "Carried with the weight (1 − m) + m d/w, and divided by it at the "
                           "pixel."
                         : "Carried with the weight (1 − m) + m d/z, and divided by it at the "
                           "pixel.",
                "How far the value with mixed weights is from the right one."};
    case Interpolation::zinv_twice:
        return {{is_mixed ? "1/w twice" : "1/z twice", "twice"},
                is_mixed
                    ? "Carried as q/w², by mistake, and divided by 1/w only once."
                    : "Carried as q/z², by mistake, and divided by 1/z only once at the pixel.",
                "How far the value divided by z twice is from the right one."};
    case Interpolation::undivided:
        return {{"undivided", "undiv."},
                is_mixed ? "Carried as q/w, and by mistake not divided by 1/w at the pixel."
                         : "Carried as q/z, and by mistake not divided by 1/z at the pixel.",
                "How far the value never divided by 1/z is from the right one."};
    case Interpolation::divided_twice:
        return {{"divided twice", "twice"},
                is_mixed ? "Carried as q/w, and by mistake divided by 1/w twice at the pixel."
                         : "Carried as q/z, and by mistake divided by 1/z twice at the pixel.",
                "How far the value divided by 1/z twice is from the right one."};
    }
    return {{"affine"},
            "Interpolated as it is, in equal steps across the picture.",
            "How far the affine value is from the right one."};
}

std::array<ValueColumn, 4> value_columns(const Ui& ui) {
    const Interpolation rule = report_of(ui).interpolation;
    const bool is_right = rule == Interpolation::perspective;
    const bool is_mixed = weight_name(ui.results.a.frame) == "1/w";
    const WrongRule wrong = wrong_rule_words(rule, is_mixed);
    const float number = text_width(ui.fonts.mono, "−0.0000");
    float names = 0.0f;
    for (const QuantityInfo& info : listed_quantities(ui))
        names = std::max(names, text_width(ui.fonts.mono, info.words.name));
    std::array<ValueColumn, 4> columns{
        ValueColumn{"value", {"value"}, "What is interpolated along the row.", false, names},
        ValueColumn{"affine", wrong.titles, wrong.help, !is_right, number},
        ValueColumn{"perspective",
                    {"perspective", "persp."},
                    is_mixed ? "Carried as q/w and divided by 1/w at the pixel."
                             : "Carried as q/z and divided by 1/z at the pixel.",
                    is_right,
                    number},
        ValueColumn{"off", {"off by"}, wrong.off_help, false, number}};
    for (ValueColumn& column : columns) {
        if (!column.in_force) continue;
        for (std::string& title : column.titles)
            title.insert(0, "● ");
    }
    return columns;
}

/// Each column gets what it needs for the long form of its title or, if that is too much for the
/// table, for the short one; and its share of what is left.
void set_up_values(const Ui& ui, const std::array<ValueColumn, 4>& columns, float padding,
                   float room) {
    const auto width = [&](const ValueColumn& column, bool is_long) {
        const std::string& title = is_long ? column.titles.front() : column.titles.back();
        return column.width_with(ui.fonts.small, title) + 2.0f * padding;
    };
    float all = 0.0f;
    for (const ValueColumn& column : columns)
        all += width(column, true);
    for (const ValueColumn& column : columns)
        ImGui::TableSetupColumn("", 0, width(column, all <= room));
}

void draw_column_headers(Ui& ui, const std::array<ValueColumn, 4>& columns) {
    const Palette& p = palette(ui.options.theme);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.fonts.small);
    for (const ValueColumn& column : columns) {
        ImGui::TableNextColumn();
        const std::string title = first_fitting(column.titles, ImGui::GetContentRegionAvail().x);
        if (&column == &columns.front()) {
            text_in(p.dim, title);
        } else {
            right_aligned(title, column.in_force ? p.link : p.dim);
        }
        const std::string name = std::string("fragment.header.") + column.name;
        register_widget(ui, name,
                        std::string(column.help) +
                            (column.in_force ? "\nThis is the method in use." : ""),
                        title);
    }
    ImGui::PopFont();
}

} // namespace

void draw_fragment_values(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const FragmentReport& report = report_of(ui);
    const bool affine = report.interpolation != Interpolation::perspective;
    const Interpolation wrong_way = affine ? report.interpolation : Interpolation::affine;
    const std::array<ValueColumn, 4> columns = value_columns(ui);
    const float room = ImGui::GetContentRegionAvail().x;
    const float padding = ui.inspector.is_narrow ? narrow_padding * ui.options.text_scale
                                                 : ImGui::GetStyle().CellPadding.x;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
    const bool is_open = begin_lined_table("values", 4, ImGuiTableFlags_SizingStretchProp);
    ImGui::PopStyleVar();
    if (!is_open) return;
    set_up_values(ui, columns, padding, room);
    draw_column_headers(ui, columns);
    ImGui::PushFont(ui.fonts.mono);
    for (const QuantityInfo& info : listed_quantities(ui)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        put_text(info.words.name);
        ImGui::PushFont(ui.fonts.text);
        register_widget(ui, std::string("fragment.") + std::string(info.words.id), info.words.help);
        ImGui::PopFont();
        const std::string cell(info.words.id);
        ImGui::TableNextColumn();
        draw_number(ui, formula_id(info.quantity, wrong_way), cell + ".affine", 4,
                    affine ? p.text : p.dim);
        ImGui::TableNextColumn();
        draw_number(ui, formula_id(info.quantity, Interpolation::perspective),
                    cell + ".perspective", 4, affine ? p.dim : p.text);
        ImGui::TableNextColumn();
        draw_error(ui, info);
    }
    ImGui::PopFont();
    ImGui::EndTable();
}

} // namespace rasterwalk
