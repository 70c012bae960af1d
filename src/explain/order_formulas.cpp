#include "explain/order_formulas.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/formula_writer.h"

namespace rasterwalk {

namespace {

void add_depth(const Frame& frame, int triangle, FormulaWriter& write) {
    const VertexRules rules = vertex_rules(frame);
    const CornerDepths depths =
        corner_depths(*frame.scene, triangle, rules, camera_rotation(rules.camera), frame.stages);
    FormulaInputs inputs;
    for (int i = 0; i < triangle_corners; ++i) {
        inputs.push_back({fmt::format("z{}", i),
                          {depths[static_cast<std::size_t>(i)]},
                          from_vertex(triangle, i, "rotated.z")});
    }
    const bool is_mean = frame.stages.painter_depth == mean_depth;
    Formula& formula =
        write.add("depth", "depth",
                  is_mean ? "The mean depth of its corners, by which it was sorted."
                          : "The depth of its nearest corner, by which it was sorted by mistake.",
                  is_mean ? "(z0 + z1 + z2) / 3" : "min(min(z0, z1), z2)", std::move(inputs),
                  {frame.list->depths[static_cast<std::size_t>(triangle)]});
    formula.section = "order";
}

/// The camera's side of a node's plane.
void add_side(const Frame& frame, int node, FormulaWriter& write) {
    const BspNode& of = frame.list->divided->tree.nodes[static_cast<std::size_t>(node)];
    const SightRays rays = sight_rays(vertex_rules(frame));
    const glm::vec3 normal(of.plane.normal);
    const std::string plane =
        fmt::format("the plane of the scene's {}", triangle_name(of.triangle));
    FormulaInputs inputs;
    const auto along = [&](const char* symbol, const glm::vec3& value, const Source& source) {
        std::string sum;
        for (int i = 0; i < 3; ++i) {
            const std::string part = fmt::format("{}.{}", symbol, axis_name(i));
            sum += fmt::format("{}n.{} · {}", i == 0 ? "" : " + ", axis_name(i), part);
            inputs.push_back({part, {value[i]}, source});
        }
        return sum;
    };
    for (int i = 0; i < 3; ++i)
        inputs.push_back({"n." + axis_name(i), {normal[i]}, from_words(plane)});
    inputs.push_back({"d", {static_cast<float>(of.plane.offset)}, from_words(plane)});
    std::string expression = along("C", rays.camera, from_setting("camera.position")) + " − d";
    if (rays.mix > 0.0f) {
        inputs.push_back({"mix", {rays.mix}, from_setting("projection_mix")});
        expression =
            fmt::format("(1 − mix) · ({}) − mix · ({})", expression,
                        along("forward", rays.forward, from_words("the way the camera looks")));
    }
    Formula& formula = write.add(
        fmt::format("side.{}", node), "n · C − d",
        fmt::format("How far in front of {} the camera is. Above 0, what lies behind the plane {} "
                    "drawn first; below 0, what lies in front of it.",
                    plane, frame.stages.is_near_side == is_near_side ? "is" : "should be"),
        expression, std::move(inputs), {camera_side(of.plane, rays)});
    formula.section = "order";
    formula.label = fmt::format("plane of [{}]", of.triangle);
}

const BspNode& node_of(const Frame& frame, int node) {
    return frame.list->divided->tree.nodes[static_cast<std::size_t>(node)];
}

} // namespace

std::vector<OrderNode> order_nodes(const Frame& frame, int triangle) {
    std::vector<OrderNode> nodes;
    if (frame.list == nullptr || frame.list->divided == nullptr) return nodes;
    const SightRays rays = sight_rays(vertex_rules(frame));
    int below = frame.list->nodes[static_cast<std::size_t>(triangle)];
    for (int node = node_of(frame, below).parent; node >= 0; node = node_of(frame, node).parent) {
        const BspNode& at = node_of(frame, node);
        const bool is_front = at.front == below;
        const float side = camera_side(at.plane, rays);
        nodes.push_back({node, at.triangle, is_front, is_front == is_near_side(side),
                         is_front == frame.stages.is_near_side(side)});
        below = node;
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
}

std::vector<Formula> order_formulas(const Frame& frame, int triangle) {
    std::vector<Formula> formulas;
    if (frame.list == nullptr) return formulas;
    FormulaWriter write(formulas, "order.");
    if (frame.list->divided == nullptr) {
        add_depth(frame, triangle, write);
        return formulas;
    }
    for (const OrderNode& node : order_nodes(frame, triangle))
        add_side(frame, node.node, write);
    add_side(frame, frame.list->nodes[static_cast<std::size_t>(triangle)], write);
    return formulas;
}

bool is_order_formula(std::string_view id) {
    constexpr std::array<std::string_view, 1> first_parts{"order"};
    return is_possible_id(id, {}, first_parts);
}

} // namespace rasterwalk
