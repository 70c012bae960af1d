// Each slot of the table gets a different function, one slot at a time: the picture, the row
// tables, the histories, the microscope, the statistics, the timeline and what an observer gets
// must all agree, and differ from what they said before.

#include <algorithm>
#include <map>
#include <vector>

#include "compare/divergence.h"
#include "explain/fragment_report.h"
#include "inspect/event_list.h"
#include "inspect/microscope.h"
#include "inspect/pixel_history.h"
#include "inspect/row_graph.h"
#include "inspect/stats.h"
#include "inspect/triangle_report.h"
#include "mistakes/coverage.h"
#include "mistakes/depth_test.h"
#include "mistakes/interpolate.h"
#include "mistakes/lines.h"
#include "mistakes/put_pixel.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/timeline.h"
#include "support/bits.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

// --- for each slot a function that does something different

ClipVertex shader_to_the_right(const Vertex& vertex, const glm::mat3& rotation,
                               const VertexRules& rules, const Stages& stages,
                               VertexSpaces* spaces) {
    ClipVertex clip = vertex_shader(vertex, rotation, rules, stages, spaces);
    const float width = rules.space == SceneSpace::world ? clip.position_clip.w : 1.0f;
    clip.position_clip.x += 2.0f * width;
    return clip;
}
ProjectedVertex project_two_right(const ClipVertex& clip, const VertexRules& rules,
                                  const Stages& stages, VertexSpaces* spaces) {
    ProjectedVertex projected = project(clip, rules, stages, spaces);
    projected.pixel.column += 2;
    return projected;
}
glm::vec3 tilted(const glm::vec3& minus_camera, const glm::mat3& rotation) {
    const glm::vec3 rotated = rotate_to_camera(minus_camera, rotation);
    return {rotated.x + 0.1f * rotated.y, rotated.y, rotated.z};
}
glm::vec4 half_as_long(const glm::vec3& rotated, const VertexRules& rules) {
    VertexRules half = rules;
    half.camera.focal_length *= 0.5f;
    return to_clip_space(rotated, half);
}
bool is_between(const glm::vec4& clip, const VertexRules&) {
    return clip.w > 0.0f && clip.w < 3.5f;
}
glm::vec2 two_columns_left(const glm::vec4& clip, float inv_w) {
    return perspective_divide(clip, inv_w) - glm::vec2(2.0f, 0.0f);
}
glm::ivec2 below_the_middle(const VertexRules& rules) {
    return viewport_middle(rules) + glm::ivec2(0, 2);
}
ScreenPlace even_columns(const glm::vec2& projected, glm::ivec2 middle, const VertexRules& rules) {
    ScreenPlace place = snap_to_pixel(projected, middle, rules);
    place.pixel.x -= place.pixel.x % 2;
    return place;
}
ClipVertex between(const ClipVertex& a, const ClipVertex& b, float t) {
    return {a.position_clip + (b.position_clip - a.position_clip) * t,
            a.varyings + (b.varyings - a.varyings) * t};
}
/// Sutherland-Hodgman against one plane, w = near: triangles become quadrilaterals, or nothing.
Clipped clip_at_near_plane(std::vector<ClipVertex>& corners, const ViewVolume&, ClipSink* sink) {
    constexpr float near = 1.5f;
    std::vector<ClipVertex> left;
    std::vector<ClipStep> steps;
    bool is_cut = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ClipVertex &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const float da = a.position_clip.w - near, db = b.position_clip.w - near;
        ClipStep& step = steps.emplace_back();
        step.from = static_cast<int>(i);
        step.keeps_from = da >= 0.0f;
        step.is_cut = (da >= 0.0f) != (db >= 0.0f);
        step.t = step.is_cut ? da / (da - db) : 0.0f;
        if (step.is_cut) step.cut = between(a, b, step.t);
        if (step.keeps_from) left.push_back(a);
        if (step.is_cut) left.push_back(step.cut);
        is_cut = is_cut || !step.keeps_from;
    }
    if (sink != nullptr && is_cut) {
        sink->begin_plane(ClipPlane::near, corners);
        for (const ClipStep& step : steps)
            sink->clip_step(step);
        sink->end_plane(ClipPlane::near, left);
    }
    corners = left;
    return {left.empty() ? Rejection::clipped_away : Rejection::none, is_cut};
}
/// Twice the area on the screen, with a sign: which way round the corners go.
float signed_area(std::span<const ClipVertex> corners) {
    float area = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec4 a = corners[i].position_clip;
        const glm::vec4 b = corners[(i + 1) % corners.size()].position_clip;
        area += (a.x * b.y - b.x * a.y) / (a.w * b.w);
    }
    return area;
}
Rejection cull_back_faces(std::span<const ClipVertex> corners, const VertexRules&, const SightRays&,
                          CullTest* test) {
    const float area = signed_area(corners);
    if (test != nullptr) *test = {"area", "by its area", {area}, area < 0.0f};
    return area < 0.0f ? Rejection::back_facing : Rejection::none;
}
void clip_and_cull(Stages& stages) {
    stages.clip = clip_at_near_plane;
    stages.cull = cull_back_faces;
}
LightTerms green_light(const glm::vec3& place, const glm::vec3& normal, const glm::vec3& colour,
                       const Light& light) {
    LightTerms terms = reflected_light(place, normal, colour, light);
    terms.reflected = {0.0f, 0.5f, 0.0f};
    return terms;
}
void rows_from_column_three(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows) {
    begin_polygon_rows(vertices, rules, rows);
    for (RowEnd& end : rows.left)
        end.column = 3;
}
Rectangle everywhere(PolygonCorners, const EdgeRules&, const Stages&) {
    return {-9999, -9999, 9999, 9999};
}
int first_half(int count, bool is_last_edge) {
    return is_last_edge ? 1 : (count + 1) / 2;
}
FoundRow all_but_the_first(int row, const PolygonRows& rows) {
    const FoundRow found = find_row(row, rows);
    return {found.index == 0 ? -1 : found.index, 2};
}
void rows_by_rows(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                  PolygonRows& rows, SampleSink* sink) {
    Stages other = stages;
    other.edge_sample_count = edge_sample_count_by_rows;
    compute_polygon_rows(vertices, rules, other, rows, sink);
}
int at_most_four(int left, int right) {
    return std::min(row_pixel_count(left, right), 4);
}
int no_more_than_three(int count) {
    return std::min(count, 3);
}
void line_backwards(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                    std::span<LineSample> result) {
    for (std::size_t i = 0; i < result.size(); ++i) {
        const int behind = part.count - 1 - part.first - static_cast<int>(i);
        const LinePart one{part.count, behind, part.rounding, part.carried};
        interpolate(b, a, line_step(b, a, part), one, {&result[i], 1});
    }
}
void fragments_backwards(const Stages& stages, const Row& row, int first, VaryingSet carried,
                         std::span<LineSample> result) {
    for (std::size_t i = 0; i < result.size(); ++i) {
        const int step = first + static_cast<int>(i);
        row_fragments(stages, row, row.count - 1 - step, carried, {&result[i], 1});
        result[i].fragment.column = row.left.column + step;
    }
}
RowEnd nearer_end(const RowEnd& end) {
    RowEnd near = end;
    near.depth = near.inv_w = 2.0f * end.inv_w;
    return near;
}
RowEnd nearer_sample(const Fragment& sample) {
    return nearer_end(row_end(sample));
}
float squared_weight(float zinv, const Stages&) {
    return zinv * zinv;
}
glm::vec3 blue(const Fragment&, const Surface&, const PixelRules&, const Stages&) {
    return {0.0f, 0.0f, 1.0f};
}
Rectangle without_border(Viewport picture) {
    return {2, 2, picture.width - 2, picture.height - 2};
}
std::uint8_t negative(float channel) {
    return static_cast<std::uint8_t>(255 - to_byte(channel));
}
float negative_channel(float channel) {
    return 1.0f - visible_channel(channel);
}

struct Replacement {
    const char* slot;
    ReplaceStages replace;
    bool needs_camera = false; ///< a scene in pixel space does not use the slot
};

const std::vector<Replacement>& replacements() {
    static const std::vector<Replacement> list{
        {"vertex_shader", [](Stages& s) { s.vertex_shader = shader_to_the_right; }},
        {"rotate_to_camera", [](Stages& s) { s.rotate_to_camera = tilted; }, true},
        {"to_clip_space", [](Stages& s) { s.to_clip_space = half_as_long; }, true},
        {"clip", [](Stages& s) { s.clip = clip_at_near_plane; }, true},
        {"cull", [](Stages& s) { s.cull = cull_back_faces; }, true},
        {"clip and cull", clip_and_cull, true},
        {"project", [](Stages& s) { s.project = project_two_right; }},
        {"is_in_front", [](Stages& s) { s.is_in_front = is_between; }},
        {"perspective_divide", [](Stages& s) { s.perspective_divide = two_columns_left; }, true},
        {"viewport_middle", [](Stages& s) { s.viewport_middle = below_the_middle; }},
        {"snap_to_pixel", [](Stages& s) { s.snap_to_pixel = even_columns; }},
        {"reflected_light", [](Stages& s) { s.reflected_light = green_light; }},
        {"begin_polygon_rows and polygon_box",
         [](Stages& s) {
             s.begin_polygon_rows = rows_from_column_three;
             s.polygon_box = everywhere;
         }},
        {"edge_sample_count", [](Stages& s) { s.edge_sample_count = edge_sample_count_by_rows; }},
        {"entered_samples", [](Stages& s) { s.entered_samples = first_half; }},
        {"find_row", [](Stages& s) { s.find_row = all_but_the_first; }},
        {"row_end", [](Stages& s) { s.row_end = nearer_sample; }},
        {"compute_polygon_rows", [](Stages& s) { s.compute_polygon_rows = rows_by_rows; }},
        {"row_pixel_count", [](Stages& s) { s.row_pixel_count = at_most_four; }},
        {"drawn_pixels", [](Stages& s) { s.drawn_pixels = no_more_than_three; }},
        {"row_fragments", [](Stages& s) { s.row_fragments = fragments_backwards; }},
        {"line: bresenham", [](Stages& s) { s.line = line_by_bresenham; }},
        {"line: midpoint", [](Stages& s) { s.line = line_by_midpoint; }},
        {"line: dda", [](Stages& s) { s.line = line_by_dda; }},
        {"line: first octant",
         [](Stages& s) {
             s.line = line_in_first_octant;
             s.edge_sample_count = edge_sample_count_to_the_right;
         }},
        {"line: wrong term", [](Stages& s) { s.line = line_by_wrong_term; }},
        {"line_step", [](Stages& s) { s.line_step = line_step_of_integers; }},
        {"interpolate", [](Stages& s) { s.interpolate = line_backwards; }},
        {"span_end", [](Stages& s) { s.span_end = nearer_end; }},
        {"varying_weight", [](Stages& s) { s.varying_weight = squared_weight; }},
        {"recovery_weight", [](Stages& s) { s.recovery_weight = squared_weight; }},
        {"depth_test", [](Stages& s) { s.depth_test = depth_test_reversed; }},
        {"depth_cell", [](Stages& s) { s.depth_cell = depth_cell_transposed; }},
        {"pixel_shader", [](Stages& s) { s.pixel_shader = blue; }},
        {"walked_area", [](Stages& s) { s.walked_area = without_border; }},
        {"drawn_area", [](Stages& s) { s.drawn_area = without_border; }},
        {"to_byte and visible_channel",
         [](Stages& s) {
             s.screen.to_byte = negative;
             s.screen.visible_channel = negative_channel;
         }},
    };
    return list;
}

// --- one story

struct Story {
    Framebuffer picture;
    Image image;
    Image depth_image;
    Recorder recorded{true};
    DrawTally tally;
};

Story story_of(const Frame& frame) {
    Story story;
    clear(story.picture, frame);
    story.tally = draw(frame, {}, story.picture, &story.recorded);
    story.image = view_image(story.picture, View::colour, std::nullopt);
    story.depth_image = view_image(story.picture, View::depth, std::nullopt);
    return story;
}

bool same_place(const EdgeSample& a, const EdgeSample& b) {
    return a.edge == b.edge && a.sample == b.sample && same_bits(a.x, b.x) && same_bits(a.y, b.y) &&
           same_bits(a.fragment, b.fragment) && a.write == b.write && a.decision == b.decision;
}

std::vector<EdgeSample> recorded_samples(const Story& story, int triangle) {
    std::vector<EdgeSample> samples;
    for (const SampleEvent& event : story.recorded.samples) {
        if (event.cursor.triangle == triangle) samples.push_back(event.sample);
    }
    return samples;
}

/// The columns of a triangle's fragments, row by row of its table.
std::map<int, std::vector<int>> recorded_rows(const Story& story, int triangle) {
    std::map<int, std::vector<int>> rows;
    for (const FragmentEvent& event : story.recorded.fragments) {
        if (event.cursor.triangle == triangle)
            rows[event.cursor.index].push_back(event.fragment.column);
    }
    return rows;
}

void check_tables(const Frame& frame, const Story& story, int triangle) {
    const std::vector<EdgeSample> recorded = recorded_samples(story, triangle);
    const TriangleReport report = triangle_report(frame, triangle);
    std::vector<EdgeSample> reported;
    for (const EdgeReport& edge : report.edges)
        reported.insert(reported.end(), edge.samples.begin(), edge.samples.end());
    REQUIRE(reported.size() == recorded.size());
    CHECK(std::equal(recorded.begin(), recorded.end(), reported.begin(), same_place));
    CHECK(report.rows.sample_count == static_cast<int>(recorded.size()));
    REQUIRE(report.rows.last);
    CHECK(same_place(*report.rows.last, recorded.back()));
    // What is drawn of each row of the table is what the observer got.
    const Rectangle area = drawn_area(frame);
    const std::map<int, std::vector<int>> rows = recorded_rows(story, triangle);
    const PolygonRows& table = report.rows.rows;
    for (int r = 0; r < table.size(); ++r) {
        std::vector<int> expected;
        const int row = table.first_row + r;
        const RowSpan span = row_span(frame.stages, table, r);
        for (int i = 0; i < span.drawn; ++i) {
            const int column = span.left + i;
            if (row >= area.top && row < area.bottom && column >= area.left && column < area.right)
                expected.push_back(column);
        }
        const auto found = rows.find(r);
        CAPTURE(triangle, r);
        CHECK((found == rows.end() ? std::vector<int>{} : found->second) == expected);
    }
}

void check_microscope(const Frame& frame, const Story& story, int triangle) {
    const PolygonCorners v = frame.triangle_vertices(triangle);
    const std::vector<EdgeSample> recorded = recorded_samples(story, triangle);
    for (std::size_t e = 0; e < v.size(); ++e) {
        const EdgeMicroscope edge =
            microscope(v[e], v[(e + 1) % v.size()], edge_rules(frame.settings), frame.stages);
        std::size_t i = 0;
        for (const EdgeSample& sample : recorded) {
            if (sample.edge != static_cast<int>(e)) continue;
            REQUIRE(i < edge.forward.size());
            CHECK(same_bits(edge.forward[i].x, sample.x));
            CHECK(edge.forward[i].column == sample.fragment.column);
            CHECK(edge.forward[i].row == sample.fragment.row);
            if (edge.decides()) CHECK(edge.decisions[i] == sample.decision);
            ++i;
        }
        // Samples that are left out of the table are still looked at.
        const bool are_all_entered = frame.stages.entered_samples == entered_samples;
        CHECK((are_all_entered ? i == edge.forward.size() : i <= edge.forward.size()));
        CHECK(edge.decides() == (frame.stages.line != line_by_interpolate));
    }
}

void check_moments(const Frame& frame, const Story& story) {
    std::vector<Cursor> recorded;
    for (const auto& vertex : story.recorded.vertices)
        recorded.push_back(vertex.cursor);
    for (const ClipEvent& event : story.recorded.clip_steps)
        recorded.push_back(event.cursor);
    for (const CullEvent& event : story.recorded.culls)
        recorded.push_back(event.cursor);
    for (const SampleEvent& event : story.recorded.samples)
        recorded.push_back(event.cursor);
    for (const FragmentEvent& event : story.recorded.fragments)
        recorded.push_back(event.cursor);
    std::sort(recorded.begin(), recorded.end());
    const Timeline timeline(frame);
    Cursor cursor = timeline.first();
    for (const Cursor& expected : recorded) {
        if (cursor != expected) FAIL(to_text(cursor) + " for " + to_text(expected));
        cursor = timeline.next(cursor, Granularity::moment);
    }
    CHECK(cursor == cursor_end);
}

/// History, report and list of moments show the clipping and culling that the observer got.
void check_clipping(const Frame& frame, const Story& story, int triangle) {
    std::vector<std::string> recorded, of_history, of_report;
    for (const ClipEvent& event : story.recorded.clip_steps) {
        if (event.cursor.triangle == triangle) recorded.push_back(clip_step_text(event.step));
    }
    const auto steps_of = [](const ClipHistory& history) {
        std::vector<std::string> steps;
        for (const PlaneHistory& plane : history.planes) {
            for (const ClipStep& step : plane.steps)
                steps.push_back(clip_step_text(step));
        }
        return steps;
    };
    const ClipHistory history = clip_history(frame, triangle);
    CAPTURE(triangle);
    CHECK(steps_of(history) == recorded);
    CHECK(steps_of(triangle_report(frame, triangle).clip) == recorded);
    const EventList list = list_events(frame, triangle);
    std::vector<std::string> of_list;
    for (const Event& event : list.events) {
        if (const auto* clip = std::get_if<ClipEvent>(&event))
            of_list.push_back(clip_step_text(clip->step));
    }
    CHECK(of_list == recorded);
    const auto cull =
        std::find_if(story.recorded.culls.begin(), story.recorded.culls.end(),
                     [&](const CullEvent& event) { return event.cursor.triangle == triangle; });
    const bool is_reported = cull != story.recorded.culls.end();
    REQUIRE(list.moments.of(Phase::cull).count() == (is_reported ? 1 : 0));
    CHECK(history.is_cull_tested == is_reported);
    if (!is_reported) return;
    CHECK(culling_text(history.cull) == culling_text(cull->test));
    const auto listed =
        std::find_if(list.events.begin(), list.events.end(),
                     [](const Event& event) { return std::holds_alternative<CullEvent>(event); });
    REQUIRE(listed != list.events.end());
    CHECK(culling_text(std::get<CullEvent>(*listed).test) == culling_text(cull->test));
}

void check_pixels(const Frame& frame, const Story& story) {
    const Viewport size = frame.settings.viewport;
    for (int row = 0; row < size.height; row += 3) {
        for (int column = 0; column < size.width; column += 2) {
            const PixelHistory history = pixel_history(frame, {column, row});
            const std::size_t pixel = story.picture.at(column, row);
            CAPTURE(column, row);
            REQUIRE(history.entries.size() == story.picture.overdraw[pixel]);
            if (history.winner < 0) continue;
            const PixelEntry& winner = history.entries[static_cast<std::size_t>(history.winner)];
            CHECK(same_bits(winner.colour_after, story.picture.colour[pixel]));
            CHECK(winner.cursor.triangle == story.picture.owner[pixel]);
            const std::optional<FragmentReport> report = fragment_report(frame, winner.cursor);
            REQUIRE(report);
            CHECK(same_bits(report->after, winner.colour_after));
            CHECK(same_bits(report->colour, winner.colour_after));
            const std::optional<RowGraph> graph =
                row_graph(frame, winner.cursor.triangle, winner.cursor.index);
            REQUIRE(graph);
            CHECK(same_bits(graph->at(frame.settings.interpolation, winner.cursor.step).inv_w,
                            winner.zinv));
        }
    }
}

void check_stats(const Frame& frame, const Story& story) {
    const FrameStats stats = frame_stats(frame);
    CHECK(stats.fragments == static_cast<std::int64_t>(story.recorded.fragments.size()));
    CHECK(stats.uncovered ==
          std::count(story.picture.overdraw.begin(), story.picture.overdraw.end(), 0U));
    const auto outside =
        std::count_if(story.recorded.samples.begin(), story.recorded.samples.end(),
                      [](const SampleEvent& event) { return !event.sample.write.inside; });
    CHECK(stats.rows_outside == outside);
    CHECK(tally_rows(frame, 0).samples_outside == outside);
    CHECK(stats.row_lookups == story.tally.row_lookups);
}

/// The small scene in front of a camera that sees it much as it is in pixels.
Scene small_world() {
    Scene scene = small_scene();
    scene.space = SceneSpace::world;
    scene.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 10.0f};
    const glm::vec2 middle(scene.viewport.width / 2, scene.viewport.height / 2);
    for (int t = 0; t < scene.triangle_count(); ++t) {
        for (int v = 0; v < triangle_corners; ++v) {
            const glm::vec3 p = scene.corner(t, v).position;
            scene.mesh.place_corner(t, v,
                                    {(p.x - middle.x) * p.z / scene.camera.focal_length,
                                     (p.y - middle.y) * p.z / scene.camera.focal_length, p.z});
        }
    }
    // The corners of these go the other way round.
    for (const int turned : {1, 7}) {
        const glm::vec3 second = scene.corner(turned, 1).position;
        scene.mesh.place_corner(turned, 1, scene.corner(turned, 2).position);
        scene.mesh.place_corner(turned, 2, second);
    }
    return scene;
}

Settings settings_of_story(const Scene& scene) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    return settings;
}

} // namespace

TEST_CASE(
    "With a different function in any slot everything shown agrees, and differs from before") {
    const Scene pixels = small_scene(), world = small_world();
    for (const Replacement& replacement : replacements()) {
        CAPTURE(replacement.slot);
        const Scene& scene = replacement.needs_camera ? world : pixels;
        const Settings settings = settings_of_story(scene);
        const Story usual = story_of(prepare_frame(scene, settings));
        const Frame frame = prepare_frame(scene, settings, replacement.replace);
        const Story story = story_of(frame);
        const bool has_new_events = !(story.picture == usual.picture) ||
                                    !(story.image.rgba == usual.image.rgba) ||
                                    !(story.depth_image.rgba == usual.depth_image.rgba) ||
                                    story.tally.samples_outside != usual.tally.samples_outside;
        CHECK(has_new_events);
        CHECK(draw_frame(frame) == story.picture); // also without an observer
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (frame.has_moments(t)) check_clipping(frame, story, t);
            if (!frame.is_drawn(t)) continue;
            check_tables(frame, story, t);
            check_microscope(frame, story, t);
        }
        check_moments(frame, story);
        check_pixels(frame, story);
        check_stats(frame, story);
    }
}

TEST_CASE("Clipping and culling show in polygons, reports, counts and comparisons") {
    const Scene scene = small_world();
    const Settings settings = settings_of_story(scene);
    const Frame usual = prepare_frame(scene, settings);
    const Frame frame = prepare_frame(scene, settings, clip_and_cull);
    LeftOut expected;
    int quadrilaterals = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        std::vector<ClipVertex> corners;
        for (const Vertex& vertex : corners_of(scene, t)) {
            corners.push_back(vertex_shader(vertex, camera_rotation(settings.camera),
                                            vertex_rules(settings, scene.space), {}, nullptr));
        }
        const Clipped clipped = clip_at_near_plane(corners, ViewVolume(VertexRules()), nullptr);
        Rejection rejection = clipped.rejection;
        if (rejection == Rejection::none) rejection = cull_back_faces(corners, {}, {}, nullptr);
        CAPTURE(t);
        CHECK(frame.rejection(t) == rejection);
        CHECK(triangle_report(frame, t).rejection == rejection);
        if (rejection != Rejection::none) {
            ++expected.counts[static_cast<std::size_t>(rejection)];
        } else {
            CHECK(frame.is_cut(t) == clipped.is_cut);
            CHECK(frame.triangle_vertices(t).size() == corners.size());
            CHECK(triangle_report(frame, t).edges.size() == corners.size());
            quadrilaterals += corners.size() == 4 ? 1 : 0;
        }
        // A triangle that is clipped away is shown as in the scene.
        if (rejection == Rejection::clipped_away) {
            CHECK_FALSE(frame.is_cut(t));
            const PolygonCorners as_given = usual.triangle_vertices(t);
            const PolygonCorners shown = frame.triangle_vertices(t);
            CHECK(std::equal(shown.begin(), shown.end(), as_given.begin(), as_given.end()));
        }
    }
    CHECK(count_left_out(frame).counts == expected.counts);
    CHECK(frame_stats(frame).left_out.counts == expected.counts);
    CHECK(expected.of(Rejection::clipped_away) > 0);
    CHECK(expected.of(Rejection::back_facing) > 0);
    CHECK(quadrilaterals > 0);
    // The comparison agrees, for each triangle that is drawn in one run only.
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!usual.is_drawn(t) || frame.is_drawn(t)) continue;
        const std::optional<Divergence> divergence =
            next_divergence(usual, frame, {t, Phase::vertices, 0, 0});
        REQUIRE(divergence);
        CHECK(divergence->kind == DivergenceKind::extra);
        const ClipHistory history = clip_history(frame, t);
        if (!history.planes.empty()) {
            CHECK(divergence->cursor == Cursor{t, Phase::clip, 0, 0});
            CHECK(divergence->text.starts_with("near plane, edge 0: A does nothing; B "));
        } else {
            CHECK(divergence->cursor == Cursor{t, Phase::cull, 0, 0});
            CHECK(divergence->text.find("B culls: area = -") != std::string::npos);
        }
        // After it, what the other run draws is missing.
        const std::optional<Divergence> edge =
            next_divergence(usual, frame, {t, Phase::edges, 0, 0});
        REQUIRE(edge);
        CHECK(edge->cursor == Cursor{t, Phase::edges, 0, 0});
        CHECK(edge->kind == DivergenceKind::missing);
        const std::string reason(words(frame.rejection(t)).sentence);
        CHECK(edge->text.find(reason) != std::string::npos);
    }
    CHECK_FALSE(next_divergence(frame, frame, cursor_begin));
    // Without clipping, all of a triangle that reaches behind the camera is left out.
    CHECK(count_left_out(usual).of(Rejection::behind_camera) == 1);
    CHECK(count_left_out(frame).of(Rejection::behind_camera) == 0);
}

TEST_CASE("Choosing functions for other settings keeps those that were put in") {
    const Scene scene = small_scene();
    Settings settings = settings_of_story(scene);
    const ReplaceStages replace = [](Stages& s) { s.drawn_pixels = no_more_than_three; };
    const Frame frame = prepare_frame(scene, settings, replace);
    settings.line_walk = LineWalk::exact;
    const Stages other = stages_for(settings, *frame.scene, frame.replace);
    CHECK(other.drawn_pixels == no_more_than_three);
    CHECK(other.interpolate == interpolate_exactly);
}
