#include "facts/fact_groups.h"

#include <array>

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

/// The cursor, if it is in this phase of a triangle.
const Cursor* cursor_in(const Facts& facts, Phase phase) {
    const Cursor& cursor = facts.results().a.cursor;
    return cursor != cursor_end && cursor.phase == phase ? &cursor : nullptr;
}

Value cursor_phase(const Facts& facts, int) {
    const Cursor& cursor = facts.results().a.cursor;
    return std::string(cursor == cursor_end ? phase_words.back() : phase_info(cursor.phase).word);
}

Value cursor_plane(const Facts& facts, int) {
    const Cursor* const at = cursor_in(facts, Phase::clip);
    if (at == nullptr) return {};
    return std::string(word_of(static_cast<ClipPlane>(at->index)));
}

/// Row or column of the picture where the next fragment falls.
Value cursor_pixel(const Facts& facts, int axis) {
    if (const std::optional<PixelTest> test = facts.pixel_test())
        return number(axis == 1 ? test->row : test->column);
    const Cursor* const cursor = cursor_in(facts, Phase::rows);
    if (cursor == nullptr) return {};
    const Timeline timeline(facts.results().a.frame);
    const PolygonRows& rows = timeline.moments(cursor->triangle).rows;
    if (axis == 1) return number(rows.first_row + cursor->index);
    return number(rows.left[static_cast<std::size_t>(cursor->index)].column + cursor->step);
}

template <class Number>
void add_frame_fact(std::vector<Fact>& table, const char* name, const char* help, Number) {
    table.push_back(
        {name, help, natural(), [](const Facts& f, int) { return Number{}(f.frame_stats()); }});
}

} // namespace

void add_cursor_facts(std::vector<Fact>& table) {
    table.push_back({"cursor", "The moment, that is, what comes next; `end` after everything.",
                     moment(), [](const Facts& f, int) { return Value(f.results().a.cursor); }});
    table.push_back(
        {"cursor.triangle", "Triangle of the moment, from 0.", natural(), [](const Facts& f, int) {
             const Cursor& cursor = f.results().a.cursor;
             return cursor == cursor_end ? Value() : number(cursor.triangle);
         }});
    table.push_back(
        {"cursor.phase", "What kind of work comes next.", words(phase_words), cursor_phase});
    table.push_back(
        {"cursor.vertex", "Vertex that comes next, 0 to 2.", whole(0, 2), [](const Facts& f, int) {
             const Cursor* const at = cursor_in(f, Phase::vertices);
             return at != nullptr ? number(at->index) : Value();
         }});
    table.push_back({"cursor.plane", "Clipping plane at which an edge is handled next.",
                     words(enum_words<ClipPlane>), cursor_plane});
    table.push_back({"cursor.clip_edge", "Edge that is handled next at that plane, from 0.",
                     whole(0, most_polygon_corners - 1), [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::clip);
                         return at != nullptr ? number(at->step) : Value();
                     }});
    table.push_back({"cursor.edge",
                     "Edge whose sample comes next; 0 to 2 for a triangle that is not cut.",
                     whole(0, most_polygon_corners - 1), [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::edges);
                         return at != nullptr ? number(at->index) : Value();
                     }});
    table.push_back({"cursor.sample", "Sample of that edge, from 0, as in line[...].", natural(),
                     [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::edges);
                         return at != nullptr ? number(at->step) : Value();
                     }});
    table.push_back(
        {"cursor.decision",
         "Decision variable at that sample, for the DDA its float; Interpolate has none.", real(),
         [](const Facts& f, int) {
             const std::optional<LineDecision> decision = f.decision();
             return decision ? number(decision->before) : Value();
         }});
    table.push_back({"cursor.diagonal",
                     "1 if the line steps diagonally from that sample, 0 if it goes straight.",
                     yes_or_no(), [](const Facts& f, int) {
                         const std::optional<LineDecision> decision = f.decision();
                         if (!decision || decision->step == PixelStep::none) return Value();
                         return number(decision->step == PixelStep::diagonal ? 1 : 0);
                     }});
    table.push_back({"cursor.column",
                     "Column of the picture in which the next fragment falls, or of the pixel that "
                     "edge functions test next.",
                     whole(-endless, endless), cursor_pixel, 0});
    table.push_back({"cursor.row",
                     "Row of the picture in which the next fragment falls, or of the pixel that "
                     "edge functions test next.",
                     whole(-endless, endless), cursor_pixel, 1});
}

void add_test_facts(std::vector<Fact>& table) {
    table.push_back({"test.inside",
                     "1 if the pixel that edge functions test next lies inside, 0 if not.",
                     yes_or_no(), [](const Facts& f, int) {
                         const std::optional<PixelTest> test = f.pixel_test();
                         return test ? number(test->is_inside ? 1 : 0) : Value();
                     }});
    for (int i = 0; i < static_cast<int>(edge_function_count); ++i) {
        table.push_back({fmt::format("test.e{}", i),
                         fmt::format("Edge function {} of the triangle, or of the triangle of the "
                                     "fan, at that pixel's centre, in square pixels.",
                                     i),
                         real(),
                         [](const Facts& f, int edge) {
                             const std::optional<PixelTest> test = f.pixel_test();
                             if (!test) return Value();
                             return number(
                                 in_square_pixels(test->e[static_cast<std::size_t>(edge)]));
                         },
                         i});
        table.push_back({fmt::format("test.weight{}", i),
                         fmt::format("Weight of corner {} of that triangle at that pixel's "
                                     "centre.",
                                     i),
                         real(),
                         [](const Facts& f, int corner) {
                             const std::optional<PixelTest> test = f.pixel_test();
                             if (!test) return Value();
                             // All digits of the float: a lesson shows its ninth digit.
                             return number(double{test->weights[static_cast<std::size_t>(corner)]});
                         },
                         i});
    }
}

void add_session_facts(std::vector<Fact>& table) {
    table.push_back({"triangle", "Selected triangle, from 0.", natural(),
                     [](const Facts& f, int) { return number(f.session().selection.triangle); }});
    table.push_back(
        {"triangle.count", "Triangles of the scene, after tessellation if it cuts them.", natural(),
         [](const Facts& f, int) { return number(f.results().a.frame.triangle_count()); }});
    table.push_back({"triangle.shown",
                     "Triangle that the inspector shows, from 0: the selected triangle, or the one "
                     "that was just drawn.",
                     natural(),
                     [](const Facts& f, int) { return number(f.results().a.triangle); }});
    table.push_back({"row", "Selected row of the picture.", whole(-endless, endless),
                     [](const Facts& f, int) { return number(f.session().selection.row); }});
    table.push_back({"vertex", "Selected vertex of the triangle shown, 0 to 2.", whole(0, 2),
                     [](const Facts& f, int) { return number(f.session().selection.vertex); }});
    table.push_back({"tab", "Open tab of the inspector.", words(tab_names()),
                     [](const Facts& f, int) { return Value(f.session().tab); }});
    table.push_back(
        {"view", "Plane of the picture that is shown.", words(enum_words<View>),
         [](const Facts& f, int) { return Value(std::string(word_of(f.session().view))); }});
    table.push_back(
        {"canvas", "What the canvas shows: the picture, the scene from outside, or both.",
         words(enum_words<CanvasShows>), [](const Facts& f, int) {
             const Session& session = f.session();
             return Value(std::string(word_of(shown_on_canvas(session.canvas, *session.scene))));
         }});
    for (const OverlayInfo& info : overlay_list()) {
        table.push_back({"overlay." + std::string(info.name),
                         "1 while the overlay '" + std::string(info.title) + "' is on.",
                         yes_or_no(),
                         [](const Facts& f, int overlay) {
                             const auto which = static_cast<Overlay>(overlay);
                             return number(f.session().overlays.has(which) ? 1 : 0);
                         },
                         static_cast<int>(info.overlay)});
    }
    table.push_back({"zoom",
                     "Screen pixels for each pixel of the picture; 0 if it is fitted to "
                     "the window.",
                     real(0, 64),
                     [](const Facts& f, int) { return number(f.session().canvas.zoom); }});
}

void add_frame_facts(std::vector<Fact>& table) {
    add_frame_fact(
        table, "frame.fragments",
        "Fragments that fall inside the picture, drawn or not; before the fill stage, marks.",
        [](const FrameStats& s) { return number(s.fragments); });
    add_frame_fact(table, "frame.fragments_outside", "Fragments that fall outside the picture.",
                   [](const FrameStats& s) { return number(s.fragments_outside); });
    add_frame_fact(table, "frame.pixels_tested",
                   "Pixels of the picture that edge functions test, one triangle after another.",
                   [](const FrameStats& s) { return number(s.pixels_tested); });
    add_frame_fact(table, "frame.shaded", "Fragments whose colour is computed.",
                   [](const FrameStats& s) { return number(s.shaded); });
    add_frame_fact(table, "frame.clipped", "Triangles that clipping has cut.",
                   [](const FrameStats& s) { return number(s.clipped); });
    add_frame_fact(table, "frame.clip_triangles",
                   "Triangles after clipping, including uncut ones; a polygon counts as the "
                   "triangles of its fan.",
                   [](const FrameStats& s) { return number(s.clip_triangles); });
    add_frame_fact(
        table, "frame.culled", "Triangles left out because they face away.",
        [](const FrameStats& s) { return number(s.left_out.of(Rejection::back_facing)); });
    add_frame_fact(table, "frame.rejected",
                   "Triangles left out because all their vertices lie beyond the same plane.",
                   [](const FrameStats& s) { return number(s.left_out.of(Rejection::outside)); });
    add_frame_fact(table, "frame.triangles", "Triangles that are drawn.",
                   [](const FrameStats& s) { return number(s.triangles - s.left_out.total()); });
    add_frame_fact(table, "frame.left_out", "Triangles that are left out.",
                   [](const FrameStats& s) { return number(s.left_out.total()); });
    table.push_back({"frame.edges", "Edges of the triangles that are drawn.", natural(),
                     [](const Facts& f, int) { return number(f.edge_ends().edges); }});
    table.push_back({"frame.ends_missed",
                     "Edges whose last sample is not on the pixel of their end vertex.", natural(),
                     [](const Facts& f, int) { return number(f.edge_ends().missed); }});
    add_frame_fact(table, "frame.max_overdraw", "Most fragments on one pixel.",
                   [](const FrameStats& s) { return number(std::int64_t{s.max_overdraw}); });
    add_frame_fact(table, "frame.uncovered", "Pixels on which nothing falls.",
                   [](const FrameStats& s) { return number(s.uncovered); });
    table.push_back({"frame.drawn_twice",
                     "Pixels that two triangles with a common edge both draw, where neither is "
                     "folded over the other.",
                     natural(), [](const Facts& f, int) { return number(f.drawn_twice()); }});
    add_frame_fact(table, "frame.rows_outside",
                   "Edge samples that fall outside their triangle's row table.",
                   [](const FrameStats& s) { return number(s.rows_outside); });
    add_frame_fact(table, "frame.rows_outside_triangles", "Triangles that have such samples.",
                   [](const FrameStats& s) { return number(s.rows_outside_triangles); });
}

void add_model_facts(std::vector<Fact>& table) {
    for (std::size_t i = 0; i < obj_count_list.size(); ++i) {
        const ObjCountInfo& info = obj_count_list[i];
        table.push_back({fmt::format("model.{}", info.name),
                         fmt::format("For the model that is open: {}.", info.help), natural(),
                         [](const Facts& f, int which) {
                             const std::optional<ObjReport>& report =
                                 f.session().scene->model_report;
                             if (!report) return Value();
                             const auto row = static_cast<std::size_t>(which);
                             return number(report->counts.*obj_count_list[row].count);
                         },
                         static_cast<int>(i)});
    }
}

} // namespace rasterwalk
