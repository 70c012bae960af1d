#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "pipeline/timeline.h"
#include "session/walk.h"
#include "ui/inspector/clip_parts.h"
#include "ui/inspector/clip_table.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// As written in ids and names of widgets.
std::string number_of(ClipPlane plane) {
    return std::to_string(static_cast<int>(plane));
}

bool has_work(const ClipPage& page, ClipPlane plane) {
    return work_of(page.history, plane) != nullptr;
}

bool is_plane_open(const ClipPage& page, ClipPlane plane) {
    const bool is_turned = page.ui.inspector.clip.is_turned[static_cast<std::size_t>(plane)];
    return has_work(page, plane) != is_turned;
}

/// The plane shown in the diagram: the one at work, the one opened last, or the first that cuts.
std::optional<ClipPlane> plane_in_diagram(const ClipPage& page) {
    const std::vector<PlaneHistory>& planes = page.history.planes;
    if (page.progress) return planes[static_cast<std::size_t>(page.progress->planes)].plane;
    const std::optional<ClipPlane> opened = page.ui.inspector.clip.plane;
    if (opened && is_plane_open(page, *opened)) return opened;
    if (planes.empty()) return std::nullopt;
    return planes.front().plane;
}

/// A distance from the plane, and which side that is.
std::string distance_text(float distance, bool is_inside) {
    return fixed(static_cast<double>(distance), 3) + (is_inside ? " in" : " out");
}

/// Is there room for the words of all distances? If not, the sign says it.
bool has_room_for_sides(const std::vector<ClipStep>& steps, float room) {
    return std::all_of(steps.begin(), steps.end(), [&](const ClipStep& step) {
        return text_width(distance_text(step.d_from, step.is_from_inside)) <= room &&
               text_width(distance_text(step.d_to, step.is_to_inside)) <= room;
    });
}

void draw_distance(const ClipPage& page, const std::string& name, const std::string& id,
                   float distance, bool is_inside, bool is_coming, bool has_side) {
    ImGui::TableNextColumn();
    const std::string text =
        has_side ? distance_text(distance, is_inside) : fixed(static_cast<double>(distance), 3);
    const Meaning meaning = is_inside ? Meaning::pass : Meaning::fail;
    draw_selected_formula(page, name, id, text,
                          is_coming ? page.palette().dim
                                    : colour_of(meaning, page.ui.options.theme),
                          is_inside ? "How far inside the plane the corner is."
                                    : "Less than 0, so the corner is outside the plane.");
}

/// What a step passes on: the corner at its beginning, the one that it makes, both or none.
std::string passed_text(const ClipPage& page, const ClipStep& step, const CutCorner& from) {
    std::string text;
    if (step.keeps_from) text = short_corner_name(from);
    if (!step.is_cut && text.empty())
        return text_width("nothing") <= ImGui::GetContentRegionAvail().x ? "nothing" : "–";
    if (!step.is_cut) return text;
    const auto made = corner_made(page.history, planes_before(page.history, step.plane), step.from);
    if (!made) return text;
    return text + (text.empty() ? "" : ", ") + short_corner_name(*made);
}

/// Scrolls to what was just drawn, if it is not entirely in view.
void show_item() {
    const ShownLines shown = shown_lines();
    const bool is_seen =
        ImGui::GetItemRectMin().y >= shown.top && ImGui::GetItemRectMax().y <= shown.bottom;
    if (!is_seen) scroll_here(0.5f);
}

/// Scrolls to a plane's table and the diagram below it, just drawn, if both have room and are not
/// in view yet.
void show_with_diagram(float top) {
    const ShownLines shown = shown_lines();
    const float bottom = ImGui::GetItemRectMax().y;
    const bool is_seen = top >= shown.top && bottom <= shown.bottom;
    if (!is_seen && bottom - top <= shown.bottom - shown.top) scroll_here(1.0f);
}

void go_to_step(const ClipPage& page, ClipPlane plane, int step) {
    const Timeline timeline(page.frame);
    const Cursor cursor{page.history.triangle, Phase::clip, static_cast<int>(plane), step};
    if (timeline.exists(cursor))
        go_to(page.ui.session, timeline, timeline.next(cursor, Granularity::moment));
}

void draw_step(const ClipPage& page, const ClipStep& step, const std::vector<CutCorner>& before,
               bool has_sides) {
    const CutCorner& from = before[static_cast<std::size_t>(step.from)];
    const CutCorner& to = before[static_cast<std::size_t>(step.to)];
    const std::string plane = number_of(step.plane);
    const std::string place = plane + "." + std::to_string(step.from);
    const bool is_coming = page.is_coming(step.plane, step.from);
    const bool is_current = page.is_current(step.plane, step.from);
    const ImVec4& dim = page.palette().dim;
    ImGui::TableNextRow();
    if (is_current)
        ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, packed(page.palette().row_lit));
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    text_in(is_coming ? dim : cut_edge_colour(page, from),
            short_corner_name(from) + "→" + short_corner_name(to));
    const std::string edge =
        from.edge >= 0 ? "On " + edge_name(from.edge) + " of the triangle"
                       : "Along the " + plane_name(from.edge_plane) + ", which cut earlier";
    register_widget(page.ui, "clip.edge." + place,
                    fmt::format("{}, from {} to {}.\nClick to go to the moment when it is cut.",
                                edge, corner_name(from), corner_name(to)));
    if (ImGui::IsItemClicked()) go_to_step(page, step.plane, step.from);
    if (is_current) {
        if (page.has_moved) show_item();
        const float padding = ImGui::GetStyle().CellPadding.x;
        draw_current_bar(page.ui, ImGui::GetWindowDrawList(), {corner.x - padding, corner.y},
                         corner.y + ImGui::GetTextLineHeight());
    }
    const auto distance_id = [&](int of) { return "d." + plane + "." + std::to_string(of); };
    const std::string name = "clip.d." + place;
    draw_distance(page, name + ".from", distance_id(step.from), step.d_from, step.is_from_inside,
                  is_coming, has_sides);
    draw_distance(page, name + ".to", distance_id(step.to), step.d_to, step.is_to_inside, is_coming,
                  has_sides);
    ImGui::TableNextColumn();
    if (step.is_cut) {
        draw_selected_formula(page, "clip.t." + place, "t." + place,
                              fixed(static_cast<double>(step.t), 4),
                              is_coming ? dim : page.palette().text,
                              "Where the plane cuts: 0 is the corner inside, 1 the one outside.");
    } else {
        right_aligned("–", dim);
    }
    ImGui::TableNextColumn();
    right_aligned(passed_text(page, step, from),
                  is_coming         ? dim
                  : step.is_cut     ? colour_of(plane_meaning, page.ui.options.theme)
                  : step.keeps_from ? page.palette().text
                                    : dim);
    register_widget(page.ui, "clip.gives." + place,
                    "What the step passes on to the polygon after this plane: the corner at its "
                    "beginning if that is inside, and the new corner if the edge is cut.");
}

/// The name of a varying's row: the lab's own word, if it has one.
std::string varying_title(const VaryingInfo& info) {
    if (info.name == "position_world") return "world";
    return info.name == "illumination" ? "light" : std::string(info.name);
}

/// A corner that the plane has made: in clip space, and everything it carries.
void draw_made(const ClipPage& page, const CutCorner& corner) {
    const std::string number = std::to_string(corner.new_index);
    draw_corner_name(page, corner, false);
    register_widget(page.ui, "clip.new." + number, corner_help(corner));
    ImGui::PushFont(page.ui.fonts.mono);
    for (int i = 0; i < 4; ++i) {
        const std::string id = corner_formula_id(corner, i);
        ImGui::TableNextColumn();
        draw_selected_formula(page, "clip." + id, id,
                              clip_number(corner.vertex.position_clip[i], i), page.palette().text,
                              clip_coordinate_help[static_cast<std::size_t>(i)]);
    }
    ImGui::PopFont();
    const VaryingSet carried = carried_varyings(page.frame);
    for (int v = 0; v < varying_count; ++v) {
        if (!carried.has(v)) continue;
        const VaryingInfo& info = varying_list[static_cast<std::size_t>(v)];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_in(page.palette().dim, varying_title(info));
        register_widget(page.ui, "clip.new." + number + "." + std::string(info.name),
                        "The " + std::string(info.word) + ", cut with the same t.");
        ImGui::PushFont(page.ui.fonts.mono);
        for (int k = 0; k < info.count; ++k) {
            const std::string id = fmt::format("new.{}.{}.{}", number, v, k);
            ImGui::TableNextColumn();
            draw_selected_formula(
                page, "clip." + id, id,
                fixed(static_cast<double>(info.component(corner.vertex.varyings, k)), 3),
                page.palette().text,
                std::string(info.components[static_cast<std::size_t>(k)].help));
        }
        ImGui::PopFont();
    }
}

void draw_made_corners(const ClipPage& page, ClipPlane plane) {
    const PlaneHistory* const work = work_of(page.history, plane);
    if (work == nullptr) return;
    std::vector<CutCorner> made;
    for (const ClipStep& step : work->steps) {
        if (!step.is_cut || page.is_coming(plane, step.from)) continue;
        if (auto corner = corner_made(page.history, planes_before(page.history, plane), step.from))
            made.push_back(*corner);
    }
    if (made.empty()) return;
    if (!begin_clip_table(page, "made" + number_of(plane), {1.1f, 1.1f, 1.1f, 0.9f, 0.9f})) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_in(page.palette().dim, "new", page.ui.fonts.small);
    for (std::size_t i = 0; i < clip_coordinates.size(); ++i)
        draw_column_title(page, std::string("clip.made.") + clip_coordinates[i],
                          clip_coordinates[i], clip_coordinate_help[i]);
    for (const CutCorner& corner : made)
        draw_made(page, corner);
    end_clip_table();
}

/// "3 corners become 4"
std::string become_text(const PlaneHistory& work) {
    return fmt::format("{} become {}",
                       counted(static_cast<int>(work.before.size()), "corner", "corners"),
                       work.after.size());
}

} // namespace

ImVec4 cut_edge_colour(const ClipPage& page, const CutCorner& corner) {
    return colour_of(corner.edge >= 0 ? edge_meaning(corner.edge) : plane_meaning,
                     page.ui.options.theme);
}

void draw_clip_plane_buttons(const ClipPage& page) {
    const float gap = 6.0f * page.ui.options.text_scale;
    draw_clip_title(page, "Plane by plane", "open: the planes that cut");
    ImGui::PushFont(page.ui.fonts.small);
    for (std::size_t p = 0; p < page.history.codes.plane_count; ++p) {
        const auto plane = static_cast<ClipPlane>(p);
        const std::string label(word_of(plane));
        if (p > 0) same_line_if_room(label, gap);
        const std::string help = has_work(page, plane)
                                     ? "It cuts. Click to open or close what it does."
                                     : "It has no work to do because every corner is inside. Click "
                                       "to open or close the distances.";
        const bool is_clicked =
            button(page.ui, "clip.plane." + label, label,
                   is_plane_open(page, plane) ? Look::chosen : Look::plain, help);
        if (!is_clicked) continue;
        bool& is_turned = page.ui.inspector.clip.is_turned[p];
        is_turned = !is_turned;
        if (is_plane_open(page, plane)) page.ui.inspector.clip.plane = plane;
    }
    ImGui::PopFont();
}

void draw_clip_plane(const ClipPage& page, ClipPlane plane) {
    if (!is_plane_open(page, plane)) return;
    const PlaneHistory* const work = work_of(page.history, plane);
    const std::vector<CutCorner> before =
        corners_before(page.history, planes_before(page.history, plane));
    draw_clip_title(page, plane_name(plane),
                    work == nullptr ? "nothing to cut" : become_text(*work));
    const float top = ImGui::GetCursorScreenPos().y;
    if (begin_clip_table(page, "plane" + number_of(plane), {0.9f, 1.3f, 1.3f, 0.9f, 0.9f})) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_in(page.palette().dim, "edge", page.ui.fonts.small);
        draw_column_title(page, "clip.header.from", "from, d",
                          "How far inside the plane the edge begins.");
        draw_column_title(page, "clip.header.to", "to, d",
                          "How far inside the plane the edge ends.");
        const float room = ImGui::GetContentRegionAvail().x;
        draw_column_title(page, "clip.header.t", "t",
                          "Where the edge is cut: d of the corner inside, divided by the sum of "
                          "both distances. Always measured from the corner inside, so that two "
                          "triangles that share an edge share the cut.");
        draw_column_title(page, "clip.header.gives", "gives",
                          "The corners that this edge passes on.");
        ImGui::PushFont(page.ui.fonts.mono);
        const std::vector<ClipStep> steps = plane_steps(page.history, plane);
        const bool has_sides = has_room_for_sides(steps, room);
        for (const ClipStep& step : steps) {
            if (step.from < static_cast<int>(before.size()) &&
                step.to < static_cast<int>(before.size()))
                draw_step(page, step, before, has_sides);
        }
        ImGui::PopFont();
        end_clip_table();
    }
    const bool has_diagram = plane == plane_in_diagram(page) && draw_clip_diagram(page, plane);
    if (has_diagram && page.progress && page.has_moved) show_with_diagram(top);
    draw_made_corners(page, plane);
}

} // namespace rasterwalk
