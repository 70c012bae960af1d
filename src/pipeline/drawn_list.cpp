#include "pipeline/drawn_list.h"

#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// The scene with other triangles, given by their sources.
Scene scene_of(const Scene& scene, std::vector<TriangleSource> sources, Mesh mesh) {
    Scene made;
    made.name = scene.name;
    made.path = scene.path;
    made.space = scene.space;
    made.mesh = std::move(mesh);
    made.sources = std::move(sources);
    made.parts = scene.parts;
    made.textures = scene.textures;
    made.applied_texture = scene.applied_texture;
    made.camera = scene.camera;
    made.light = scene.light;
    made.viewport = scene.viewport;
    made.stage = scene.stage;
    made.model_report = scene.model_report;
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
    Mesh mesh;
    for (const Vertex& vertex : scene.mesh.vertices())
        mesh.add_vertex(vertex);
    std::vector<TriangleSource> sources;
    for (const int triangle : order.triangles) {
        mesh.add_triangle(scene.mesh.triangles()[static_cast<std::size_t>(triangle)]);
        sources.push_back({triangle});
        list.depths.push_back(order.depths[static_cast<std::size_t>(triangle)]);
    }
    list.scene = scene_of(scene, std::move(sources), std::move(mesh));
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

void divide(const Scene& scene, const VertexRules& rules, const Stages& stages,
            const DrawnList* before, DrawnList& list) {
    const bool is_known =
        before != nullptr && before->divided != nullptr && before->divided->given == scene.mesh;
    list.divided = is_known ? before->divided
                            : std::make_shared<const DividedMesh>(
                                  DividedMesh{scene.mesh, make_bsp_tree(scene.mesh)});
    const BspTree& tree = list.divided->tree;
    const BspWalk walk = walk_bsp_tree(tree, sight_rays(rules), stages);
    list.comparisons = walk.comparisons;
    Mesh mesh;
    for (const Vertex& vertex : scene.mesh.vertices())
        mesh.add_vertex(vertex);
    VertexJoin cuts(mesh);
    std::vector<TriangleSource> sources;
    for (const BspStep& step : walk.steps) {
        const BspPiece& piece = tree.pieces[static_cast<std::size_t>(step.piece)];
        const std::array<Vertex, triangle_corners> given = corners_of(scene, piece.triangle);
        TriangleIndices indices = scene.mesh.triangles()[static_cast<std::size_t>(piece.triangle)];
        TriangleSource source{piece.triangle, piece.is_cut};
        if (piece.is_cut) {
            for (std::size_t i = 0; i < indices.size(); ++i) {
                indices[i] = cuts.index_of(vertex_of(given, piece.corners[i]));
                source.weights[i] = glm::vec3(piece.corners[i].weights);
            }
        }
        mesh.add_triangle(indices);
        sources.push_back(source);
        list.nodes.push_back(step.node);
    }
    list.scene = scene_of(scene, std::move(sources), std::move(mesh));
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
                                                 const Stages& stages, const DrawnList* before) {
    const Hidden hidden = hidden_rule(settings);
    if (hidden == Hidden::depth_buffer || scene.space == SceneSpace::pixels) return nullptr;
    if (scene.triangle_count() > most_sorted_triangles) return nullptr;
    const VertexRules rules = vertex_rules(settings, scene.space);
    DrawnList list;
    list.made_by = hidden;
    if (hidden == Hidden::painter)
        paint(scene, rules, stages, list);
    else
        divide(scene, rules, stages, before, list);
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
