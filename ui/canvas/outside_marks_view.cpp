#include "ui/canvas/outside_marks_view.h"

#include <algorithm>
#include <vector>

#include "ui/canvas/outside_names.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// In a view smaller than this the marks are smaller too, down to this part of their size, and
/// names are short; design pixels.
constexpr float roomy_view = 420.0f;
constexpr float smallest_marks = 0.6f;

void draw_dashed_with(const OutsidePen& pen, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
    draw_dashed(pen.list, pen.u, from, to, colour, width);
}

/// A plane is a pane that everything is seen through.
void draw_face(const OutsidePen& pen, const std::vector<glm::vec2>& face, ImU32 colour) {
    std::vector<ImVec2> corners;
    for (const glm::vec2& corner : face)
        corners.push_back(pen.at(corner));
    if (corners.size() < 3) return;
    pen.list->AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), colour);
}

void draw_arrow_with(const OutsidePen& pen, ImVec2 from, ImVec2 to, ImU32 colour) {
    draw_arrow(pen.list, pen.u, from, to, {colour, pen.ground(0.7f)});
}

/// A line of the overlay of vectors; from outside the right angle looks like the perpendicular.
void draw_vector_mark(const OutsidePen& pen, const OutsideLine& line) {
    const bool is_angle = line.kind == OutsideLineKind::vector_angle;
    draw_vector_line({pen.list, pen.u, pen.ui.options.theme, pen.ground(0.7f)},
                     is_angle ? OutsideLineKind::vector_dropped : line.kind,
                     static_cast<VectorName>(line.number), pen.at(line.from), pen.at(line.to));
}

void draw_line(const OutsidePen& pen, const OutsideLine& line) {
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

void draw_camera(const OutsidePen& pen, ImVec2 at) {
    const float u = pen.u;
    const ImVec2 half{10.0f * u, 7.0f * u};
    const ImVec2 low{at.x - half.x, at.y - half.y}, high{at.x + half.x, at.y + half.y};
    pen.list->AddRectFilled(low, high, pen.ground(), 3.0f * u);
    pen.list->AddRect(low, high, pen.text(), 3.0f * u, 0, 1.8f * u);
    pen.list->AddCircleFilled(at, 3.0f * u, pen.text());
}

void draw_lamp(const OutsidePen& pen, ImVec2 at) {
    const float u = pen.u;
    pen.list->AddCircleFilled(at, 8.5f * u, pen.ground(0.7f));
    pen.list->AddCircle(at, 7.0f * u, pen.meaning(Meaning::left_end), 0, 1.6f * u);
    pen.list->AddCircleFilled(at, 3.0f * u, pen.meaning(Meaning::left_end));
}

void draw_dot(const OutsidePen& pen, ImVec2 at, float radius, ImU32 colour) {
    pen.list->AddCircleFilled(at, radius + 1.4f * pen.u, pen.ground(0.85f));
    pen.list->AddCircleFilled(at, radius, colour);
}

void draw_point(const OutsidePen& pen, const OutsidePoint& point) {
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

} // namespace

void draw_outside_marks(const Ui& ui, ImDrawList* list, const OutsideMarks& marks, const Pane& pane,
                        float top, float bottom) {
    const float roomy = roomy_view * ui.options.text_scale;
    const float size = std::min(pane.room().x, pane.room().y) / roomy;
    const OutsidePen pen{ui, list, pane,
                         ui.options.text_scale * std::clamp(size, smallest_marks, 1.0f),
                         pane.room().x < roomy};
    draw_face(pen, marks.face, pen.meaning(Meaning::left_end, 0.12f));
    draw_face(pen, marks.span, pen.text(span_tint));
    for (const OutsideLine& line : marks.lines)
        draw_line(pen, line);
    for (const OutsidePoint& point : marks.points)
        draw_point(pen, point);
    const ImVec2 room = pane.room();
    draw_outside_names(
        pen, marks, {{{0.0f, 0.0f}, {room.x, top}}, {{0.0f, room.y - bottom}, {room.x, room.y}}});
}

} // namespace rasterwalk
