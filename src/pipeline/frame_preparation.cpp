#include "pipeline/frame_preparation.h"

#include <algorithm>

#include "pipeline/shadow_pass.h"
#include "scene/tessellation.h"

namespace rasterwalk {

namespace {

/// The cost of a vertex and a triangle, relative to a fragment. Most of a vertex's is its memory,
/// if that is newly allocated.
constexpr double vertex_preparation = 25;
constexpr double triangle_preparation = 40;

/// Takes the scene itself, or its tessellation, in the scene's order. A tessellation is kept as
/// long as it is the same: while the camera moves, nothing is divided again.
void take_scene(const Scene& scene, int tessellation, Frame& frame) {
    const int parts = tessellation_of(scene, tessellation);
    const TessellatedScene* const known = frame.tessellated.get();
    if (parts == 1) {
        frame.tessellated = nullptr;
    } else if (known == nullptr || known->parts != parts || !(known->given == scene)) {
        frame.tessellated = std::make_shared<const TessellatedScene>(
            TessellatedScene{scene, parts, tessellate(scene, parts)});
    }
    frame.given = &scene;
    frame.pass = 0;
    frame.in_order = parts == 1 ? &scene : &frame.tessellated->made;
}

/// Is the picture of the frame to be divided into squares?
bool is_divided(const Frame& frame) {
    return hidden_rule(frame.settings) == Hidden::warnock && frame.scene != nullptr &&
           frame.scene->space == SceneSpace::world;
}

/// Puts its triangles in the order in which they are drawn.
void take_list(Frame& frame) {
    frame.list = make_drawn_list(*frame.in_order, frame.settings, frame.stages, frame.divided);
    frame.scene = frame.list == nullptr ? frame.in_order : &frame.list->scene;
}

} // namespace

FramePreparation::FramePreparation(const Mesh& mesh, const VertexRules& rules, Frame& frame)
    : mesh_(&mesh), frame_(&frame), volume_(rules), rays_(sight_rays(rules)),
      rotation_(camera_rotation(rules.camera)),
      asks_corners_(frame.stages.reject != reject_nothing || frame.stages.clip != clip_nothing ||
                    frame.stages.cull != cull_nothing),
      needs_squares_(is_divided(frame)) {
    frame.triangles = mesh.triangles();
    frame.shaded.clear();
    frame.projected.clear();
    frame.vertices.clear();
    frame.polygons.clear();
    frame.squares = nullptr;
    frame.shaded.reserve(mesh.vertices().size());
    frame.projected.reserve(mesh.vertices().size());
    frame.polygons.reserve(mesh.triangles().size());
}

bool FramePreparation::is_done() const {
    return !needs_squares_ && frame_->projected.size() == mesh_->vertices().size() &&
           frame_->polygons.size() == mesh_->triangles().size();
}

double FramePreparation::work() const {
    return vertex_preparation * static_cast<double>(mesh_->vertices().size()) +
           triangle_preparation * static_cast<double>(mesh_->triangles().size()) +
           (needs_squares_ ? squares_work(*frame_) : 0.0);
}

void FramePreparation::advance(const WorkLimit& limit) {
    const double part = limit.of(work());
    const auto count_of = [&](double work, double each, std::size_t left) {
        const double share = std::clamp(work / each, 1.0, static_cast<double>(left) + 1.0);
        return std::min(static_cast<std::size_t>(share), left);
    };
    const std::size_t vertices =
        count_of(part, vertex_preparation, mesh_->vertices().size() - frame_->projected.size());
    shade_vertices(vertices);
    if (frame_->projected.size() < mesh_->vertices().size()) return;
    const double left = part - vertex_preparation * static_cast<double>(vertices);
    make_polygons(
        count_of(left, triangle_preparation, mesh_->triangles().size() - frame_->polygons.size()));
    const bool has_polygons = frame_->polygons.size() == mesh_->triangles().size();
    // How much work the squares are is a guess, so they are bounded by the size of a part.
    if (needs_squares_ && has_polygons) make_squares(limit.slice);
}

void FramePreparation::make_squares(double work) {
    if (!squares_) squares_.emplace(*frame_);
    squares_->advance(work);
    if (!squares_->is_done()) return;
    frame_->squares = squares_->take();
    squares_ = std::nullopt;
    needs_squares_ = false;
}

void FramePreparation::shade_vertices(std::size_t count) {
    const Stages& stages = frame_->stages;
    const VertexRules& rules = volume_.rules;
    for (std::size_t end = frame_->projected.size() + count; frame_->projected.size() < end;) {
        const Vertex& vertex = mesh_->vertices()[frame_->projected.size()];
        frame_->shaded.push_back(stages.vertex_shader(vertex, rotation_, rules, stages, nullptr));
        frame_->projected.push_back(stages.project(frame_->shaded.back(), rules, stages, nullptr));
    }
}

void FramePreparation::make_polygons(std::size_t count) {
    for (std::size_t end = frame_->polygons.size() + count; frame_->polygons.size() < end;)
        frame_->polygons.push_back(make(static_cast<int>(frame_->polygons.size())));
}

/// Reject, clip, cull and project. The corners of a cut polygon are appended to the frame's.
Polygon FramePreparation::make(int triangle) {
    Polygon polygon{static_cast<int>(frame_->vertices.size()), 0, Rejection::none, false};
    if (asks_corners_) {
        clip(triangle, polygon);
        if (polygon.rejection == Rejection::none)
            polygon.rejection = frame_->stages.cull(corners_, volume_.rules, rays_, nullptr);
    }
    if (!polygon.is_cut) {
        for (int corner = 0; corner < triangle_corners; ++corner)
            count(frame_->given_vertex(triangle, corner), polygon);
        return polygon;
    }
    for (const ClipVertex& corner : corners_) {
        const ProjectedVertex projected =
            frame_->stages.project(corner, volume_.rules, frame_->stages, nullptr);
        count(projected, polygon);
        frame_->vertices.push_back(projected.pixel);
    }
    return polygon;
}

void FramePreparation::clip(int triangle, Polygon& polygon) {
    const auto given = frame_->given_clip_vertices(triangle);
    corners_.assign(given.begin(), given.end());
    polygon.rejection = frame_->stages.reject(corners_, volume_);
    if (polygon.rejection != Rejection::none) return;
    const Clipped clipped = frame_->stages.clip(corners_, volume_, nullptr);
    polygon.rejection = clipped.rejection;
    if (corners_.size() < least_corners) polygon.rejection = Rejection::clipped_away;
    // A triangle that is not drawn is shown as it is in the scene.
    polygon.is_cut = clipped.is_cut && polygon.rejection == Rejection::none;
}

void FramePreparation::count(const ProjectedVertex& corner, Polygon& polygon) {
    if (polygon.rejection == Rejection::none) polygon.rejection = corner.rejection;
    ++polygon.count;
}

FramePreparation begin_frame(const Scene& scene, const Settings& settings,
                             const ReplaceStages& replace, Frame& frame) {
    take_scene(scene, settings.tessellation, frame);
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, *frame.in_order, replace);
    take_list(frame);
    const Mesh& mesh = frame.scene->mesh;
    const bool blends_textures = settings.texture_alpha == TextureAlpha::blend &&
                                 is_textured(frame) && has_texture_alpha(*frame.scene);
    frame.blends =
        frame.stages.blend != blend_nothing && (has_alpha(*frame.scene) || blends_textures);
    frame.bends = bends_normals(settings) && has_normal_map(*frame.scene);
    frame.shifts = shifts_textures(settings) && has_height_map(*frame.scene);
    take_occluders(frame);
    return {mesh, vertex_rules(frame), frame};
}

} // namespace rasterwalk
