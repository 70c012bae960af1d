#include "stages/surface_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

SurfacePoint on_lit_side(SurfacePoint point, const SightRays& rays, const Stages& stages) {
    point.normal = stages.light_side(point.position_world, point.normal, rays) * point.normal;
    return point;
}

SurfaceLight surface_light(const SurfacePoint& point, const Light& light, const SightRays& rays,
                           const Occluders* occluders, const Stages& stages) {
    SurfaceLight result;
    // In its own space the point is the origin.
    const glm::vec3 place = point.space ? glm::vec3(0.0f) : point.position_world;
    const glm::vec3& normal = point.space ? point.space->normal : point.normal;
    Light arriving = light;
    if (point.space)
        arriving.position = along_axes(light.position - point.position_world, point.space->axes);
    result.diffuse = stages.reflected_light(place, normal, point.reflectance, arriving);
    // No light comes from behind, whatever is there.
    if (occluders != nullptr && result.diffuse.cosine > 0.0f) {
        result.shadow = stages.shadow(
            {point.position_world, point.normal, light.position, result.diffuse.cosine}, *occluders,
            stages);
        if (result.shadow.is_dark()) {
            arriving.power = light.power * result.shadow.lit;
            result.diffuse = stages.reflected_light(place, normal, point.reflectance, arriving);
        }
    }
    result.reflected = result.diffuse.reflected;
    if (light.model == LightModel::lambert) return result;
    const glm::vec3 to_eye = -sight_ray(point.position_world, rays);
    result.highlight =
        stages.highlight(result.diffuse,
                         {normal,
                          point.space ? along_axes(to_eye, point.space->axes) : to_eye,
                          {point.shine.specular, exponent_of(point.shine, light)}},
                         arriving.power);
    result.reflected = result.reflected + result.highlight.reflected;
    return result;
}

glm::vec3 reflectance_at(const Fragment& fragment, const Surface& surface, const Stages& stages) {
    if (!surface.differences.colours) return surface.reflectance;
    return fragment.varyings.colour / weight_of(fragment, stages);
}

SurfacePoint surface_point(const Fragment& fragment, const Surface& surface, const Camera& camera,
                           const Stages& stages) {
    // Only the varyings that are read are divided.
    const float weight = weight_of(fragment, stages);
    return {fragment.varyings.position_world / weight,
            surface_normal(fragment, surface, camera, stages),
            reflectance_at(fragment, surface, stages), surface.shine};
}

SurfacePoint lit_point(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages) {
    SurfacePoint point = surface_point(fragment, surface, rules.camera, stages);
    point.reflectance = textured(point.reflectance, fragment, surface, rules, stages);
    // The surface decides which side it is, not its bumps: from behind, a bump is a dent.
    const float side = stages.light_side(point.position_world, point.normal, rules.rays);
    if (surface.normal_map != nullptr)
        point = mapped_point(point, fragment, surface, rules, stages);
    point.normal = side * point.normal;
    if (point.space) point.space->normal = side * point.space->normal;
    return point;
}

glm::vec3 normal_map_colour(const Fragment& fragment, const Surface& surface,
                            const PixelRules& rules, const Stages& stages, SampledTexels* taken) {
    return stages.sample_texture(*surface.normal_map,
                                 place_in_texture(fragment, surface, rules, stages), stages, taken);
}

SurfacePoint mapped_point(SurfacePoint point, const Fragment& fragment, const Surface& surface,
                          const PixelRules& rules, const Stages& stages) {
    const glm::vec3 arrow =
        stages.arrow_of_texel(normal_map_colour(fragment, surface, rules, stages, nullptr));
    const TangentFrame axes = stages.tangent_frame(surface.uv_directions, point.normal);
    point.normal = bent_normal(arrow, axes);
    point.space = stages.light_space(arrow, axes);
    return point;
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
    switch (rules.shading) {
    case Shading::unlit:
        return textured(reflectance_at(fragment, surface, stages), fragment, surface, rules,
                        stages);
    case Shading::flat:
        return textured(surface.flat_light, fragment, surface, rules, stages);
    case Shading::gouraud:
        break;
    case Shading::phong:
        return surface_light(lit_point(fragment, surface, rules, stages), rules.light, rules.rays,
                             rules.occluders, stages)
            .reflected;
    }
    return pixel_shader(fragment, surface, rules, stages);
}

} // namespace rasterwalk
