#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "base/limits.h"
#include "mistakes/hidden.h"
#include "stages/bsp.h"
#include "stages/stage_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace tree {

Mesh random_mesh(Random& random, int triangles) {
    Mesh mesh;
    for (int t = 0; t < triangles; ++t) {
        std::array<Vertex, triangle_corners> corners;
        for (Vertex& corner : corners) {
            for (int axis = 0; axis < 3; ++axis)
                corner.position[axis] = random.number(-2.0, 2.0);
        }
        mesh.add_triangle_of(corners);
    }
    return mesh;
}

double area(const BspPiece& piece) {
    const glm::dvec3 a = piece.corners[0].place;
    return 0.5 * glm::length(glm::cross(piece.corners[1].place - a, piece.corners[2].place - a));
}

/// The node that each piece lies in.
std::vector<int> nodes_of_pieces(const BspTree& tree) {
    std::vector<int> nodes(tree.pieces.size(), -1);
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        for (const int piece : tree.nodes[n].pieces) {
            CHECK(nodes[static_cast<std::size_t>(piece)] == -1); // in one node only
            nodes[static_cast<std::size_t>(piece)] = static_cast<int>(n);
        }
    }
    return nodes;
}

} // namespace tree
} // namespace

TEST_CASE("A BSP tree has every triangle whole, in pieces that no plane above them cuts") {
    Random random(262);
    for (int round = 0; round < rounds(300, 12); ++round) {
        const Mesh mesh = tree::random_mesh(random, random.integer(1, 14));
        const BspTree tree = make_bsp_tree(mesh);
        CAPTURE(round);
        std::vector<double> areas(static_cast<std::size_t>(mesh.triangle_count()), 0.0);
        for (const BspPiece& piece : tree.pieces) {
            areas[static_cast<std::size_t>(piece.triangle)] += tree::area(piece);
            for (const BspCorner& corner : piece.corners) {
                glm::dvec3 place(0.0);
                for (int i = 0; i < triangle_corners; ++i)
                    place +=
                        corner.weights[i] * glm::dvec3(mesh.corner(piece.triangle, i).position);
                CHECK(glm::length(place - corner.place) < 1e-12);
            }
        }
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            BspPiece whole{t, false, {}};
            for (int i = 0; i < triangle_corners; ++i)
                whole.corners[static_cast<std::size_t>(i)].place =
                    glm::dvec3(mesh.corner(t, i).position);
            CHECK(areas[static_cast<std::size_t>(t)] == Approx(tree::area(whole)));
        }
        const std::vector<int> nodes = tree::nodes_of_pieces(tree);
        for (std::size_t i = 0; i < tree.pieces.size(); ++i) {
            REQUIRE(nodes[i] >= 0);
            int below = nodes[i];
            for (int node = below; node >= 0;
                 node = tree.nodes[static_cast<std::size_t>(node)].parent) {
                const BspNode& at = tree.nodes[static_cast<std::size_t>(node)];
                for (const BspCorner& corner : tree.pieces[i].corners) {
                    const double d = glm::dot(at.plane.normal, corner.place) - at.plane.offset;
                    // 2e-6: what lies so near counts as in the plane, see make_bsp_tree().
                    if (node == nodes[i])
                        CHECK(std::abs(d) < 2e-6);
                    else if (at.front == below)
                        CHECK(d > -2e-6);
                    else {
                        CHECK(at.back == below);
                        CHECK(d < 2e-6);
                    }
                }
                below = node;
            }
        }
    }
}

TEST_CASE("A triangle through another's plane is cut once: into three pieces") {
    Mesh mesh;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        mesh.add_triangle_of({Vertex{a}, Vertex{b}, Vertex{c}});
    };
    add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
    add({0, 0, 0}, {1, 0, 0}, {0, 0, 3});
    const BspTree tree = make_bsp_tree(mesh);
    CHECK(tree.splits == 1);
    CHECK(tree.nodes.size() == 3); // both sides of the root have pieces
    REQUIRE(tree.pieces.size() == 4);
    CHECK(std::count_if(tree.pieces.begin(), tree.pieces.end(),
                        [](const BspPiece& piece) { return piece.is_cut; }) == 3);
    // One in the same plane is not cut, nor is one that only touches it.
    Mesh flat;
    flat.add_triangle_of({Vertex{{0, 0, 1}}, Vertex{{1, 0, 1}}, Vertex{{0, 1, 1}}});
    flat.add_triangle_of({Vertex{{5, 0, 1}}, Vertex{{6, 0, 1}}, Vertex{{5, 1, 1}}});
    flat.add_triangle_of({Vertex{{0, 0, 1}}, Vertex{{1, 0, 1}}, Vertex{{0, 1, 4}}});
    const BspTree uncut = make_bsp_tree(flat);
    CHECK(uncut.splits == 0);
    CHECK(uncut.nodes.front().pieces.size() == 2);
}

TEST_CASE("The walk draws everything, the side without the camera first") {
    Random random(263);
    for (int round = 0; round < rounds(300, 12); ++round) {
        const Mesh mesh = tree::random_mesh(random, random.integer(1, 14));
        const BspTree tree = make_bsp_tree(mesh);
        const std::vector<int> nodes = tree::nodes_of_pieces(tree);
        const SightRays rays{{random.number(-5, 5), random.number(-5, 5), random.number(-5, 5)},
                             glm::normalize(glm::vec3(random.number(-1, 1), 0.3f, 1.0f)),
                             static_cast<float>(round % 3) * 0.5f};
        const BspWalk walk = walk_bsp_tree(tree, rays, Stages());
        CAPTURE(round);
        REQUIRE(walk.steps.size() == tree.pieces.size());
        CHECK(walk.comparisons == std::ssize(tree.nodes));
        std::vector<std::size_t> place(tree.pieces.size());
        for (std::size_t i = 0; i < walk.steps.size(); ++i)
            place[static_cast<std::size_t>(walk.steps[i].piece)] = i;
        // Two pieces that a plane divides: the camera's eye, far back where rays are parallel,
        // says which is first.
        const double back = rays.mix < 1.0f ? rays.mix / (1.0 - double{rays.mix}) : 1e6;
        const glm::dvec3 eye = glm::dvec3(rays.camera) - back * glm::dvec3(rays.forward);
        for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
            const BspNode& node = tree.nodes[n];
            const double side = glm::dot(node.plane.normal, eye) - node.plane.offset;
            if (std::abs(side) < 1e-3) continue;
            for (std::size_t a = 0; a < tree.pieces.size(); ++a) {
                for (std::size_t b = 0; b < tree.pieces.size(); ++b) {
                    const auto is_below = [&](std::size_t piece, int top) {
                        int at = nodes[piece];
                        while (at >= 0 && at != top)
                            at = tree.nodes[static_cast<std::size_t>(at)].parent;
                        return top >= 0 && at == top;
                    };
                    const int far = side > 0.0 ? node.back : node.front;
                    const int near = side > 0.0 ? node.front : node.back;
                    const bool is_in_plane = nodes[b] == static_cast<int>(n);
                    if (is_below(a, far) && (is_in_plane || is_below(b, near)))
                        REQUIRE(place[a] < place[b]);
                    if (is_in_plane && is_below(a, near)) REQUIRE(place[b] < place[a]);
                }
            }
        }
    }
}

TEST_CASE("With near and far exchanged the walk is the other way round") {
    Random random(264);
    const Mesh mesh = tree::random_mesh(random, 8);
    const BspTree tree = make_bsp_tree(mesh);
    const SightRays rays{{0, 0, -5}, {0, 0, 1}, 0.0f};
    Stages stages;
    stages.is_near_side = is_far_side;
    std::vector<int> right, exchanged;
    for (const BspStep& step : walk_bsp_tree(tree, rays, Stages()).steps)
        right.push_back(step.node);
    for (const BspStep& step : walk_bsp_tree(tree, rays, stages).steps)
        exchanged.push_back(step.node);
    std::reverse(exchanged.begin(), exchanged.end());
    CHECK(right == exchanged);
}

TEST_CASE("Needles, points and hostile meshes end in a tree, or in none") {
    Mesh mesh;
    const glm::vec3 a(0, 0, 1), b(1, 1, 2);
    mesh.add_triangle_of({Vertex{a}, Vertex{a}, Vertex{a}});
    mesh.add_triangle_of({Vertex{a}, Vertex{b}, Vertex{0.5f * (a + b)}});
    mesh.add_triangle_of({Vertex{{-1e6f, 0, 1}}, Vertex{{1e6f, 1e-6f, 1}}, Vertex{{0, 0, 1}}});
    const BspTree tree = make_bsp_tree(mesh);
    std::vector<bool> has(3, false);
    for (const BspPiece& piece : tree.pieces)
        has[static_cast<std::size_t>(piece.triangle)] = true;
    CHECK(has == std::vector<bool>(3, true));

    CHECK(make_bsp_tree(Mesh()).nodes.empty());

    // Each of these cuts all others: far more pieces than a tree may have.
    Random random(265);
    CHECK(make_bsp_tree(tree::random_mesh(random, 600)).nodes.empty());
}
