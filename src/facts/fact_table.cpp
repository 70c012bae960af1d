#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/limits.h"
#include "facts/fact_values.h"
#include "facts/facts.h"
#include "inspect/triangle_sides.h"
#include "picture/view_image.h"
#include "session/tabs.h"
#include "stages/matrices.h"

namespace rasterwalk {

namespace {

/// The words of the phases, and at last one for the end.
constexpr auto phase_words = [] {
    std::array<std::string_view, phase_count + 1> words;
    for (std::size_t i = 0; i < phase_list.size(); ++i)
        words[i] = phase_list[i].word;
    words.back() = "end";
    return words;
}();

/// Of a triangle behind all planes, one of which cuts off each of the corners it has by then.
constexpr int most_corners = triangle_corners + static_cast<int>(clip_plane_count);

const ValueRange yes_or_no = whole(0, 1);
const ValueRange count = whole(0, endless);
const ValueRange place = whole(0, largest_viewport - 1); ///< column or row of the picture
const ValueRange outcode_bits = whole(0, (1 << clip_plane_count) - 1);

// --- cursor

/// The cursor, if it stands in this phase of a triangle.
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

/// Row or column of the picture of the pixel that is asked next, or where the next fragment falls.
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

void add_cursor_facts(std::vector<Fact>& table) {
    table.push_back({"cursor", "The moment: what comes next. `end` after everything.", moment(),
                     [](const Facts& f, int) { return Value(f.results().a.cursor); }});
    table.push_back(
        {"cursor.triangle", "Triangle of the moment, from 0.", count, [](const Facts& f, int) {
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
    table.push_back({"cursor.plane", "Clipping plane at which an edge comes next.",
                     words(enum_words<ClipPlane>), cursor_plane});
    table.push_back({"cursor.clip_edge", "Edge that comes next at that plane, from 0.",
                     whole(0, most_corners - 1), [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::clip);
                         return at != nullptr ? number(at->step) : Value();
                     }});
    table.push_back({"cursor.edge",
                     "Edge whose sample comes next; of a triangle that is not cut 0 "
                     "to 2.",
                     whole(0, most_corners - 1), [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::edges);
                         return at != nullptr ? number(at->index) : Value();
                     }});
    table.push_back({"cursor.sample", "Sample of that edge, from 0: line[...].", count,
                     [](const Facts& f, int) {
                         const Cursor* const at = cursor_in(f, Phase::edges);
                         return at != nullptr ? number(at->step) : Value();
                     }});
    table.push_back({"cursor.decision",
                     "Decision variable at that sample; only lines that decide have one.", real(),
                     [](const Facts& f, int) {
                         const std::optional<LineDecision> decision = f.decision();
                         return decision ? number(decision->before) : Value();
                     }});
    table.push_back({"cursor.diagonal",
                     "1 if the line goes on diagonally from that sample, 0 if straight.", yes_or_no,
                     [](const Facts& f, int) {
                         const std::optional<LineDecision> decision = f.decision();
                         if (!decision || decision->step == PixelStep::none) return Value();
                         return number(decision->step == PixelStep::diagonal ? 1 : 0);
                     }});
    table.push_back({"cursor.column",
                     "Column of the picture in which the next fragment falls, or of the pixel that "
                     "edge functions ask next.",
                     whole(-endless, endless), cursor_pixel, 0});
    table.push_back({"cursor.row",
                     "Row of the picture in which the next fragment falls, or of the pixel that "
                     "edge functions ask next.",
                     whole(-endless, endless), cursor_pixel, 1});
}

void add_test_facts(std::vector<Fact>& table) {
    table.push_back({"test.inside",
                     "1 if the pixel that edge functions ask next lies inside, 0 if not.",
                     yes_or_no, [](const Facts& f, int) {
                         const std::optional<PixelTest> test = f.pixel_test();
                         return test ? number(test->is_inside ? 1 : 0) : Value();
                     }});
    for (int i = 0; i < static_cast<int>(edge_function_count); ++i) {
        table.push_back({fmt::format("test.e{}", i),
                         fmt::format("Edge function of edge {} at that pixel's centre, in square "
                                     "pixels.",
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
                         fmt::format("Weight of corner {} at that pixel's centre.", i), real(),
                         [](const Facts& f, int corner) {
                             const std::optional<PixelTest> test = f.pixel_test();
                             if (!test) return Value();
                             return number(test->weights[static_cast<std::size_t>(corner)]);
                         },
                         i});
    }
}

// --- what is looked at

void add_session_facts(std::vector<Fact>& table) {
    table.push_back({"triangle", "Selected triangle, from 0.", count,
                     [](const Facts& f, int) { return number(f.session().selection.triangle); }});
    table.push_back({"triangle.count", "Triangles of the scene.", count, [](const Facts& f, int) {
                         return number(f.results().a.frame.triangle_count());
                     }});
    table.push_back({"triangle.shown",
                     "Triangle that the inspector shows, from 0: the selected one, or "
                     "the one that was just drawn.",
                     count, [](const Facts& f, int) { return number(f.results().a.triangle); }});
    table.push_back({"row", "Selected row of the picture.", whole(-endless, endless),
                     [](const Facts& f, int) { return number(f.session().selection.row); }});
    table.push_back({"vertex", "Selected vertex of the triangle on show, 0 to 2.", whole(0, 2),
                     [](const Facts& f, int) { return number(f.session().selection.vertex); }});
    table.push_back({"tab", "Tab of the inspector that is open.", words(tab_names()),
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
                         "1 while the overlay '" + std::string(info.title) + "' is on.", yes_or_no,
                         [](const Facts& f, int overlay) {
                             const auto which = static_cast<Overlay>(overlay);
                             return number(f.session().overlays.has(which) ? 1 : 0);
                         },
                         static_cast<int>(info.overlay)});
    }
    table.push_back({"zoom", "Screen pixels for each pixel of the picture; 0: it fits.",
                     real(0, 64),
                     [](const Facts& f, int) { return number(f.session().canvas.zoom); }});
}

// --- where the triangle on show lies, and which side it shows

/// Calls `read` with the frame of run A and the triangle on show; none without one.
template <class Read>
Value of_shown_triangle(const Facts& facts, Read read) {
    const RunResults& run = facts.results().a;
    return run.triangle ? read(run.frame, *run.triangle) : Value();
}

/// The words of the reasons why a triangle is not drawn.
constexpr auto rejection_names = [] {
    std::array<std::string_view, rejection_list.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = rejection_list[i].name;
    return names;
}();

Value triangle_arrows(const Facts& facts, int is_cross) {
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        // Of a back that is culled nobody has asked whether all corners have a pixel.
        const auto has_pixel = [&](int v) { return frame.given_vertex(triangle, v).has_pixel; };
        const bool has_pixels =
            frame.is_drawn(triangle) || (frame.rejection(triangle) == Rejection::back_facing &&
                                         has_pixel(0) && has_pixel(1) && has_pixel(2));
        const std::optional<Arrows> arrows =
            has_pixels ? arrows_of(frame.triangle_vertices(triangle)) : std::nullopt;
        if (!arrows) return Value();
        return number(is_cross != 0 ? arrows->cross : arrows->dot);
    });
}

Value triangle_outcode(const Facts& facts, int is_any) {
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        const TriangleSides sides = triangle_sides(frame, triangle);
        return number(is_any != 0 ? sides.any() : sides.common());
    });
}

Value vertex_outcode(const Facts& facts, int) {
    const std::optional<int>& vertex = facts.session().selection.vertex;
    if (!vertex || *vertex < 0 || *vertex >= triangle_corners) return {};
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        return number(triangle_sides(frame, triangle).outcodes[static_cast<std::size_t>(*vertex)]);
    });
}

void add_side_facts(std::vector<Fact>& table) {
    table.push_back({"triangle.rejection", "Why the triangle on show is not drawn, or none.",
                     words(rejection_names), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             return Value(std::string(words(frame.rejection(triangle)).name));
                         });
                     }});
    table.push_back({"triangle.corners",
                     "Corners of what is drawn of the triangle on show: 3 unless it is cut; 0 if "
                     "nothing is.",
                     count, [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             const auto corners = frame.triangle_vertices(triangle).size();
                             return number(frame.is_drawn(triangle) ? static_cast<int>(corners)
                                                                    : 0);
                         });
                     }});
    table.push_back({"triangle.away",
                     "dot(n, v0 - camera) of the triangle on show, world units: positive if it "
                     "shows its back.",
                     real(), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             return number(triangle_sides(frame, triangle).away);
                         });
                     }});
    table.push_back({"triangle.near_t",
                     "t of its first edge that the near plane cuts: 0 at the corner in front.",
                     real(0, 1), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             return number(triangle_sides(frame, triangle).near_t);
                         });
                     }});
    table.push_back({"triangle.dot",
                     "Dot product of its arrows on the screen, from vertices[0] to vertices[1] and "
                     "to vertices[2], in pixels.",
                     real(), triangle_arrows, 0});
    table.push_back({"triangle.cross",
                     "Cross product of the same two arrows: twice the area; positive if the "
                     "corners go round clockwise.",
                     real(), triangle_arrows, 1});
    table.push_back({"triangle.outcode_and",
                     "Bits that the outcodes of its three vertices have in common: near 1, far 2, "
                     "left 4, right 8, top 16, bottom 32.",
                     outcode_bits, triangle_outcode, 0});
    table.push_back({"triangle.outcode_or", "Bits that any of its outcodes has.", outcode_bits,
                     triangle_outcode, 1});
}

// --- the whole frame

template <class Number>
void add_frame_fact(std::vector<Fact>& table, const char* name, const char* help, Number) {
    table.push_back(
        {name, help, count, [](const Facts& f, int) { return Number{}(f.frame_stats()); }});
}

void add_frame_facts(std::vector<Fact>& table) {
    add_frame_fact(table, "frame.fragments",
                   "Fragments that fall in the picture, drawn or not; before stage fill, marks.",
                   [](const FrameStats& s) { return number(s.fragments); });
    add_frame_fact(table, "frame.fragments_outside", "Fragments that fall beside the picture.",
                   [](const FrameStats& s) { return number(s.fragments_outside); });
    add_frame_fact(table, "frame.shaded", "Fragments whose colour is worked out.",
                   [](const FrameStats& s) { return number(s.shaded); });
    add_frame_fact(table, "frame.clipped", "Triangles that clipping has cut.",
                   [](const FrameStats& s) { return number(s.clipped); });
    add_frame_fact(table, "frame.clip_triangles",
                   "Triangles after clipping, uncut ones too: a polygon counts as its fan.",
                   [](const FrameStats& s) { return number(s.clip_triangles); });
    add_frame_fact(
        table, "frame.culled", "Triangles left out because they show their back.",
        [](const FrameStats& s) { return number(s.left_out.of(Rejection::back_facing)); });
    add_frame_fact(table, "frame.rejected",
                   "Triangles left out because all their vertices lie beyond the same plane.",
                   [](const FrameStats& s) { return number(s.left_out.of(Rejection::outside)); });
    add_frame_fact(table, "frame.triangles", "Triangles that are drawn.",
                   [](const FrameStats& s) { return number(s.triangles - s.left_out.total()); });
    add_frame_fact(table, "frame.left_out", "Triangles that are left out.",
                   [](const FrameStats& s) { return number(s.left_out.total()); });
    table.push_back({"frame.edges", "Edges of the triangles that are drawn.", count,
                     [](const Facts& f, int) { return number(f.edge_ends().edges); }});
    table.push_back({"frame.ends_missed",
                     "Edges whose last sample is not on the pixel of their end vertex.", count,
                     [](const Facts& f, int) { return number(f.edge_ends().missed); }});
    add_frame_fact(table, "frame.max_overdraw", "Most fragments on one pixel.",
                   [](const FrameStats& s) { return number(std::int64_t{s.max_overdraw}); });
    add_frame_fact(table, "frame.uncovered", "Pixels on which nothing falls.",
                   [](const FrameStats& s) { return number(s.uncovered); });
    add_frame_fact(table, "frame.rows_outside",
                   "Edge samples that fall outside their triangle's row table.",
                   [](const FrameStats& s) { return number(s.rows_outside); });
    add_frame_fact(table, "frame.rows_outside_triangles", "Triangles that have such samples.",
                   [](const FrameStats& s) { return number(s.rows_outside_triangles); });
}

// --- the picked pixel

Value pixel_place(const Facts& facts, int axis) {
    const std::optional<PixelHistory>& history = facts.results().history;
    return history ? number(axis == 0 ? history->pixel.x : history->pixel.y) : Value();
}

Value pixel_channel(const Facts& facts, int channel) {
    if (!facts.results().history) return {};
    const PixelEntry* const winner = facts.winner();
    return winner != nullptr ? number(winner->colour_after[channel]) : number(0);
}

/// Ndc z of a depth in front of run A's camera; none in a scene in pixels.
Value z_ndc(const Facts& facts, float z) {
    const Frame& frame = facts.results().a.frame;
    if (frame.scene->space == SceneSpace::pixels) return {};
    return number(
        ndc_depth(static_cast<double>(z), vertex_rules(frame.settings, frame.scene->space)));
}

void add_pixel_facts(std::vector<Fact>& table) {
    table.push_back({"pixel.column", "Column of the picked pixel.", place, pixel_place, 0});
    table.push_back({"pixel.row", "Row of the picked pixel.", place, pixel_place, 1});
    table.push_back({"pixel.fragments", "Fragments that fall on the picked pixel, drawn or not.",
                     count, [](const Facts& f, int) {
                         const auto& history = f.results().history;
                         return history ? number(static_cast<std::int64_t>(history->entries.size()))
                                        : Value();
                     }});
    table.push_back({"pixel.uncovered", "1 if nothing falls on the picked pixel.", yes_or_no,
                     [](const Facts& f, int) {
                         const auto& history = f.results().history;
                         return history ? number(history->entries.empty() ? 1 : 0) : Value();
                     }});
    table.push_back({"pixel.losers", "Fragments on the picked pixel that fail the depth test.",
                     count, [](const Facts& f, int) {
                         const auto& history = f.results().history;
                         if (!history) return Value();
                         return number(std::count_if(
                             history->entries.begin(), history->entries.end(),
                             [](const PixelEntry& e) { return e.fate == Fate::depth_failed; }));
                     }});
    table.push_back({"pixel.owner", "Triangle that the picked pixel shows in the end; -1: none.",
                     whole(-1, endless), [](const Facts& f, int) {
                         if (!f.results().history) return Value();
                         const PixelEntry* const winner = f.winner();
                         return number(winner != nullptr ? winner->cursor.triangle : -1);
                     }});
    table.push_back({"pixel.zinv", "1/z of what the picked pixel shows in the end.", real(),
                     [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr ? number(winner->zinv) : Value();
                     }});
    table.push_back({"pixel.z", "z of what the picked pixel shows in the end.", real(),
                     [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr && winner->zinv > 0.0f ? number(winner->z)
                                                                         : Value();
                     }});
    table.push_back({"pixel.z_ndc",
                     "Ndc z of what the picked pixel shows in the end: 0 at the near plane, 1 at "
                     "the far one.",
                     real(), [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr && winner->zinv > 0.0f ? z_ndc(f, winner->z)
                                                                         : Value();
                     }});
    constexpr std::array<const char*, 3> channels{"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        const std::string channel = channels[static_cast<std::size_t>(i)];
        table.push_back({"pixel." + channel,
                         "The picked pixel's " + channel +
                             " in the end, linear, not cut at 1; 0 where nothing falls.",
                         real(), pixel_channel, i});
    }
    table.push_back({"pixel.light_error",
                     "How far off affine interpolation puts the light there, largest channel.",
                     real(0), [](const Facts& f, int) {
                         const auto error = f.interpolation_error();
                         return error ? number(error->light) : Value();
                     }});
    table.push_back({"pixel.position_error",
                     "How far off affine interpolation puts the place there, world units.", real(0),
                     [](const Facts& f, int) {
                         const auto error = f.interpolation_error();
                         return error ? number(error->position) : Value();
                     }});
}

// --- clipping and culling of the triangle on show

template <class Read>
void add_clip_fact(std::vector<Fact>& table, const char* name, const char* help, ValueRange range,
                   Read) {
    table.push_back({name, help, std::move(range), [](const Facts& f, int) {
                         const ClipHistory* const clip = f.clip();
                         return clip != nullptr ? Read{}(*clip) : Value();
                     }});
}

void add_clip_facts(std::vector<Fact>& table) {
    add_clip_fact(table, "polygon.planes", "Planes that cut the triangle on show.",
                  whole(0, static_cast<int>(clip_plane_count)),
                  [](const ClipHistory& c) { return number(std::ssize(c.planes)); });
    add_clip_fact(table, "polygon.cuts", "Cuts of its edges, at all planes together.", count,
                  [](const ClipHistory& c) {
                      std::ptrdiff_t cuts = 0;
                      for (const PlaneHistory& plane : c.planes)
                          cuts += std::count_if(plane.steps.begin(), plane.steps.end(),
                                                [](const ClipStep& step) { return step.is_cut; });
                      return number(cuts);
                  });
    add_clip_fact(table, "polygon.corners", "Corners that clipping leaves of it; 0: nothing.",
                  whole(0, most_corners),
                  [](const ClipHistory& c) { return number(std::ssize(c.polygon)); });
    add_clip_fact(
        table, "polygon.triangles", "Triangles as which it is drawn: a fan of what is left.",
        whole(0, most_corners - 2), [](const ClipHistory& c) { return number(std::ssize(c.fan)); });
    add_clip_fact(table, "polygon.culled", "1 if the triangle on show is culled.", yes_or_no,
                  [](const ClipHistory& c) { return number(c.cull.is_back ? 1 : 0); });
}

// --- the row table of the triangle on show

Value edge_samples(const Facts& facts, int edge) {
    const RowHistory* const table = facts.table();
    if (table == nullptr) return {};
    return number(table->edge_samples[static_cast<std::size_t>(edge)]);
}

/// An end of the selected row; none where no sample reached it.
Value row_end(const Facts& facts, int end) {
    const std::optional<int> row = facts.table_row();
    if (!row || facts.table()->rows.is_empty_row(*row)) return {};
    const PolygonRows& rows = facts.table()->rows;
    return number((end == 0 ? rows.left : rows.right)[static_cast<std::size_t>(*row)].column);
}

Value table_fragments(const Facts& facts, int) {
    const RowHistory* const table = facts.table();
    if (table == nullptr) return {};
    std::int64_t sum = 0;
    for (int row = 0; row < table->rows.size(); ++row)
        sum += table->rows.pixel_count(row);
    return number(sum);
}

void add_table_facts(std::vector<Fact>& table) {
    table.push_back({"table.rows", "Rows of the row table of the triangle on show.", count,
                     [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.size()) : Value();
                     }});
    table.push_back({"table.first_row", "Row of the picture with which the table begins.",
                     whole(-endless, endless), [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.first_row) : Value();
                     }});
    table.push_back({"table.outside", "Edge samples that fall outside the table.", count,
                     [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.outside) : Value();
                     }});
    table.push_back({"table.fragments", "Pixels from end to end of all rows of the table.", count,
                     table_fragments});
    table.push_back({"table.left", "Left end of the selected row, when the table is finished.",
                     whole(-endless, endless), row_end, 0});
    table.push_back({"table.right", "Right end of the selected row, when the table is finished.",
                     whole(-endless, endless), row_end, 1});
    table.push_back({"table.count", "Pixels of the selected row, both ends included.", count,
                     [](const Facts& f, int) {
                         const std::optional<int> row = f.table_row();
                         return row ? number(f.table()->rows.pixel_count(*row)) : Value();
                     }});
    for (int edge = 0; edge < triangle_corners; ++edge) {
        table.push_back(
            {fmt::format("table.e{}.samples", edge),
             fmt::format("How many samples {} of the triangle on show has.", edge_name(edge)),
             count, edge_samples, edge});
    }
}

// --- the selected vertex

/// Which of its numbers: 0 to 2 in the world, 3 to 5 seen from the camera, then projected x and y.
Value vertex_place(const Facts& facts, int which) {
    const ShadedVertex* const vertex = facts.vertex();
    if (vertex == nullptr) return {};
    if (which < 3) return number(vertex->in("world")[which]);
    if (which < 6) return number(vertex->in("rotated")[which - 3]);
    if (vertex->rejection != Rejection::none) return {};
    return number(which == 6 ? vertex->in("projected").x : vertex->in("projected").y);
}

void add_vertex_facts(std::vector<Fact>& table) {
    const auto with_pixel = [](const Facts& f) {
        const ShadedVertex* const vertex = f.vertex();
        return vertex != nullptr && vertex->rejection == Rejection::none ? vertex : nullptr;
    };
    using WithPixel = decltype(with_pixel);
    table.push_back({"vertex.column", "Column of the selected vertex of the triangle on show.",
                     whole(-endless, endless), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.column) : Value();
                     }});
    table.push_back({"vertex.row", "Its row.", whole(-endless, endless), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.row) : Value();
                     }});
    table.push_back({"vertex.zinv", "Its 1/z.", real(), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.inv_w) : Value();
                     }});
    table.push_back(
        {"vertex.z", "Its z before the camera; negative behind it.", real(), vertex_place, 5});
    table.push_back({"vertex.outcode",
                     "Outcode of the selected vertex of the triangle on show: the sides of the "
                     "view beyond which it lies, two pixels at least.",
                     outcode_bits, vertex_outcode});
    table.push_back({"vertex.z_ndc", "Its ndc z: 0 at the near plane, 1 at the far one.", real(),
                     [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? z_ndc(f, vertex->in("rotated").z) : Value();
                     }});
    constexpr std::array<const char*, 8> names{"world_x",     "world_y",    "world_z",
                                               "camera_x",    "camera_y",   "camera_z",
                                               "projected_x", "projected_y"};
    constexpr std::array<const char*, 8> helps{
        "Its place in the world, x.",
        "Its place in the world, y.",
        "Its place in the world, z.",
        "Its place seen from the camera, x.",
        "Its place seen from the camera, y.",
        "Its place seen from the camera, z.",
        "Pixels from the middle of the picture to the right, before int().",
        "Pixels from the middle of the picture downward, before int()."};
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.push_back({std::string("vertex.").append(names[i]), helps[i], real(), vertex_place,
                         static_cast<int>(i)});
    }
}

// --- two runs

/// The comparison of the whole frames; null without a second run, and until it is done.
const Comparison* comparison(const Facts& facts) {
    const Results& results = facts.results();
    return results.b && results.comparison.work.is_done() ? &results.comparison.whole() : nullptr;
}

template <class Read>
void add_compare_fact(std::vector<Fact>& table, const char* name, const char* help,
                      ValueRange range, Read) {
    table.push_back({name, help, std::move(range), [](const Facts& f, int) {
                         const Comparison* const whole = comparison(f);
                         return whole != nullptr ? Read{}(*whole) : Value();
                     }});
}

/// Vertices of the scene's triangles, uncut and drawn in both runs, whose pixel is another one in
/// run B.
Value vertices_elsewhere(const Facts& facts, int) {
    const Results& results = facts.results();
    if (!results.b) return {};
    const Frame &a = results.a.frame, &b = results.b->frame;
    int elsewhere = 0;
    for (int t = 0; t < std::min(a.triangle_count(), b.triangle_count()); ++t) {
        if (!a.is_drawn(t) || !b.is_drawn(t) || a.is_cut(t) || b.is_cut(t)) continue;
        const std::span<const ScreenVertex> in_a = a.triangle_vertices(t);
        const std::span<const ScreenVertex> in_b = b.triangle_vertices(t);
        for (std::size_t v = 0; v < std::min(in_a.size(), in_b.size()); ++v)
            elsewhere += in_a[v].column != in_b[v].column || in_a[v].row != in_b[v].row ? 1 : 0;
    }
    return number(elsewhere);
}

void add_compare_facts(std::vector<Fact>& table) {
    table.push_back({"comparing", "1 while a second run is compared.", yes_or_no,
                     [](const Facts& f, int) { return number(f.session().b ? 1 : 0); }});
    add_compare_fact(table, "compare.different_pixels", "Pixels whose colour differs in run B.",
                     count, [](const Comparison& c) { return number(c.pixels.different); });
    add_compare_fact(table, "compare.largest_difference",
                     "Largest difference of a pixel, linear, of its channel that differs most.",
                     real(0), [](const Comparison& c) { return number(c.pixels.largest); });
    add_compare_fact(table, "compare.mean_difference", "The same on average, over all pixels.",
                     real(0), [](const Comparison& c) { return number(c.pixels.mean); });
    table.push_back({"compare.samples", "Edge samples that lie on another pixel in run B.", count,
                     [](const Facts& f, int) { return number(f.different_samples()); }});
    for (int edge = 0; edge < triangle_corners; ++edge) {
        table.push_back(
            {fmt::format("compare.e{}.samples", edge),
             fmt::format("The same of {} of the triangle on show.", edge_name(edge)), count,
             [](const Facts& f, int e) { return number(f.different_samples(e)); }, edge});
    }
    table.push_back({"compare.vertices_elsewhere",
                     "Corners of triangles that fall on another pixel in run B.", count,
                     vertices_elsewhere});
    add_compare_fact(table, "compare.rows", "Rows of row tables that differ.", count,
                     [](const Comparison& c) { return number(c.different_rows); });
    add_compare_fact(table, "compare.first", "First moment at which the runs differ, or none.",
                     moment(), [](const Comparison& c) {
                         const std::optional<Divergence>& first = c.divergences.first;
                         return first ? Value(first->cursor) : Value();
                     });
}

} // namespace

std::span<const Fact> fact_table() {
    static const std::vector<Fact> table = [] {
        std::vector<Fact> facts;
        add_cursor_facts(facts);
        add_test_facts(facts);
        add_session_facts(facts);
        add_side_facts(facts);
        add_frame_facts(facts);
        add_pixel_facts(facts);
        add_clip_facts(facts);
        add_table_facts(facts);
        add_vertex_facts(facts);
        add_compare_facts(facts);
        return facts;
    }();
    return table;
}

} // namespace rasterwalk
