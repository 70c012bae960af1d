#include "facts/fact_groups.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "picture/view_image.h"
#include "scene/obj_report.h"
#include "session/tabs.h"

namespace rasterwalk {

namespace {

/// The words of the phases, and one more for the end.
constexpr auto phase_words = [] {
    std::array<std::string_view, phase_count + 1> words;
    for (std::size_t i = 0; i < phase_list.size(); ++i)
        words[i] = phase_list[i].word;
    words.back() = "end";
    return words;
}();

/// The cursor, if there is one before the end.
const Cursor* cursor_before_end(const Facts& facts) {
    const Cursor& cursor = facts.results().a.cursor;
    return cursor != cursor_end ? &cursor : nullptr;
}

/// The cursor, if it is in this phase of a triangle.
template <Phase phase>
const Cursor* cursor_in(const Facts& facts) {
    const Cursor* const cursor = cursor_before_end(facts);
    const bool is_in_it = cursor != nullptr && cursor->phase == phase && !is_square(*cursor);
    return is_in_it ? cursor : nullptr;
}

/// What the ray through the picked pixel brings back.
struct RaySight {
    int triangle = -1;
    glm::vec3 colour{0.0f};
};

/// None unless a pixel is picked, and rays have drawn the whole picture of run A or run B.
std::optional<RaySight> ray_sight(const Facts& facts) {
    const std::optional<glm::ivec2>& pixel = facts.session().selection.pixel;
    const Results& results = facts.results();
    for (const RunResults* const run :
         {&results.a, static_cast<const RunResults*>(results.b.get())}) {
        if (!pixel || run == nullptr || run->engine != Engine::rays || !run->planes.is_whole)
            continue;
        const Framebuffer& planes = run->planes.planes;
        if (!planes.contains(pixel->x, pixel->y)) continue;
        const std::size_t at = planes.at(pixel->x, pixel->y);
        return RaySight{planes.owner[at], planes.colour[at]};
    }
    return std::nullopt;
}

/// Row or column of the picture where the next fragment falls.
std::optional<int> cursor_pixel(const Facts& facts, int axis) {
    if (const std::optional<PixelTest> test = facts.pixel_test())
        return axis == 1 ? test->row : test->column;
    const Cursor* const cursor = cursor_in<Phase::rows>(facts);
    if (cursor == nullptr) return std::nullopt;
    const Timeline timeline(facts.results().a.frame);
    const PolygonRows& rows = timeline.moments(cursor->triangle).rows;
    if (axis == 1) return rows.first_row + cursor->index;
    return rows.left[static_cast<std::size_t>(cursor->index)].column + cursor->step;
}

const FrameStats* stats_of(const Facts& facts) {
    return &facts.frame_stats();
}

const ObjReport* model_report(const Facts& facts) {
    const std::optional<ObjReport>& report = facts.session().scene->model_report;
    return report ? &*report : nullptr;
}

} // namespace

void add_cursor_facts(std::vector<Fact>& table) {
    const FactAdder<everything> add(table);
    const FactAdder<cursor_before_end> add_before_end(table);
    const FactAdder<cursor_in<Phase::vertices>> add_in_vertices(table);
    const FactAdder<cursor_in<Phase::clip>> add_in_clip(table);
    const FactAdder<cursor_in<Phase::edges>> add_in_edges(table);
    const FactAdder<&Facts::decision> add_of_decision(table);
    add("cursor", "The moment, that is, what comes next; `end` after everything.", moment(),
        [](const Facts& f) {
            const RunResults& run = f.results().a;
            return Value(in_pass(run.cursor, run.frame.pass));
        });
    add("cursor.triangle", "Triangle of the moment, from 0.", natural(), [](const Facts& f) {
        const Cursor* const at = cursor_before_end(f);
        return at == nullptr ? std::nullopt : triangle_at(f.results().a.frame, *at);
    });
    add("cursor.phase", "What kind of work comes next.", words(phase_words), [](const Facts& f) {
        const Cursor* const at = cursor_before_end(f);
        if (at != nullptr && is_square(*at)) return Value(); // it has no phases
        return Value(std::string(at == nullptr ? phase_words.back() : phase_info(at->phase).word));
    });
    add_in_vertices("cursor.vertex", "Vertex that comes next, 0 to 2.", whole(0, 2),
                    [](const Cursor& at) { return at.index; });
    add_in_clip("cursor.plane", "Clipping plane at which an edge is handled next.",
                words(enum_words<ClipPlane>),
                [](const Cursor& at) { return word_of(static_cast<ClipPlane>(at.index)); });
    add_in_clip("cursor.clip_edge", "Edge that is handled next at that plane, from 0.",
                whole(0, most_polygon_corners - 1), [](const Cursor& at) { return at.step; });
    add_in_edges("cursor.edge",
                 "Edge whose sample comes next; 0 to 2 for a triangle that is not cut.",
                 whole(0, most_polygon_corners - 1), [](const Cursor& at) { return at.index; });
    add_in_edges("cursor.sample", "Sample of that edge, from 0, as in line[...].", natural(),
                 [](const Cursor& at) { return at.step; });
    add_of_decision("cursor.decision",
                    "Decision variable at that sample, for the DDA its float; "
                    "Interpolate has none.",
                    real(), [](const LineDecision& decision) { return decision.before; });
    add_of_decision("cursor.diagonal",
                    "1 if the line steps diagonally from that sample, 0 if it goes straight.",
                    yes_or_no(), [](const LineDecision& decision) {
                        if (decision.step == PixelStep::none) return Value();
                        return as_value(decision.step == PixelStep::diagonal);
                    });
    add(
        "cursor.column",
        "Column of the picture in which the next fragment falls, or of the pixel "
        "that edge "
        "functions test next.",
        whole(-endless, endless), [](const Facts& f, int axis) { return cursor_pixel(f, axis); },
        0);
    add(
        "cursor.row",
        "Row of the picture in which the next fragment falls, or of the pixel "
        "that edge functions "
        "test next.",
        whole(-endless, endless), [](const Facts& f, int axis) { return cursor_pixel(f, axis); },
        1);
}

void add_test_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::pixel_test> add(table);
    add("test.inside", "1 if the pixel that edge functions test next lies inside, 0 if not.",
        yes_or_no(), [](const PixelTest& test) { return test.is_inside; });
    for (int i = 0; i < static_cast<int>(edge_function_count); ++i) {
        add(
            fmt::format("test.e{}", i),
            fmt::format("Edge function {} of the triangle, or of the triangle of "
                        "the fan, at that "
                        "pixel's centre, in square pixels.",
                        i),
            real(),
            [](const PixelTest& test, int edge) {
                return in_square_pixels(test.e[static_cast<std::size_t>(edge)]);
            },
            i);
        add(
            fmt::format("test.weight{}", i),
            fmt::format("Weight of corner {} of that triangle at that pixel's centre.", i), real(),
            // All digits of the float: a lesson shows its ninth digit.
            [](const PixelTest& test, int corner) {
                return double{test.weights[static_cast<std::size_t>(corner)]};
            },
            i);
    }
}

void add_session_facts(std::vector<Fact>& table) {
    const FactAdder<everything> add(table);
    add("triangle", "Selected triangle, from 0.", natural(),
        [](const Facts& f) { return f.session().selection.triangle; });
    add("triangle.count", "Triangles of the scene, after tessellation if it cuts them.", natural(),
        [](const Facts& f) { return f.results().a.frame.triangle_count(); });
    add("triangle.shown",
        "Triangle that the inspector shows, from 0: the selected triangle, or "
        "the one that was "
        "just drawn.",
        natural(), [](const Facts& f) { return f.results().a.triangle; });
    add("triangle.scene",
        "Triangle of the scene that the triangle shown is, or is a piece of, from 0: another one "
        "only if hidden is painter or bsp, or draw_order is not scene.",
        natural(), [](const Facts& f) -> std::optional<int> {
            const RunResults& run = f.results().a;
            if (!run.triangle) return std::nullopt;
            return scene_triangle(*run.frame.scene, *run.triangle);
        });
    add("row", "Selected row of the picture.", whole(-endless, endless),
        [](const Facts& f) { return f.session().selection.row; });
    add("vertex", "Selected vertex of the triangle shown, 0 to 2.", whole(0, 2),
        [](const Facts& f) { return f.session().selection.vertex; });
    add("tab", "Open tab of the inspector.", words(tab_names()),
        [](const Facts& f) { return f.session().tab; });
    add("view", "Plane of the picture that is shown.", words(enum_words<View>),
        [](const Facts& f) { return word_of(f.session().view); });
    add("canvas", "What the canvas shows: the picture, the scene from outside, or both.",
        words(enum_words<CanvasShows>), [](const Facts& f) {
            return word_of(shown_on_canvas(f.session().canvas, *f.session().scene));
        });
    for (const OverlayInfo& info : overlay_list()) {
        add(
            "overlay." + std::string(info.name),
            "1 while the overlay '" + std::string(info.title) + "' is on.", yes_or_no(),
            [](const Facts& f, int overlay) {
                return f.session().overlays.has(static_cast<Overlay>(overlay));
            },
            static_cast<int>(info.overlay));
    }
    add("zoom",
        "Screen pixels for each pixel of the picture; 0 if it is fitted to the "
        "window.",
        real(0, 64), [](const Facts& f) { return f.session().canvas.zoom; });
}

void add_frame_facts(std::vector<Fact>& table) {
    const FactAdder<everything> add(table);
    const FactAdder<stats_of> add_counted(table);
    using Stats = const FrameStats&;
    add_counted("frame.fragments",
                "Fragments that fall inside the picture, drawn or not; before "
                "the fill stage, "
                "marks.",
                natural(), [](Stats s) { return s.fragments; });
    add_counted("frame.fragments_outside", "Fragments that fall outside the picture.", natural(),
                [](Stats s) { return s.fragments_outside; });
    add_counted("frame.pixels_tested",
                "Pixels of the picture that edge functions test, one triangle "
                "after another.",
                natural(), [](Stats s) { return s.pixels_tested; });
    add_counted("frame.shaded", "Fragments whose colour is computed.", natural(),
                [](Stats s) { return s.shaded; });
    for (std::size_t i = 0; i < cost_list().size(); ++i) {
        const CostInfo& info = cost_list()[i];
        const std::string name = fmt::format("frame.{}", info.name);
        if (std::any_of(table.begin(), table.end(), [&](const Fact& f) { return f.name == name; }))
            continue;
        add(
            name, fmt::format("In the whole frame, {}.", info.help), natural(),
            [](const Facts& f, int which) {
                return f.draw_cost().*cost_list()[static_cast<std::size_t>(which)].count;
            },
            static_cast<int>(i));
    }
    add("frame.lights", "Lights that are computed: at vertices, for triangles and at pixels.",
        natural(),
        [](const Facts& f) { return f.draw_cost().vertex_lights + f.draw_cost().pixel_lights; });
    add("frame.prepass_shaded",
        "Fragments whose colour would be computed after a depth pre-pass; none if that would "
        "change the picture.",
        natural(), [](const Facts& f) { return f.prepass_shaded(); });
    add_counted("frame.clipped", "Triangles that clipping has cut.", natural(),
                [](Stats s) { return s.clipped; });
    add_counted("frame.clip_triangles",
                "Triangles after clipping, including uncut ones; a polygon "
                "counts as the triangles "
                "of its fan.",
                natural(), [](Stats s) { return s.clip_triangles; });
    add_counted("frame.culled", "Triangles left out because they face away.", natural(),
                [](Stats s) { return s.left_out.of(Rejection::back_facing); });
    add_counted("frame.rejected",
                "Triangles left out because all their vertices lie beyond the "
                "same plane.",
                natural(), [](Stats s) { return s.left_out.of(Rejection::outside); });
    add_counted("frame.triangles", "Triangles that are drawn.", natural(),
                [](Stats s) { return s.triangles - s.left_out.total(); });
    add_counted("frame.left_out", "Triangles that are left out.", natural(),
                [](Stats s) { return s.left_out.total(); });
    add_counted(
        "frame.comparisons",
        "What the removal of hidden surfaces compares: fragments with the depth buffer, "
        "two depths (painter), the camera with a plane (bsp), or a triangle with a square and "
        "two triangles in one (warnock).",
        natural(), [](Stats s) { return s.hidden.comparisons; });
    add_counted("frame.splits", "Triangles and pieces that planes of the BSP tree have cut.",
                natural(), [](Stats s) { return s.hidden.splits; });
    add_counted("frame.squares",
                "Squares into which Warnock's algorithm divides the picture, those that are "
                "divided in turn too.",
                natural(), [](Stats s) { return s.hidden.squares; });
    add_counted("frame.memory",
                "Bytes that the removal of hidden surfaces needs besides scene and picture.",
                natural(), [](Stats s) { return s.hidden.memory; });
    const FactAdder<&Facts::hidden_way> add_of_way(table);
    add_of_way(
        "frame.wrong",
        "Pixels of the finished picture that show a triangle of the scene, or nothing, which "
        "the depth buffer shows neither there nor at any pixel next to it.",
        natural(), [](const HiddenWay& way) { return way.wrong; });
    const FactAdder<&Facts::rays> add_of_rays(table);
    using Rays = const RayStats&;
    add_of_rays("rays.triangle_tests",
                "Tests of a ray against a triangle, to follow a ray through each pixel.", natural(),
                [](Rays rays) { return rays.count.triangles; });
    add_of_rays("rays.box_tests", "Tests of such a ray against a box of triangles.", natural(),
                [](Rays rays) { return rays.count.boxes; });
    add_of_rays("rays.missed", "Pixels whose ray meets nothing.", natural(),
                [](Rays rays) { return rays.missed; });
    const FactAdder<ray_sight> add_sight(table);
    add_sight("rays.triangle",
              "Triangle that the ray through the picked pixel meets first, where rays draw a run; "
              "-1 if it meets none.",
              whole(-1, endless), [](const RaySight& sight) { return sight.triangle; });
    for (int i = 0; i < 3; ++i) {
        add_sight(
            "rays." + channel_name(i),
            "The " + channel_name(i) +
                " of what that ray brings back, mirrors included; linear, not clamped.",
            real(), [](const RaySight& sight, int channel) { return sight.colour[channel]; }, i);
    }
    add("frame.edges", "Edges of the triangles that are drawn.", natural(),
        [](const Facts& f) { return f.edge_ends().edges; });
    add("frame.ends_missed", "Edges whose last sample is not on the pixel of their end vertex.",
        natural(), [](const Facts& f) { return f.edge_ends().missed; });
    add_counted("frame.max_overdraw", "Most fragments on one pixel.", natural(),
                [](Stats s) { return s.max_overdraw; });
    add_counted("frame.uncovered", "Pixels on which nothing falls.", natural(),
                [](Stats s) { return s.uncovered; });
    add("frame.drawn_twice",
        "Pixels that two triangles with a common edge both draw, where neither "
        "is folded over the "
        "other.",
        natural(), [](const Facts& f) { return f.drawn_twice(); });
    add_counted("frame.rows_outside", "Edge samples that fall outside their triangle's row table.",
                natural(), [](Stats s) { return s.rows_outside; });
    add_counted("frame.rows_outside_triangles", "Triangles that have such samples.", natural(),
                [](Stats s) { return s.rows_outside_triangles; });
}

void add_model_facts(std::vector<Fact>& table) {
    const FactAdder<model_report> add(table);
    for (std::size_t i = 0; i < obj_count_list.size(); ++i) {
        const ObjCountInfo& info = obj_count_list[i];
        add(
            fmt::format("model.{}", info.name),
            fmt::format("For the model that is open: {}.", info.help), natural(),
            [](const ObjReport& report, int which) {
                return report.counts.*obj_count_list[static_cast<std::size_t>(which)].count;
            },
            static_cast<int>(i));
    }
}

} // namespace rasterwalk
