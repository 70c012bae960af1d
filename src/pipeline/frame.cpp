#include "pipeline/frame.h"

#include <utility>

#include "scene/tessellation.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const Scene& scene, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings, scene);
    if (replace) replace(stages);
    return stages;
}

namespace {

/// Shades and projects the vertices of the mesh: once a vertex, however many triangles meet in it.
void shade_vertices(const Mesh& mesh, const VertexRules& rules, Frame& frame) {
    frame.triangles = mesh.triangles();
    frame.shaded.clear();
    frame.projected.clear();
    frame.shaded.reserve(mesh.vertices().size());
    frame.projected.reserve(mesh.vertices().size());
    const glm::mat3 rotation = camera_rotation(rules.camera);
    for (const Vertex& vertex : mesh.vertices()) {
        frame.shaded.push_back(
            frame.stages.vertex_shader(vertex, rotation, rules, frame.stages, nullptr));
        frame.projected.push_back(
            frame.stages.project(frame.shaded.back(), rules, frame.stages, nullptr));
    }
}

/// What the triangles of a frame go through before they are covered.
class PolygonMaker {
  public:
    PolygonMaker(const VertexRules& rules, Frame& frame)
        : volume_(rules), rays_(sight_rays(rules)), frame_(frame) {}

    /// Reject, clip, cull and project; appends the corners to the frame's.
    Polygon make(int triangle) {
        Polygon polygon{static_cast<int>(frame_.vertices.size()), 0, Rejection::none, false};
        clip(triangle, polygon);
        if (polygon.rejection == Rejection::none)
            polygon.rejection = frame_.stages.cull(corners_, volume_.rules, rays_, nullptr);
        if (polygon.is_cut) {
            for (const ClipVertex& corner : corners_)
                add(frame_.stages.project(corner, volume_.rules, frame_.stages, nullptr), polygon);
        } else {
            for (int corner = 0; corner < triangle_corners; ++corner)
                add(frame_.given_vertex(triangle, corner), polygon);
        }
        return polygon;
    }

  private:
    void clip(int triangle, Polygon& polygon) {
        const auto given = frame_.given_clip_vertices(triangle);
        corners_.assign(given.begin(), given.end());
        polygon.rejection = frame_.stages.reject(corners_, volume_);
        if (polygon.rejection != Rejection::none) return;
        const Clipped clipped = frame_.stages.clip(corners_, volume_, nullptr);
        polygon.rejection = clipped.rejection;
        if (corners_.size() < least_corners) polygon.rejection = Rejection::clipped_away;
        // Of what nothing is drawn is shown as the scene has it.
        polygon.is_cut = clipped.is_cut && polygon.rejection == Rejection::none;
    }

    void add(const ProjectedVertex& corner, Polygon& polygon) {
        if (polygon.rejection == Rejection::none) polygon.rejection = corner.rejection;
        frame_.vertices.push_back(corner.pixel);
        ++polygon.count;
    }

    ViewVolume volume_;
    SightRays rays_;
    Frame& frame_;
    std::vector<ClipVertex> corners_; ///< of the polygon on its way
};

void make_polygons(const Mesh& mesh, const VertexRules& rules, Frame& frame) {
    shade_vertices(mesh, rules, frame);
    frame.vertices.clear();
    frame.polygons.clear();
    frame.vertices.reserve(triangle_corners * mesh.triangles().size());
    frame.polygons.reserve(mesh.triangles().size());
    PolygonMaker maker(rules, frame);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        frame.polygons.push_back(maker.make(t));
}

/// Takes the scene as it is, or what tessellation makes of it. That is kept as long as it is the
/// same: while the camera moves nothing is cut anew.
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
    frame.scene = parts == 1 ? &scene : &frame.tessellated->made;
}

} // namespace

void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame) {
    take_scene(scene, settings.tessellation, frame);
    const Mesh& mesh = frame.scene->mesh;
    frame.settings = settings;
    frame.replace = replace;
    frame.stages = stages_for(settings, *frame.scene, replace);
    frame.blends = frame.stages.blend != blend_nothing && has_alpha(*frame.scene);
    frame.bends = bends_normals(settings) && has_normal_map(*frame.scene);
    make_polygons(mesh, vertex_rules(settings, scene.space), frame);
}

Frame prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace) {
    Frame frame;
    prepare_frame(scene, settings, replace, frame);
    return frame;
}

std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle,
                                        const Settings& settings) {
    Mesh mesh;
    mesh.add_triangle_of(corners_of(*frame.scene, triangle));
    Frame other;
    other.stages = stages_for(settings, *frame.scene, frame.replace);
    make_polygons(mesh, vertex_rules(settings, frame.scene->space), other);
    return std::move(other.vertices);
}

int triangle_in(const Frame& frame, const Frame& other, int triangle_of_other) {
    const int of_each = frame.triangles_of_each(), of_other = other.triangles_of_each();
    if (of_each == of_other) return triangle_of_other;
    return triangle_of_other / of_other * of_each;
}

VaryingSet carried_varyings(const Frame& frame) {
    const VaryingSet carried = carried_varyings(frame.stages, shading_rule(frame.settings));
    return is_textured(frame) || frame.bends ? carried | VaryingSet::of(&Varyings::texcoord)
                                             : carried;
}

void tell_clipping(const Frame& frame, int triangle, ClipSink& sink) {
    if (!frame.is_clip_told(triangle)) return;
    const auto given = frame.given_clip_vertices(triangle);
    std::vector<ClipVertex> corners(given.begin(), given.end());
    frame.stages.clip(corners, ViewVolume(vertex_rules(frame.settings, frame.scene->space)), &sink);
}

CullTest cull_test(const Frame& frame, int triangle) {
    CullTest test;
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const auto given = frame.given_clip_vertices(triangle);
    std::vector<ClipVertex> corners(given.begin(), given.end());
    frame.stages.clip(corners, ViewVolume(rules), nullptr);
    test.is_back = frame.stages.cull(corners, rules, sight_rays(rules), &test) != Rejection::none;
    return test;
}

void compute_rows(const Frame& frame, int triangle, PolygonRows& rows, SampleSink* sink,
                  VaryingSet carried) {
    frame.stages.compute_polygon_rows(frame.triangle_vertices(triangle),
                                      edge_rules(frame.settings, carried), frame.stages, rows,
                                      sink);
}

Rectangle drawn_area(const Frame& frame) {
    const Viewport& picture = frame.settings.viewport;
    return intersection(frame.stages.walked_area(picture), frame.stages.drawn_area(picture));
}

} // namespace rasterwalk
