#include "inspect/clip_diagram.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "outside/label_places.h"
#include "outside/outside_marks.h"
#include "ui/inspector/clip_parts.h"
#include "ui/inspector/clip_table.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The heights it can have, design pixels; if the page is too low for the smaller one, it is left
/// out.
constexpr float diagram_heights[] = {170.0f, 120.0f};

/// A narrower diagram has no room for names, design pixels.
constexpr float least_diagram_width = 180.0f;

/// Opacity of the part of an edge that the plane takes away.
constexpr float taken_opacity = 0.35f;

/// The diagram on the screen.
struct ClipField {
    const ClipPage& page;
    const ClipDiagram& diagram;
    float u;
    ImDrawList* list;
    ImVec2 low, high; ///< corners of what is ruled

    ImVec2 at(const glm::dvec2& place) const {
        const auto share = [](double value, const Interval& range) {
            return static_cast<float>((value - range.low) / (range.high - range.low));
        };
        return {low.x + (high.x - low.x) * share(place.x, diagram.side_range),
                high.y - (high.y - low.y) * share(place.y, diagram.w_range)};
    }
    ImVec2 at(const CutCorner& corner) const { return at(diagram.place(corner)); }
    ImU32 colour(Meaning meaning, float opacity = 1.0f) const {
        return packed(colour_of(meaning, page.ui.options.theme), opacity);
    }
};

/// Corners at one point of the diagram, and what is written there.
struct CornerMark {
    ImVec2 at;
    std::string widget, name, help, number; ///< `number` is the id of the formula it leads to
    ImU32 ink;
    bool is_made;
};

/// "x = −160.0, y = 160.0, z = 1, w = −2.000"
std::string coordinates_text(const CutCorner& corner) {
    std::string text;
    for (int i = 0; i < 4; ++i) {
        text += fmt::format("{}{} = {}", i == 0 ? "" : ", ",
                            clip_coordinates[static_cast<std::size_t>(i)],
                            clip_number(corner.vertex.position_clip[i], i));
    }
    return text;
}

/// The step that made a corner of this plane; null if none did.
const ClipStep* cutting_step(const ClipDiagram& diagram, const CutCorner& made) {
    const auto found =
        std::find_if(diagram.steps.begin(), diagram.steps.end(), [&](const ClipStep& step) {
            return step.is_cut && step.from == made.plane_edge;
        });
    return found == diagram.steps.end() ? nullptr : &*found;
}

CornerMark given_mark(const ClipField& field, std::size_t i) {
    const ClipDiagram& diagram = field.diagram;
    const CutCorner& corner = diagram.corners[i];
    const bool is_inside = i < diagram.steps.size() && diagram.steps[i].is_from_inside;
    const float d = i < diagram.steps.size() ? diagram.steps[i].d_from : 0.0f;
    return {field.at(corner),
            fmt::format("clip.diagram.corner.{}", i),
            short_corner_name(corner),
            fmt::format("{}, {} the {}: d = {}\n{}", corner_name(corner),
                        is_inside ? "on the inner side of" : "beyond", plane_name(diagram.plane),
                        fixed(static_cast<double>(d), 3), coordinates_text(corner)),
            fmt::format("d.{}.{}", static_cast<int>(diagram.plane), i),
            field.colour(is_inside ? Meaning::pass : Meaning::fail),
            false};
}

CornerMark made_mark(const ClipField& field, const CutCorner& corner, const ClipStep& step) {
    const ClipDiagram& diagram = field.diagram;
    const bool is_current = field.page.is_current(diagram.plane, step.from);
    const std::string t = fixed(static_cast<double>(step.t), 4);
    return {field.at(corner),
            fmt::format("clip.diagram.new.{}", corner.new_index),
            short_corner_name(corner) + (is_current ? ", t = " + t : ""),
            fmt::format("{}, on the {}: t = {}\n{}", corner_name(corner), plane_name(diagram.plane),
                        t, coordinates_text(corner)),
            fmt::format("t.{}.{}", static_cast<int>(diagram.plane), step.from),
            field.colour(is_current ? Meaning::current : plane_meaning),
            true};
}

/// All corners made so far; those at one point share a mark.
std::vector<CornerMark> corner_marks(const ClipField& field) {
    std::vector<CornerMark> marks;
    const auto add = [&](CornerMark mark) {
        const float near = 6.0f * field.u;
        const auto same = std::find_if(marks.begin(), marks.end(), [&](const CornerMark& other) {
            return other.is_made == mark.is_made && std::abs(other.at.x - mark.at.x) < near &&
                   std::abs(other.at.y - mark.at.y) < near;
        });
        if (same == marks.end()) {
            marks.push_back(std::move(mark));
            return;
        }
        same->name += ", " + mark.name;
        same->help += "\n" + mark.help;
    };
    // If the step at work has made a corner, that is named first.
    for (const bool is_current : {true, false}) {
        for (const CutCorner& corner : field.diagram.made) {
            const ClipStep* const step = cutting_step(field.diagram, corner);
            if (step == nullptr || field.page.is_coming(field.diagram.plane, step->from)) continue;
            if (field.page.is_current(field.diagram.plane, step->from) == is_current)
                add(made_mark(field, corner, *step));
        }
    }
    for (std::size_t i = 0; i < field.diagram.corners.size(); ++i)
        add(given_mark(field, i));
    return marks;
}

void draw_ground(const ClipField& field) {
    const Palette& p = field.page.palette();
    field.list->AddRectFilled(field.low, field.high, packed(p.card));
    std::vector<ImVec2> inside;
    for (const glm::dvec2& place : field.diagram.inside)
        inside.push_back(field.at(place));
    if (inside.size() >= least_corners) {
        field.list->AddConvexPolyFilled(inside.data(), static_cast<int>(inside.size()),
                                        field.colour(Meaning::pass, 0.16f));
    }
}

/// The numbers of both axes, and their names at the ends.
void draw_diagram_axes(const ClipField& field, float left) {
    const Palette& p = field.page.palette();
    const float u = field.u, line = ImGui::GetFontSize();
    const ClipDiagram& diagram = field.diagram;
    const char* const side_name = clip_coordinates[static_cast<std::size_t>(diagram.side)];
    field.list->AddText({left, field.low.y}, packed(p.text), "w");
    const int rows = std::max(static_cast<int>((field.high.y - field.low.y) / (2.4f * line)), 2);
    const Ticks up = nice_ticks(diagram.w_range, rows);
    for (const double tick : up.places) {
        const float y = std::floor(field.at({diagram.side_range.low, tick}).y) + 0.5f;
        field.list->AddLine({field.low.x, y}, {field.high.x, y}, packed(p.line));
        const std::string label = fixed(tick, up.digits);
        const float x = field.low.x - text_width(label) - 5.0f * u;
        const bool is_free = y - 0.5f * line > field.low.y + line && x >= left;
        if (is_free) field.list->AddText({x, y - 0.5f * line}, packed(p.dim), label.c_str());
    }
    const float below = field.high.y + 4.0f * u;
    const float name_begin = field.high.x - text_width(side_name);
    field.list->AddText({name_begin, below}, packed(p.text), side_name);
    const Ticks across = nice_ticks(diagram.side_range, 5);
    float free_from = left;
    for (const double tick : across.places) {
        const float x = std::floor(field.at({tick, diagram.w_range.low}).x) + 0.5f;
        field.list->AddLine({x, field.high.y}, {x, field.high.y + 3.0f * u}, packed(p.dim));
        const std::string label = fixed(tick, across.digits);
        const float half = 0.5f * text_width(label);
        if (x - half < free_from || x + half > name_begin - 6.0f * u) continue;
        field.list->AddText({x - half, below}, packed(p.dim), label.c_str());
        free_from = x + half + 6.0f * u;
    }
}

/// An edge of the polygon before the plane: what is left of it, and in fainter ink what the plane
/// takes.
void draw_diagram_edge(const ClipField& field, const ClipStep& step) {
    const std::vector<CutCorner>& corners = field.diagram.corners;
    const CutCorner& from = corners[static_cast<std::size_t>(step.from)];
    const ImVec2 a = field.at(from), b = field.at(corners[static_cast<std::size_t>(step.to)]);
    const ImVec4 colour = cut_edge_colour(field.page, from);
    const float width = 2.0f * field.u;
    if (field.page.is_current(field.diagram.plane, step.from))
        field.list->AddLine(a, b, field.colour(Meaning::current, 0.5f), 3.0f * width);
    if (field.page.is_coming(field.diagram.plane, step.from)) {
        field.list->AddLine(a, b, packed(colour), width);
        return;
    }
    const bool is_taken = !step.is_from_inside && !step.is_to_inside;
    field.list->AddLine(a, b, packed(colour, is_taken || step.is_cut ? taken_opacity : 1.0f),
                        width);
    if (!step.is_cut) return;
    const glm::vec4& cut = step.cut.position_clip;
    field.list->AddLine(step.is_from_inside ? a : b, field.at({cut[field.diagram.side], cut.w}),
                        packed(colour), width);
}

void draw_corner_mark(const ClipField& field, const CornerMark& mark) {
    const float r = (mark.is_made ? 5.0f : 4.0f) * field.u;
    const ImVec2 at = mark.at;
    if (!mark.is_made) {
        field.list->AddCircleFilled(at, r + field.u, packed(field.page.palette().card));
        field.list->AddCircleFilled(at, r, mark.ink);
        return;
    }
    field.list->AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r},
                              {at.x - r, at.y}, mark.ink);
}

OutsideLine label_line(const ClipField& field, ImVec2 from, ImVec2 to) {
    return {.kind = OutsideLineKind::edge,
            .from = {from.x - field.low.x, from.y - field.low.y},
            .to = {to.x - field.low.x, to.y - field.low.y}};
}

/// A text of the diagram, next to the place that it names. A text with several possible places or
/// lengths is written where it first has room.
struct DiagramName {
    ImVec2 at;
    std::string text;
    ImU32 ink;
    std::string line{}; ///< the line it names, if it names no corner: a line has only one name
};

/// The names, where there is room, next to what is drawn.
void draw_diagram_names(const ClipField& field, const std::vector<DiagramName>& names,
                        const std::vector<OutsideLine>& lines) {
    const float u = field.u, distance = 6.0f * u;
    const auto within = [&](ImVec2 at) {
        return glm::vec2(at.x - field.low.x, at.y - field.low.y);
    };
    std::vector<OutsideBox> taken;
    for (const DiagramName& name : names) {
        if (name.line.empty())
            taken.push_back({within(name.at) - distance, within(name.at) + distance});
    }
    std::set<std::string> written;
    for (const DiagramName& name : names) {
        const bool is_of_line = !name.line.empty();
        if (is_of_line && written.count(name.line) > 0) continue;
        const OutsideLabel label{
            .point = within(name.at),
            .size = {text_width(name.text) + 4.0f * u, ImGui::GetFontSize() + 2.0f * u},
            .distance = distance,
            .line_distance = 2.0f * u,
            .needs_distance = is_of_line}; // on a line it would look like that line's name
        const auto place = label_places({&label, 1}, taken, lines, within(field.high)).front();
        if (!place) continue;
        written.insert(name.line);
        taken.push_back({*place, *place + label.size});
        field.list->AddText(
            {std::round(field.low.x + place->x + 2.0f * u), std::round(field.low.y + place->y + u)},
            name.ink, name.text.c_str());
    }
}

void draw_field(const ClipField& field, const std::vector<CornerMark>& marks, float left) {
    const ClipDiagram& diagram = field.diagram;
    const Palette& p = field.page.palette();
    draw_ground(field);
    draw_diagram_axes(field, left);
    std::vector<DiagramName> names;
    std::vector<OutsideLine> lines;
    for (const CornerMark& mark : marks)
        names.push_back({mark.at, mark.name, mark.is_made ? mark.ink : packed(p.text)});
    for (const ClipStep& step : diagram.steps) {
        draw_diagram_edge(field, step);
        lines.push_back(label_line(field,
                                   field.at(diagram.corners[static_cast<std::size_t>(step.from)]),
                                   field.at(diagram.corners[static_cast<std::size_t>(step.to)])));
    }
    if (diagram.line) {
        const ImVec2 a = field.at((*diagram.line)[0]), b = field.at((*diagram.line)[1]);
        field.list->AddLine(a, b, field.colour(plane_meaning), 2.0f * field.u);
        lines.push_back(label_line(field, a, b));
        const ImVec2 upper = a.y < b.y ? a : b, lower = a.y < b.y ? b : a;
        for (const float share : {0.12f, 0.88f, 0.5f, 0.3f, 0.7f}) {
            names.push_back(
                {{upper.x + share * (lower.x - upper.x), upper.y + share * (lower.y - upper.y)},
                 plane_name(diagram.plane),
                 field.colour(plane_meaning),
                 "plane"});
        }
    }
    if (diagram.w_range.low < 0.0 && diagram.w_range.high > 0.0) {
        const float y = std::floor(field.at({diagram.side_range.low, 0.0}).y) + 0.5f;
        field.list->AddLine({field.low.x, y}, {field.high.x, y}, packed(p.dim), field.u);
        lines.push_back(label_line(field, {field.low.x, y}, {field.high.x, y}));
        for (const char* const name : {"w = 0: the eye's plane", "w = 0"}) {
            for (const float share : {0.0f, 0.5f, 1.0f, 0.25f, 0.75f}) {
                const float x = field.low.x + share * (field.high.x - field.low.x);
                names.push_back({{x, y}, name, packed(p.dim), "w = 0"});
            }
        }
    }
    for (const CornerMark& mark : marks)
        draw_corner_mark(field, mark);
    draw_diagram_names(field, names, lines);
}

/// Each corner can be pointed at and clicked.
void draw_corner_buttons(const ClipField& field, const std::vector<CornerMark>& marks) {
    const float reach = 7.0f * field.u;
    for (const CornerMark& mark : marks) {
        ImGui::SetCursorScreenPos({mark.at.x - reach, mark.at.y - reach});
        if (ImGui::InvisibleButton(mark.widget.c_str(), {2.0f * reach, 2.0f * reach}))
            field.page.ui.inspector.clip.number = mark.number;
        register_widget(field.page.ui, mark.widget,
                        mark.help + "\nClick to see how it was "
                                    "calculated.");
    }
}

/// How high it may be: a drawing shown whole or not at all fills at most half of the window that
/// scrolls. None if that is too low.
std::optional<float> fitting_height(const ClipPage& page, float caption) {
    const float u = page.ui.options.text_scale;
    if (ImGui::GetContentRegionAvail().x < least_diagram_width * u) return std::nullopt;
    for (const float height : diagram_heights) {
        if (height * u + caption <= 0.5f * page_room()) return height * u;
    }
    return std::nullopt;
}

/// Says above the diagram which side is inside.
void draw_caption(const ClipPage& page, const ClipDiagram& diagram) {
    const std::string condition = "inside: " + inside_condition(page.history, diagram);
    const std::string side = clip_coordinates[static_cast<std::size_t>(diagram.side)];
    text_in(page.palette().dim,
            first_fitting({"clip space, " + side + " and w; " + condition, condition},
                          ImGui::GetContentRegionAvail().x));
    register_widget(
        page.ui, "clip.diagram.inside",
        "Before the division, the plane is a straight line in these two coordinates, and "
        "so is every edge, even where w is negative. So each edge meets the plane at "
        "most once, and a straight cut is enough. On the screen, an edge through the "
        "eye's plane would come back from the other side.\nx and y are in pixels: at the "
        "border of the picture, x is W/2 · w and y is H/2 · w.");
}

} // namespace

bool draw_clip_diagram(const ClipPage& page, ClipPlane plane) {
    const std::optional<ClipDiagram> diagram = clip_diagram(page.history, plane);
    if (!diagram) return false;
    Ui& ui = page.ui;
    const float u = ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    const float caption = ImGui::GetTextLineHeightWithSpacing();
    const std::optional<float> height = fitting_height(page, caption);
    if (height && diagram->is_endless) {
        wrapped_text_in(page.palette().dim,
                        "No diagram: a corner is not a number, or is too far away to be drawn.");
        register_widget(ui, "clip.diagram.none",
                        "A diagram needs corners with finite coordinates.");
    } else if (height) {
        const float top = ImGui::GetCursorScreenPos().y;
        draw_caption(page, *diagram);
        const ImVec2 start = ImGui::GetCursorScreenPos();
        const ImVec2 size{ImGui::GetContentRegionAvail().x, *height};
        const float numbers = text_width("−00.00") + 8.0f * u;
        const ClipField field{page,
                              *diagram,
                              u,
                              ImGui::GetWindowDrawList(),
                              {start.x + numbers, start.y + 2.0f * u},
                              {start.x + size.x - 2.0f * u,
                               start.y + size.y - ImGui::GetTextLineHeight() - 6.0f * u}};
        const std::vector<CornerMark> marks = corner_marks(field);
        draw_corner_buttons(field, marks);
        ImGui::SetCursorScreenPos(start);
        ImGui::Dummy(size);
        register_widget(ui, "clip.diagram");
        clip_range_to_lines(top, start.y + size.y);
        draw_field(field, marks, start.x);
    }
    ImGui::PopFont();
    return height.has_value();
}

} // namespace rasterwalk
