#include "pipeline/draw.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// Everything that stays the same while a window is drawn.
struct Drawing {
    const Frame& frame;
    DrawWindow window;
    Rectangle clip; ///< what is drawn of the picture: the framebuffer, cut by the scissor
    EdgeRules edges;
    PixelRules pixels;
    DepthTest depth;
    bool is_usual; ///< shading comes after the depth test, and every pixel has a depth cell
    Framebuffer& target;
    Observer* observer;
    DrawTally tally;
};

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

Rectangle clip_rectangle(const DrawWindow& window, const Framebuffer& target) {
    const Rectangle clip{target.origin.x, target.origin.y, target.origin.x + target.size.width,
                         target.origin.y + target.size.height};
    return window.scissor ? intersection(clip, *window.scissor) : clip;
}

/// Can a pixel of the triangle lie in the clip? Tells by the box of its vertices, which is a little
/// too large.
bool can_reach(const Rectangle& clip, std::span<const Fragment> vertices, RowStart row_start) {
    Rectangle box{vertices[0].column, vertices[0].row, vertices[0].column, vertices[0].row};
    for (const Fragment& vertex : vertices.subspan(1)) {
        box.left = std::min(box.left, vertex.column);
        box.right = std::max(box.right, vertex.column);
        box.top = std::min(box.top, vertex.row);
        box.bottom = std::max(box.bottom, vertex.row);
    }
    // A row left of the picture then ends where its right end started.
    if (row_start == RowStart::window) box.right = std::max(box.right, 0);
    // A walk that adds up its steps strays from the box: each addition is off by half a unit in the
    // last place, 2^-24 of the largest value. The bound is twice that; the 1 is for the rounding.
    const int steps = std::max(box.right - box.left, box.bottom - box.top);
    const int largest = std::max({-box.left, box.right, -box.top, box.bottom});
    const int stray =
        1 + static_cast<int>(0x1p-23f * static_cast<float>(steps) * static_cast<float>(largest));
    return box.left - stray < clip.right && box.right + stray >= clip.left &&
           box.top - stray < clip.bottom && box.bottom + stray >= clip.top;
}

/// The part [first, last) of `count` pieces of a phase that begin in the window. `piece` is the
/// first piece of the phase; `field` is the member of the cursor that counts its pieces.
struct Range {
    int first, last;
};
Range clamp_to_window(const DrawWindow& window, Cursor piece, int Cursor::*field, int count) {
    // A cursor of this triangle and phase bounds the loop by its own count; any other lies wholly
    // before or wholly after all pieces.
    const auto begun_before = [&](const Cursor& bound) {
        const bool same_line = bound.triangle == piece.triangle && bound.phase == piece.phase &&
                               (field == &Cursor::index || bound.index == piece.index);
        if (!same_line) return bound > piece ? count : 0;
        const int whole = std::clamp(bound.*field, 0, count);
        const bool within_piece = field == &Cursor::index && bound.step > 0;
        return within_piece ? std::min(whole + 1, count) : whole;
    };
    return {begun_before(window.from), begun_before(window.to)};
}

/// Puts one fragment on the screen: depth test, colour, all planes, the observer. The place must
/// lie in the picture.
template <bool is_usual, class Colour>
void put_fragment(Drawing& d, const Cursor& cursor, const Fragment& fragment, float depth,
                  DepthTest rule, Colour colour) {
    const std::size_t pixel = d.target.at(fragment.column, fragment.row);
    const float stored = d.target.depth[pixel];
    const glm::vec3 before = d.target.colour[pixel];
    bool has_cell = true;
    std::optional<glm::vec3> early;
    if constexpr (!is_usual) {
        const Settings& settings = d.frame.settings;
        has_cell =
            has_depth_cell(fragment.column, fragment.row, settings.viewport, settings.depth_index);
        if (!has_cell && rule != DepthTest::off) ++d.tally.depth_outside;
        if (settings.shading == Shading::before_depth_test) early = colour();
    }
    const bool passed = d.frame.stages->depth_test(depth, stored, rule);
    ++d.tally.fragments;
    ++d.target.overdraw[pixel];
    if (passed) {
        d.target.colour[pixel] = early ? *early : colour();
        if (has_cell) d.target.depth[pixel] = depth;
        d.target.owner[pixel] = cursor.triangle;
    }
    if (d.observer != nullptr) {
        d.observer->fragment({cursor, fragment, passed ? Fate::written : Fate::depth_failed, depth,
                              stored, before, d.target.colour[pixel]});
    }
}

bool in_clip(const Rectangle& clip, const Fragment& fragment) {
    return fragment.column >= clip.left && fragment.column < clip.right &&
           fragment.row >= clip.top && fragment.row < clip.bottom;
}

/// Points, edges and row ends are marks: one colour, no depth.
void put_mark(Drawing& d, const Cursor& cursor, const Fragment& fragment, const glm::vec3& colour) {
    if (!in_clip(d.clip, fragment)) return;
    put_fragment<true>(d, cursor, fragment, d.target.rules.depth_clear, DepthTest::off,
                       [&] { return colour; });
}

constexpr glm::vec3 white{1.0f};

void draw_vertices(Drawing& d, int triangle) {
    const std::span<const Fragment> vertices = d.frame.triangle_vertices(triangle);
    const Range range =
        clamp_to_window(d.window, {triangle, Phase::vertices, 0, 0}, &Cursor::index, 3);
    for (int v = range.first; v < range.last; ++v) {
        const Cursor cursor{triangle, Phase::vertices, v, 0};
        if (d.observer != nullptr) d.observer->vertex(cursor, vertices[v]);
        if (d.frame.settings.stage == Stage::points) put_mark(d, cursor, vertices[v], white);
    }
}

/// Shows the samples of the edges, and tells the observer what each does to a row table of its own.
void draw_edges(Drawing& d, int triangle) {
    const bool shown = d.frame.settings.stage == Stage::edges;
    const bool watched = d.observer != nullptr && d.observer->wants_edge_samples();
    const bool in_window = d.window.from < Cursor{triangle, Phase::rows, 0, 0} &&
                           d.window.to > Cursor{triangle, Phase::edges, 0, 0};
    if ((!shown && !watched) || !in_window) return;
    const std::span<const Fragment> vertices = d.frame.triangle_vertices(triangle);
    static thread_local PolygonRows rows;
    if (watched) begin_polygon_rows(vertices, d.edges, rows);
    for (int e = 0; e < 3; ++e) {
        LineWalker edge = walk_edge(vertices[e], vertices[(e + 1) % 3], d.edges);
        const int count = edge_sample_count(vertices[e], vertices[(e + 1) % 3], d.edges.samples);
        const Range range =
            clamp_to_window(d.window, {triangle, Phase::edges, e, 0}, &Cursor::step, count);
        for (; edge.index() < range.last; edge.advance()) {
            const bool in_range = edge.index() >= range.first;
            if (!in_range && !watched) continue;
            const Cursor cursor{triangle, Phase::edges, e, edge.index()};
            const Fragment& sample = edge.sample();
            if (watched) {
                const RowWrite write = add_edge_sample(sample, rows);
                if (in_range) d.observer->edge_sample({cursor, sample, edge.x(), edge.y(), write});
            }
            if (shown && in_range) put_mark(d, cursor, sample, white);
        }
    }
}

/// Stage `rows`: both ends of each row, the left one first.
void draw_row_ends(Drawing& d, int triangle, const PolygonRows& rows) {
    const Range range =
        clamp_to_window(d.window, {triangle, Phase::rows, 0, 0}, &Cursor::index, rows.size());
    const int first = std::max(range.first, d.clip.top - rows.first_row);
    const int last = std::min(range.last, d.clip.bottom - rows.first_row);
    for (int r = first; r < last; ++r) {
        if (rows.is_empty_row(r)) continue;
        const Cursor cursor{triangle, Phase::rows, r, 0};
        put_mark(d, cursor, rows.left[r], left_end_colour);
        put_mark(d, cursor, rows.right[r], right_end_colour);
    }
}

/// The lab's DrawPolygonRows: every row from its left to its right end, both included.
template <bool is_usual>
void draw_polygon_rows(Drawing& d, int triangle, const PolygonRows& rows) {
    const Vertex& corner = d.frame.scene->triangles[triangle].vertices[0];
    const Surface surface{corner.normal, corner.reflectance};
    const Spans spans = d.frame.settings.spans;
    const Range range =
        clamp_to_window(d.window, {triangle, Phase::rows, 0, 0}, &Cursor::index, rows.size());
    // The row above the first that begins in the window may end in it; its columns will tell.
    const int first_row = std::max({range.first - 1, d.clip.top - rows.first_row, 0});
    const int last_row = std::min(range.last, d.clip.bottom - rows.first_row);
    for (int r = first_row; r < last_row; ++r) {
        if (rows.is_empty_row(r)) continue;
        const Fragment& left = rows.left[r];
        const int count = rows.pixel_count(r);
        const Range columns = clamp_to_window(d.window, {triangle, Phase::rows, r, 0},
                                              &Cursor::step, drawn_pixels(count, spans));
        const int first = std::max(columns.first, d.clip.left - left.column);
        const int last = std::min(columns.last, d.clip.right - left.column);
        if (first >= last) continue;
        // Starts at the left end even if its first columns are not drawn: the numbers must not
        // depend on what is looked at.
        LineWalker row(span_end(left, d.pixels.interpolation),
                       span_end(rows.right[r], d.pixels.interpolation), count, d.edges.line);
        for (row.advance_to(first); row.index() < last; row.advance()) {
            const Fragment& fragment = row.sample_at(left.column + row.index(), left.row);
            put_fragment<is_usual>(d, {triangle, Phase::rows, r, row.index()}, fragment,
                                   depth_value(fragment, d.depth), d.depth, [&] {
                                       ++d.tally.shaded;
                                       return d.frame.stages->pixel_shader(fragment, surface,
                                                                           d.pixels);
                                   });
        }
    }
}

/// What the row table took, and what is wrong with it.
void count_rows(Drawing& d, std::span<const Fragment> vertices, const PolygonRows& rows) {
    const Settings& settings = d.frame.settings;
    d.tally.samples_outside += rows.outside;
    d.tally.triangles_outside += rows.outside > 0 ? 1 : 0;
    const std::int64_t asked = settings.row_search == RowSearch::all_rows ? rows.size() : 1;
    for (std::size_t e = 0; e < vertices.size(); ++e) {
        d.tally.rows_looked_at +=
            asked * edge_sample_count(vertices[e], vertices[(e + 1) % vertices.size()],
                                      settings.edge_samples);
    }
    if (settings.empty_rows == EmptyRows::skipped || !has_fragments(settings.stage)) return;
    for (int r = 0; r < rows.size(); ++r)
        d.tally.unset_rows += rows.is_empty_row(r) ? 1 : 0;
}

void draw_triangle(Drawing& d, int triangle) {
    draw_vertices(d, triangle);
    if (d.frame.settings.stage == Stage::points) return;
    draw_edges(d, triangle);
    static thread_local PolygonRows rows;
    const std::span<const Fragment> vertices = d.frame.triangle_vertices(triangle);
    d.frame.stages->compute_polygon_rows(vertices, d.edges, rows);
    count_rows(d, vertices, rows);
    if (d.frame.settings.stage == Stage::edges) return;
    if (d.frame.settings.stage == Stage::rows) {
        draw_row_ends(d, triangle, rows);
    } else if (d.is_usual) {
        draw_polygon_rows<true>(d, triangle, rows);
    } else {
        draw_polygon_rows<false>(d, triangle, rows);
    }
}

} // namespace

void clear(Framebuffer& framebuffer, const Frame& frame) {
    clear(framebuffer, frame, frame.settings.viewport, {0, 0});
}

void clear(Framebuffer& framebuffer, const Frame& frame, Viewport size, glm::ivec2 origin) {
    clear(framebuffer, size, origin, picture_rules(frame.settings));
}

DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               Observer* observer) {
    Drawing d{.frame = frame,
              .window = window,
              .clip = clip_rectangle(window, framebuffer),
              .edges = edge_rules(frame.settings),
              .pixels = pixel_rules(frame.settings),
              .depth = depth_rule(frame.settings),
              .is_usual = frame.settings.shading == Shading::after_depth_test &&
                          frame.settings.depth_index == DepthIndex::row_major,
              .target = framebuffer,
              .observer = observer,
              .tally = {}};
    // Whoever watches sees every varying; otherwise only those are walked that the shader reads.
    if (observer == nullptr) {
        d.edges.line.carried = carried_varyings(*frame.stages, d.pixels.lighting);
    }
    const Viewport picture = frame.settings.viewport;
    const bool draws_part = !(d.clip == Rectangle{0, 0, picture.width, picture.height});
    d.clip = intersection(d.clip, drawn_area(frame.settings));
    // Only of our own row table is it known that it stays by its vertices.
    const bool passes_over =
        draws_part && frame.stages->compute_polygon_rows == compute_polygon_rows;
    const int count = frame.triangle_count();
    const int last = std::min(window.to.triangle, count - 1);
    for (int t = std::max(window.from.triangle, 0); t <= last; ++t) {
        if (!frame.is_drawn(t)) continue;
        if (passes_over && !can_reach(d.clip, frame.triangle_vertices(t), frame.settings.row_start))
            continue;
        draw_triangle(d, t);
    }
    return d.tally;
}

Framebuffer draw_frame(const Frame& frame) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer);
    return framebuffer;
}

} // namespace rasterwalk
