#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "inspect/stats.h"
#include "pipeline/timeline.h"
#include "session/walk.h"
#include "settings/value_words.h"
#include "ui/inspector/clip_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void put_text(const ClipPage& page, const ImVec4& colour, std::string_view text) {
    text_in(colour, text);
    keep_item_whole(page.ui);
}

/// In a cell of a table, at its right edge.
void put_right(const ClipPage& page, std::string_view text, const ImVec4& colour) {
    right_aligned(text, colour);
    keep_item_whole(page.ui);
}

constexpr std::array<const char*, 4> clip_coordinates{"x", "y", "z", "w"};
constexpr std::array<const char*, 4> clip_coordinate_help{
    "x of clip space: pixels from the middle of the picture, times w. Divided by w it is on the "
    "screen.",
    "y of clip space: pixels from the middle of the picture, times w; points down.",
    "z of clip space, of which the depth is made: it is divided by w too.",
    "What x, y and z are divided by: how far in front of the camera. 0 or less is behind it."};

/// A coordinate in clip space as its column shows it.
std::string clip_number(float value, int coordinate) {
    if (coordinate < 2) return fixed(static_cast<double>(value), 1);
    return coordinate == 2 ? shown({value}) : fixed(static_cast<double>(value), 3);
}

/// A number of a table that can be asked where it came from.
void draw_asked(const ClipPage& page, const std::string& name, const std::string& id,
                const std::string& text, const ImVec4& colour, const std::string& help) {
    if (!number_cell(page.ui, name, text, colour, page.number == id,
                     help + "\nClick: how it came to be."))
        return;
    page.ui.inspector.clip.number = id;
}

void draw_clip_title(const ClipPage& page, const std::string& title, const std::string& beside) {
    ImGui::Dummy({0.0f, 4.0f * page.ui.options.text_scale});
    ImGui::PushFont(page.ui.fonts.bold);
    put_text(page, page.palette().text, title);
    ImGui::PopFont();
    if (beside.empty()) return;
    ImGui::PushFont(page.ui.fonts.small);
    const float gap = 10.0f * page.ui.options.text_scale;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float width = text_width(beside);
    if (ImGui::GetItemRectMax().x + gap + width <= right) {
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::SetCursorScreenPos(
            {right - width,
             ImGui::GetItemRectMax().y - ImGui::GetTextLineHeight() - page.ui.options.text_scale});
    }
    put_text(page, page.palette().dim, beside);
    ImGui::PopFont();
}

/// A title over a column, at its right edge.
void draw_column_title(const ClipPage& page, const std::string& name, const std::string& title,
                       const std::string& help) {
    ImGui::TableNextColumn();
    ImGui::PushFont(page.ui.fonts.small);
    put_right(page, title, page.palette().dim);
    ImGui::PopFont();
    name_widget(page.ui, name, help);
}

/// @param widths of the columns in relation to each other; the first is that of names
bool begin_clip_table(const ClipPage& page, const std::string& name,
                      const std::vector<float>& widths) {
    const float padding = (page.ui.inspector.is_narrow ? 2.0f : 5.0f) * page.ui.options.text_scale;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
    const bool is_open =
        ImGui::BeginTable(name.c_str(), static_cast<int>(widths.size()),
                          ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_BordersInnerH);
    if (!is_open) {
        ImGui::PopStyleVar();
        return false;
    }
    for (const float width : widths)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, width);
    return true;
}

void end_clip_table() {
    ImGui::EndTable();
    ImGui::PopStyleVar();
}

/// A corner's name, in whole words where there is room.
std::string fitting_corner_name(const CutCorner& corner) {
    const std::string name = corner_name(corner);
    return text_width(name) <= ImGui::GetContentRegionAvail().x ? name : short_corner_name(corner);
}

ImVec4 corner_colour(const ClipPage& page, const CutCorner& corner) {
    return corner.is_new() ? colour_of(plane_meaning, page.ui.options.theme) : page.palette().text;
}

std::string corner_help(const CutCorner& corner) {
    return corner.is_new() ? "Made by the " + plane_name(corner.plane) + "."
                           : vertex_name(corner.vertex_index) + " of the scene's triangle.";
}

/// The name of a corner in its own column.
void draw_corner_name(const ClipPage& page, const CutCorner& corner, bool is_dim) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    put_text(page, is_dim ? page.palette().dim : corner_colour(page, corner),
             fitting_corner_name(corner));
}

/// As ids and names of widgets have it.
std::string number_of(ClipPlane plane) {
    return std::to_string(static_cast<int>(plane));
}

/// A bit of an outcode: 1 is beyond the plane.
void draw_bit(const ClipPage& page, const std::string& text, bool is_set) {
    put_right(page, text,
              is_set ? colour_of(Meaning::fail, page.ui.options.theme) : page.palette().dim);
}

void draw_code_row(const ClipPage& page, const std::string& title, Outcode code,
                   const std::string& help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    put_text(page, page.palette().text, title);
    name_widget(page.ui, "clip.code." + title, help);
    ImGui::PushFont(page.ui.fonts.mono);
    for (std::size_t p = 0; p < page.history.codes.plane_count; ++p) {
        const bool is_set = (code >> p & 1u) != 0;
        ImGui::TableNextColumn();
        draw_bit(page, is_set ? "1" : "0", is_set);
    }
    ImGui::PopFont();
}

/// The steps of a plane; of one without work what they would be.
std::vector<ClipStep> steps_of(const ClipPage& page, ClipPlane plane,
                               const std::vector<CutCorner>& before) {
    if (const PlaneHistory* const work = work_of(page.history, plane)) return work->steps;
    const glm::vec4& coefficients = page.history.codes.planes[static_cast<std::size_t>(plane)];
    std::vector<ClipStep> steps;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::size_t next = (i + 1) % before.size();
        ClipStep step;
        step.plane = plane;
        step.from = static_cast<int>(i);
        step.to = static_cast<int>(next);
        step.d_from = inner_distance(coefficients, before[i].vertex);
        step.d_to = inner_distance(coefficients, before[next].vertex);
        step.is_from_inside = step.is_to_inside = step.keeps_from = true;
        steps.push_back(step);
    }
    return steps;
}

bool has_work(const ClipPage& page, ClipPlane plane) {
    return work_of(page.history, plane) != nullptr;
}

bool is_plane_open(const ClipPage& page, ClipPlane plane) {
    const bool is_turned = page.ui.inspector.clip.is_turned[static_cast<std::size_t>(plane)];
    return has_work(page, plane) != is_turned;
}

/// A distance from the plane, and on which side that is.
std::string distance_text(float distance, bool is_inside) {
    return fixed(static_cast<double>(distance), 3) + (is_inside ? " in" : " out");
}

/// Is there room for the words of all distances? Where there is none the sign says it.
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
    draw_asked(page, name, id, text,
               is_coming ? page.palette().dim : colour_of(meaning, page.ui.options.theme),
               is_inside ? "How far inside of the plane the corner lies."
                         : "Less than 0: the corner lies outside of the plane.");
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

/// Scrolls to what was just drawn where it is not seen whole.
void show_item(const Ui& ui) {
    const ShownLines seen = shown_lines(ui);
    const bool is_seen =
        ImGui::GetItemRectMin().y >= seen.top && ImGui::GetItemRectMax().y <= seen.bottom;
    if (!is_seen) ImGui::SetScrollHereY(0.5f);
}

void go_to_step(const ClipPage& page, ClipPlane plane, int step) {
    const Timeline timeline(page.frame);
    const Cursor cursor{page.history.triangle, Phase::clip, static_cast<int>(plane), step};
    if (timeline.exists(cursor)) go_to(page.ui.session, timeline.next(cursor, Granularity::moment));
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
    put_text(page, is_coming ? dim : cut_edge_colour(page, from),
             short_corner_name(from) + "→" + short_corner_name(to));
    const std::string edge =
        from.edge >= 0 ? "On " + edge_name(from.edge) + " of the triangle"
                       : "Along the " + plane_name(from.edge_plane) + ", which has cut before";
    name_widget(page.ui, "clip.edge." + place,
                fmt::format("{}, from {} to {}.\nClick: to the moment in which it is cut.", edge,
                            corner_name(from), corner_name(to)));
    if (ImGui::IsItemClicked()) go_to_step(page, step.plane, step.from);
    if (is_current) {
        if (page.has_moved) show_item(page.ui);
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
        draw_asked(page, "clip.t." + place, "t." + place, fixed(static_cast<double>(step.t), 4),
                   is_coming ? dim : page.palette().text,
                   "Where the plane cuts: 0 is the corner inside, 1 the one outside.");
    } else {
        put_right(page, "–", dim);
    }
    ImGui::TableNextColumn();
    put_right(page, passed_text(page, step, from),
              is_coming         ? dim
              : step.is_cut     ? colour_of(plane_meaning, page.ui.options.theme)
              : step.keeps_from ? page.palette().text
                                : dim);
    name_widget(page.ui, "clip.gives." + place,
                "What the step passes on to the polygon after this plane: the corner at its "
                "beginning if that lies inside, and the new corner if the edge is cut.");
}

/// The names of a varying's row: where the lab has a word for it, that.
std::string varying_title(const VaryingInfo& info) {
    if (info.name == "position_world") return "world";
    return info.name == "illumination" ? "light" : std::string(info.name);
}

/// A corner that the plane has made: in clip space, and all that it carries.
void draw_made(const ClipPage& page, const CutCorner& corner) {
    const std::string number = std::to_string(corner.new_index);
    draw_corner_name(page, corner, false);
    name_widget(page.ui, "clip.new." + number, corner_help(corner));
    ImGui::PushFont(page.ui.fonts.mono);
    for (int i = 0; i < 4; ++i) {
        const std::string id = corner_formula_id(corner, i);
        ImGui::TableNextColumn();
        draw_asked(page, "clip." + id, id, clip_number(corner.vertex.position_clip[i], i),
                   page.palette().text, clip_coordinate_help[static_cast<std::size_t>(i)]);
    }
    ImGui::PopFont();
    const VaryingSet carried =
        carried_varyings(page.frame.stages, shading_rule(page.frame.settings));
    for (int v = 0; v < varying_count; ++v) {
        if (!carried.has(v)) continue;
        const VaryingInfo& info = varying_list[static_cast<std::size_t>(v)];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        put_text(page, page.palette().dim, varying_title(info));
        name_widget(page.ui, "clip.new." + number + "." + std::string(info.name),
                    "The " + std::string(info.word) + ", cut with the same t.");
        ImGui::PushFont(page.ui.fonts.mono);
        for (int k = 0; k < info.count; ++k) {
            const std::string id = fmt::format("new.{}.{}.{}", number, v, k);
            ImGui::TableNextColumn();
            draw_asked(page, "clip." + id, id,
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

const char* answer_text(const CullAnswer& answer) {
    if (answer.is_open) return "no answer";
    return answer.is_in_parts ? "in parts" : answer.is_back ? "back" : "front";
}

std::string_view answer_help(Cull way) {
    switch (way) {
    case Cull::face_normal:
        return "n · (p − C): does the normal of the first corner point the way from the camera to "
               "it? Then it is a back.";
    case Cull::screen_area:
        return "The area on the screen with its sign: less than 0 where the corners go round "
               "counterclockwise, as those of a back do. With a corner behind the camera there is "
               "no such order.";
    case Cull::vertex_normals:
        return "n · (p − C) of the corner whose normal points least away: a back only if all of "
               "them do. A smooth body keeps the faces of its outline.";
    case Cull::fragment_normal:
        return "n · (p − C) at every fragment, with the normal that was interpolated to it: a back "
               "only as far as it is greater than 0. The number is that of the corner whose normal "
               "points least away.";
    case Cull::none:
    case Cull::view_axis:
        break;
    }
    return "";
}

void draw_answer(const ClipPage& page, const CullAnswer& answer, bool is_in_force) {
    const Setting& setting = *find_setting("cull");
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string word(word_of(answer.way));
    put_text(page, is_in_force ? page.palette().text : page.palette().dim,
             (is_in_force ? "● " : "○ ") + said_word(setting, word));
    name_widget(page.ui, "clip.cull.way." + word, answer_help(answer.way));
    ImGui::PushFont(page.ui.fonts.mono);
    ImGui::TableNextColumn();
    const std::string text = std::abs(answer.measure) >= 1000.0f
                                 ? fixed(static_cast<double>(answer.measure), 0)
                                 : fixed(static_cast<double>(answer.measure), 3);
    draw_asked(page, "clip.cull." + word, answer.formula, text, page.palette().text,
               std::string(answer_help(answer.way)));
    ImGui::TableNextColumn();
    const Meaning meaning = answer.is_back ? Meaning::fail : Meaning::pass;
    put_right(page, answer_text(answer),
              answer.is_open ? page.palette().dim : colour_of(meaning, page.ui.options.theme));
    ImGui::PopFont();
}

/// What becomes of it, and why the ways differ.
std::string culling_text(const ClipPage& page, const std::vector<CullAnswer>& answers) {
    const Cull in_force = page.frame.settings.cull;
    std::string text;
    if (in_force == Cull::none) {
        text = "The setting leaves out no backs: it is drawn whichever side it shows.";
    } else if (in_force == Cull::fragment_normal) {
        text = "The setting asks each fragment by itself: those with a back's normal are left out.";
    } else {
        text = page.history.cull.is_back ? "It is left out." : "It is drawn.";
    }
    const auto is_back = [](const CullAnswer& answer) { return answer.is_back; };
    const auto backs = std::count_if(answers.begin(), answers.end(), is_back);
    if (backs == 0 || backs == static_cast<std::ptrdiff_t>(answers.size())) return text;
    const bool is_open = std::any_of(answers.begin(), answers.end(),
                                     [](const CullAnswer& answer) { return answer.is_open; });
    text += " The ways differ here: ";
    if (is_open) {
        text += "a corner lies behind the camera, so that the corners have no order on the screen.";
    } else if (answers[0].is_back != answers[1].is_back) {
        text += "the normal and the order of the corners do not say the same of its front.";
    } else {
        text += "some of its vertices have normals that point to the camera.";
    }
    return text;
}

} // namespace

ImVec4 cut_edge_colour(const ClipPage& page, const CutCorner& corner) {
    return colour_of(corner.edge >= 0 ? edge_meaning(corner.edge) : plane_meaning,
                     page.ui.options.theme);
}

void draw_clip_corners(const ClipPage& page) {
    draw_clip_title(page, "The corners", "clip space, before dividing by w");
    if (!begin_clip_table(page, "corners", {1.4f, 1.1f, 1.1f, 0.6f, 0.9f})) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < clip_coordinates.size(); ++i)
        draw_column_title(page, std::string("clip.header.") + clip_coordinates[i],
                          clip_coordinates[i], clip_coordinate_help[i]);
    for (const CutCorner& corner : given_corners(page.history)) {
        draw_corner_name(page, corner, false);
        const bool is_behind = !(corner.vertex.position_clip.w > 0.0f);
        ImGui::PushFont(page.ui.fonts.mono);
        for (int i = 0; i < 4; ++i) {
            const std::string id = corner_formula_id(corner, i);
            ImGui::TableNextColumn();
            draw_asked(page, "clip." + id, id, clip_number(corner.vertex.position_clip[i], i),
                       i == 3 && is_behind ? colour_of(Meaning::fail, page.ui.options.theme)
                                           : page.palette().text,
                       clip_coordinate_help[static_cast<std::size_t>(i)]);
        }
        ImGui::PopFont();
    }
    end_clip_table();
}

void draw_clip_codes(const ClipPage& page) {
    const TriangleCodes& codes = page.history.codes;
    if (codes.plane_count == 0) return;
    draw_clip_title(page, "Outcodes", "1: beyond the plane");
    std::vector<float> widths{1.5f};
    widths.resize(codes.plane_count + 1, 1.0f);
    if (!begin_clip_table(page, "codes", widths)) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t p = 0; p < codes.plane_count; ++p) {
        const auto plane = static_cast<ClipPlane>(p);
        draw_column_title(page, "clip.header." + std::string(word_of(plane)),
                          std::string(word_of(plane)),
                          "1 for a corner beyond the " + plane_name(plane) + ".");
    }
    for (int v = 0; v < triangle_corners; ++v) {
        const CutCorner corner = given_corners(page.history)[static_cast<std::size_t>(v)];
        draw_corner_name(page, corner, false);
        ImGui::PushFont(page.ui.fonts.mono);
        for (std::size_t p = 0; p < codes.plane_count; ++p) {
            const bool is_set = (codes.of_corner[static_cast<std::size_t>(v)] >> p & 1u) != 0;
            const std::string id = fmt::format("code.{}.{}", p, v);
            ImGui::TableNextColumn();
            draw_asked(
                page, "clip." + id, id, is_set ? "1" : "0",
                is_set ? colour_of(Meaning::fail, page.ui.options.theme) : page.palette().dim,
                fmt::format("{} lies {} the {}.", vertex_name(v), is_set ? "beyond" : "inside of",
                            plane_name(static_cast<ClipPlane>(p))));
        }
        ImGui::PopFont();
    }
    draw_code_row(
        page, "AND", codes.common(),
        "The bits that all corners have: beyond such a plane the whole triangle lies, and "
        "it can be rejected at once. No such bit does not mean that a part is inside.");
    draw_code_row(
        page, "OR", codes.any(),
        "The bits that any corner has: only these planes can have work. No bit: the whole "
        "triangle lies inside, and is accepted at once.");
    end_clip_table();
}

void draw_clip_plane_buttons(const ClipPage& page) {
    const float gap = 6.0f * page.ui.options.text_scale;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    draw_clip_title(page, "Plane by plane", "open: those that have work");
    ImGui::PushFont(page.ui.fonts.small);
    for (std::size_t p = 0; p < page.history.codes.plane_count; ++p) {
        const auto plane = static_cast<ClipPlane>(p);
        const std::string label(word_of(plane));
        if (p > 0 && ImGui::GetItemRectMax().x + gap + button_width(label) <= right)
            ImGui::SameLine(0.0f, gap);
        const std::string help = has_work(page, plane)
                                     ? "It cuts. Click: opens or closes what it does."
                                     : "It has no work: every corner lies inside. Click: opens or "
                                       "closes the distances.";
        if (!button(page.ui, "clip.plane." + label, label,
                    is_plane_open(page, plane) ? Look::chosen : Look::plain, help))
            continue;
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
    if (begin_clip_table(page, "plane" + number_of(plane), {0.9f, 1.3f, 1.3f, 0.9f, 0.9f})) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushFont(page.ui.fonts.small);
        put_text(page, page.palette().dim, "edge");
        ImGui::PopFont();
        draw_column_title(page, "clip.header.from", "from, d",
                          "How far inside of the plane the edge begins.");
        draw_column_title(page, "clip.header.to", "to, d",
                          "How far inside of the plane the edge ends.");
        const float room = ImGui::GetContentRegionAvail().x;
        draw_column_title(page, "clip.header.t", "t",
                          "Where the edge is cut: d of the corner inside, divided by the sum of "
                          "both distances. Always measured from the corner inside, so that two "
                          "triangles that share an edge share the cut.");
        draw_column_title(page, "clip.header.gives", "gives",
                          "The corners that this edge passes on.");
        ImGui::PushFont(page.ui.fonts.mono);
        const std::vector<ClipStep> steps = steps_of(page, plane, before);
        const bool has_sides = has_room_for_sides(steps, room);
        for (const ClipStep& step : steps) {
            if (step.from < static_cast<int>(before.size()) &&
                step.to < static_cast<int>(before.size()))
                draw_step(page, step, before, has_sides);
        }
        ImGui::PopFont();
        end_clip_table();
    }
    draw_made_corners(page, plane);
}

void draw_clip_rest(const ClipPage& page) {
    const std::vector<CutCorner> corners = corners_before(page.history);
    if (page.history.planes.empty() || page.history.polygon.empty()) return;
    const std::span<const ScreenVertex> pixels =
        page.frame.triangle_vertices(page.history.triangle);
    const bool has_pixels =
        page.frame.is_drawn(page.history.triangle) && pixels.size() == corners.size();
    draw_clip_title(page, "The polygon that remains", "divided by w: pixels");
    if (begin_clip_table(page, "rest", {1.2f, 1.1f, 1.1f, 0.8f, 0.9f, 0.9f})) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        for (const int i : {0, 1, 3}) {
            const auto at = static_cast<std::size_t>(i);
            draw_column_title(page, std::string("clip.rest.") + clip_coordinates[at],
                              clip_coordinates[at], clip_coordinate_help[at]);
        }
        draw_column_title(page, "clip.rest.column", "column", "The column of its pixel.");
        draw_column_title(page, "clip.rest.row", "row", "The row of its pixel.");
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const std::string corner = std::to_string(c);
            draw_corner_name(page, corners[c], page.progress.has_value());
            name_widget(page.ui, "clip.rest." + corner, corner_help(corners[c]));
            ImGui::PushFont(page.ui.fonts.mono);
            for (const int i : {0, 1, 3}) {
                const std::string id = corner_formula_id(corners[c], i);
                ImGui::TableNextColumn();
                draw_asked(page,
                           "clip.rest." + corner + "." +
                               clip_coordinates[static_cast<std::size_t>(i)],
                           id, clip_number(corners[c].vertex.position_clip[i], i),
                           page.palette().dim, clip_coordinate_help[static_cast<std::size_t>(i)]);
            }
            for (const bool is_column : {true, false}) {
                const std::string id = "pixel." + corner + (is_column ? ".column" : ".row");
                ImGui::TableNextColumn();
                if (!has_pixels) continue;
                draw_asked(page, "clip." + id, id,
                           whole_text(is_column ? pixels[c].column : pixels[c].row),
                           page.palette().text, "Its pixel in the picture.");
            }
            ImGui::PopFont();
        }
        end_clip_table();
    }
    std::string fan;
    for (const auto& triangle : page.history.fan) {
        fan += fan.empty() ? "" : ",  ";
        for (std::size_t k = 0; k < triangle.size(); ++k)
            fan += (k == 0 ? "" : " ") +
                   short_corner_name(corners[static_cast<std::size_t>(triangle[k])]);
    }
    wrapped_text(
        fmt::format("{} make {}:", counted(static_cast<int>(corners.size()), "corner", "corners"),
                    counted(static_cast<int>(page.history.fan.size()), "triangle", "triangles")));
    keep_text_whole(page.ui);
    ImGui::PushFont(page.ui.fonts.mono);
    ImGui::PushStyleColor(ImGuiCol_Text, page.palette().dim);
    wrapped_text(fan);
    keep_text_whole(page.ui);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    name_widget(page.ui, "clip.fan",
                "The fan: every triangle begins at the first corner of the polygon.");
}

void draw_clip_culling(const ClipPage& page) {
    const std::vector<CullAnswer> answers = cull_answers(page.frame, page.history);
    if (answers.empty()) return;
    draw_clip_title(page, "Front or back?", "each way to ask");
    if (begin_clip_table(page, "culling", {1.6f, 1.2f, 1.0f})) {
        for (const CullAnswer& answer : answers)
            draw_answer(page, answer, answer.way == page.frame.settings.cull);
        end_clip_table();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, page.palette().dim);
    wrapped_text(culling_text(page, answers));
    keep_text_whole(page.ui);
    ImGui::PopStyleColor();
    name_widget(page.ui, "clip.culling",
                "Of a closed body one sees only the sides that face the camera; the others need "
                "not be drawn. The setting \"Backs left out\" says which way is in force.");
}

void draw_clip_counts(const ClipPage& page) {
    const RunResults& a = page.ui.results.a;
    const bool is_whole = a.replay.tallied() == cursor_end;
    const LeftOut left_out = count_left_out(page.frame);
    const ClipCounts clipping = count_clipping(page.frame);
    draw_clip_title(page, "In the whole frame",
                    counted(page.frame.triangle_count(), "triangle", "triangles"));
    if (!begin_clip_table(page, "counts", {2.2f, 1.0f})) return;
    const auto line = [&](const std::string& title, const std::string& name, std::int64_t count,
                          const std::string& help) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        put_text(page, page.palette().text, title);
        name_widget(page.ui, "clip.count." + name, help);
        ImGui::PushFont(page.ui.fonts.mono);
        ImGui::TableNextColumn();
        put_right(page, whole_text(count), page.palette().text);
        ImGui::PopFont();
        note_text(page.ui, "clip.count." + name, whole_text(count));
    };
    line("rejected", "rejected", left_out.of(Rejection::outside),
         "Triangles of which all corners lie beyond the same plane, found by their outcodes.");
    line("cut", "clipped", clipping.clipped, "Triangles from which a plane has cut a part.");
    line("after clipping", "clip_triangles", clipping.clip_triangles,
         "Triangles after clipping: a fan of each polygon; those that were not cut count as well.");
    line("culled", "culled", left_out.of(Rejection::back_facing),
         "Triangles that show their back and are left out.");
    line(is_whole ? "fragments outside" : "fragments outside, so far", "fragments_outside",
         a.replay.tally().fragments_outside,
         "Fragments that fall beside the picture: worked out for nothing. Clipping by all planes "
         "saves them, and so does cheap clipping.");
    end_clip_table();
}

} // namespace rasterwalk
