#include "explain/cull_formulas.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "explain/light_formulas.h"

namespace rasterwalk {

std::string_view sight_name(const Frame& frame) {
    const float mix = vertex_rules(frame.settings, frame.scene->space).projection.mix;
    if (mix == 0.0f) return "n · (p − C)";
    return mix == 1.0f ? "n · forward" : "n · ((1 − mix) (p − C) + mix forward)";
}

Formula cull_normal_formula(const ClipFormulaBuilder& builder, const CutCorner& corner,
                            std::string id) {
    const SightRays sight = builder.rays();
    const bool has_sight = sight.mix<1.0f, has_forward = sight.mix> 0.0f;
    Formula formula{std::move(id),
                    std::string(sight_name(builder.frame)),
                    "If it is greater than 0, the normal n points ",
                    "",
                    {},
                    {away_from_camera(corner.vertex.varyings, sight)}};
    formula.help += !has_forward ? "the same way as the ray from the camera C to the corner p"
                    : !has_sight ? "the same way as all rays, forward"
                                 : "the same way as the mix of forward and the ray from the camera "
                                   "C to the corner p";
    formula.help += ", so you see the back.";
    const int place = varying_index(&Varyings::position_world);
    const int normal = varying_index(&Varyings::normal);
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[static_cast<std::size_t>(i)];
        const std::string offset = "(p." + axis + " − C." + axis + ")", forward = "forward." + axis;
        formula.expression += (i == 0 ? "n." : " + n.") + axis + " · ";
        formula.expression += !has_forward ? offset
                              : !has_sight ? forward
                                           : "((1 − mix) · " + offset + " + mix · " + forward + ")";
        formula.inputs.push_back(builder.varying("n." + axis, corner, normal, i));
        if (has_sight) {
            formula.inputs.push_back(builder.varying("p." + axis, corner, place, i));
            formula.inputs.push_back(
                {"C." + axis, {sight.camera[i]}, from_setting("camera.position")});
        }
        if (has_forward) {
            formula.inputs.push_back(
                {forward,
                 {sight.forward[i]},
                 from_vertex(builder.history.triangle, 0, fmt::format("R.{}.2", i))});
        }
    }
    if (has_sight && has_forward)
        formula.inputs.push_back({"mix", {sight.mix}, from_setting("projection_mix")});
    return builder.checked(formula, from_words("the function that culls"));
}

Formula cull_normal_formula(const ClipFormulaBuilder& builder, CutCorner first) {
    const glm::vec3 own = first.vertex.varyings.normal;
    first.vertex.varyings = as_one_face(builder.history.polygon);
    Formula formula = cull_normal_formula(builder, first, "cull.normal");
    if (first.vertex.varyings.normal == own) return formula;
    for (FormulaInput& input : formula.inputs) {
        if (input.symbol.starts_with("n."))
            input.source = from_words("perpendicular to the plane of the corners, because their "
                                      "normals differ");
    }
    return formula;
}

Formula cull_area_formula(const ClipFormulaBuilder& builder, int triangle) {
    const ClipHistory& history = builder.history;
    const std::vector<CutCorner> corners = corners_before(history);
    const std::array<int, 3>& fan = history.fan[static_cast<std::size_t>(triangle)];
    std::array<ClipVertex, 3> places;
    Formula formula{
        fmt::format("cull.area.{}", triangle),
        fmt::format("A{}", triangle),
        "Twice the area on the screen of a triangle of the fan, times the w of each of its "
        "corners; below 0 if they go round counterclockwise.",
        "x0 · (y1 · w2 − y2 · w1) + y0 · (w1 · x2 − w2 · x1) + w0 · (x1 · y2 − x2 · y1)",
        {},
        {}};
    for (std::size_t k = 0; k < fan.size(); ++k) {
        const CutCorner& corner = corners[static_cast<std::size_t>(fan[k])];
        places[k] = corner.vertex;
        for (const int i : {0, 1, 3}) {
            formula.inputs.push_back(builder.input(
                clip_coordinate_names[static_cast<std::size_t>(i)] + std::to_string(k), corner, i));
        }
    }
    formula.result.value = screen_area_sign(places, builder.rules());
    return builder.checked(formula, from_words("the function that culls"));
}

Formula cull_area_formula(const ClipFormulaBuilder& builder) {
    const ClipHistory& history = builder.history;
    Formula formula{"cull.area",
                    "area",
                    "If it is greater than 0, the corners go round clockwise on the screen, as "
                    "those of a front face do.",
                    "",
                    {},
                    {screen_area_sign(history.polygon, builder.rules())}};
    if (history.fan.size() == 1) {
        const Formula only = cull_area_formula(builder, 0);
        formula.expression = only.expression;
        formula.inputs = only.inputs;
        return formula;
    }
    for (std::size_t i = 0; i < history.fan.size(); ++i) {
        const Formula part = cull_area_formula(builder, static_cast<int>(i));
        formula.expression += (i == 0 ? "" : " + ") + part.name;
        formula.inputs.push_back({part.name, part.result, from_formula(part.id)});
    }
    return builder.checked(formula, from_words("the function that culls"));
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
