#include "explain/clip_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/clip_formula_builder.h"
#include "explain/cull_formulas.h"
#include "explain/vertex_report.h"

namespace rasterwalk {

namespace {

/// The parts of an id: "d.2.0" has three.
std::vector<std::string_view> parts_of(std::string_view id) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t point = id.find('.');
        parts.push_back(id.substr(0, point));
        if (point == std::string_view::npos) return parts;
        id.remove_prefix(point + 1);
    }
}

/// A part as a number from 0 up to, not including, `end`; -1 for anything else.
int index_of(std::string_view part, std::size_t end) {
    const std::optional<int> number = parse_int(part);
    return number && *number >= 0 && *number < static_cast<int>(end) ? *number : -1;
}

/// 0..3 for x y z w; -1 for anything else.
int coordinate_of(std::string_view part) {
    const auto found = std::find(clip_coordinate_names.begin(), clip_coordinate_names.end(), part);
    return found == clip_coordinate_names.end()
               ? -1
               : static_cast<int>(found - clip_coordinate_names.begin());
}

/// Makes the formulas of one triangle.
struct ClipReportBuilder : ClipFormulaBuilder {
    std::optional<Formula> corner(int vertex, int i) const;
    std::optional<Formula> moved(CornerPlace place, int number, int i) const;
    Formula distance(const CutCorner& corner, ClipPlane plane, std::string id) const;
    std::optional<Formula> distance_before(ClipPlane plane, std::string_view corner) const;
    std::optional<Formula> cut(ClipPlane plane, std::string_view edge) const;
    std::optional<Formula> made(std::string_view number,
                                const std::vector<std::string_view>& parts) const;
    std::optional<Formula> pixel(std::string_view corner, std::string_view part) const;

    /// Where a new corner comes from.
    struct Origin {
        const ClipStep& step;
        CutCorner inside, outside, corner;
    };
    std::optional<Origin> origin(int new_index) const;
};

std::optional<Formula> ClipReportBuilder::corner(int vertex, int i) const {
    const ClipVertex& v = history.corners[static_cast<std::size_t>(vertex)];
    const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
    const ImageAxes axes = frame.settings.image_axes;
    const int from = axes == ImageAxes::exchanged && i < 2 ? 1 - i : i;
    const std::string along = clip_coordinate_names[static_cast<std::size_t>(from)];
    const std::string camera = i == 3 ? "rotated.z" : "rotated." + along;
    const Source source = from_vertex(history.triangle, vertex, camera);
    Formula formula{
        fmt::format("corner.{}.{}", vertex, name), name, "", "", {}, {coordinate(v, i)}};
    const auto camera_place = [&] {
        const VertexReport report = vertex_report(frame, history.triangle, vertex);
        return report.shaded.in("rotated");
    };
    if (i < 2) {
        formula.help = "Clip space, before the division: pixels from the middle, times w.";
        if (view_box_rule(frame.settings, frame.scene->space)) {
            formula.expression = "v";
            formula.inputs = {
                {"v", formula.result, from_vertex(history.triangle, vertex, "clip." + name)}};
            return formula;
        }
        formula.expression = "f · " + along;
        formula.inputs = {
            {"f", {frame.settings.camera.focal_length}, from_setting("camera.focal_length")},
            {along, {camera_place()[from]}, source}};
        if (axes == ImageAxes::mirrored) formula.expression.insert(0, "−");
        return checked(formula, source);
    }
    formula.help = i == 2 ? "What the depth, " + std::string(depth_words(frame).name) +
                                ", is made from; it is divided by w too."
                          : "What x, y and z are divided by: how far the corner is in front of the "
                            "camera.";
    const float usual = i == 2 ? 1.0f : camera_place().z;
    if (frame.settings.projection_mix == 0.0f && formula.result.value == usual) {
        formula.expression = i == 2 ? "1" : "z_camera";
        if (i == 3) formula.inputs = {{"z_camera", formula.result, source}};
        return formula;
    }
    formula.expression = "v";
    formula.inputs = {{"v", formula.result, from_words("from the projection")}};
    return formula;
}

/// A corner that was divided before the planes saw it, or multiplied again after them.
/// @param place  which of the two; the result is none if the corner's place is a different one
/// @param number of the corner, among the triangle's or among those left
std::optional<Formula> ClipReportBuilder::moved(CornerPlace place, int number, int i) const {
    const auto at = static_cast<std::size_t>(number);
    const bool is_before = place == CornerPlace::changed;
    const CutCorner corner = (is_before ? corners_before(history, 0) : corners_before(history))[at];
    if (corner.place != place) return std::nullopt;
    const CutCorner given =
        is_before ? given_corners(history)[at]
                  : corners_before(history, static_cast<int>(history.planes.size()))[at];
    // Before the planes by w; after them by 1/w, which is then in z.
    const int by = is_before ? 3 : 2;
    const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
    const std::string divisor = clip_coordinate_names[static_cast<std::size_t>(by)];
    Formula formula{corner_formula_id(corner, i),
                    name,
                    is_before ? "Divided by w before the planes cut, which is a mistake."
                              : "Multiplied by w again after the planes have cut, so that it can "
                                "be divided.",
                    i < 2     ? name + " · (1 / " + divisor + ")"
                    : i == by ? "1"
                              : "1 / " + divisor,
                    {},
                    {coordinate(corner.vertex, i)}};
    if (i < 2) formula.inputs.push_back(input(name, given, i));
    if (i != by) formula.inputs.push_back(input(divisor, given, by));
    return checked(formula, from_words("the function that cuts"));
}

/// A coefficient of a plane under a name, and where it comes from.
FormulaInput coefficient(const Settings& settings, ClipPlane plane, float size) {
    const bool is_near = plane == ClipPlane::near, is_far = plane == ClipPlane::far;
    if (is_near && size == settings.near) return {"near", {size}, from_setting("near")};
    if (is_far && size == settings.far) return {"far", {size}, from_setting("far")};
    if (is_near || is_far)
        return {"k", {size}, from_words("the plane, from the depth that the projection gives it")};
    const bool is_across = plane == ClipPlane::left || plane == ClipPlane::right;
    const int side = is_across ? settings.viewport.width : settings.viewport.height;
    const int whole_half = side / 2;
    const auto half = static_cast<float>(whole_half);
    if (size != half && size != static_cast<float>(side) - half)
        return {"g", {size}, from_words("the guard band: pixels from the picture's middle")};
    return {is_across ? "W/2" : "H/2", {size}, from_setting("viewport.size")};
}

Formula ClipReportBuilder::distance(const CutCorner& corner, ClipPlane plane,
                                    std::string id) const {
    const glm::vec4& c = history.codes.planes[static_cast<std::size_t>(plane)];
    Formula formula{std::move(id),
                    "d",
                    "How far inside the " + plane_name(plane) +
                        " the corner is; below 0 it is outside.",
                    "",
                    {},
                    {inner_distance(c, corner.vertex)}};
    // Added terms come first.
    for (const bool is_added : {true, false}) {
        for (int i = 0; i < 4; ++i) {
            if (c[i] == 0.0f || (c[i] > 0.0f) != is_added) continue;
            const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
            std::string term = name;
            formula.inputs.push_back(input(name, corner, i));
            const float size = std::abs(c[i]);
            if (size != 1.0f) {
                const FormulaInput factor = coefficient(frame.settings, plane, size);
                term = factor.symbol + " · " + name;
                formula.inputs.push_back(factor);
            }
            if (formula.expression.empty()) {
                formula.expression = (is_added ? "" : "−") + term;
            } else {
                formula.expression += (is_added ? " + " : " − ") + term;
            }
        }
    }
    if (formula.expression.empty()) formula.expression = "0";
    return checked(formula, from_words("the plane's function of x, y, z and w"));
}

std::optional<Formula> ClipReportBuilder::distance_before(ClipPlane plane,
                                                          std::string_view corner) const {
    const std::vector<CutCorner> corners = corners_before(history, planes_before(history, plane));
    const int i = index_of(corner, corners.size());
    if (i < 0) return std::nullopt;
    return distance(corners[static_cast<std::size_t>(i)], plane,
                    fmt::format("d.{}.{}", static_cast<int>(plane), i));
}

std::optional<Formula> ClipReportBuilder::cut(ClipPlane plane, std::string_view edge) const {
    const PlaneHistory* const work = work_of(history, plane);
    if (work == nullptr) return std::nullopt;
    const std::vector<ClipStep>& steps = work->steps;
    const int e = index_of(edge, steps.size());
    if (e < 0 || !steps[static_cast<std::size_t>(e)].is_cut) return std::nullopt;
    const ClipStep& step = steps[static_cast<std::size_t>(e)];
    const auto end = [&](bool is_inside) {
        const bool is_from = step.is_from_inside == is_inside;
        const float d = is_from ? step.d_from : step.d_to;
        return FormulaInput{is_inside ? "d_in" : "d_out",
                            {d},
                            from_formula(fmt::format("d.{}.{}", static_cast<int>(plane),
                                                     is_from ? step.from : step.to))};
    };
    Formula formula{fmt::format("t.{}.{}", static_cast<int>(plane), e),
                    "t",
                    "How far along the edge the cut is: 0 at the corner inside, 1 at the corner "
                    "outside.",
                    "d_in / (d_in − d_out)",
                    {end(true), end(false)},
                    {step.t}};
    return checked(formula, from_words("the function that cuts"));
}

std::optional<ClipReportBuilder::Origin> ClipReportBuilder::origin(int new_index) const {
    for (std::size_t p = 0; p < history.planes.size(); ++p) {
        const auto place = static_cast<int>(p);
        const std::vector<CutCorner> before = corners_before(history, place);
        for (const CutCorner& corner : corners_before(history, place + 1)) {
            if (!corner.is_new() || corner.new_index != new_index) continue;
            if (corner.plane != history.planes[p].plane) continue;
            const ClipStep& step =
                history.planes[p].steps[static_cast<std::size_t>(corner.plane_edge)];
            const CutCorner& from = before[static_cast<std::size_t>(step.from)];
            const CutCorner& to = before[static_cast<std::size_t>(step.to)];
            return step.is_from_inside ? Origin{step, from, to, corner}
                                       : Origin{step, to, from, corner};
        }
    }
    return std::nullopt;
}

std::optional<Formula> ClipReportBuilder::made(std::string_view number,
                                               const std::vector<std::string_view>& parts) const {
    const int new_index = index_of(number, 1000);
    const std::optional<Origin> from = new_index < 0 ? std::nullopt : origin(new_index);
    if (!from) return std::nullopt;
    const FormulaInput t{
        "t",
        {from->step.t},
        from_formula(fmt::format("t.{}.{}", static_cast<int>(from->step.plane), from->step.from))};
    const std::string help =
        fmt::format("Where the {} cuts the line from {} to {}.", plane_name(from->step.plane),
                    corner_name(from->inside), corner_name(from->outside));
    const Source other = from_words("the function that cuts");
    if (parts.size() == 1) {
        const int i = coordinate_of(parts[0]);
        if (i < 0) return std::nullopt;
        const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
        return checked({corner_formula_id(from->corner, i),
                        name,
                        help,
                        "a + t · (b − a)",
                        {input("a", from->inside, i), t, input("b", from->outside, i)},
                        {coordinate(from->corner.vertex, i)}},
                       other);
    }
    const int index = index_of(parts[0], varying_list.size());
    if (index < 0) return std::nullopt;
    const VaryingInfo& info = varying_list[static_cast<std::size_t>(index)];
    const int part = index_of(parts[1], static_cast<std::size_t>(info.count));
    if (part < 0) return std::nullopt;
    return checked(
        {fmt::format("new.{}.{}.{}", new_index, index, part),
         std::string(info.components[static_cast<std::size_t>(part)].name),
         help,
         "a + (b − a) · t",
         {varying("a", from->inside, index, part), varying("b", from->outside, index, part), t},
         {info.component(from->corner.vertex.varyings, part)}},
        other);
}

std::optional<Formula> ClipReportBuilder::pixel(std::string_view corner,
                                                std::string_view part) const {
    if (!frame.is_drawn(history.triangle) || (part != "column" && part != "row"))
        return std::nullopt;
    const std::vector<CutCorner> corners = corners_before(history);
    const PolygonCorners pixels = frame.triangle_vertices(history.triangle);
    const int i = index_of(corner, std::min(corners.size(), pixels.size()));
    if (i < 0) return std::nullopt;
    const ScreenVertex& pixel = pixels[static_cast<std::size_t>(i)];
    const bool is_column = part == "column";
    const std::string name = is_column ? "x" : "y";
    const std::string half = is_column ? "W/2" : "H/2";
    const Viewport& size = frame.settings.viewport;
    const std::string word(rounding_function(frame.settings.vertex_rounding));
    const bool is_sum = frame.settings.vertex_rounding == VertexRounding::truncate_sum;
    const CutCorner& c = corners[static_cast<std::size_t>(i)];
    const int middle = (is_column ? size.width : size.height) / 2;
    Formula formula{fmt::format("pixel.{}.{}", i, part),
                    std::string(part),
                    "Divided by w, rounded to a whole number and shifted by half the picture's "
                    "size.",
                    word + "(" + name + " · 1/w" + (is_sum ? " + " + half + ")" : ") + " + half),
                    {input(name, c, is_column ? 0 : 1),
                     {"1/w", {pixel.inv_w}, from_formula(corner_formula_id(c, 3))},
                     {half, {static_cast<float>(middle), true}, from_setting("viewport.size")}},
                    {static_cast<float>(is_column ? pixel.column : pixel.row), true}};
    if (frame.settings.image_axes == ImageAxes::uncentred) {
        formula.help = "Divided by w and rounded to a whole number; by mistake not moved to the "
                       "middle of the picture.";
        formula.expression = word + "(" + name + " · 1/w)";
        formula.inputs.pop_back();
    }
    return checked(formula, from_words("the viewport transform"));
}

} // namespace

std::string plane_name(ClipPlane plane) {
    return plane_name(static_cast<int>(plane));
}

std::string corner_formula_id(const CutCorner& corner, int coordinate) {
    const char* const name = clip_coordinate_names[static_cast<std::size_t>(coordinate)];
    if (corner.place == CornerPlace::changed)
        return fmt::format("changed.{}.{}", corner.vertex_index, name);
    if (corner.place == CornerPlace::handed_on)
        return fmt::format("left.{}.{}", corner.number, name);
    return corner.is_new() ? fmt::format("new.{}.{}", corner.new_index, name)
                           : fmt::format("corner.{}.{}", corner.vertex_index, name);
}

bool is_clip_formula(std::string_view id) {
    constexpr std::array<std::string_view, 9> first_parts{"corner", "changed", "left",  "code", "d",
                                                          "t",      "new",     "pixel", "cull"};
    return is_possible_id(id, {}, first_parts);
}

std::optional<Formula> clip_formula(const Frame& frame, const ClipHistory& history,
                                    std::string_view id) {
    const ClipReportBuilder builder{{frame, history}};
    const std::vector<std::string_view> parts = parts_of(id);
    const std::string_view kind = parts[0];
    const auto index = [&](std::size_t part, std::size_t end) {
        return part < parts.size() ? index_of(parts[part], end) : -1;
    };
    if (kind == "cull") {
        if (history.polygon.empty() || parts.size() < 2) return std::nullopt;
        const std::vector<CutCorner> corners = corners_before(history);
        if (parts[1] == "area" && parts.size() == 2) return cull_area_formula(builder);
        if (parts[1] == "area" && index(2, history.fan.size()) >= 0)
            return cull_area_formula(builder, index(2, history.fan.size()));
        if (parts[1] != "normal") return std::nullopt;
        if (parts.size() == 2) return cull_normal_formula(builder, corners.front());
        const int corner = index(2, corners.size());
        if (corner < 0) return std::nullopt;
        return cull_normal_formula(builder, corners[static_cast<std::size_t>(corner)],
                                   std::string(id));
    }
    if (parts.size() == 3 && kind == "corner") {
        const int vertex = index(1, triangle_corners), i = coordinate_of(parts[2]);
        if (vertex >= 0 && i >= 0) return builder.corner(vertex, i);
    }
    if (parts.size() == 3 && kind == "changed") {
        const int vertex = index(1, triangle_corners), i = coordinate_of(parts[2]);
        if (vertex >= 0 && i >= 0) return builder.moved(CornerPlace::changed, vertex, i);
    }
    if (parts.size() == 3 && kind == "left") {
        const int number = index(1, history.polygon.size()), i = coordinate_of(parts[2]);
        if (number >= 0 && i >= 0) return builder.moved(CornerPlace::handed_on, number, i);
    }
    if (parts.size() == 3 && kind == "code") {
        const int plane = index(1, history.codes.plane_count), vertex = index(2, triangle_corners);
        if (plane < 0 || vertex < 0) return std::nullopt;
        return builder.distance(given_corners(history)[static_cast<std::size_t>(vertex)],
                                static_cast<ClipPlane>(plane), std::string(id));
    }
    if (parts.size() == 3 && (kind == "d" || kind == "t")) {
        const int plane = index(1, clip_plane_count);
        if (plane < 0) return std::nullopt;
        return kind == "d" ? builder.distance_before(static_cast<ClipPlane>(plane), parts[2])
                           : builder.cut(static_cast<ClipPlane>(plane), parts[2]);
    }
    if (parts.size() == 3 && kind == "pixel") return builder.pixel(parts[1], parts[2]);
    if ((parts.size() == 3 || parts.size() == 4) && kind == "new")
        return builder.made(parts[1], {parts.begin() + 2, parts.end()});
    return std::nullopt;
}

} // namespace rasterwalk
