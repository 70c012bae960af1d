#include "outside/outside_eye.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "base/limits.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

/// Focal length of the eye outside, in units of its picture's smaller side: a field of view of some
/// 40 degrees.
constexpr double outside_lens = 1.4;

/// A lamp farther from the middle of the scene than this is ignored, radii of the scene.
constexpr double farthest_lamp = 4.0;

/// The nearest distance seen, in parts of the distance from eye to target.
constexpr double near_share = 1e-3;

/// The part of the picture filled by what the camera sees.
constexpr double camera_share = 0.98;

glm::dmat3 rotation_of(const OutsideView& view) {
    Camera camera;
    camera.yaw = view.yaw;
    camera.pitch = view.pitch;
    return camera_rotation(camera);
}

std::vector<glm::dvec3> places_to_see(const OutsideScene& outside_scene) {
    const SceneBox& box = outside_scene.box;
    std::vector<glm::dvec3> places;
    for (int i = 0; i < 8; ++i) {
        places.emplace_back((i & 1) != 0 ? box.high.x : box.low.x,
                            (i & 2) != 0 ? box.high.y : box.low.y,
                            (i & 4) != 0 ? box.high.z : box.low.z);
    }
    for (const glm::dvec3& corner : outside_scene.plane.corners()) {
        places.push_back(corner);
        // If rays do not meet in the camera, its view volume begins next to it.
        if (outside_scene.plane.mix > 0.0)
            places.push_back(outside_scene.plane.in_world(
                outside_scene.plane.on_ray(outside_scene.plane.in_camera(corner), 0.0)));
    }
    places.push_back(outside_scene.plane.eye);
    if (glm::length(outside_scene.lamp - box.middle()) <= farthest_lamp * box.radius()) {
        places.push_back(outside_scene.lamp);
    }
    return places;
}

/// The limits of the eye along one axis of the picture: every point, with z forward, must satisfy
/// |x - eye| <= slope * (z - eye_z).
struct AxisLimits {
    double low = -std::numeric_limits<double>::infinity(); ///< largest x - slope z
    double high = std::numeric_limits<double>::infinity(); ///< smallest x + slope z

    void add(double x, double z, double slope) {
        low = std::max(low, x - slope * z);
        high = std::min(high, x + slope * z);
    }
    double farthest_eye(double slope) const { return (high - low) / (2.0 * slope); }
    double middle() const { return 0.5 * (low + high); }
};

double usual_focal_length(glm::ivec2 size) {
    return outside_lens * std::max(std::min(size.x, size.y), 1);
}

/// Through the camera, what it sees is as large as fits.
double camera_focal_length(const PicturePlane& plane, glm::ivec2 size, double margin) {
    const double width = std::max(size.x - 2.0 * margin, 0.5 * size.x);
    const double height = std::max(size.y - 2.0 * margin, 0.5 * size.y);
    const glm::dvec2 scale(width / std::max(plane.size.width, 1),
                           height / std::max(plane.size.height, 1));
    return camera_share * std::min(scale.x * plane.focal_length.x, scale.y * plane.focal_length.y);
}

} // namespace

std::optional<glm::dvec2> OutsideEye::pixel_of(const glm::dvec3& world) const {
    const glm::dvec3 place = in_eye(world);
    if (!(place.z >= near_distance)) return std::nullopt;
    const glm::dvec2 at = pixel(place);
    return std::isfinite(at.x) && std::isfinite(at.y) ? std::optional(at) : std::nullopt;
}

OutsideView settled(const OutsideView& view, const OutsideScene& outside_scene, glm::ivec2 size,
                    double margin) {
    OutsideView whole = within_ranges(view);
    if (whole.distance > 0.0f && !whole.is_camera) return whole;
    if (whole.is_camera) {
        const glm::dmat3& r = outside_scene.plane.rotation;
        whole.yaw = static_cast<float>(std::atan2(r[2].x, r[2].z));
        whole.pitch = static_cast<float>(std::asin(std::clamp(-r[2].y, -1.0, 1.0)));
        whole.is_camera = false;
    }
    const glm::dmat3 rotation = rotation_of(whole);
    const double focal_length = usual_focal_length(size);
    const auto slope = [&](int side) {
        return std::max(0.5 * side - margin, 0.2 * side) / focal_length;
    };
    const glm::dvec2 slopes(slope(std::max(size.x, 1)), slope(std::max(size.y, 1)));
    AxisLimits across, down;
    for (const glm::dvec3& place : places_to_see(outside_scene)) {
        const glm::dvec3 turned_place = place * rotation;
        across.add(turned_place.x, turned_place.z, slopes.x);
        down.add(turned_place.y, turned_place.z, slopes.y);
    }
    const double eye_z = std::min(across.farthest_eye(slopes.x), down.farthest_eye(slopes.y));
    // The target is as deep as the middle of the scene, and the eye turns about it.
    const double target_z = (outside_scene.box.middle() * rotation).z;
    const double distance = std::max(target_z - eye_z, 0.1 * outside_scene.box.radius());
    whole.distance = static_cast<float>(distance);
    whole.target = rotation * glm::dvec3(across.middle(), down.middle(), eye_z + distance);
    return within_ranges(whole);
}

OutsideEye eye_of(const OutsideView& view, const OutsideScene& outside_scene, glm::ivec2 size,
                  double margin) {
    const glm::ivec2 sides = glm::max(size, glm::ivec2(1));
    OutsideEye eye;
    eye.middle = 0.5 * glm::dvec2(sides);
    if (view.is_camera) {
        const PicturePlane& plane = outside_scene.plane;
        eye.position = plane.eye;
        eye.rotation = plane.rotation;
        eye.focal_length = camera_focal_length(plane, sides, margin);
        // What is straight ahead is not in the middle of the picture if its sides are odd numbers
        // of pixels or its box is off-centre.
        const glm::dvec2 scale = eye.focal_length / plane.focal_length;
        eye.middle +=
            scale * (plane.middle - 0.5 * glm::dvec2(plane.size.width, plane.size.height));
        eye.near_distance = near_share * outside_scene.box.radius();
        return eye;
    }
    const OutsideView whole = settled(view, outside_scene, sides, margin);
    eye.rotation = rotation_of(whole);
    eye.position = glm::dvec3(whole.target) - static_cast<double>(whole.distance) * eye.rotation[2];
    eye.focal_length = usual_focal_length(sides);
    eye.near_distance = near_share * static_cast<double>(whole.distance);
    return eye;
}

OutsideView shifted(OutsideView view, const OutsideEye& eye, glm::vec2 pixels) {
    const double scale = static_cast<double>(view.distance) / eye.focal_length;
    view.target -= glm::vec3(eye.rotation * glm::dvec3(scale * static_cast<double>(pixels.x),
                                                       scale * static_cast<double>(pixels.y), 0.0));
    return within_ranges(view);
}

Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area) {
    const auto is_near = [&](const glm::dvec3& corner) { return corner.z < eye.near_distance; };
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& corner : corners) {
        if (!std::isfinite(corner.x + corner.y + corner.z)) return {};
        if (is_near(corner)) continue;
        const glm::dvec2 pixel = eye.pixel(corner);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    if (std::all_of(corners.begin(), corners.end(), is_near)) return {};
    if (std::any_of(corners.begin(), corners.end(), is_near)) return area;
    // A point between two corners may be rounded beyond them.
    const glm::dvec2 first = glm::floor(low) - 1.0, end = glm::ceil(high) + 1.0;
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp<double>(x, area.left, area.right));
    };
    const auto row = [&](double y) {
        return static_cast<int>(std::clamp<double>(y, area.top, area.bottom));
    };
    const Rectangle box{column(first.x), row(first.y), column(end.x), row(end.y)};
    return is_empty(box) ? Rectangle{} : box;
}

} // namespace rasterwalk
