#include "engines/rays/ray_tracer.h"

#include <limits>

#include <glm/geometric.hpp>

#include "engines/refusal.h"
#include "pipeline/surface.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// A mirrored ray begins this far from its surface, world units, or it could meet that first.
constexpr float mirror_offset = 1e-3f;

/// Does clipping cut what is nearer than the near plane, or beyond the far one?
bool cuts_near(Clip clip) {
    return clip == Clip::near || clip == Clip::all || clip == Clip::guard_band;
}
bool cuts_far(Clip clip) {
    return clip == Clip::all || clip == Clip::guard_band;
}

/// The most tests of rays against triangles for a picture without boxes: some minutes.
constexpr double most_tests_without_boxes = 2e10;

} // namespace

std::string rays_refuse(const Scene& scene, const Settings& settings) {
    if (scene.space != SceneSpace::world) return "rays need a scene in the world, not in pixels";
    const auto unknown = [](std::string_view what) {
        return "rays do not support " + std::string(what);
    };
    if (settings.stage < Stage::depth) return unknown("stages before depth");
    if (const std::string what = only_steps_have(scene, settings); !what.empty())
        return unknown(what);
    if (settings.cull == Cull::fragment_normal) return unknown("cull=fragment_normal");
    if (settings.clip == Clip::none) return unknown("clip=none");
    const double tests = static_cast<double>(settings.viewport.width) * settings.viewport.height *
                         scene.triangle_count();
    if (settings.ray_boxes == TreeBoxes::one && tests > most_tests_without_boxes)
        return unknown("ray_boxes=one with so many triangles and pixels");
    return {};
}

RayTracer::RayTracer(const Frame& frame, const TriangleTree& tree)
    : frame_(frame), tree_(tree), axes_(camera_rotation(frame.settings.camera)),
      middle_(frame.stages.viewport_middle(vertex_rules(frame.settings, frame.scene->space))),
      rules_(pixel_rules(frame)), end_(infinite) {
    const Settings& settings = frame.settings;
    if (cuts_near(settings.clip)) begin_ = settings.near;
    if (cuts_far(settings.clip)) end_ = settings.far - begin_;
    are_drawn_.reserve(static_cast<std::size_t>(frame.triangle_count()));
    for (int t = 0; t < frame.triangle_count(); ++t)
        are_drawn_.push_back(frame.is_drawn(t) ? 1 : 0);
}

WorldRay RayTracer::ray_of(int column, int row) const {
    const Camera& camera = frame_.settings.camera;
    constexpr float to_centre = 0.5f;
    const float right = (static_cast<float>(column - middle_.x) + to_centre) / camera.focal_length;
    const float down = (static_cast<float>(row - middle_.y) + to_centre) / camera.focal_length;
    const glm::vec3 direction = axes_ * glm::vec3(right, down, 1.0f);
    return {camera.position + begin_ * direction, direction, end_};
}

Fragment RayTracer::fragment_at(const TriangleHit& hit) const {
    const std::array corners = frame_.given_clip_vertices(hit.triangle);
    const float first = 1.0f - hit.u - hit.v;
    const glm::vec4 clip = first * corners[0].position_clip + hit.u * corners[1].position_clip +
                           hit.v * corners[2].position_clip;
    Fragment fragment;
    fragment.inv_w = 1.0f / clip.w;
    fragment.depth = clip.z * fragment.inv_w;
    fragment.z = clip.w;
    // The pixel shader expects them with the weight that rows give them.
    fragment.varyings =
        (corners[0].varyings * first + corners[1].varyings * hit.u + corners[2].varyings * hit.v) *
        call<varying_weight>(frame_.stages.varying_weight, fragment.inv_w, frame_.stages);
    return fragment;
}

const Surface& RayTracer::surface_at(int triangle) {
    if (surface_triangle_ != triangle) surface_ = lit_surface_of(frame_, triangle);
    surface_triangle_ = triangle;
    return surface_;
}

RayPixel RayTracer::trace(int column, int row) {
    const WorldRay ray = ray_of(column, row);
    const TriangleHit hit = tree_.first_hit(ray, {&are_drawn_, &count_});
    if (!hit.is_hit()) return {-1, farthest_depth(depth_kind(frame_)), glm::vec3(0.0f)};
    const Fragment fragment = fragment_at(hit);
    const Surface& surface = surface_at(hit.triangle);
    const glm::vec3 own = frame_.stages.pixel_shader(fragment, surface, rules_, frame_.stages);
    return {hit.triangle, fragment.depth, own + mirrored(ray, hit, surface, 0)};
}

/// What a surface adds to its own colour if it is a mirror.
/// @param mirrors that the ray has met before
glm::vec3 RayTracer::mirrored(const WorldRay& ray, const TriangleHit& hit, const Surface& surface,
                              int mirrors) {
    const bool is_mirror =
        frame_.settings.mirrors == Mirrors::on && !is_invisible(surface.shine.specular);
    if (!is_mirror || mirrors == most_mirrors) return glm::vec3(0.0f);
    const SurfacePoint point =
        surface_point(fragment_at(hit), surface, frame_.settings.camera, frame_.stages);
    const float away = glm::dot(ray.direction, point.normal);
    const glm::vec3 direction = ray.direction - 2.0f * away * point.normal;
    const float side = away < 0.0f ? mirror_offset : -mirror_offset;
    const WorldRay next{point.position_world + side * point.normal, direction, infinite};
    // Whatever the camera cannot see can still be seen in a mirror.
    const TriangleHit seen = tree_.first_hit(next, {nullptr, &count_});
    if (!seen.is_hit()) return glm::vec3(0.0f);
    Surface seen_surface = lit_surface_of(frame_, seen.triangle);
    seen_surface.texture_slope = {}; // it holds for the screen
    PixelRules rules = rules_;
    rules.rays.camera = next.from;
    const glm::vec3 colour =
        frame_.stages.pixel_shader(fragment_at(seen), seen_surface, rules, frame_.stages) +
        mirrored(next, seen, seen_surface, mirrors + 1);
    return surface.shine.specular * colour;
}

} // namespace rasterwalk
