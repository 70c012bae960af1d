#include "pipeline/surface.h"

namespace rasterwalk {

glm::vec3 triangle_normal(const Scene& scene, int triangle) {
    const std::array<Vertex, triangle_corners> corners = corners_of(scene, triangle);
    return scene.mesh.differences(triangle).normals
               ? face_normal(corners[0].position, corners[1].position, corners[2].position)
               : corners[0].normal;
}

glm::vec3 flat_normal(const Frame& frame, int triangle) {
    return frame.stages.light_normal(triangle_normal(*frame.scene, triangle),
                                     frame.settings.camera);
}

SurfacePoint flat_point(const Frame& frame, int triangle) {
    return on_lit_side(
        middle_point(corners_of(*frame.scene, triangle), flat_normal(frame, triangle)),
        pixel_rules(frame).rays, frame.stages);
}

namespace {

/// From a sample to the next: half as far as from a pixel to the next.
TextureSlope half_slope(const TextureSlope& slope) {
    return {slope.texcoord_right / 2.0f, slope.texcoord_down / 2.0f, slope.weight_right / 2.0f,
            slope.weight_down / 2.0f};
}

} // namespace

Surface surface_of(const Frame& frame, int triangle) {
    const Vertex& corner = frame.scene->corner(triangle, 0);
    Surface surface{frame.stages.light_normal(corner.normal, frame.settings.camera),
                    corner.reflectance};
    if (frame.blends) surface.alpha = alpha_rule(frame.settings, *frame.scene, triangle);
    if (is_textured(frame)) surface.texture = texture_of(*frame.scene, triangle);
    if (surface.texture != nullptr && surface.texture->has_alpha())
        surface.texture_alpha = texture_alpha_rule(frame);
    if (frame.bends) surface.normal_map = normal_map_of(*frame.scene, triangle);
    const bool has_map = surface.texture != nullptr || surface.normal_map != nullptr;
    const HeightMap* const heights =
        frame.shifts && has_map ? height_map_of(*frame.scene, triangle) : nullptr;
    if (heights != nullptr) {
        const auto index = static_cast<std::size_t>(heights->texture);
        surface.heights = {&*frame.scene->textures[index], heights->scale, heights->bias};
    }
    if (surface.normal_map != nullptr || heights != nullptr)
        surface.uv_directions = uv_directions(corners_of(*frame.scene, triangle));
    if (has_map)
        surface.texture_slope = texture_slope(frame.triangle_vertices(triangle), frame.stages);
    if (frame.has_samples() && sampling_rule(frame.settings) == Sampling::supersample)
        surface.texture_slope = half_slope(surface.texture_slope);
    if (frame.stages.pixel_shader == pixel_shader) return surface;
    surface.shine = corner.shine;
    surface.differences = frame.scene->mesh.differences(triangle);
    if (shading_rule(frame.settings) == Shading::flat) {
        const PixelRules rules = pixel_rules(frame);
        surface.flat_light = surface_light(flat_point(frame, triangle), rules.light, rules.rays,
                                           rules.occluders, frame.stages)
                                 .reflected;
    }
    return surface;
}

Surface lit_surface_of(const Frame& frame, int triangle) {
    Surface surface = surface_of(frame, triangle);
    surface.shine = frame.scene->corner(triangle, 0).shine;
    surface.differences = frame.scene->mesh.differences(triangle);
    return surface;
}

} // namespace rasterwalk
