#include "scene/obj_places.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace rasterwalk {

namespace {

double longest(const glm::dvec3& way) {
    return std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
}

glm::dvec3 origin_of(const ObjStatements& file) {
    if (file.faces.empty()) return glm::dvec3(0.0);
    const auto position = [&](const ObjCorner& corner) {
        return file.positions[static_cast<std::size_t>(corner.position)];
    };
    glm::dvec3 least = position(file.corner(file.faces.front(), 0)), most = least;
    for (const ObjFace& face : file.faces) {
        for (int i = 0; i < face.corner_count; ++i) {
            const glm::dvec3 place = position(file.corner(face, i));
            least = glm::min(least, place);
            most = glm::max(most, place);
        }
    }
    glm::dvec3 middle = 0.5 * (least + most);
    const double half = 0.5 * longest(most - least);
    constexpr double far = 16.0;
    if (half == 0.0 || longest(middle) <= far * half) return glm::dvec3(0.0);
    // A power of two, so that subtracting the middle rounds nothing again.
    const double unit = std::ldexp(1.0, std::ilogb(half) - 7);
    for (int i = 0; i < 3; ++i) {
        const double units = middle[i] / unit;
        constexpr double most_whole = 1e15; // of a double
        if (std::abs(units) < most_whole) middle[i] = std::round(units) * unit;
    }
    return middle;
}

} // namespace

ObjPlaces obj_places(const ObjStatements& file) {
    ObjPlaces made;
    made.origin = origin_of(file);
    made.places.reserve(file.positions.size());
    for (const glm::dvec3& position : file.positions)
        made.places.emplace_back(position - made.origin);
    return made;
}

} // namespace rasterwalk
