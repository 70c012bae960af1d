#include "pipeline/frame.h"

#include <utility>

#include "pipeline/frame_preparation.h"

namespace rasterwalk {

Stages stages_for(const Settings& settings, const Scene& scene, const ReplaceStages& replace) {
    Stages stages = choose_stages(settings, scene);
    if (replace) replace(stages);
    return stages;
}

VertexRules vertex_rules(const Frame& frame) {
    VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    rules.occluders = occluders_of(frame);
    return rules;
}

PixelRules pixel_rules(const Frame& frame) {
    PixelRules rules = pixel_rules(frame.settings, frame.scene->space);
    rules.occluders = occluders_of(frame);
    return rules;
}

void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame) {
    begin_frame(scene, settings, replace, frame).advance();
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
    VertexRules rules = vertex_rules(settings, frame.scene->space);
    rules.occluders = occluders_of(frame);
    FramePreparation(mesh, rules, other).advance();
    const PolygonCorners corners = other.triangle_vertices(0);
    return {corners.begin(), corners.end()};
}

int triangle_in(const Frame& frame, const Frame& other, int triangle_of_other) {
    if (triangle_of_other < 0 || triangle_of_other >= other.triangle_count()) return 0;
    if (have_same_triangles(frame, other)) return triangle_of_other;
    const int of_each = frame.triangles_of_each(), of_other = other.triangles_of_each();
    const int in_order = scene_triangle(*other.scene, triangle_of_other);
    const int first = of_each == of_other ? in_order : in_order / of_other * of_each;
    return first_drawn(*frame.scene, first).value_or(0);
}

bool have_same_triangles(const Frame& a, const Frame& b) {
    if (a.triangles_of_each() != b.triangles_of_each()) return false;
    if (a.list == b.list) return true; // and if neither has one
    return a.scene->sources == b.scene->sources;
}

bool have_same_moments(const Frame& a, const Frame& b) {
    return a.squares == nullptr && b.squares == nullptr && !a.has_samples() && !b.has_samples() &&
           have_same_triangles(a, b);
}

int next_with_moments(const Frame& frame, int triangle) {
    for (int t = std::max(triangle, 0); t < frame.triangle_count(); ++t) {
        if (frame.has_moments(t)) return t;
    }
    return frame.has_samples() && triangle <= resolve_triangle ? resolve_triangle : no_triangle;
}

int last_with_moments(const Frame& frame, int triangle) {
    if (frame.has_samples() && triangle > resolve_triangle) return resolve_triangle;
    int t = std::min(triangle, frame.triangle_count()) - 1;
    while (t >= 0 && !frame.has_moments(t))
        --t;
    return t;
}

int time_units(const Frame& frame) {
    if (frame.squares != nullptr) return frame.squares->count();
    return frame.triangle_count() + (frame.has_samples() ? 1 : 0);
}

std::string moment_text(const Frame& frame, const Cursor& cursor) {
    return to_text(in_pass(cursor, frame.pass));
}

bool has_moments_in_unit(const Frame& frame, int unit) {
    return unit < frame.triangle_count() ? frame.has_moments(unit) : frame.has_samples();
}

std::optional<int> triangle_at(const Frame& frame, const Cursor& cursor) {
    int triangle = cursor.triangle;
    if (is_square(cursor) && frame.squares != nullptr && cursor.square < frame.squares->count())
        triangle = (*frame.squares)[cursor.square].surface;
    const bool exists = triangle >= 0 && triangle < frame.triangle_count();
    return exists ? std::optional(triangle) : std::nullopt;
}

VaryingSet carried_varyings(const Frame& frame) {
    const VaryingSet carried = carried_varyings(frame.stages, shading_rule(frame.settings));
    return is_textured(frame) || frame.bends ? carried | VaryingSet::of(&Varyings::texcoord)
                                             : carried;
}

void replay_clipping(const Frame& frame, int triangle, ClipSink& sink) {
    if (!frame.has_clip_events(triangle)) return;
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
