#include "stages/surface_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

SurfaceLight surface_light(const SurfacePoint& point, const Light& light, const SightRays& rays,
                           const Stages& stages) {
    SurfaceLight result;
    result.diffuse =
        stages.reflected_light(point.position_world, point.normal, point.reflectance, light);
    result.reflected = result.diffuse.reflected;
    if (light.model == LightModel::lambert) return result;
    result.highlight = stages.highlight(
        result.diffuse, {point.normal, -sight_ray(point.position_world, rays), point.shine},
        light.power);
    result.reflected = result.reflected + result.highlight.reflected;
    return result;
}

SurfacePoint surface_point(const Varyings& varyings, const Surface& surface, const Camera& camera,
                           const Stages& stages) {
    SurfacePoint point{varyings.position_world, surface.normal, surface.reflectance, surface.shine};
    if (surface.differences.normals)
        point.normal = stages.light_normal(stages.unit_normal(varyings.normal), camera);
    if (surface.differences.colours) point.reflectance = varyings.colour;
    return point;
}

glm::vec3 normal_map_colour(const Fragment& fragment, const Surface& surface, const Stages& stages,
                            TakenTexels* taken) {
    return stages.sample_texture(*surface.normal_map, place_in_texture(fragment, surface, stages),
                                 stages, taken);
}

glm::vec3 mapped_normal(const glm::vec3& normal, const Fragment& fragment, const Surface& surface,
                        const Stages& stages) {
    return bent_normal(stages.arrow_of_texel(normal_map_colour(fragment, surface, stages, nullptr)),
                       stages.tangent_frame(surface.uv_directions, normal));
}

SurfacePoint middle_point(const std::array<Vertex, triangle_corners>& corners,
                          const glm::vec3& normal) {
    const auto mean = [&](glm::vec3 Vertex::*member) {
        const glm::vec3 &a = corners[0].*member, &b = corners[1].*member, &c = corners[2].*member;
        return a == b && a == c ? a : (a + b + c) / 3.0f;
    };
    return {mean(&Vertex::position), normal, mean(&Vertex::reflectance), corners[0].shine};
}

glm::vec3 surface_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                         const Stages& stages) {
    const float weight = call<varying_weight>(stages.varying_weight, fragment.inv_w);
    switch (rules.shading) {
    case Shading::unlit:
        break;
    case Shading::flat:
        return textured(surface.flat_light, fragment, surface, stages);
    case Shading::gouraud:
        return textured(fragment.varyings.illumination / weight, fragment, surface, stages);
    case Shading::phong: {
        // Only what is read is divided.
        Varyings varyings;
        varyings.position_world = fragment.varyings.position_world / weight;
        if (surface.differences.normals) varyings.normal = fragment.varyings.normal / weight;
        if (surface.differences.colours) varyings.colour = fragment.varyings.colour / weight;
        SurfacePoint point = surface_point(varyings, surface, rules.camera, stages);
        point.reflectance = textured(point.reflectance, fragment, surface, stages);
        if (surface.normal_map != nullptr)
            point.normal = mapped_normal(point.normal, fragment, surface, stages);
        return surface_light(point, rules.light, rules.rays, stages).reflected;
    }
    }
    return textured(surface.differences.colours ? fragment.varyings.colour / weight
                                                : surface.reflectance,
                    fragment, surface, stages);
}

} // namespace rasterwalk
