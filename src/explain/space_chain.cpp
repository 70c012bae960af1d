#include "explain/space_chain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#include "scene/scene.h"

namespace rasterwalk {

namespace {

constexpr std::size_t ndc_space = 4, window_space = 5;

ChainPoint point_by(const SpaceMatrices& matrices, const glm::dvec3& object) {
    ChainPoint point;
    point.places[0] = glm::dvec4(object, 1.0);
    point.places[1] = matrices.to_world * point.places[0];
    point.places[2] = matrices.to_camera * point.places[1];
    point.places[chain_clip_space] = matrices.to_clip * point.places[2];
    const glm::dvec4& clip = point.places[chain_clip_space];
    point.is_in_front = clip.w > 0.0;
    if (!point.is_in_front) return point;
    point.places[ndc_space] = clip / clip.w;
    point.places[window_space] = matrices.to_window * point.places[ndc_space];
    return point;
}

/// Collects points and edges, each once.
class ChainCollector {
  public:
    ChainCollector(const Frame& frame, SpaceChain& chain) : frame_(frame), chain_(chain) {}

    /// False if there is no room for more.
    bool add(int triangle, bool is_of_triangle) {
        const int part = part_of(*frame_.scene, triangle);
        if (part != part_ || known_.empty()) {
            part_ = part;
            matrices_ = space_matrices(frame_, triangle);
        }
        const std::array<glm::dvec3, triangle_corners> object =
            object_corners(*frame_.scene, triangle);
        std::array<std::size_t, triangle_corners> corners{};
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = index_of(object[i]);
        if (is_of_triangle) chain_.corners = corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t a = corners[i], b = corners[(i + 1) % corners.size()];
            if (!edges_.insert(std::minmax(a, b)).second) continue;
            if (chain_.edges.size() >= most_chain_edges) {
                chain_.is_complete = false;
                return false;
            }
            chain_.edges.push_back({a, b, is_of_triangle});
        }
        return true;
    }

  private:
    /// Vertices at one place are one point; parts have matrices of their own.
    std::size_t index_of(const glm::dvec3& object) {
        const auto [known, is_new] =
            known_.try_emplace({part_, object.x, object.y, object.z}, chain_.points.size());
        if (is_new) chain_.points.push_back(point_by(matrices_, object));
        return known->second;
    }

    const Frame& frame_;
    SpaceChain& chain_;
    int part_ = -1;
    SpaceMatrices matrices_;
    std::map<std::tuple<int, double, double, double>, std::size_t> known_;
    std::set<std::pair<std::size_t, std::size_t>> edges_;
};

/// Around the points that are in the space, and its origin.
ChainScale fitting_scale(const SpaceChain& chain, std::size_t space) {
    glm::dvec3 low(0.0), high(0.0);
    for (const ChainPoint& point : chain.points) {
        const glm::dvec3 place(point.places[space]);
        const bool is_finite = std::isfinite(place.x + place.y + place.z);
        if (!is_finite || !is_in_chain(point, static_cast<double>(space))) continue;
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const glm::dvec3 half = 0.5 * (high - low);
    const double longest = std::max({half.x, half.y, half.z});
    return {low + half, glm::dvec3(longest > 0.0 ? 1.0 / longest : 1.0)};
}

glm::dvec3 in_figure(const ChainScale& scale, const glm::dvec3& place) {
    return (place - scale.middle) * scale.scale;
}

/// The twelve sides of a box.
std::vector<ChainGuide> box_guides(const ChainScale& scale, const glm::dvec3& low,
                                   const glm::dvec3& high) {
    const auto corner = [&](unsigned bits) {
        return in_figure(scale,
                         {(bits & 1U) != 0 ? high.x : low.x, (bits & 2U) != 0 ? high.y : low.y,
                          (bits & 4U) != 0 ? high.z : low.z});
    };
    std::vector<ChainGuide> guides;
    for (unsigned bits = 0; bits < 8; ++bits) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            if ((bits & axis) == 0) guides.push_back({corner(bits), corner(bits | axis), -1});
        }
    }
    return guides;
}

} // namespace

SpaceChain space_chain(const Frame& frame, int triangle, bool is_whole_scene) {
    const Scene& scene = *frame.scene;
    SpaceChain chain;
    ChainCollector collector(frame, chain);
    collector.add(triangle, true);
    const int part = part_of(scene, triangle);
    int first = 0, last = frame.triangle_count();
    // The triangles of a drawn list are not sorted by their parts.
    const bool has_range = !is_whole_scene && part >= 0 && scene.sources.empty();
    if (has_range) {
        const Part& of = scene.parts[static_cast<std::size_t>(part)];
        first = of.first_triangle;
        last = std::min(last, first + of.triangle_count);
    }
    bool has_room = true;
    for (int t = first; t < last && has_room; ++t) {
        if (is_whole_scene || has_range || part_of(scene, t) == part)
            has_room = collector.add(t, false);
    }
    for (std::size_t space = 0; space <= chain_clip_space; ++space)
        chain.scales[space] = fitting_scale(chain, space);
    const Viewport& size = frame.settings.viewport;
    chain.scales[ndc_space] = {{0.0, 0.0, 0.5}, glm::dvec3(1.0)};
    const double half = 0.5 * std::max(size.width, size.height);
    chain.scales[window_space] = {{0.5 * size.width, 0.5 * size.height, 0.5},
                                  {1.0 / half, 1.0 / half, 1.0}};
    return chain;
}

bool is_in_chain(const ChainPoint& point, double at) {
    return point.is_in_front || at <= static_cast<double>(chain_clip_space);
}

glm::dvec3 chain_place(const SpaceChain& chain, const ChainPoint& point, double at) {
    const double begin =
        std::clamp(std::floor(at), 0.0, static_cast<double>(chain_space_count - 1));
    const auto space = static_cast<std::size_t>(begin);
    const double share = std::clamp(at - begin, 0.0, 1.0);
    const auto place_in = [&](std::size_t i) {
        return in_figure(chain.scales[i], glm::dvec3(point.places[i]));
    };
    if (share == 0.0 || space + 1 == chain_space_count) return place_in(space);
    return (1.0 - share) * place_in(space) + share * place_in(space + 1);
}

std::vector<ChainGuide> chain_guides(const SpaceChain& chain, const Frame& frame,
                                     std::size_t space) {
    const ChainScale& scale = chain.scales[space];
    const Viewport& size = frame.settings.viewport;
    if (space == ndc_space) return box_guides(scale, {-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0});
    if (space == window_space) {
        return box_guides(scale, glm::dvec3(0.0),
                          {static_cast<double>(size.width), static_cast<double>(size.height), 1.0});
    }
    std::vector<ChainGuide> guides;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 end(0.0);
        end[axis] = 0.6 / scale.scale[axis];
        guides.push_back({in_figure(scale, glm::dvec3(0.0)), in_figure(scale, end), axis});
    }
    return guides;
}

glm::dvec2 seen_obliquely(const glm::dvec3& place) {
    // Turned about y, then about x.
    constexpr double cos_yaw = 0.8, sin_yaw = 0.6, cos_pitch = 0.96, sin_pitch = 0.28;
    const double away = sin_yaw * place.x + cos_yaw * place.z;
    return {cos_yaw * place.x - sin_yaw * place.z, cos_pitch * place.y - sin_pitch * away};
}

} // namespace rasterwalk
