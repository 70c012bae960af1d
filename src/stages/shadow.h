#pragma once

// Shadow: how much of the lamp's light arrives at a point.
//
// In:  a point of a surface that faces the lamp, the lamp, and what may be in between.
// Out: the share of the lamp's power that arrives, and what keeps the rest away.
// Picture: look from the point to the lamp. A ray does just that. For a map the lamp has looked
//          first, all around, and has noted how far it sees in each direction: anything farther
//          away than that is in shadow.
//
// A point in floats is not the exact one but one close by, above or below the surface. So a ray
// begins a little above the surface, by `offset`; and a map is compared with a `bias`, a distance
// too small to count, because all points that fall in one texel are compared with one depth.
//
// The classic mistakes: no bias, and a surface shades itself in stripes (acne); too much of it, and
// shadows come loose from whatever casts them (peter panning); a ray that goes on beyond the lamp.
//
// Source: by ray A. Appel, "Some Techniques for Shading Machine Renderings of Solids", AFIPS 1968;
// by map L. Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978; the mean of
// several comparisons (PCF) W. T. Reeves, D. H. Salesin, R. L. Cook, "Rendering Antialiased Shadows
// with Depth Maps", SIGGRAPH 1987.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "stages/triangle_tree.h"

namespace rasterwalk {

struct Stages;

/// The rules for finding what is in between.
struct ShadowRules {
    float offset = 0.001f;   ///< of a ray's start from the surface, world units
    float bias = 0.05f;      ///< of a map: how far beyond the depth it saw a point is still lit
    float slope_bias = 0.0f; ///< added to the bias: texels times the tangent of the light's slant

    friend bool operator==(const ShadowRules&, const ShadowRules&) = default;
};

/// The six faces of the cube around the lamp, by the axis of the world that each looks along.
inline constexpr int shadow_face_count = 6;
inline constexpr std::array<glm::vec3, shadow_face_count> shadow_face_directions{
    {{1.0f, 0.0f, 0.0f},
     {-1.0f, 0.0f, 0.0f},
     {0.0f, 1.0f, 0.0f},
     {0.0f, -1.0f, 0.0f},
     {0.0f, 0.0f, 1.0f},
     {0.0f, 0.0f, -1.0f}}};
inline constexpr std::array<const char*, shadow_face_count> shadow_face_names{"+x", "−x", "+y",
                                                                              "−y", "+z", "−z"};

/// What the lamp sees in the direction of one face: a depth buffer.
struct ShadowFace {
    glm::mat3 axes{1.0f};         ///< columns: right, down and forward in the world
    std::vector<float> inv_depth; ///< 1/z of each texel, row by row; 0: nothing is there
};

/// The depth that the lamp sees all around.
struct ShadowMap {
    glm::vec3 lamp{0.0f}; ///< where it was when the map was drawn
    int resolution = 0;   ///< texels along each side of a face
    std::array<ShadowFace, shadow_face_count> faces;
};

/// What may be between a point and the lamp. A ray needs only the triangles, a lookup in the
/// map only the map.
struct Occluders {
    std::shared_ptr<const TriangleTree> triangles;
    std::shared_ptr<const ShadowMap> map;
    ShadowRules rules;
};

/// A point to be tested. It faces the lamp.
struct ShadowPoint {
    glm::vec3 position_world{0.0f};
    glm::vec3 normal{0.0f}; ///< of unit length
    glm::vec3 lamp{0.0f};   ///< world
    float cosine = 1.0f;    ///< how slanted the light falls, above 0
};

/// One comparison with a texel of the map.
struct ShadowTexel {
    int column = 0, row = 0;
    float inv_depth = 0.0f; ///< 1/z of the surface the lamp saw there; 0: none
    bool is_lit = true;
};

/// The most texels that one point is compared with.
inline constexpr int most_shadow_texels = 4;

/// Every number on the way to the share of light.
struct ShadowTerms {
    bool is_tested = false; ///< false: nothing casts a shadow, or the point faces away
    ShadowPoint point{};    ///< the point tested
    float lit = 1.0f;       ///< the share of the lamp's power that arrives, 0..1
    // By ray:
    WorldRay ray{};
    TriangleHit hit{}; ///< the first triangle in between
    // By map:
    int face = -1;             ///< in which the point lies; -1: no map is used
    glm::vec3 from_face{0.0f}; ///< the point from the lamp: right, down and forward of that face
    glm::vec2 place{0.0f};     ///< the same in texels from the left and from the top
    float bias = 0.0f;         ///< the one used here
    float compared = 0.0f;     ///< its depth minus the bias: dark if the lamp saw something nearer
    std::array<ShadowTexel, most_shadow_texels> texels{};
    int texel_count = 0;

    bool is_dark() const { return lit < 1.0f; }
};

/// The stretch to be tested: from a little above the surface to the lamp, and no farther.
inline WorldRay shadow_ray(const ShadowPoint& point, float offset) {
    const glm::vec3 from = point.position_world + offset * point.normal;
    return {from, point.lamp - from, 1.0f};
}

/// Nothing casts a shadow: the lab.
ShadowTerms no_shadow(const ShadowPoint& point, const Occluders& occluders, const Stages& stages);

/// Tests the triangles of the scene. Needs Occluders::triangles.
ShadowTerms shadow_by_ray(const ShadowPoint& point, const Occluders& occluders,
                          const Stages& stages);

/// Uses the map. Needs Occluders::map.
ShadowTerms shadow_by_map(const ShadowPoint& point, const Occluders& occluders,
                          const Stages& stages);

/// The tangent of the slant of light, by which slope_bias is multiplied. For light nearly along the
/// surface it would grow without limit, and there is hardly any light: below a cosine of 0.01 it
/// keeps the value that it has there.
float shadow_slope(float cosine);

/// The face of a map in which a direction from the lamp lies: that of its largest component.
int shadow_face_of(const glm::vec3& from_lamp);

/// Where a point in the space of a face falls, in texels from the left and from the top. Like the
/// drawing of the face, this has a focal length of half a side, so that it sees 90 degrees.
/// @param seen right, down, forward; forward above 0
glm::vec2 shadow_place(const glm::vec3& from_face, int resolution);

/// Which texels a point is compared with: writes them to `texels`.
/// @return how many
using ShadowTexels = std::array<glm::ivec2, most_shadow_texels>;
/// The one in which it lies.
int nearest_shadow_texel(const glm::vec2& place, int resolution, ShadowTexels& texels);
/// The four around it. At the border of a face, texels inside it replace those beyond.
int four_shadow_texels(const glm::vec2& place, int resolution, ShadowTexels& texels);

} // namespace rasterwalk
