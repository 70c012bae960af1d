#include "explain/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/enum_words.h"
#include "base/numbers.h"
#include "pipeline/surface.h"
#include "stages/orthographic.h"
#include "stages/project.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void add_vector(VectorReport& report, const ShownVector& vector) {
    const bool has_length = vector.along != glm::dvec3(0.0);
    if (has_length && is_finite(vector.from) && is_finite(vector.along))
        report.vectors.push_back(vector);
}

/// A direction in the world, from one along the axes of the space where the light is worked out.
glm::dvec3 in_world(const glm::vec3& direction, const std::optional<TangentSpace>& space) {
    const glm::dvec3 d(direction);
    if (!space) return d;
    const TangentFrame& axes = space->axes;
    return d.x * glm::dvec3(axes.tangent) + d.y * glm::dvec3(axes.bitangent) +
           d.z * glm::dvec3(axes.normal);
}

/// Where the light of a fragment is worked out, and with what.
struct LitPlace {
    glm::dvec3 position;
    glm::vec3 normal;
    const SurfaceLight& light;
    std::optional<TangentSpace> space;
    const BumpReport* bump; ///< null: no normal map acts there
};

LitPlace lit_place(const Frame& frame, const FragmentReport& fragment) {
    if (fragment.shading == Shading::flat) {
        const SurfacePoint middle = flat_point(frame, fragment.cursor.triangle);
        return {glm::dvec3(middle.position_world),
                middle.normal,
                fragment.light_per_triangle,
                {},
                nullptr};
    }
    const BumpReport* const bump = fragment.bump ? &*fragment.bump : nullptr;
    return {glm::dvec3(fragment.under(fragment.interpolation).position_world), fragment.normal,
            fragment.light, bump != nullptr ? bump->space : std::nullopt, bump};
}

VectorReport light_vectors(const Frame& frame, const FragmentReport& fragment) {
    VectorReport report;
    report.pixel = fragment.pixel;
    report.triangle = fragment.cursor.triangle;
    const LitPlace place = lit_place(frame, fragment);
    const auto add = [&](VectorName name, const glm::dvec3& along) {
        add_vector(report, {name, place.position, along});
    };
    add(VectorName::normal, glm::dvec3(place.normal));
    if (place.bump != nullptr && place.bump->sign != 0.0f) {
        // With both sides lit the light may use the other side.
        const bool is_turned = glm::dot(place.normal, place.bump->normal) < 0.0f;
        add(VectorName::unbent, (is_turned ? -1.0 : 1.0) * glm::dvec3(place.bump->axes.normal));
    }
    const glm::dvec3 to_light = in_world(place.light.diffuse.to_light, place.space);
    const double distance = glm::length(to_light);
    if (distance > 0.0) add(VectorName::to_lamp, to_light / distance);
    const HighlightTerms& highlight = place.light.highlight;
    add(VectorName::to_eye, in_world(highlight.to_eye, place.space));
    add(VectorName::half, in_world(highlight.half, place.space));
    if (place.bump != nullptr && place.bump->sign != 0.0f) {
        add(VectorName::tangent, glm::dvec3(place.bump->axes.tangent));
        add(VectorName::bitangent, glm::dvec3(place.bump->axes.bitangent));
    }
    return report;
}

using Corners = std::array<glm::dvec3, triangle_corners>;

Corners corners_in(const Frame& frame, int triangle) {
    const Scene& scene = *frame.scene;
    Corners corners;
    for (int i = 0; i < triangle_corners; ++i) {
        glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        corner = scene.corner(triangle, i).position;
        if (scene.space != SceneSpace::pixels) continue;
        // Depth is no third direction of the picture.
        if (i > 0) corner.z = corners[0].z;
        const ProjectedVertex& vertex = frame.given_vertex(triangle, i);
        if (vertex.has_pixel) corner = {vertex.pixel.column, vertex.pixel.row, corner.z};
    }
    return corners;
}

std::optional<SpannedSides> spanned_sides(const Corners& corners) {
    SpannedSides sides{corners[0], corners[1] - corners[0], corners[2] - corners[0]};
    const double length = glm::length(sides.u);
    if (!(length > 0.0)) return std::nullopt;
    sides.shadow = glm::dot(sides.u, sides.v) / length;
    sides.foot = sides.start + sides.u * (sides.shadow / length);
    sides.area = glm::length(glm::cross(sides.u, sides.v));
    const bool is_known = is_finite(sides.foot) && is_finite(sides.u) && is_finite(sides.v) &&
                          std::isfinite(sides.area);
    return is_known ? std::optional(sides) : std::nullopt;
}

VectorReport side_vectors(const Frame& frame, int triangle, std::optional<int> vertex) {
    VectorReport report;
    report.triangle = triangle;
    const Corners corners = corners_in(frame, triangle);
    const bool has_eye = frame.scene->space == SceneSpace::world;
    const auto chosen = static_cast<std::size_t>(std::clamp(vertex.value_or(0), 0, 2));
    if (has_eye) {
        add_vector(report, {VectorName::normal, corners[chosen],
                            glm::dvec3(triangle_normal(*frame.scene, triangle))});
    }
    if (has_eye && vertex) {
        const glm::dvec3 eye(frame.settings.camera.position);
        add_vector(report, {VectorName::from_eye, eye, corners[chosen] - eye});
        return report;
    }
    const glm::dvec3& start = corners[0];
    add_vector(report, {VectorName::u, start, corners[1] - start});
    add_vector(report, {VectorName::v, start, corners[2] - start});
    report.sides = spanned_sides(corners);
    return report;
}

/// The sign at the foot: a square of which the perpendicular and u are the other two sides.
void add_right_angle(const SpannedSides& sides, double angle, std::vector<OutsideArrow>& lines) {
    const glm::dvec3 up = sides.start + sides.v - sides.foot;
    const double height = glm::length(up);
    const double side = std::min({angle, 0.5 * height, 0.5 * std::abs(sides.shadow)});
    if (!(side > 0.0)) return;
    // Toward the start, where the shadow is.
    const glm::dvec3 along = sides.u * ((sides.shadow > 0.0 ? -side : side) / glm::length(sides.u));
    const glm::dvec3 above = up * (side / height);
    const glm::dvec3 middle = sides.foot + along + above;
    lines.push_back({OutsideLineKind::vector_angle, 0, sides.foot + along, middle});
    lines.push_back({OutsideLineKind::vector_angle, 0, middle, sides.foot + above});
}

void add_sides(const SpannedSides& sides, double angle, std::vector<OutsideArrow>& lines) {
    const auto [start, end, across, tip] = sides.corners();
    const auto add = [&](OutsideLineKind kind, const glm::dvec3& from, const glm::dvec3& to) {
        if (from != to) lines.push_back({kind, 0, from, to});
    };
    if (sides.area > 0.0) {
        add(OutsideLineKind::vector_opposite, end, across);
        add(OutsideLineKind::vector_opposite, tip, across);
    }
    if (sides.shadow > glm::length(sides.u)) add(OutsideLineKind::vector_dropped, end, sides.foot);
    add(OutsideLineKind::vector_shadow, start, sides.foot);
    if (sides.area > 0.0) {
        add(OutsideLineKind::vector_dropped, tip, sides.foot);
        add_right_angle(sides, angle, lines);
    }
}

/// A place on its way to the picture.
struct SeenPlace {
    glm::vec4 clip{0.0f};
    double depth = 0.0; ///< in front of the camera
};

SeenPlace seen_place(const Frame& frame, const glm::dvec3& place) {
    VertexRules rules = vertex_rules(frame);
    rules.shading = Shading::unlit; // only the place is wanted
    Vertex vertex;
    vertex.position = place;
    const glm::vec4 clip =
        frame.stages
            .vertex_shader(vertex, camera_rotation(rules.camera), rules, frame.stages, nullptr)
            .position_clip;
    return {clip, static_cast<double>(camera_depth(clip, rules))};
}

std::optional<glm::dvec2> in_picture(const Frame& frame, const SeenPlace& seen) {
    if (!(seen.clip.w > 0.0f)) return std::nullopt;
    const Stages& stages = frame.stages;
    const glm::dvec2 projected(stages.perspective_divide(seen.clip, 1.0f / seen.clip.w));
    // Positions count from the picture's corner, pixels from their middles.
    const glm::dvec2 pixel =
        projected + glm::dvec2(stages.viewport_middle(vertex_rules(frame))) - 0.5;
    return std::isfinite(pixel.x) && std::isfinite(pixel.y) ? std::optional(pixel) : std::nullopt;
}

} // namespace

VectorWords vector_words(VectorName name) {
    switch (name) {
    case VectorName::normal:
        return {"n", "normal"};
    case VectorName::unbent:
        return {"n", "normal before it is bent"};
    case VectorName::to_lamp:
        return {"l", "to the lamp"};
    case VectorName::to_eye:
        return {"v", "to the eye"};
    case VectorName::half:
        return {"h", "halfway between l and v"};
    case VectorName::tangent:
        return {"t", "tangent"};
    case VectorName::bitangent:
        return {"b", "bitangent"};
    case VectorName::u:
        return {"u", "[0] to [1]"};
    case VectorName::v:
        return {"v", "[0] to [2]"};
    case VectorName::from_eye:
        return {"p − C", "from the eye to the vertex"};
    }
    return {};
}

char letter_of(VectorName name) {
    const std::string_view symbol = vector_words(name).symbol;
    return symbol.size() == 1 ? symbol.front() : char{0};
}

bool is_direction(VectorName name) {
    return name != VectorName::u && name != VectorName::v && name != VectorName::from_eye;
}

bool is_vector_letter(char letter) {
    for (std::size_t i = 0; letter != 0 && i < enum_words<VectorName>.size(); ++i) {
        if (letter_of(static_cast<VectorName>(i)) == letter) return true;
    }
    return false;
}

std::optional<VectorReport> vector_report(const Frame& frame, const FragmentReport* fragment,
                                          std::optional<int> triangle, std::optional<int> vertex) {
    const bool is_world = frame.scene->space == SceneSpace::world;
    if (is_world && fragment != nullptr && fragment->shading != Shading::unlit)
        return light_vectors(frame, *fragment);
    if (!triangle || *triangle < 0 || *triangle >= frame.triangle_count()) return std::nullopt;
    return side_vectors(frame, *triangle, vertex);
}

std::string length_words(const ShownVector& vector, SceneSpace space) {
    const double length = glm::length(vector.along);
    if (is_direction(vector.name)) {
        // Made unit length in float.
        constexpr double rounding = 1e-5;
        const bool is_unit = std::abs(length - 1.0) < rounding;
        return "length " + (is_unit ? std::string("1") : decimals(length, 3));
    }
    return space == SceneSpace::pixels ? decimals(length, 2) + " pixels"
                                       : decimals(length, 3) + " world units";
}

std::vector<OutsideArrow> vector_lines(const VectorReport& report, double unit, double angle) {
    std::vector<OutsideArrow> lines;
    if (report.sides) add_sides(*report.sides, angle, lines);
    for (const ShownVector& vector : report.vectors) {
        const double scale = is_direction(vector.name) ? unit : 1.0;
        lines.push_back({OutsideLineKind::vector, static_cast<int>(vector.name), vector.from,
                         vector.from + scale * vector.along});
    }
    return lines;
}

std::optional<PictureLine> line_in_picture(const Frame& frame, const glm::dvec3& from,
                                           const glm::dvec3& to) {
    if (frame.scene->space == SceneSpace::pixels)
        return PictureLine{glm::dvec2(from), glm::dvec2(to)};
    SeenPlace a = seen_place(frame, from), b = seen_place(frame, to);
    const double near = static_cast<double>(frame.settings.near);
    const bool is_a_seen = a.depth >= near, is_b_seen = b.depth >= near;
    if (!is_a_seen && !is_b_seen) return std::nullopt;
    if (!is_a_seen || !is_b_seen) {
        const glm::dvec3 place = glm::mix(from, to, (near - a.depth) / (b.depth - a.depth));
        (is_a_seen ? b : a) = seen_place(frame, place);
    }
    const std::optional<glm::dvec2> begin = in_picture(frame, a), end = in_picture(frame, b);
    if (!begin || !end) return std::nullopt;
    return PictureLine{*begin, *end, !is_a_seen, !is_b_seen};
}

double pixels_per_unit(const Frame& frame, const glm::dvec3& place) {
    if (frame.scene->space == SceneSpace::pixels) return 1.0;
    const SeenPlace seen = seen_place(frame, place);
    if (!(seen.depth >= static_cast<double>(frame.settings.near)) || !(seen.clip.w > 0.0f))
        return 0.0;
    const VertexRules rules = vertex_rules(frame);
    const PictureScale picture = picture_scale(static_cast<double>(rules.camera.focal_length),
                                               rules.viewport, rules.projection);
    return std::abs(picture.scale.x) / static_cast<double>(seen.clip.w);
}

} // namespace rasterwalk
