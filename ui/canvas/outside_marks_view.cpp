#include "ui/canvas/outside_marks_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "outside/label_places.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// In a view smaller than this the marks are smaller too, down to this part of their size, and
/// names are short; design pixels.
constexpr float roomy_view = 420.0f;
constexpr float smallest_marks = 0.6f;

/// From the dark rim of a name to what it names, design pixels.
constexpr float name_distance = 2.5f;

/// Between a name and the lines of the triangle, design pixels.
constexpr float line_room = 2.5f;

/// What the marks are drawn with.
struct Pen {
    const Ui& ui;
    ImDrawList* list;
    const Pane& pane;
    float u;        ///< design pixel, smaller in a small view
    bool is_narrow; ///< names are short

    ImVec2 at(const glm::vec2& place) const { return {pane.low.x + place.x, pane.low.y + place.y}; }
    ImU32 text(float opacity = 1.0f) const {
        return packed(palette(ui.options.theme).text, opacity);
    }
    ImU32 ground(float opacity = 1.0f) const {
        return packed(palette(ui.options.theme).canvas, opacity);
    }
    /// Of a name. The letters of vectors are told apart by their colours, which need more contrast.
    ImU32 rim_of(OutsidePointKind kind) const {
        const Palette& p = palette(ui.options.theme);
        return kind == OutsidePointKind::vector ? packed(p.ground, 0.9f) : ground(0.8f);
    }
    ImU32 meaning(Meaning meaning, float opacity = 1.0f) const {
        return packed(colour_of(meaning, ui.options.theme), opacity);
    }
};

void draw_dashed_with(const Pen& pen, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
    draw_dashed(pen.list, pen.u, from, to, colour, width);
}

/// A plane is a pane that everything is seen through.
void draw_face(const Pen& pen, const std::vector<glm::vec2>& face, ImU32 colour) {
    std::vector<ImVec2> corners;
    for (const glm::vec2& corner : face)
        corners.push_back(pen.at(corner));
    if (corners.size() < 3) return;
    pen.list->AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), colour);
}

/// The three axes of a space have the colours of three edges.
Meaning axis_meaning(int number) {
    return edge_meaning(number % axis_count);
}

void draw_arrow_with(const Pen& pen, ImVec2 from, ImVec2 to, ImU32 colour) {
    draw_arrow(pen.list, pen.u, from, to, {colour, pen.ground(0.7f)});
}

/// A line of the overlay of vectors; from outside the right angle looks like the perpendicular.
void draw_vector_mark(const Pen& pen, const OutsideLine& line) {
    const bool is_angle = line.kind == OutsideLineKind::vector_angle;
    draw_vector_line({pen.list, pen.u, pen.ui.options.theme, pen.ground(0.7f)},
                     is_angle ? OutsideLineKind::vector_dropped : line.kind,
                     static_cast<VectorName>(line.number), pen.at(line.from), pen.at(line.to));
}

void draw_line(const Pen& pen, const OutsideLine& line) {
    const ImVec2 from = pen.at(line.from), to = pen.at(line.to);
    const float u = pen.u;
    switch (line.kind) {
    case OutsideLineKind::frustum:
        pen.list->AddLine(from, to, pen.text(0.7f), 1.3f * u);
        break;
    case OutsideLineKind::beyond:
        pen.list->AddLine(from, to, pen.text(0.3f), 1.0f * u);
        break;
    case OutsideLineKind::border:
        pen.list->AddLine(from, to, pen.text(), 1.8f * u);
        break;
    case OutsideLineKind::edge:
        pen.list->AddLine(from, to, pen.ground(0.7f), 5.0f * u);
        pen.list->AddLine(from, to, pen.meaning(edge_meaning(line.number)), 2.6f * u);
        break;
    case OutsideLineKind::ray:
        pen.list->AddLine(from, to, pen.ground(0.6f), 3.2f * u);
        pen.list->AddLine(from, to, pen.meaning(Meaning::pass), 1.5f * u);
        break;
    case OutsideLineKind::behind:
    case OutsideLineKind::mirrored:
    case OutsideLineKind::cut_off:
        draw_dashed_with(pen, from, to, pen.meaning(Meaning::fail), 1.5f * u);
        break;
    case OutsideLineKind::cut:
        pen.list->AddLine(from, to, pen.ground(0.7f), 5.0f * u);
        pen.list->AddLine(from, to, pen.meaning(Meaning::left_end), 2.6f * u);
        break;
    case OutsideLineKind::fan:
        pen.list->AddLine(from, to, pen.ground(0.6f), 2.6f * u);
        pen.list->AddLine(from, to, pen.text(0.9f), 1.0f * u);
        break;
    case OutsideLineKind::plane:
        pen.list->AddLine(from, to, pen.meaning(Meaning::left_end, 0.8f), 1.3f * u);
        break;
    case OutsideLineKind::end:
        pen.list->AddLine(from, to, pen.meaning(Meaning::left_end, 0.55f), 1.0f * u);
        break;
    case OutsideLineKind::lamp_ray:
        pen.list->AddLine(from, to, pen.ground(0.7f), 4.0f * u);
        pen.list->AddLine(from, to, pen.meaning(Meaning::left_end), 2.0f * u);
        break;
    case OutsideLineKind::blocked_ray:
        draw_dashed_with(pen, from, to, pen.meaning(Meaning::fail), 1.8f * u);
        break;
    case OutsideLineKind::sight_ray:
        pen.list->AddLine(from, to, pen.ground(0.6f), 3.2f * u);
        pen.list->AddLine(from, to, pen.meaning(Meaning::current), 1.3f * u);
        break;
    case OutsideLineKind::imagined:
        draw_dashed_with(pen, from, to, pen.text(0.9f), 1.5f * u);
        break;
    case OutsideLineKind::shift:
        draw_arrow_with(pen, from, to, pen.meaning(Meaning::current));
        break;
    case OutsideLineKind::footprint:
        pen.list->AddLine(from, to, pen.ground(0.7f), 3.0f * u);
        pen.list->AddLine(from, to, pen.meaning(Meaning::pass), 1.2f * u);
        break;
    case OutsideLineKind::axis:
        draw_arrow_with(pen, from, to, pen.meaning(axis_meaning(line.number)));
        break;
    case OutsideLineKind::vector:
    case OutsideLineKind::vector_shadow:
    case OutsideLineKind::vector_dropped:
    case OutsideLineKind::vector_angle:
    case OutsideLineKind::vector_opposite:
        draw_vector_mark(pen, line);
        break;
    }
}

void draw_camera(const Pen& pen, ImVec2 at) {
    const float u = pen.u;
    const ImVec2 half{10.0f * u, 7.0f * u};
    const ImVec2 low{at.x - half.x, at.y - half.y}, high{at.x + half.x, at.y + half.y};
    pen.list->AddRectFilled(low, high, pen.ground(), 3.0f * u);
    pen.list->AddRect(low, high, pen.text(), 3.0f * u, 0, 1.8f * u);
    pen.list->AddCircleFilled(at, 3.0f * u, pen.text());
}

void draw_lamp(const Pen& pen, ImVec2 at) {
    const float u = pen.u;
    pen.list->AddCircleFilled(at, 8.5f * u, pen.ground(0.7f));
    pen.list->AddCircle(at, 7.0f * u, pen.meaning(Meaning::left_end), 0, 1.6f * u);
    pen.list->AddCircleFilled(at, 3.0f * u, pen.meaning(Meaning::left_end));
}

void draw_dot(const Pen& pen, ImVec2 at, float radius, ImU32 colour) {
    pen.list->AddCircleFilled(at, radius + 1.4f * pen.u, pen.ground(0.85f));
    pen.list->AddCircleFilled(at, radius, colour);
}

void draw_point(const Pen& pen, const OutsidePoint& point) {
    const ImVec2 at = pen.at(point.at);
    const float u = pen.u;
    switch (point.kind) {
    case OutsidePointKind::camera:
        draw_camera(pen, at);
        break;
    case OutsidePointKind::lamp:
        draw_lamp(pen, at);
        break;
    case OutsidePointKind::picture:
    case OutsidePointKind::plane:
    case OutsidePointKind::end:
    case OutsidePointKind::divider:
    case OutsidePointKind::axis:
    case OutsidePointKind::vector:
    case OutsidePointKind::origin:
        break; // only its name is there
    case OutsidePointKind::cut:
        draw_dot(pen, at, 4.5f * u, pen.meaning(Meaning::left_end));
        break;
    case OutsidePointKind::mirrored:
        pen.list->AddCircle(at, 5.0f * u, pen.ground(), 0, 4.0f * u);
        pen.list->AddCircle(at, 5.0f * u, pen.meaning(Meaning::fail), 0, 1.8f * u);
        break;
    case OutsidePointKind::shaded:
        draw_dot(pen, at, 3.5f * u, pen.meaning(Meaning::left_end));
        break;
    case OutsidePointKind::seen:
        draw_dot(pen, at, 3.0f * u, pen.text());
        break;
    case OutsidePointKind::texel:
        draw_dot(pen, at, 3.5f * u, pen.meaning(Meaning::current));
        break;
    case OutsidePointKind::occluder:
        draw_dot(pen, at, 4.5f * u, pen.meaning(Meaning::fail));
        break;
    case OutsidePointKind::vertex:
        draw_dot(pen, at, 4.5f * u, pen.meaning(Meaning::current));
        break;
    case OutsidePointKind::behind:
        draw_dot(pen, at, 4.5f * u, pen.meaning(Meaning::fail));
        break;
    case OutsidePointKind::crossing:
        draw_dot(pen, at, 3.0f * u, pen.meaning(Meaning::pass));
        break;
    case OutsidePointKind::pixel: {
        const float half = 4.0f * u;
        pen.list->AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, pen.ground(),
                          0.0f, 0, 3.6f * u);
        pen.list->AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half},
                          pen.meaning(Meaning::current), 0.0f, 0, 1.8f * u);
        break;
    }
    }
}

/// Half the room that a point takes from names, design pixels.
float reach_of(OutsidePointKind kind) {
    switch (kind) {
    case OutsidePointKind::camera:
        return 10.0f;
    case OutsidePointKind::lamp:
        return 8.5f;
    case OutsidePointKind::vertex:
    case OutsidePointKind::behind:
    case OutsidePointKind::pixel:
    case OutsidePointKind::cut:
    case OutsidePointKind::mirrored:
    case OutsidePointKind::shaded:
    case OutsidePointKind::occluder:
    case OutsidePointKind::texel:
    case OutsidePointKind::vector:
        return 6.0f;
    case OutsidePointKind::crossing:
    case OutsidePointKind::seen:
        return 4.5f;
    case OutsidePointKind::picture:
    case OutsidePointKind::plane:
    case OutsidePointKind::end:
    case OutsidePointKind::divider:
    case OutsidePointKind::axis:
    case OutsidePointKind::origin:
        break; // nothing is drawn there
    }
    return 0.0f;
}

bool is_of_triangle(OutsideLineKind kind) {
    return kind == OutsideLineKind::ray || kind == OutsideLineKind::behind ||
           kind == OutsideLineKind::edge || kind == OutsideLineKind::cut ||
           kind == OutsideLineKind::cut_off;
}

struct Name {
    OutsidePoint point;
    std::string text;
    ImU32 colour;
    int rank; ///< the first is placed first
    LabelSide side = LabelSide::right;
};

/// "world x", "right", "object z", "tangent". In a narrow view "x": there the space is named at its
/// origin.
std::string axis_name(int number, bool is_narrow) {
    constexpr std::array<const char*, axis_count> plain{"x", "y", "z"},
        of_camera{"right", "down", "forward"}, of_surface{"tangent", "bitangent", "normal"};
    const auto axis = static_cast<std::size_t>(number % axis_count);
    const auto of = static_cast<BasisOf>(number / axis_count);
    if (of == BasisOf::camera) return of_camera[axis];
    if (of == BasisOf::surface)
        return is_narrow ? std::string(1, of_surface[axis][0]) : of_surface[axis];
    return (is_narrow ? "" : std::string(word_of(of)) + " ") + plain[axis];
}

/// The camera has its name already.
std::string origin_name(int number, bool is_narrow) {
    const auto of = static_cast<BasisOf>(number);
    return is_narrow && of != BasisOf::camera ? std::string(word_of(of)) : "";
}

/// Is it a plane, which is named at one of its corners?
bool is_plane(OutsidePointKind kind) {
    return kind == OutsidePointKind::plane || kind == OutsidePointKind::end ||
           kind == OutsidePointKind::divider;
}

/// Empty for a point without a name.
Name name_of(const Pen& pen, const OutsidePoint& point) {
    const std::string vertex =
        (pen.is_narrow ? "[" : "vertices[") + std::to_string(point.number) + "]";
    const bool is_of_plane = point.kind == OutsidePointKind::cut ||
                             (is_plane(point.kind) && point.kind != OutsidePointKind::divider);
    const auto which = is_of_plane ? static_cast<ClipPlane>(point.number) : ClipPlane::near;
    const std::string_view plane = word_of(which);
    switch (point.kind) {
    case OutsidePointKind::camera:
        return {point, "camera", pen.text(), 0, LabelSide::below};
    case OutsidePointKind::lamp:
        return {point, "lamp", pen.text(), 1};
    case OutsidePointKind::vertex:
        return {point, vertex, pen.text(), 2};
    case OutsidePointKind::behind:
        return {point, pen.is_narrow ? vertex : vertex + ", behind the camera",
                pen.meaning(Meaning::fail), 2};
    case OutsidePointKind::picture:
        return {point, "the picture", pen.text(), 3, LabelSide::above_right};
    case OutsidePointKind::cut:
        return {point, std::string(plane), pen.meaning(Meaning::left_end), 3};
    case OutsidePointKind::plane:
    case OutsidePointKind::end:
        return {point, pen.is_narrow ? std::string(plane) : std::string(plane) + " plane",
                pen.meaning(Meaning::left_end), 4, LabelSide::above_right};
    case OutsidePointKind::divider:
        return {point, fmt::format("plane of [{}]", point.number), pen.meaning(Meaning::left_end),
                4, LabelSide::above_right};
    case OutsidePointKind::mirrored:
        return {point, pen.is_narrow ? "divided" : "dividing puts it here",
                pen.meaning(Meaning::fail), 2};
    case OutsidePointKind::occluder:
        return {point, pen.is_narrow ? "blocks" : "blocks the light", pen.meaning(Meaning::fail),
                1};
    case OutsidePointKind::texel:
        return {point, pen.is_narrow ? "texel" : "its texel is shown",
                pen.meaning(Meaning::current), 1};
    case OutsidePointKind::axis:
        // Before the vertices: an arrow without a name says nothing, while the panel has the
        // vertices' numbers.
        return {point, axis_name(point.number, pen.is_narrow),
                pen.meaning(axis_meaning(point.number)), 1};
    case OutsidePointKind::vector: {
        const auto vector = static_cast<VectorName>(point.number);
        return {point, std::string(vector_words(vector).symbol),
                packed(vector_colour(vector, pen.ui.options.theme)), -1};
    }
    case OutsidePointKind::origin:
        return {point, origin_name(point.number, pen.is_narrow), pen.text(), 2};
    case OutsidePointKind::crossing:
    case OutsidePointKind::pixel:
    case OutsidePointKind::shaded:
    case OutsidePointKind::seen:
        break;
    }
    return {point, {}, 0, 4};
}

/// The corners of the picture, or of the plane, that lie farthest up and to the right come first:
/// there its name has room.
std::vector<const OutsidePoint*> named_corners(const OutsideMarks& marks, OutsidePointKind kind) {
    std::vector<const OutsidePoint*> corners;
    for (const OutsidePoint& point : marks.points) {
        if (point.kind == kind) corners.push_back(&point);
    }
    std::stable_sort(corners.begin(), corners.end(),
                     [](const OutsidePoint* a, const OutsidePoint* b) {
                         return a->at.x - a->at.y > b->at.x - b->at.y;
                     });
    return corners;
}

/// The planes' names come last, once for each of their corners: one of those has room.
std::vector<Name> names_of(const Pen& pen, const OutsideMarks& marks) {
    const auto picture = named_corners(marks, OutsidePointKind::picture);
    std::vector<Name> names;
    for (const OutsidePoint& point : marks.points) {
        if (is_plane(point.kind)) continue;
        if (point.kind == OutsidePointKind::picture && &point != picture.front()) continue;
        Name name = name_of(pen, point);
        if (!name.text.empty()) names.push_back(std::move(name));
    }
    std::stable_sort(names.begin(), names.end(),
                     [](const Name& a, const Name& b) { return a.rank < b.rank; });
    for (const OutsidePointKind kind :
         {OutsidePointKind::plane, OutsidePointKind::divider, OutsidePointKind::end}) {
        for (const OutsidePoint* const point : named_corners(marks, kind))
            names.push_back(name_of(pen, *point));
    }
    return names;
}

/// @param taken in addition to the points
void draw_names(const Pen& pen, const OutsideMarks& marks, std::vector<OutsideBox> taken) {
    const ImFont* const font = pen.ui.fonts.small;
    for (const OutsidePoint& point : marks.points) {
        const float reach = reach_of(point.kind) * pen.u;
        if (reach > 0.0f) taken.push_back({point.at - reach, point.at + reach});
    }
    // Names lie on whole pixels.
    const float halo = halo_width * pen.u + 1.0f, away = name_distance * pen.u;
    const std::vector<Name> names = names_of(pen, marks);
    std::vector<OutsideLine> lines;
    std::copy_if(marks.lines.begin(), marks.lines.end(), std::back_inserter(lines),
                 [](const OutsideLine& line) { return is_of_triangle(line.kind); });
    std::vector<OutsideLabel> labels;
    for (const Name& name : names) {
        const glm::vec2 size{text_width(font, name.text), font->FontSize};
        // The picture is marked by its border alone: next to a line, the name would seem to be the
        // line's.
        const bool is_picture = name.point.kind == OutsidePointKind::picture;
        labels.push_back({name.point.at, size + 2.0f * halo,
                          reach_of(name.point.kind) * pen.u + away, name.side, line_room * pen.u,
                          is_picture});
    }
    const ImVec2 room = pen.pane.room();
    const auto places = label_places(labels, std::move(taken), lines, {room.x, room.y});
    std::set<int> planes; // already named
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!places[i]) continue;
        const OutsidePoint& point = names[i].point;
        if (is_plane(point.kind) && !planes.insert(point.number).second) continue;
        const ImVec2 low = pen.at(*places[i] + halo);
        draw_haloed(pen.list, pen.ui.fonts.small, pen.u, {std::round(low.x), std::round(low.y)},
                    names[i].text, {names[i].colour, pen.rim_of(point.kind)});
    }
}

} // namespace

void draw_outside_marks(const Ui& ui, ImDrawList* list, const OutsideMarks& marks, const Pane& pane,
                        float top, float bottom) {
    const float roomy = roomy_view * ui.options.text_scale;
    const float size = std::min(pane.room().x, pane.room().y) / roomy;
    const Pen pen{ui, list, pane, ui.options.text_scale * std::clamp(size, smallest_marks, 1.0f),
                  pane.room().x < roomy};
    draw_face(pen, marks.face, pen.meaning(Meaning::left_end, 0.12f));
    draw_face(pen, marks.span, pen.text(span_tint));
    for (const OutsideLine& line : marks.lines)
        draw_line(pen, line);
    for (const OutsidePoint& point : marks.points)
        draw_point(pen, point);
    const ImVec2 room = pane.room();
    draw_names(pen, marks,
               {{{0.0f, 0.0f}, {room.x, top}}, {{0.0f, room.y - bottom}, {room.x, room.y}}});
}

} // namespace rasterwalk
