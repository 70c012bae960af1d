#include "explain/clip_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/light_formulas.h"
#include "explain/vertex_report.h"

namespace rasterwalk {

namespace {

constexpr std::array<const char*, 4> clip_coordinate_names{"x", "y", "z", "w"};

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

/// A part as a number from 0 to before `end`; -1 for anything else.
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

float coordinate(const ClipVertex& vertex, int i) {
    return vertex.position_clip[i];
}

/// What makes formulas of one triangle.
struct Maker {
    const Frame& frame;
    const ClipHistory& history;

    VertexRules rules() const { return vertex_rules(frame.settings, frame.scene->space); }
    SightRays rays() const { return sight_rays(rules()); }

    /// The formula, or where other functions stand in the slots the bare number.
    Formula checked(Formula formula, const Source& source) const {
        const float value = evaluate(formula);
        const bool is_same = value == formula.result.value ||
                             (std::isnan(value) && std::isnan(formula.result.value));
        if (is_same) return formula;
        formula.expression = "v";
        formula.inputs = {{"v", formula.result, source}};
        return formula;
    }

    FormulaInput input(std::string symbol, const CutCorner& corner, int i) const {
        return {std::move(symbol),
                {coordinate(corner.vertex, i)},
                from_formula(corner_formula_id(corner, i))};
    }

    /// A component of a corner's varying.
    FormulaInput varying(std::string symbol, const CutCorner& corner, int index, int part) const {
        const VaryingInfo& info = varying_list[static_cast<std::size_t>(index)];
        const Number number{info.component(corner.vertex.varyings, part)};
        if (corner.is_new()) {
            return {std::move(symbol), number,
                    from_formula(fmt::format("new.{}.{}.{}", corner.new_index, index, part))};
        }
        // Named as in the Vertices tab.
        std::string id;
        const auto axis = static_cast<std::size_t>(part);
        if (info.name == "position_world") id = std::string("world.") + axis_names[axis];
        if (info.name == "normal") id = std::string("normal.") + axis_names[axis];
        if (info.name == "colour") id = std::string("reflectance.") + channel_names[axis];
        if (info.name == "illumination") id = std::string("light.R.") + channel_names[axis];
        return {std::move(symbol), number,
                id.empty() ? from_words("given by the scene")
                           : from_vertex(history.triangle, corner.vertex_index, id)};
    }

    std::optional<Formula> corner(int vertex, int i) const;
    std::optional<Formula> changed(int vertex, int i) const;
    std::optional<Formula> handed_on(int number, int i) const;
    Formula distance(const CutCorner& corner, ClipPlane plane, std::string id) const;
    std::optional<Formula> distance_before(ClipPlane plane, std::string_view corner) const;
    std::optional<Formula> cut(ClipPlane plane, std::string_view edge) const;
    std::optional<Formula> made(std::string_view number,
                                const std::vector<std::string_view>& parts) const;
    std::optional<Formula> pixel(std::string_view corner, std::string_view part) const;
    Formula away(const CutCorner& corner, std::string id) const;
    Formula away_as_one(CutCorner first) const;
    Formula area_of(int triangle) const;
    Formula area() const;

    /// Where a new corner comes from.
    struct Origin {
        const ClipStep& step;
        CutCorner inside, outside, corner;
    };
    std::optional<Origin> origin(int new_index) const;
};

std::optional<Formula> Maker::corner(int vertex, int i) const {
    const ClipVertex& v = history.corners[static_cast<std::size_t>(vertex)];
    const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
    const std::string camera = i == 3 ? "rotated.z" : "rotated." + name;
    const Source source = from_vertex(history.triangle, vertex, camera);
    Formula formula{
        fmt::format("corner.{}.{}", vertex, name), name, "", "", {}, {coordinate(v, i)}};
    const auto camera_place = [&] {
        const VertexReport report = vertex_report(frame, history.triangle, vertex);
        return report.shaded.in("rotated");
    };
    if (i < 2) {
        formula.help = "Clip space before the division: pixels from the middle, times w.";
        formula.expression = "f · " + name;
        formula.inputs = {
            {"f", {frame.settings.camera.focal_length}, from_setting("camera.focal_length")},
            {name, {camera_place()[i]}, source}};
        if (frame.settings.image_axes == ImageAxes::mirrored) formula.expression.insert(0, "−");
        return checked(formula, source);
    }
    formula.help = i == 2 ? "What the depth, " + std::string(depth_words(frame).name) +
                                ", is made of: it is divided by w too."
                          : "What x, y and z are divided by: how far in front of the camera.";
    const float usual = i == 2 ? 1.0f : camera_place().z;
    if (frame.settings.projection_mix == 0.0f && formula.result.value == usual) {
        formula.expression = i == 2 ? "1" : "z_camera";
        if (i == 3) formula.inputs = {{"z_camera", formula.result, source}};
        return formula;
    }
    formula.expression = "v";
    formula.inputs = {{"v", formula.result, from_words("as the projection makes it")}};
    return formula;
}

/// A corner that was divided before the planes saw it.
std::optional<Formula> Maker::changed(int vertex, int i) const {
    const auto at = static_cast<std::size_t>(vertex);
    const CutCorner given = given_corners(history)[at], corner = corners_before(history, 0)[at];
    if (corner.place != CornerPlace::changed) return std::nullopt;
    const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
    Formula formula{corner_formula_id(corner, i),
                    name,
                    "Divided by w before the planes cut, which is a mistake.",
                    i < 2    ? name + " · (1 / w)"
                    : i == 2 ? "1 / w"
                             : "1",
                    {},
                    {coordinate(corner.vertex, i)}};
    if (i < 2) formula.inputs.push_back(input(name, given, i));
    if (i < 3) formula.inputs.push_back(input("w", given, 3));
    return checked(formula, from_words("the function that cuts"));
}

/// A corner that was multiplied again behind the planes.
std::optional<Formula> Maker::handed_on(int number, int i) const {
    const auto at = static_cast<std::size_t>(number);
    const CutCorner corner = corners_before(history)[at];
    if (corner.place != CornerPlace::handed_on) return std::nullopt;
    const CutCorner before = corners_before(history, static_cast<int>(history.planes.size()))[at];
    const std::string name = clip_coordinate_names[static_cast<std::size_t>(i)];
    Formula formula{corner_formula_id(corner, i),
                    name,
                    "Multiplied by w again behind the planes, so that it can be divided.",
                    i < 2    ? name + " · (1 / z)"
                    : i == 2 ? "1"
                             : "1 / z",
                    {},
                    {coordinate(corner.vertex, i)}};
    if (i < 2) formula.inputs.push_back(input(name, before, i));
    if (i != 2) formula.inputs.push_back(input("z", before, 2));
    return checked(formula, from_words("the function that cuts"));
}

/// A coefficient of a plane under a name, and where it comes from.
FormulaInput coefficient(const Settings& settings, ClipPlane plane, float size) {
    const bool is_near = plane == ClipPlane::near, is_far = plane == ClipPlane::far;
    if (is_near && size == settings.near) return {"near", {size}, from_setting("near")};
    if (is_far && size == settings.far) return {"far", {size}, from_setting("far")};
    if (is_near || is_far)
        return {"k", {size}, from_words("the plane, as the projection has its depth")};
    const bool is_across = plane == ClipPlane::left || plane == ClipPlane::right;
    const int side = is_across ? settings.viewport.width : settings.viewport.height;
    const int whole_half = side / 2;
    const auto half = static_cast<float>(whole_half);
    if (size != half && size != static_cast<float>(side) - half)
        return {"g", {size}, from_words("the guard band: pixels from the picture's middle")};
    return {is_across ? "W/2" : "H/2", {size}, from_setting("viewport.size")};
}

Formula Maker::distance(const CutCorner& corner, ClipPlane plane, std::string id) const {
    const glm::vec4& c = history.codes.planes[static_cast<std::size_t>(plane)];
    Formula formula{std::move(id),
                    "d",
                    "How far inside of the " + plane_name(plane) +
                        " the corner lies; less than 0 is outside.",
                    "",
                    {},
                    {inner_distance(c, corner.vertex)}};
    // What is added comes first.
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

std::optional<Formula> Maker::distance_before(ClipPlane plane, std::string_view corner) const {
    const std::vector<CutCorner> corners = corners_before(history, planes_before(history, plane));
    const int i = index_of(corner, corners.size());
    if (i < 0) return std::nullopt;
    return distance(corners[static_cast<std::size_t>(i)], plane,
                    fmt::format("d.{}.{}", static_cast<int>(plane), i));
}

std::optional<Formula> Maker::cut(ClipPlane plane, std::string_view edge) const {
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
                    "How far along the edge the cut lies: 0 at the corner inside, 1 at the one "
                    "outside.",
                    "d_in / (d_in − d_out)",
                    {end(true), end(false)},
                    {step.t}};
    return checked(formula, from_words("the function that cuts"));
}

std::optional<Maker::Origin> Maker::origin(int new_index) const {
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

std::optional<Formula> Maker::made(std::string_view number,
                                   const std::vector<std::string_view>& parts) const {
    const int new_index = index_of(number, 1000);
    const std::optional<Origin> from = new_index < 0 ? std::nullopt : origin(new_index);
    if (!from) return std::nullopt;
    const FormulaInput t{
        "t",
        {from->step.t},
        from_formula(fmt::format("t.{}.{}", static_cast<int>(from->step.plane), from->step.from))};
    const std::string help =
        fmt::format("Where the {} cuts the way from {} to {}.", plane_name(from->step.plane),
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

std::optional<Formula> Maker::pixel(std::string_view corner, std::string_view part) const {
    if (!frame.is_drawn(history.triangle) || (part != "column" && part != "row"))
        return std::nullopt;
    const std::vector<CutCorner> corners = corners_before(history);
    const std::span<const ScreenVertex> pixels = frame.triangle_vertices(history.triangle);
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
                    "Divided by w, made a whole number and moved to the middle of the picture.",
                    word + "(" + name + " · 1/w" + (is_sum ? " + " + half + ")" : ") + " + half),
                    {input(name, c, is_column ? 0 : 1),
                     {"1/w", {pixel.inv_w}, from_formula(corner_formula_id(c, 3))},
                     {half, {static_cast<float>(middle), true}, from_setting("viewport.size")}},
                    {static_cast<float>(is_column ? pixel.column : pixel.row), true}};
    return checked(formula, from_words("the viewport transform"));
}

Formula Maker::away(const CutCorner& corner, std::string id) const {
    const SightRays sight = rays();
    const bool has_way = sight.mix<1.0f, has_forward = sight.mix> 0.0f;
    Formula formula{std::move(id),
                    std::string(sight_name(frame)),
                    "Greater than 0: the normal n points ",
                    "",
                    {},
                    {away_from_camera(corner.vertex.varyings, sight)}};
    formula.help += !has_forward ? "the way from the camera C to the corner p"
                    : !has_way   ? "the way all rays run, forward"
                                 : "the way between that from the camera C to the corner p and "
                                   "forward";
    formula.help += ", so one sees the back.";
    const int place = varying_index(&Varyings::position_world);
    const int normal = varying_index(&Varyings::normal);
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[static_cast<std::size_t>(i)];
        const std::string way = "(p." + axis + " − C." + axis + ")", forward = "forward." + axis;
        formula.expression += (i == 0 ? "n." : " + n.") + axis + " · ";
        formula.expression += !has_forward ? way
                              : !has_way   ? forward
                                         : "((1 − mix) · " + way + " + mix · " + forward + ")";
        formula.inputs.push_back(varying("n." + axis, corner, normal, i));
        if (has_way) {
            formula.inputs.push_back(varying("p." + axis, corner, place, i));
            formula.inputs.push_back(
                {"C." + axis, {sight.camera[i]}, from_setting("camera.position")});
        }
        if (has_forward) {
            formula.inputs.push_back({forward,
                                      {sight.forward[i]},
                                      from_vertex(history.triangle, 0, fmt::format("R.{}.2", i))});
        }
    }
    if (has_way && has_forward)
        formula.inputs.push_back({"mix", {sight.mix}, from_setting("projection_mix")});
    return checked(formula, from_words("the function that culls"));
}

/// The same for the polygon as one face, whose normal may be none of its corners'.
Formula Maker::away_as_one(CutCorner first) const {
    const glm::vec3 own = first.vertex.varyings.normal;
    first.vertex.varyings = as_one_face(history.polygon);
    Formula formula = away(first, "cull.normal");
    if (first.vertex.varyings.normal == own) return formula;
    for (FormulaInput& input : formula.inputs) {
        if (input.symbol.starts_with("n."))
            input.source = from_words("across the places of the corners, whose normals differ");
    }
    return formula;
}

Formula Maker::area_of(int triangle) const {
    const std::vector<CutCorner> corners = corners_before(history);
    const std::array<int, 3>& fan = history.fan[static_cast<std::size_t>(triangle)];
    std::array<ClipVertex, 3> places;
    Formula formula{
        fmt::format("cull.area.{}", triangle),
        fmt::format("A{}", triangle),
        "Twice the area on the screen of a triangle of the fan, times the w of its "
        "corners: less than 0 where they go round counterclockwise.",
        "x0 · (y1 · w2 − y2 · w1) + y0 · (w1 · x2 − w2 · x1) + w0 · (x1 · y2 − x2 · y1)",
        {},
        {}};
    for (std::size_t k = 0; k < fan.size(); ++k) {
        const CutCorner& corner = corners[static_cast<std::size_t>(fan[k])];
        places[k] = corner.vertex;
        for (const int i : {0, 1, 3}) {
            formula.inputs.push_back(input(
                clip_coordinate_names[static_cast<std::size_t>(i)] + std::to_string(k), corner, i));
        }
    }
    formula.result.value = screen_area_sign(places, rules());
    return checked(formula, from_words("the function that culls"));
}

Formula Maker::area() const {
    Formula formula{"cull.area",
                    "area",
                    "Greater than 0: on the screen the corners go round clockwise, as those of a "
                    "front do.",
                    "",
                    {},
                    {screen_area_sign(history.polygon, rules())}};
    if (history.fan.size() == 1) {
        const Formula only = area_of(0);
        formula.expression = only.expression;
        formula.inputs = only.inputs;
        return formula;
    }
    for (std::size_t i = 0; i < history.fan.size(); ++i) {
        const Formula part = area_of(static_cast<int>(i));
        formula.expression += (i == 0 ? "" : " + ") + part.name;
        formula.inputs.push_back({part.name, part.result, from_formula(part.id)});
    }
    return checked(formula, from_words("the function that culls"));
}

} // namespace

std::string_view sight_name(const Frame& frame) {
    const float mix = vertex_rules(frame.settings, frame.scene->space).projection.mix;
    if (mix == 0.0f) return "n · (p − C)";
    return mix == 1.0f ? "n · forward" : "n · ((1 − mix) (p − C) + mix forward)";
}

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

std::optional<Formula> clip_formula(const Frame& frame, const ClipHistory& history,
                                    std::string_view id) {
    const Maker maker{frame, history};
    const std::vector<std::string_view> parts = parts_of(id);
    const std::string_view kind = parts[0];
    const auto index = [&](std::size_t part, std::size_t end) {
        return part < parts.size() ? index_of(parts[part], end) : -1;
    };
    if (kind == "cull") {
        if (history.polygon.empty() || parts.size() < 2) return std::nullopt;
        const std::vector<CutCorner> corners = corners_before(history);
        if (parts[1] == "area" && parts.size() == 2) return maker.area();
        if (parts[1] == "area" && index(2, history.fan.size()) >= 0)
            return maker.area_of(index(2, history.fan.size()));
        if (parts[1] != "normal") return std::nullopt;
        if (parts.size() == 2) return maker.away_as_one(corners.front());
        const int corner = index(2, corners.size());
        if (corner < 0) return std::nullopt;
        return maker.away(corners[static_cast<std::size_t>(corner)], std::string(id));
    }
    if (parts.size() == 3 && kind == "corner") {
        const int vertex = index(1, triangle_corners), i = coordinate_of(parts[2]);
        if (vertex >= 0 && i >= 0) return maker.corner(vertex, i);
    }
    if (parts.size() == 3 && kind == "changed") {
        const int vertex = index(1, triangle_corners), i = coordinate_of(parts[2]);
        if (vertex >= 0 && i >= 0) return maker.changed(vertex, i);
    }
    if (parts.size() == 3 && kind == "left") {
        const int number = index(1, history.polygon.size()), i = coordinate_of(parts[2]);
        if (number >= 0 && i >= 0) return maker.handed_on(number, i);
    }
    if (parts.size() == 3 && kind == "code") {
        const int plane = index(1, history.codes.plane_count), vertex = index(2, triangle_corners);
        if (plane < 0 || vertex < 0) return std::nullopt;
        return maker.distance(given_corners(history)[static_cast<std::size_t>(vertex)],
                              static_cast<ClipPlane>(plane), std::string(id));
    }
    if (parts.size() == 3 && (kind == "d" || kind == "t")) {
        const int plane = index(1, clip_plane_count);
        if (plane < 0) return std::nullopt;
        return kind == "d" ? maker.distance_before(static_cast<ClipPlane>(plane), parts[2])
                           : maker.cut(static_cast<ClipPlane>(plane), parts[2]);
    }
    if (parts.size() == 3 && kind == "pixel") return maker.pixel(parts[1], parts[2]);
    if ((parts.size() == 3 || parts.size() == 4) && kind == "new")
        return maker.made(parts[1], {parts.begin() + 2, parts.end()});
    return std::nullopt;
}

std::vector<CullAnswer> cull_answers(const Frame& frame, const ClipHistory& history) {
    if (history.polygon.empty()) return {};
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const std::vector<ClipVertex>& polygon = history.polygon;
    const auto is_back = [](Rejection rejection) { return rejection != Rejection::none; };
    const SightRays rays = sight_rays(rules);
    const auto away = [&](std::size_t i) { return away_from_camera(polygon[i].varyings, rays); };
    CullAnswer normal{Cull::face_normal, is_back(cull_by_face_normal(polygon, rules, rays)),
                      away_from_camera(as_one_face(polygon), rays), "cull.normal"};
    CullAnswer area{Cull::screen_area, is_back(cull_by_screen_area(polygon, rules, rays)),
                    screen_area_sign(polygon, rules), "cull.area"};
    area.is_open = !std::all_of(polygon.begin(), polygon.end(),
                                [](const ClipVertex& v) { return v.position_clip.w > 0.0f; });
    std::size_t least = 0, most = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i) {
        least = away(i) < away(least) ? i : least;
        most = away(i) > away(most) ? i : most;
    }
    const std::string least_formula = "cull.normal." + std::to_string(least);
    const CullAnswer normals{Cull::vertex_normals,
                             is_back(cull_by_vertex_normals(polygon, rules, rays)), away(least),
                             least_formula};
    CullAnswer fragments{Cull::fragment_normal, away(least) > 0.0f, away(least), least_formula};
    fragments.is_in_parts = !fragments.is_back && away(most) > 0.0f;
    return {normal, area, normals, fragments};
}

} // namespace rasterwalk
