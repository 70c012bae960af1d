#include "pipeline/drawn_list.h"

#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// The scene with other triangles, given by their sources.
Scene scene_of(const Scene& scene, std::vector<TriangleSource> sources, Mesh mesh) {
    Scene made = scene;
    made.mesh = std::move(mesh);
    made.sources = std::move(sources);
    return made;
}

/// The same vertices, and these triangles of the mesh in this order.
Mesh in_order(const Mesh& mesh, const std::vector<int>& triangles) {
    Mesh made;
    for (const Vertex& vertex : mesh.vertices())
        made.add_vertex(vertex);
    for (const int triangle : triangles)
        made.add_triangle(mesh.triangles()[static_cast<std::size_t>(triangle)]);
    return made;
}

void paint(const Scene& scene, const VertexRules& rules, const Stages& stages, DrawnList& list) {
    const glm::mat3 rotation = camera_rotation(rules.camera);
    std::vector<CornerDepths> triangles;
    triangles.reserve(scene.mesh.triangles().size());
    for (int t = 0; t < scene.triangle_count(); ++t)
        triangles.push_back(corner_depths(scene, t, rules, rotation, stages));
    const PaintersOrder order = painters_order(triangles, stages);
    list.comparisons = order.comparisons;
    std::vector<TriangleSource> sources;
    for (const int triangle : order.triangles) {
        sources.push_back({triangle});
        list.depths.push_back(order.depths[static_cast<std::size_t>(triangle)]);
    }
    list.scene = scene_of(scene, std::move(sources), in_order(scene.mesh, order.triangles));
}

/// A corner of a piece: everything is mixed by its weights. What the corners have in common keeps
/// its bits.
Vertex vertex_of(const std::array<Vertex, triangle_corners>& corners, const BspCorner& at) {
    const glm::vec3 weights(at.weights);
    const auto mix = [&](auto member) {
        const auto &a = corners[0].*member, &b = corners[1].*member, &c = corners[2].*member;
        return a == b && b == c ? a : weights.x * a + weights.y * b + weights.z * c;
    };
    Vertex vertex = corners[0];
    vertex.position = glm::vec3(at.place);
    vertex.reflectance = mix(&Vertex::reflectance);
    vertex.texcoord = mix(&Vertex::texcoord);
    const glm::vec3 normal = mix(&Vertex::normal);
    const float length = glm::length(normal);
    const bool is_new = !(normal == corners[0].normal) && length > 0.0f;
    vertex.normal = is_new ? normal / length : normal;
    return vertex;
}

DividedMesh divide(const Mesh& mesh) {
    DividedMesh divided{mesh, make_bsp_tree(mesh), {}, {}};
    for (const Vertex& vertex : mesh.vertices())
        divided.pieces.add_vertex(vertex);
    VertexJoin cuts(divided.pieces);
    for (const BspPiece& piece : divided.tree.pieces) {
        const int t = piece.triangle;
        TriangleIndices indices = mesh.triangles()[static_cast<std::size_t>(t)];
        TriangleSource source{t, piece.is_cut};
        const std::array<Vertex, triangle_corners> given{mesh.corner(t, 0), mesh.corner(t, 1),
                                                         mesh.corner(t, 2)};
        for (std::size_t i = 0; piece.is_cut && i < indices.size(); ++i) {
            indices[i] = cuts.index_of(vertex_of(given, piece.corners[i]));
            source.weights[i] = glm::vec3(piece.corners[i].weights);
        }
        divided.pieces.add_triangle(indices);
        divided.sources.push_back(source);
    }
    return divided;
}

void walk(const Scene& scene, const VertexRules& rules, const Stages& stages, DrawnList& list) {
    const DividedMesh& divided = *list.divided;
    const BspWalk walk = walk_bsp_tree(divided.tree, sight_rays(rules), stages);
    list.comparisons = walk.comparisons;
    std::vector<int> order;
    for (const BspStep& step : walk.steps) {
        order.push_back(step.piece);
        list.nodes.push_back(step.node);
    }
    std::vector<TriangleSource> sources;
    for (const int piece : order)
        sources.push_back(divided.sources[static_cast<std::size_t>(piece)]);
    list.scene = scene_of(scene, std::move(sources), in_order(divided.pieces, order));
}

} // namespace

CornerDepths corner_depths(const Scene& scene, int triangle, const VertexRules& rules,
                           const glm::mat3& rotation, const Stages& stages) {
    CornerDepths depths{};
    for (int i = 0; i < triangle_corners; ++i) {
        const glm::vec3& place = scene.corner(triangle, i).position;
        depths[static_cast<std::size_t>(i)] =
            stages.to_camera_space(place, rules.camera, rotation, stages).rotated.z;
    }
    return depths;
}

std::shared_ptr<const DrawnList> make_drawn_list(const Scene& scene, const Settings& settings,
                                                 const Stages& stages,
                                                 std::shared_ptr<const DividedMesh>& divided) {
    const Hidden hidden = hidden_rule(settings);
    const bool is_sorted =
        hidden == Hidden::painter || draw_order_rule(settings) != DrawOrder::scene;
    if ((!is_sorted && hidden != Hidden::bsp) || scene.space == SceneSpace::pixels) return nullptr;
    if (scene.triangle_count() > most_sorted_triangles) return nullptr;
    const VertexRules rules = vertex_rules(settings, scene.space);
    DrawnList list;
    list.made_by = hidden;
    if (is_sorted) {
        paint(scene, rules, stages, list);
    } else {
        if (divided == nullptr || !(divided->given == scene.mesh))
            divided = std::make_shared<const DividedMesh>(divide(scene.mesh));
        list.divided = divided;
        walk(scene, rules, stages, list);
    }
    if (list.scene.triangle_count() == 0) return nullptr;
    return std::make_shared<const DrawnList>(std::move(list));
}

std::optional<int> first_drawn(const Scene& drawn, int scene_triangle) {
    if (drawn.sources.empty()) return scene_triangle;
    for (std::size_t t = 0; t < drawn.sources.size(); ++t) {
        if (drawn.sources[t].triangle == scene_triangle) return static_cast<int>(t);
    }
    return std::nullopt;
}

} // namespace rasterwalk
