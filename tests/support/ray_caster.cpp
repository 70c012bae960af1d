#include "support/ray_caster.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace rasterwalk::test {

namespace {

/// Turns about the y axis: from z toward x.
glm::dvec3 turn_sideways(const glm::dvec3& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

/// Turns about the x axis: from z toward -y, which is up.
glm::dvec3 turn_upwards(const glm::dvec3& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {v.x, c * v.y - s * v.z, c * v.z + s * v.y};
}

} // namespace

CameraAxes camera_axes(const Camera& camera) {
    const auto turned = [&](const glm::dvec3& in_camera) {
        return turn_sideways(turn_upwards(in_camera, camera.pitch), camera.yaw);
    };
    return {turned({1.0, 0.0, 0.0}), turned({0.0, 1.0, 0.0}), turned({0.0, 0.0, 1.0})};
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

RayCaster::RayCaster(const Scene& scene, const Camera& camera, const Light& light)
    : scene_(scene), eye_(camera.position), axes_(camera_axes(camera)),
      focal_length_(camera.focal_length), lamp_(light.position), power_(light.power),
      indirect_(light.indirect) {
    for (int t = 0; t < scene.triangle_count(); ++t) {
        glm::dvec3 p[3];
        for (int v = 0; v < 3; ++v)
            p[v] = scene.corner(t, v).position;
        Corners corners{p[0], p[1] - p[0], p[2] - p[0], {}, {}};
        corners.normal = glm::cross(corners.ab, corners.ac);
        for (int v = 0; v < 3; ++v)
            corners.light[v] = this->light(t, v, p[v]);
        triangles_.push_back(corners);
        for (std::size_t v = 0; v < 3; ++v)
            edges_.push_back({pixel_at(p[v]), pixel_at(p[(v + 1) % 3])});
    }
}

glm::dvec3 RayCaster::direction(glm::dvec2 place) const {
    // One unit forward, so that what a ray travels is z.
    return axes_.forward + (place.x * axes_.right + place.y * axes_.down) / focal_length_;
}

glm::dvec2 RayCaster::pixel_at(const glm::dvec3& position_world) const {
    // By the three directions of the camera rather than by turning the world.
    const glm::dvec3 way = position_world - eye_;
    const double z = glm::dot(way, axes_.forward);
    return focal_length_ / z * glm::dvec2(glm::dot(way, axes_.right), glm::dot(way, axes_.down));
}

RayHit RayCaster::on_plane(int triangle, glm::dvec2 place) const {
    const Corners& corners = triangles_[static_cast<std::size_t>(triangle)];
    const glm::dvec3 d = direction(place);
    const glm::dvec3 to_eye = eye_ - corners.a;
    // The ray crosses the plane where its height over it has become 0; 1/z never divides by 0.
    RayHit hit;
    hit.triangle = triangle;
    hit.zinv = -glm::dot(d, corners.normal) / glm::dot(to_eye, corners.normal);
    const double z = 1.0 / hit.zinv;
    hit.position_world = eye_ + z * d;
    const glm::dvec3 inside = hit.position_world - corners.a;
    const double area2 = glm::dot(corners.normal, corners.normal);
    const double at_b = glm::dot(glm::cross(inside, corners.ac), corners.normal) / area2;
    const double at_c = glm::dot(glm::cross(corners.ab, inside), corners.normal) / area2;
    hit.weights = {1.0 - at_b - at_c, at_b, at_c};
    return hit;
}

std::vector<RayHit> RayCaster::hits(glm::dvec2 place) const {
    std::vector<RayHit> found;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        const RayHit hit = on_plane(t, place);
        const double least = std::min({hit.weights.x, hit.weights.y, hit.weights.z});
        if (hit.zinv > 0.0 && least >= 0.0) found.push_back(hit);
    }
    std::sort(found.begin(), found.end(),
              [](const RayHit& a, const RayHit& b) { return a.zinv > b.zinv; });
    return found;
}

glm::dvec3 RayCaster::light(int triangle, int vertex, const glm::dvec3& position_world) const {
    const Vertex& corner = scene_.corner(triangle, vertex);
    const double pi = std::acos(-1.0);
    const glm::dvec3 ray = lamp_ - position_world;
    const double r = glm::length(ray);
    const double slant = glm::dot(ray / r, glm::dvec3(corner.normal));
    const glm::dvec3 direct = power_ * (std::max(slant, 0.0) / (4.0 * pi * r * r));
    return glm::dvec3(corner.reflectance) * (direct + indirect_);
}

glm::dvec3 RayCaster::light_at_point(const RayHit& hit) const {
    return light(hit.triangle, 0, hit.position_world);
}

glm::dvec3 RayCaster::light_from_vertices(const RayHit& hit) const {
    const Corners& corners = triangles_[static_cast<std::size_t>(hit.triangle)];
    return hit.weights.x * corners.light[0] + hit.weights.y * corners.light[1] +
           hit.weights.z * corners.light[2];
}

double RayCaster::distance_to_edges(glm::dvec2 place) const {
    double nearest = INFINITY;
    for (const Edge& edge : edges_)
        nearest = std::min(nearest, distance_to_segment(place, edge.from, edge.to));
    return nearest;
}

} // namespace rasterwalk::test
