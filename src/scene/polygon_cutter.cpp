#include "scene/polygon_cutter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

constexpr double full_turn = 6.283185307179586;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

} // namespace

glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 first(corners.front());
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(glm::dvec3(corners[i]) - first, glm::dvec3(corners[i + 1]) - first);
    return normal;
}

PolygonCut PolygonCutter::cut(std::span<const glm::vec3> corners) {
    triangles_.clear();
    if (corners.size() == 3) {
        triangles_.push_back({0, 1, 2});
        return PolygonCut::fan;
    }
    flatten(corners);
    previous_.resize(corners.size());
    std::iota(previous_.begin(), previous_.end(), 0);
    if (is_fan()) {
        add_fan(previous_);
        return PolygonCut::fan;
    }
    if (!is_begun_) work_left_ = most_ear_tests;
    is_begun_ = true;
    if (corners.size() > most_ear_corners || work_left_ <= 0) return PolygonCut::refused;
    const PolygonCut how = cut_ears();
    if (how == PolygonCut::refused) triangles_.clear();
    return how;
}

/// Leaves out the axis along which the polygon shows the largest area. If it has none, because its
/// edges cross or are on one line, leaves out the axis along which it is shortest.
void PolygonCutter::flatten(std::span<const glm::vec3> corners) {
    glm::dvec3 least(corners.front()), most(least);
    for (const glm::vec3& corner : corners) {
        least = glm::min(least, glm::dvec3(corner));
        most = glm::max(most, glm::dvec3(corner));
    }
    const glm::dvec3 normal = newell_normal(corners);
    constexpr double nothing = 1e-9;
    const bool has_area = glm::length(normal) > nothing * glm::dot(most - least, most - least);
    const glm::dvec3 size = has_area ? glm::abs(normal) : least - most;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    const double side = normal[axis] < 0.0 ? -1.0 : 1.0;
    places_.resize(corners.size());
    const glm::dvec3 origin(corners.front());
    glm::dvec2 extent(0.0);
    double far_out = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 place(corners[i]);
        const glm::dvec3 offset = place - origin;
        places_[i] = {offset[first], side * offset[second]};
        extent = glm::max(extent, glm::abs(places_[i]));
        far_out = std::max({far_out, std::abs(place[first]), std::abs(place[second])});
    }
    // Corners are floats: each is within half a unit in the last place of where it was meant.
    constexpr double float_rounding = 1.2e-7;
    fuzz_ = 4.0 * float_rounding * far_out * std::max(extent.x, extent.y);
}

bool PolygonCutter::is_fan() const {
    double swept = 0.0;
    for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
        const double area = cross(places_[i], places_[i + 1]);
        if (area < -fuzz_) return false;
        swept += std::abs(std::atan2(area, glm::dot(places_[i], places_[i + 1])));
    }
    return swept <= full_turn;
}

void PolygonCutter::add_fan(const std::vector<int>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        triangles_.push_back({corners[0], corners[i], corners[i + 1]});
}

double PolygonCutter::turn(int a, int b, int c) const {
    const auto place = [&](int i) { return places_[static_cast<std::size_t>(i)]; };
    return cross(place(b) - place(a), place(c) - place(a));
}

/// No part of an ear is outside the polygon: it turns to the inside, and no reflex corner is in it.
/// One that coincides with a corner of it, as where a hole is joined to the outline, does not
/// count.
bool PolygonCutter::is_ear(int corner) {
    const auto at = static_cast<std::size_t>(corner);
    const int a = previous_[at], b = corner, c = next_[at];
    if (!(turn(a, b, c) > 0.0)) return false;
    const auto is_at = [&](int i, int j) {
        return places_[static_cast<std::size_t>(i)] == places_[static_cast<std::size_t>(j)];
    };
    work_left_ -= static_cast<long long>(reflex_.size());
    return std::none_of(reflex_.begin(), reflex_.end(), [&](int p) {
        if (p == a || p == b || p == c) return false;
        if (turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0) return false;
        return !is_at(p, a) && !is_at(p, b) && !is_at(p, c);
    });
}

/// Cuts a corner, and its triangle, from the ring.
void PolygonCutter::clip(int corner) {
    const auto at = static_cast<std::size_t>(corner);
    const int a = previous_[at], c = next_[at];
    triangles_.push_back({a, corner, c});
    next_[static_cast<std::size_t>(a)] = c;
    previous_[static_cast<std::size_t>(c)] = a;
    work_left_ -= static_cast<long long>(reflex_.size());
    const auto is_convex_now = [&](int p) {
        const auto here = static_cast<std::size_t>(p);
        return p == corner || ((p == a || p == c) && turn(previous_[here], p, next_[here]) > 0.0);
    };
    reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(), is_convex_now), reflex_.end());
}

/// The first ear of the ring, starting at a corner; one without area if there is no other; -1 if
/// there is none.
int PolygonCutter::find_ear(int start) {
    int flat = -1;
    int corner = start;
    do {
        if (work_left_ <= 0) return -1;
        if (is_ear(corner)) return corner;
        const auto at = static_cast<std::size_t>(corner);
        if (flat < 0 && std::abs(turn(previous_[at], corner, next_[at])) <= fuzz_) flat = corner;
        corner = next_[at];
        --work_left_;
    } while (corner != start);
    return flat;
}

PolygonCut PolygonCutter::cut_ears() {
    const int count = static_cast<int>(places_.size());
    next_.resize(places_.size());
    for (int i = 0; i < count; ++i) {
        previous_[static_cast<std::size_t>(i)] = (i + count - 1) % count;
        next_[static_cast<std::size_t>(i)] = (i + 1) % count;
    }
    reflex_.clear();
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!(turn(previous_[at], i, next_[at]) > 0.0)) reflex_.push_back(i);
    }
    int at = 0;
    for (int left = count; left > 3; --left) {
        const int ear = find_ear(at);
        if (work_left_ <= 0) return PolygonCut::refused;
        if (ear < 0) {
            std::vector<int> ring;
            for (int i = 0; i < left; ++i) {
                ring.push_back(at);
                at = next_[static_cast<std::size_t>(at)];
            }
            add_fan(ring);
            return PolygonCut::crossed;
        }
        clip(ear);
        // The corner after next: otherwise the ears of a round polygon would become a fan.
        at = next_[static_cast<std::size_t>(next_[static_cast<std::size_t>(ear)])];
    }
    const auto last = static_cast<std::size_t>(at);
    const bool is_turned = turn(previous_[last], at, next_[last]) < -fuzz_;
    triangles_.push_back(
        {previous_[static_cast<std::size_t>(at)], at, next_[static_cast<std::size_t>(at)]});
    return is_turned ? PolygonCut::crossed : PolygonCut::ears;
}

} // namespace rasterwalk
