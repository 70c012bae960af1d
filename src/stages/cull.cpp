#include "stages/cull.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "stages/fan.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// How a way of culling puts its answer in words.
struct CullWords {
    std::string_view measure, front, back;
};

CullWords face_words(const SightRays& rays) {
    return {sight_measure(rays), "the normal points to the camera's side",
            "the normal points away from the camera"};
}

CullWords corner_words(const SightRays& rays) {
    return {sight_measure(rays), "not every normal points away from the camera",
            "the normals of all corners point away from the camera"};
}

constexpr CullWords area_words{"area times w", "its corners go round clockwise on the screen",
                               "its corners go round counterclockwise on the screen"};

/// @param test receives words and answer, or null; it already has the values
Rejection back_facing_if(bool is_back, const CullWords& words, CullTest* test) {
    if (test != nullptr) {
        test->measure = words.measure;
        test->reason = is_back ? words.back : words.front;
        test->is_back = is_back;
    }
    return is_back ? Rejection::back_facing : Rejection::none;
}

} // namespace

SightRays sight_rays(const VertexRules& rules) {
    // In a row vector times R, z is the product with the last column.
    return {rules.camera.position, camera_rotation(rules.camera)[2], rules.projection.mix};
}

float away_from_camera(const Varyings& varyings, const SightRays& rays) {
    return glm::dot(varyings.normal, sight_ray(varyings.position_world, rays));
}

std::string_view sight_measure(const SightRays& rays) {
    if (rays.mix == 0.0f) return "dot(n, p - C)";
    return rays.mix == 1.0f ? "dot(n, forward)" : "dot(n, (1 - mix) (p - C) + mix forward)";
}

float screen_area_sign(std::span<const ClipVertex> corners, const VertexRules& rules) {
    const bool is_divided = rules.space == SceneSpace::pixels;
    const auto row = [is_divided](const ClipVertex& v) {
        const glm::vec4& clip = v.position_clip;
        return glm::vec3(clip.x, clip.y, is_divided ? 1.0f : clip.w);
    };
    float sum = 0.0f;
    for_each_fan_corners(corners.size(), [&](std::size_t a, std::size_t b, std::size_t c) {
        sum += glm::dot(row(corners[a]), glm::cross(row(corners[b]), row(corners[c])));
    });
    return sum;
}

Varyings as_one_face(std::span<const ClipVertex> corners) {
    Varyings face = corners.front().varyings;
    const bool is_bent = std::any_of(corners.begin(), corners.end(), [&](const ClipVertex& v) {
        return v.varyings.normal != face.normal;
    });
    if (!is_bent) return face;
    // Newell's sum, so three corners in a line, which clipping can leave, do no harm.
    glm::vec3 across(0.0f);
    for_each_fan_corners(corners.size(), [&](std::size_t, std::size_t last, std::size_t next) {
        across += glm::cross(corners[next].varyings.position_world - face.position_world,
                             corners[last].varyings.position_world - face.position_world);
    });
    const float length = glm::length(across);
    face.normal = length > 0.0f ? across / length : across;
    return face;
}

Rejection cull_by_face_normal(std::span<const ClipVertex> corners, const VertexRules& rules,
                              const SightRays& rays, CullTest* test) {
    static_cast<void>(rules);
    const float away = away_from_camera(as_one_face(corners), rays);
    if (test != nullptr) test->values = {away};
    return back_facing_if(away > 0.0f, face_words(rays), test);
}

Rejection cull_by_screen_area(std::span<const ClipVertex> corners, const VertexRules& rules,
                              const SightRays& rays, CullTest* test) {
    static_cast<void>(rays);
    const auto is_in_front = [](const ClipVertex& v) { return v.position_clip.w > 0.0f; };
    if (rules.space == SceneSpace::world &&
        !std::all_of(corners.begin(), corners.end(), is_in_front)) {
        if (test != nullptr) test->reason = "a corner lies behind the camera";
        return Rejection::none;
    }
    const float area = screen_area_sign(corners, rules);
    if (test != nullptr) test->values = {area};
    return back_facing_if(area < 0.0f, area_words, test);
}

Rejection cull_by_vertex_normals(std::span<const ClipVertex> corners, const VertexRules& rules,
                                 const SightRays& rays, CullTest* test) {
    static_cast<void>(rules);
    const auto is_away = [&rays](const ClipVertex& v) {
        return away_from_camera(v.varyings, rays) > 0.0f;
    };
    if (test != nullptr) {
        test->values.clear();
        for (const ClipVertex& corner : corners)
            test->values.push_back(away_from_camera(corner.varyings, rays));
    }
    return back_facing_if(std::all_of(corners.begin(), corners.end(), is_away), corner_words(rays),
                          test);
}

bool cull_by_fragment_normal(const Fragment& fragment, const SightRays& rays,
                             const Stages& stages) {
    return away_from_camera(recover_varyings(fragment, stages), rays) > 0.0f;
}

} // namespace rasterwalk
