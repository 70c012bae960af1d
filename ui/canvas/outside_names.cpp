#include "ui/canvas/outside_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "ui/canvas/vector_marks.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// From the dark rim of a name to what it names, design pixels.
constexpr float name_distance = 2.5f;

/// Between a name and the lines of the triangle, design pixels.
constexpr float line_room = 2.5f;

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
Name name_of(const OutsidePen& pen, const OutsidePoint& point) {
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
std::vector<Name> names_of(const OutsidePen& pen, const OutsideMarks& marks) {
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

/// The colour of the rim around a name. Only their colours distinguish the letters of the vectors,
/// so theirs contrasts more.
ImU32 rim_of(const OutsidePen& pen, OutsidePointKind kind) {
    const ImU32 ground = packed(palette(pen.ui.options.theme).ground, 0.9f);
    return kind == OutsidePointKind::vector ? ground : pen.ground(0.8f);
}

} // namespace

Meaning axis_meaning(int number) {
    return edge_meaning(number % axis_count);
}

void draw_outside_names(const OutsidePen& pen, const OutsideMarks& marks,
                        std::vector<OutsideBox> taken) {
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
                    names[i].text, {names[i].colour, rim_of(pen, point.kind)});
    }
}

} // namespace rasterwalk
