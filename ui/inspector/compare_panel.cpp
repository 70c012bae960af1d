#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/element_names.h"
#include "session/moments.h"
#include "settings/setting_table.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_tab.h"
#include "ui/inspector/compare_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/setting_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The word after the current one: another value of a setting of few words.
void set_next_word(Settings& settings, const ChoiceSetting& choice) {
    const int next = choice.read(settings) + 1;
    choice.write(settings, next < static_cast<int>(choice.words.size()) ? next : 0);
}

/// A list of settings: the one that is chosen is changed in run B.
void draw_choice_of_difference(Ui& ui, const char* title) {
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##another", title, ImGuiComboFlags_HeightLarge);
    register_widget(ui, "compare.another", "Changes a setting in run B.");
    if (!open) return;
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || !is_of_use(setting, *ui.session.scene, ui.session.a.settings))
            continue;
        const std::string name(setting.name);
        if (ImGui::Selectable((std::string(setting.title) + "##" + name).c_str())) {
            Run other = ui.session.b.value_or(ui.session.a);
            set_next_word(other.settings, *choice);
            compare_with(ui.session, other);
        }
        register_widget(ui, "compare.another." + name, name + "\n" + std::string(setting.help));
    }
    ImGui::EndCombo();
}

void draw_no_comparison(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    wrapped_text("Two runs of the same scene: where do they diverge, and why?");
    ImGui::Spacing();
    draw_offers(ui);
    ImGui::Spacing();
    wrapped_text_in(
        p.dim, "Run A is the picture as it is. Run B is a copy in which one thing is different; "
               "whatever you change after that changes both.");
    ImGui::Spacing();
    draw_choice_of_difference(ui, "or compare by a setting ...");
}

/// @param titles the first that has room is used
void header_cell(Ui& ui, const std::vector<std::string>& titles, std::string_view name,
                 const char* help, bool is_left) {
    ImGui::TableNextColumn();
    ImGui::PushFont(ui.fonts.small);
    const std::string title = first_fitting(titles, ImGui::GetContentRegionAvail().x);
    if (is_left) {
        text_in(palette(ui.options.theme).dim, title);
    } else {
        right_aligned(title, palette(ui.options.theme).dim);
    }
    ImGui::PopFont();
    register_widget(ui, name, help);
}

/// The name of a setting; it leads to the setting.
void setting_link(Ui& ui, const std::string& name, const Setting& setting) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    const std::string title =
        shortened(std::string(setting.title), ImGui::GetContentRegionAvail().x);
    if (button(ui, "compare.setting." + name, title, Look::link,
               name + "\n" + std::string(setting.help) + "\nClick to see it in the settings.")) {
        ui.inspector.setting_search = name;
        open_tab(ui, "settings");
    }
    ImGui::PopStyleVar();
}

/// A setting in both runs, in two cells of a table.
void edit_both(Ui& ui, const std::string& name, const Setting& setting) {
    ImGui::PushID(name.c_str());
    const auto edit = [&](Settings& settings, const char* run) {
        ImGui::TableNextColumn();
        ImGui::PushID(run);
        ImGui::SetNextItemWidth(-1.0f);
        edit_setting(ui, settings, setting, std::string("compare.") + run + "." + name);
        ImGui::PopID();
    };
    edit(ui.session.a.settings, "a");
    edit(ui.session.b->settings, "b");
    ImGui::PopID();
}

/// @param of the setting whose values the columns show; empty: all settings
void run_headers(Ui& ui, const std::string& of) {
    const std::string end = of.empty() ? "" : "." + of;
    header_cell(ui, {"A"}, "compare.header.a" + end,
                "Run A, which the switches and settings apply "
                "to.",
                true);
    header_cell(ui, {"B"}, "compare.header.b" + end, "Run B, which is compared with run A.", true);
}

bool begin_columns(const std::string& name, int count) {
    const bool is_open = ImGui::BeginTable(name.c_str(), count, ImGuiTableFlags_SizingStretchProp);
    for (int column = 0; is_open && column < count; ++column)
        ImGui::TableSetupColumn("", 0, 1.0f);
    return is_open;
}

/// A table of this width has room for the names of settings next to their values, design pixels.
constexpr float least_three_columns = 400.0f;

/// What differs in B. In a narrow panel each name is above its values.
void draw_settings(Ui& ui) {
    const std::vector<RunDifference> differences = run_differences(ui.session);
    if (differences.empty()) {
        wrapped_text_in(palette(ui.options.theme).dim,
                        "Both runs have the same settings. If you change one, run A changes.");
        return;
    }
    if (ImGui::GetContentRegionAvail().x < least_three_columns * ui.options.text_scale) {
        for (const RunDifference& difference : differences) {
            const std::string name(difference.setting);
            setting_link(ui, name, *find_setting(name));
            if (!begin_columns("compare.settings." + name, 2)) continue;
            ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
            run_headers(ui, name);
            ImGui::TableNextRow();
            edit_both(ui, name, *find_setting(name));
            ImGui::EndTable();
        }
        return;
    }
    if (!begin_columns("compare.settings", 3)) return;
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    header_cell(ui, {"setting"}, "compare.header.setting",
                "The settings that differ in run "
                "B.",
                true);
    run_headers(ui, "");
    for (const RunDifference& difference : differences) {
        const std::string name(difference.setting);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        setting_link(ui, name, *find_setting(name));
        edit_both(ui, name, *find_setting(name));
    }
    ImGui::EndTable();
}

/// The numbers of one kind, at the cursor and of the whole frame.
void count_line(Ui& ui, const char* title, const char* name, const std::string& here,
                const std::string& whole, const char* help) {
    const Palette& p = palette(ui.options.theme);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    put_text(title);
    register_widget(ui, name, help);
    ImGui::PushFont(ui.fonts.mono);
    ImGui::TableNextColumn();
    right_aligned(here, p.dim);
    ImGui::TableNextColumn();
    right_aligned(whole, p.text);
    register_text(ui, name, whole);
    ImGui::PopFont();
}

/// What differs besides the pictures, where moments are compared.
void draw_moment_counts(Ui& ui, const Comparison& whole) {
    const bool is_known = ui.results.comparison.work.is_done();
    const auto found = [&](std::int64_t count) { return grouped(count) + (is_known ? "" : " …"); };
    count_line(ui, "table rows", "compare.count.rows", "", found(whole.different_rows),
               "Rows of row tables whose left or right end differs.");
    count_line(
        ui, "moments", "compare.count.moments", "", found(whole.divergences.count),
        "A moment is the smallest piece of work: a vertex, a sample of an edge, a fragment of a "
        "row. This many of them do something different in the two runs.");
}

void draw_counts(Ui& ui) {
    const ComparisonResults& comparison = ui.results.comparison;
    const PixelDifference& here = comparison.pixels;
    const PixelDifference& whole = comparison.whole().pixels;
    if (!ImGui::BeginTable("compare.counts", 3, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("", 0, 1.3f);
    ImGui::TableSetupColumn("", 0, 1.0f);
    ImGui::TableSetupColumn("", 0, 1.0f);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    header_cell(ui, {"what differs"}, "compare.header.what", "How much the two runs differ.", true);
    header_cell(ui, {"so far"}, "compare.header.here", "In what is drawn so far.", false);
    header_cell(ui, {"whole frame", "whole"}, "compare.header.whole", "When everything is drawn.",
                false);
    const auto number = [](double value, int digits) { return fixed(value, digits); };
    const bool is_known = comparison.work.is_done();
    const auto known = [&](const std::string& text) { return is_known ? text : "…"; };
    count_line(ui, "pixels", "compare.count.pixels", grouped(here.different),
               known(grouped(whole.different)),
               "Pixels whose colour is not the same to the last bit.");
    count_line(ui, "of them visible", "compare.count.shown", grouped(here.shown),
               known(grouped(whole.shown)),
               "Pixels whose colour on the screen differs too, in 8 bits per channel.");
    count_line(ui, "largest difference", "compare.count.largest",
               number(static_cast<double>(here.largest), 4),
               known(number(static_cast<double>(whole.largest), 4)),
               "The largest difference of any channel of any pixel, in linear colour.");
    count_line(ui, "mean difference", "compare.count.mean", number(here.mean, 5),
               known(number(whole.mean, 5)),
               "The mean over all pixels of the channel that differs most.");
    if (comparison.whole().only_pictures.empty()) draw_moment_counts(ui, comparison.whole());
    ImGui::EndTable();
}

/// A moment at which the runs diverge, with its cause; its name leads there.
void draw_divergence(Ui& ui, const char* title, const std::string& name,
                     const Divergence& divergence) {
    const std::string kind =
        kind_text(divergence.kind) + (divergence.only_rounding ? ", too small to see" : "");
    wrapped_text_in(palette(ui.options.theme).dim, std::string(title) + " · " + kind,
                    ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (button(ui, name, moment_name(divergence.cursor), Look::link,
               describe_moment(ui.results.a.frame, divergence.cursor) +
                   "\nClick to go there in both runs.")) {
        stand_at(ui, divergence.cursor);
    }
    ImGui::PopStyleVar();
    const std::string cause = with_minus_signs(divergence.text);
    wrapped_text(cause);
    register_text(ui, name, kind + ": " + cause);
}

void draw_first(Ui& ui) {
    const ComparisonResults& comparison = ui.results.comparison;
    const DivergenceList& list = comparison.whole().divergences;
    begin_card(ui);
    if (!list.first) {
        text_in(palette(ui.options.theme).dim, comparison.work.is_done()
                                                   ? "The two runs behave identically."
                                                   : work_words(ui.results).c_str());
        end_card(ui);
        return;
    }
    draw_divergence(ui, "first difference", "compare.first", *list.first);
    const bool has_more =
        list.first_beyond_rounding && list.first_beyond_rounding->cursor != list.first->cursor;
    if (has_more) {
        ImGui::Spacing();
        draw_divergence(ui, "first that is larger", "compare.first_beyond_rounding",
                        *list.first_beyond_rounding);
    }
    if (comparison.here && comparison.here->cursor != list.first->cursor &&
        !(has_more && comparison.here->cursor == list.first_beyond_rounding->cursor)) {
        ImGui::Spacing();
        draw_divergence(ui, "at this moment", "compare.here", *comparison.here);
    }
    end_card(ui);
    if (button(ui, "compare.previous", "‹ difference", Look::plain,
               tooltip_of("compare.previous"))) {
        go_to_previous_divergence(ui);
    }
    ImGui::SameLine();
    if (button(ui, "compare.next", "difference ›", Look::plain, tooltip_of("compare.next"))) {
        go_to_next_divergence(ui);
    }
    ImGui::SameLine();
    const char* const key = "marked on the timeline";
    ImGui::PushFont(ui.fonts.small);
    if (ImGui::CalcTextSize(key).x + difference_key_indent(ui) > ImGui::GetContentRegionAvail().x)
        ImGui::NewLine();
    ImGui::AlignTextToFramePadding();
    draw_difference_key(ui, key);
    register_widget(ui, "compare.key",
                    "On the timeline, this mark shows where the two runs begin to differ.");
    ImGui::PopFont();
}

/// The list of groups has at least this many lines; if they have no room, the page scrolls.
constexpr float least_lines = 5.0f;

void draw_group(Ui& ui, const DivergenceGroup& group, int index) {
    const Palette& p = palette(ui.options.theme);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(index);
    const bool is_here = ui.results.a.triangle == group.triangle &&
                         ui.results.a.cursor >= group.first && ui.results.a.cursor <= group.last;
    if (selectable_row("##group", is_here)) {
        stand_at(ui, group.first);
    }
    ImGui::PopID();
    const std::string part = part_words(*ui.results.a.frame.scene, group.triangle);
    register_widget(ui, "compare.group." + std::to_string(index),
                    triangle_name(group.triangle) + ", " + part + ": from " +
                        moment_text(ui.results.a.frame, group.first) + " to " +
                        moment_text(ui.results.a.frame, group.last) +
                        ".\nClick to go to the first of them.");
    ImGui::SameLine(0.0f, 0.0f);
    put_text(shortened(short_triangle_name(group.triangle) + " " + part,
                       ImGui::GetContentRegionAvail().x));
    ImGui::TableNextColumn();
    text_in(p.dim, phase_info(group.phase).word);
    ImGui::TableNextColumn();
    text_in(p.text, shortened(kind_text(group.kind), ImGui::GetContentRegionAvail().x));
    ImGui::TableNextColumn();
    right_aligned(grouped(group.count), p.text, ui.fonts.mono);
}

void draw_groups(Ui& ui) {
    const std::vector<DivergenceGroup>& groups = ui.results.comparison.whole().divergences.groups;
    if (groups.empty()) return;
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    // As many whole lines as fit: none is cut off.
    const float head = ui.fonts.small->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y;
    const float whole = std::floor((ImGui::GetContentRegionAvail().y - head) / line);
    const auto all = static_cast<float>(groups.size());
    const float lines = std::min(all, std::max(whole, least_lines));
    const float height = head + lines * line;
    if (!begin_lined_table("compare.groups", 4,
                           ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp,
                           {0, height})) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const float width : {1.4f, 0.8f, 1.2f, 0.8f})
        ImGui::TableSetupColumn("", 0, width);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    header_cell(ui, {"triangle"}, "compare.header.triangle", "The triangle being drawn.", true);
    header_cell(ui, {"phase"}, "compare.header.phase", "Vertices, clip, cull, edges or rows.",
                true);
    header_cell(ui, {"how"}, "compare.header.kind",
                "Missing from B: only A does something there. Extra in B: only B does.", true);
    header_cell(ui, {"moments"}, "compare.header.moments",
                "How many moments differ: vertices, samples of edges, fragments of rows.", false);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(groups.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_group(ui, groups[static_cast<std::size_t>(i)], i);
    }
    ImGui::EndTable();
}

} // namespace

void draw_compare_panel(Ui& ui) {
    if (!ui.session.b && hides_settings(ui.session)) {
        wrapped_text("During a quiz, the laboratory compares with the correct run.");
        return;
    }
    if (!ui.session.b) {
        draw_no_comparison(ui);
        return;
    }
    if (ui.session.b->program != nullptr) {
        draw_program_run(ui);
    } else if (!hides_settings(ui.session)) {
        draw_pairs(ui);
        ImGui::Spacing();
        ImGui::PushFont(ui.fonts.small);
        draw_settings(ui);
        draw_choice_of_difference(ui, "another difference ...");
        ImGui::PopFont();
    }
    if (!is_comparing(ui)) {
        wrapped_text(ui.results.no_comparison);
        return;
    }
    ImGui::Spacing();
    draw_counts(ui);
    ImGui::Spacing();
    const Comparison& found = ui.results.comparison.whole();
    if (!found.only_pictures.empty()) {
        draw_reasons(ui);
        return;
    }
    draw_first(ui);
    ImGui::Spacing();
    draw_groups(ui);
}

} // namespace rasterwalk
