#include "stages/bsp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/limits.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// On which side of a plane something lies.
enum class PlaneSide : std::uint8_t { in_it, front, back, both };

/// Builds one tree. Which node comes next is kept in a list: the tree of a hostile mesh is as deep
/// as it has triangles.
class BspBuilder {
  public:
    explicit BspBuilder(const Mesh& mesh) {
        double largest = 0.0;
        std::vector<BspPiece> pieces;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            BspPiece piece{t, false, {}};
            for (int i = 0; i < triangle_corners; ++i) {
                const glm::dvec3 place(mesh.corner(t, i).position);
                glm::dvec3 weights(0.0);
                weights[i] = 1.0;
                piece.corners[static_cast<std::size_t>(i)] = {place, weights};
                const glm::dvec3 size = glm::abs(place);
                largest = std::max({largest, size.x, size.y, size.z});
            }
            pieces.push_back(piece);
        }
        // The mesh has floats: rounding has moved each coordinate by up to 2^-24 of its size. A
        // product with the normal adds three of them, on both sides of the comparison.
        tolerance_ = 8.0 * 0x1p-24 * largest;
        waiting_ = pieces.size();
        if (waiting_ > 0) left_.push_back({std::move(pieces), -1, false});
    }

    BspTree build() {
        while (!left_.empty()) {
            Rest rest = std::move(left_.back());
            left_.pop_back();
            if (!divide(rest)) return {};
        }
        return std::move(tree_);
    }

  private:
    /// Pieces that no node has yet.
    struct Rest {
        std::vector<BspPiece> pieces; ///< one or more
        int parent;
        bool is_front; ///< on which side of the parent's plane they lie
    };

    static BspPlane plane_of(const BspPiece& piece) {
        const auto& [a, b, c] = piece.corners;
        const glm::dvec3 normal = glm::cross(c.place - a.place, b.place - a.place);
        const double length = glm::length(normal);
        if (!(length > 0.0)) return {};
        return {normal / length, glm::dot(normal / length, a.place)};
    }

    double distance(const BspCorner& corner, const BspPlane& plane) const {
        const double distance = glm::dot(plane.normal, corner.place) - plane.offset;
        return std::abs(distance) <= tolerance_ ? 0.0 : distance;
    }

    PlaneSide side(const BspPiece& piece, const BspPlane& plane) const {
        bool is_front = false, is_back = false;
        for (const BspCorner& corner : piece.corners) {
            const double d = distance(corner, plane);
            is_front = is_front || d > 0.0;
            is_back = is_back || d < 0.0;
        }
        if (is_front && is_back) return PlaneSide::both;
        if (is_front) return PlaneSide::front;
        return is_back ? PlaneSide::back : PlaneSide::in_it;
    }

    /// Makes a node in the plane of the first piece that has one. False: too many pieces.
    bool divide(Rest& rest) {
        BspNode node;
        const BspPiece* own = nullptr;
        for (const BspPiece& piece : rest.pieces) {
            own = &piece;
            node.plane = plane_of(piece);
            if (node.plane.normal != glm::dvec3(0.0)) break;
        }
        node.triangle = own->triangle;
        const int number = static_cast<int>(tree_.nodes.size());
        node.parent = rest.parent;
        if (rest.parent >= 0) {
            BspNode& parent = tree_.nodes[static_cast<std::size_t>(rest.parent)];
            (rest.is_front ? parent.front : parent.back) = number;
        }
        std::vector<BspPiece> front, back;
        for (const BspPiece& piece : rest.pieces) {
            ++tree_.tests;
            // Of a needle even the plane through its corners may miss them.
            switch (&piece == own ? PlaneSide::in_it : side(piece, node.plane)) {
            case PlaneSide::in_it:
                node.pieces.push_back(static_cast<int>(tree_.pieces.size()));
                tree_.pieces.push_back(piece);
                break;
            case PlaneSide::front:
                front.push_back(piece);
                break;
            case PlaneSide::back:
                back.push_back(piece);
                break;
            case PlaneSide::both:
                ++tree_.splits;
                split(piece, node.plane, front, back);
                break;
            }
        }
        waiting_ += front.size() + back.size();
        waiting_ -= std::exchange(rest.pieces, {}).size();
        tree_.nodes.push_back(std::move(node));
        if (!back.empty()) left_.push_back({std::move(back), number, false});
        if (!front.empty()) left_.push_back({std::move(front), number, true});
        return tree_.pieces.size() + waiting_ <= most_bsp_pieces && tree_.tests <= most_bsp_tests;
    }

    /// Cuts a piece in two, one of them a quadrangle, which becomes two triangles.
    void split(const BspPiece& piece, const BspPlane& plane, std::vector<BspPiece>& front,
               std::vector<BspPiece>& back) const {
        std::vector<BspCorner> in_front, behind;
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            const BspCorner& a = piece.corners[i];
            const BspCorner& b = piece.corners[(i + 1) % piece.corners.size()];
            const double from_a = distance(a, plane), from_b = distance(b, plane);
            if (from_a >= 0.0) in_front.push_back(a);
            if (from_a <= 0.0) behind.push_back(a);
            if (from_a * from_b >= 0.0) continue;
            const double t = from_a / (from_a - from_b);
            const BspCorner cut{a.place + t * (b.place - a.place),
                                a.weights + t * (b.weights - a.weights)};
            in_front.push_back(cut);
            behind.push_back(cut);
        }
        add_fan(piece.triangle, in_front, front);
        add_fan(piece.triangle, behind, back);
    }

    static void add_fan(int triangle, const std::vector<BspCorner>& corners,
                        std::vector<BspPiece>& pieces) {
        for (std::size_t i = 2; i < corners.size(); ++i)
            pieces.push_back({triangle, true, {corners[0], corners[i - 1], corners[i]}});
    }

    BspTree tree_;
    std::vector<Rest> left_;
    std::size_t waiting_ = 0; ///< pieces in left_
    double tolerance_ = 0.0;  ///< world units
};

} // namespace

BspTree make_bsp_tree(const Mesh& mesh) {
    return BspBuilder(mesh).build();
}

float camera_side(const BspPlane& plane, const SightRays& rays) {
    const glm::vec3 n(plane.normal);
    const auto along = [&](const glm::vec3& v) { return n.x * v.x + n.y * v.y + n.z * v.z; };
    const float ahead = along(rays.camera) - static_cast<float>(plane.offset);
    if (rays.mix == 0.0f) return ahead;
    return (1.0f - rays.mix) * ahead - rays.mix * along(rays.forward);
}

BspWalk walk_bsp_tree(const BspTree& tree, const SightRays& rays, const Stages& stages) {
    /// What is left to walk: a node and all below it, or only its own pieces.
    struct Left {
        int node;
        bool is_whole;
    };
    BspWalk walk;
    std::vector<Left> left;
    if (!tree.nodes.empty()) left.push_back({0, true});
    while (!left.empty()) {
        const Left next = left.back();
        left.pop_back();
        const BspNode& node = tree.nodes[static_cast<std::size_t>(next.node)];
        if (!next.is_whole) {
            for (const int piece : node.pieces)
                walk.steps.push_back({piece, next.node});
            continue;
        }
        ++walk.comparisons;
        const bool is_front_near = stages.is_near_side(camera_side(node.plane, rays));
        const int near = is_front_near ? node.front : node.back;
        const int far = is_front_near ? node.back : node.front;
        // What is put down first is walked last.
        if (near >= 0) left.push_back({near, true});
        left.push_back({next.node, false});
        if (far >= 0) left.push_back({far, true});
    }
    return walk;
}

} // namespace rasterwalk
