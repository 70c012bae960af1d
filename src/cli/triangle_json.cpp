#include "cli/triangle_json.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "cli/row_json.h"
#include "cli/spaces_report.h"
#include "inspect/coverage_comparison.h"
#include "inspect/shared_edge.h"
#include "pipeline/draw_cost.h"

namespace rasterwalk {

namespace {

Json to_json(const ShadedVertex& vertex) {
    Json object{{"fault", words(vertex.rejection).name},
                {"minus_camera", vector_to_json(vertex.in("minus_camera"))}};
    const bool has_pixel = vertex.rejection == Rejection::none;
    if (has_pixel) object["pixel"] = {vertex.pixel.column, vertex.pixel.row};
    if (is_projected(vertex)) {
        object["projected"] = {vertex.in("projected").x, vertex.in("projected").y};
    }
    object["rotated"] = vector_to_json(vertex.in("rotated"));
    object["world"] = vector_to_json(vertex.in("world"));
    if (has_pixel) object["depth"] = vertex.pixel.depth;
    if (has_pixel) object["zinv"] = vertex.pixel.inv_w;
    return object;
}

/// @param decides the line decides at each sample where it goes; Interpolate does not
Json to_json(const EdgeSample& step, bool decides) {
    Json object = Json::object();
    object["column"] = step.fragment.column;
    if (decides) object["decision"] = step.decision.before;
    object["row"] = step.fragment.row;
    object["sample"] = step.sample;
    if (decides) object["step"] = word_of(step.decision.step);
    object["wrote"] = write_name(step.write);
    object["x"] = step.x;
    object["y"] = step.y;
    return object;
}

Json to_json(const EdgeReport& edge, int number) {
    const bool decides =
        std::any_of(edge.samples.begin(), edge.samples.end(),
                    [](const EdgeSample& s) { return s.decision.step != PixelStep::none; });
    Json samples = Json::array();
    for (const EdgeSample& step : edge.samples)
        samples.push_back(to_json(step, decides));
    return {{"count", edge.count},
            {"edge", number},
            {"from", {edge.from.column, edge.from.row}},
            {"samples", std::move(samples)},
            {"to", {edge.to.column, edge.to.row}}};
}

Json to_json(const ClipVertex& corner) {
    const glm::vec4& p = corner.position_clip;
    return {p.x, p.y, p.z, p.w};
}

Json to_json(const ClipStep& step) {
    Json object;
    if (step.is_cut) object["cut"] = to_json(step.cut);
    object["distance_from"] = step.d_from;
    object["distance_to"] = step.d_to;
    object["from"] = step.from;
    object["kept"] = step.keeps_from;
    if (step.is_cut) object["t"] = step.t;
    object["to"] = step.to;
    return object;
}

Json clip_to_json(const ClipHistory& clip) {
    Json codes = Json::array(), corners = Json::array(), planes = Json::array();
    for (const Outcode code : clip.codes.of_corner)
        codes.push_back(code_text(code));
    for (const ClipVertex& corner : clip.polygon)
        corners.push_back(to_json(corner));
    for (const PlaneHistory& plane : clip.planes) {
        Json steps = Json::array();
        for (const ClipStep& step : plane.steps)
            steps.push_back(to_json(step));
        planes.push_back({{"plane", word_of(plane.plane)}, {"steps", std::move(steps)}});
    }
    return {{"corners", std::move(corners)},
            {"outcodes", std::move(codes)},
            {"planes", std::move(planes)},
            {"triangles", clip.fan.size()}};
}

/// Nothing if the triangle does not get as far as culling.
Json cull_to_json(const ClipHistory& clip) {
    if (!clip.is_cull_tested) return nullptr;
    return {{"culled", clip.cull.is_back},
            {"measure", clip.cull.measure},
            {"reason", clip.cull.reason},
            {"values", clip.cull.values}};
}

Json to_json(const CoverageComparison& comparison) {
    return {{"area", comparison.area},
            {"corners", comparison.corners},
            {"fan", comparison.fan},
            {"fan_area", comparison.fan_area},
            {"fan_laid", comparison.fan_writes},
            {"inside", comparison.inside},
            {"rows", comparison.rows},
            {"table", comparison.table},
            {"wrong_rows", comparison.wrong_rows}};
}

/// Nothing if the triangle shares no edge, or no fill rule is used.
Json shared_edges_to_json(const Frame& frame, int triangle) {
    Json edges = Json::array();
    for (const SharedEdge& shared : shared_edges(frame, triangle)) {
        Json rules = Json::array();
        for (const EdgeByRule& by_rule : count_by_rules(frame, shared))
            rules.push_back({{"holes", by_rule.holes},
                             {"rule", word_of(by_rule.rule)},
                             {"twice", by_rule.twice}});
        edges.push_back({{"edge", shared.edge},
                         {"neighbour", shared.neighbour},
                         {"neighbour_edge", shared.neighbour_edge},
                         {"rules", std::move(rules)}});
    }
    return edges;
}

Json cost_json(const DrawCost& cost) {
    Json counts = Json::object();
    for (const CostInfo& info : cost_list()) {
        if (info.is_of_triangle) counts[std::string(info.name)] = cost.*info.count;
    }
    return counts;
}

} // namespace

bool is_projected(const ShadedVertex& vertex) {
    return vertex.rejection == Rejection::none || vertex.rejection == Rejection::too_far_out;
}

bool has_spaces(const Frame& frame) {
    return frame.settings.transform == Transform::matrices &&
           frame.scene->space == SceneSpace::world;
}

Json to_json(const TriangleReport& report, const Frame& frame) {
    Json vertices = Json::array(), edges = Json::array();
    for (const ShadedVertex& vertex : report.vertices)
        vertices.push_back(to_json(vertex));
    if (report.rejection == Rejection::none) {
        for (std::size_t e = 0; e < report.edges.size(); ++e)
            edges.push_back(to_json(report.edges[e], static_cast<int>(e)));
    }
    Json object = Json::object();
    object["clip"] = clip_to_json(report.clip);
    if (has_spaces(frame)) object["conventions"] = conventions_json(frame, report.triangle);
    object["cost"] = cost_json(triangle_cost(frame, report.triangle));
    object["cull"] = cull_to_json(report.clip);
    object["edges"] = std::move(edges);
    object["left_out"] = words(report.rejection).name;
    object["name"] = part_name(*frame.scene, report.triangle);
    object["outside"] = outside_json(report.rows);
    if (const auto comparison = coverage_comparison(frame, report.triangle))
        object["polygon"] = to_json(*comparison);
    object["rows"] = rows_json(report.rows);
    if (Json shared = shared_edges_to_json(frame, report.triangle); !shared.empty())
        object["shared_edges"] = std::move(shared);
    if (has_spaces(frame)) object["spaces"] = spaces_json(frame, report.triangle);
    if (!frame.scene->sources.empty())
        object["scene_triangle"] = scene_triangle(*frame.scene, report.triangle);
    object["triangle"] = report.triangle;
    object["vertices"] = std::move(vertices);
    return object;
}

} // namespace rasterwalk
