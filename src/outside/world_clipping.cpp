#include "outside/world_clipping.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

/// How far a face reaches beyond what it cuts, in parts of its size.
constexpr double face_margin = 0.08;

/// A side of the view volume is drawn at least to this multiple of the picture's distance.
constexpr double side_depth = 1.0;

/// Where the plane cuts, in camera space.
std::vector<glm::dvec3> cuts_of(const WorldClipping& clipping, const PicturePlane& picture) {
    std::vector<glm::dvec3> places;
    for (const glm::dvec3& place : clipping.plane->cuts)
        places.push_back(picture.in_camera(place));
    return places;
}

/// Twice the area of the triangle, positive if its corners go round from x to y.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The smallest convex polygon around points.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information
/// Processing Letters 9(5), 1979.
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> places) {
    std::sort(places.begin(), places.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (!(b.x < a.x) && a.y < b.y);
    });
    std::vector<glm::dvec2> hull;
    const auto add = [&hull](const glm::dvec2& place, std::size_t least) {
        while (hull.size() >= least &&
               area(hull[hull.size() - 2], hull[hull.size() - 1], place) <= 0.0)
            hull.pop_back();
        hull.push_back(place);
    };
    for (const glm::dvec2& place : places)
        add(place, 2);
    const std::size_t lower = hull.size() + 1;
    for (auto place = places.rbegin() + 1; place != places.rend(); ++place)
        add(*place, lower);
    hull.pop_back(); // the first again
    return hull;
}

/// A rectangle perpendicular to the camera's direction.
std::vector<glm::dvec3> end_face(const WorldClipping& clipping, const PicturePlane& picture,
                                 double z) {
    const glm::dvec2 size(picture.size.width, picture.size.height);
    const glm::dvec2 scale = picture.w_at(z) / picture.scale;
    glm::dvec2 low = -picture.middle * scale, high = (size - picture.middle) * scale;
    for (const glm::dvec3& corner : cuts_of(clipping, picture)) {
        low = glm::min(low, glm::dvec2(corner));
        high = glm::max(high, glm::dvec2(corner));
    }
    const glm::dvec2 margin = face_margin * (high - low);
    low -= margin;
    high += margin;
    return {picture.in_world({low.x, low.y, z}), picture.in_world({high.x, low.y, z}),
            picture.in_world({high.x, high.y, z}), picture.in_world({low.x, high.y, z})};
}

/// A side of the view volume, from the near plane onward.
/// @param slope across the side: x/w, or y/w for top and bottom
std::vector<glm::dvec3> side_face(const WorldClipping& clipping, const PicturePlane& picture,
                                  double slope, bool is_upright) {
    const int along = is_upright ? 1 : 0; // the axis along the border of the picture
    const glm::dvec2 size(picture.size.width, picture.size.height);
    const double low = -picture.middle[along] / picture.scale[along];
    const double high = (size[along] - picture.middle[along]) / picture.scale[along];
    const std::vector<glm::dvec3> cuts = cuts_of(clipping, picture);
    double near = clipping.ends ? clipping.ends->x : 0.0, deep = side_depth * picture.distance;
    for (const glm::dvec3& corner : cuts)
        deep = std::max(deep, (1.0 + face_margin) * corner.z);
    near = std::min(near, deep);
    // Depth, and position along the border.
    std::vector<glm::dvec2> places;
    for (const double z : {near, deep}) {
        places.emplace_back(z, low * picture.w_at(z));
        places.emplace_back(z, high * picture.w_at(z));
    }
    for (const glm::dvec3& corner : cuts)
        places.emplace_back(corner.z, corner[along]);
    std::vector<glm::dvec3> face;
    for (const glm::dvec2& place : hull_of(places)) {
        const double across = slope * picture.w_at(place.x);
        face.push_back(picture.in_world(is_upright ? glm::dvec3(across, place.y, place.x)
                                                   : glm::dvec3(place.y, across, place.x)));
    }
    return face;
}

} // namespace

std::vector<glm::dvec3> plane_face(const WorldClipping& clipping, const PicturePlane& picture) {
    if (!clipping.plane) return {};
    const glm::dvec4 c(clipping.plane->coefficients);
    const bool has_x = std::abs(c.x) > 0.0, has_y = std::abs(c.y) > 0.0;
    std::vector<glm::dvec3> face;
    if (!has_x && !has_y) {
        face = end_face(clipping, picture, clipping.plane->depth);
    } else if (has_x != has_y) {
        // In clip space, x and y are those of camera space times scale, plus w times shift.
        const int axis = has_x ? 0 : 1;
        const double slope = (-c.w / c[axis] - picture.shift[axis]) / picture.scale[axis];
        face = side_face(clipping, picture, slope, has_x);
    }
    const auto is_finite = [](const glm::dvec3& p) { return std::isfinite(p.x + p.y + p.z); };
    if (!std::all_of(face.begin(), face.end(), is_finite)) face.clear();
    return face;
}

} // namespace rasterwalk
