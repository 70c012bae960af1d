#include "ui/canvas/canvas_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "inspect/pixel_tests.h"
#include "session/bench.h"
#include "ui/canvas/clip_marks.h"
#include "ui/canvas/marks.h"
#include "ui/canvas/square_marks.h"
#include "ui/canvas/test_marks.h"
#include "ui/widgets/arrows.h"

namespace rasterwalk {

namespace {

/// More points than this are not ringed: the rings would be a carpet.
constexpr std::size_t most_rings = 500;

void fill_pixel(const Marks& m, int column, int row, ImU32 colour) {
    const ImVec2 c = m.at(static_cast<float>(column), static_cast<float>(row));
    if (!m.is_visible(c)) return;
    const float h = 0.5f * m.scale;
    m.list->AddRectFilled({c.x - h, c.y - h}, {c.x + h, c.y + h}, colour);
}

void frame_pixel(const Marks& m, int column, int row, ImU32 colour, float thickness) {
    const ImVec2 c = m.at(static_cast<float>(column), static_cast<float>(row));
    const float h = std::max(0.5f * m.scale, 3.0f * m.u);
    m.list->AddRect({c.x - h, c.y - h}, {c.x + h, c.y + h}, colour, 0.0f, 0, thickness);
}

/// The pixels of the vertices drawn so far that can be seen, each once; none if there are too many.
std::vector<std::pair<int, int>> visible_points(const Marks& m) {
    const Frame& frame = m.run.frame;
    std::vector<std::pair<int, int>> points;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        for (int v = 0; v < triangle_corners; ++v) {
            if (Cursor{t, Phase::vertices, v, 0} >= m.run.cursor) break;
            const ProjectedVertex& vertex = frame.given_vertex(t, v);
            if (vertex.has_pixel && m.is_visible(m.at(vertex.pixel)))
                points.emplace_back(vertex.pixel.row, vertex.pixel.column);
        }
        // Neighbours share their corners, but no more than this.
        if (points.size() > 16 * most_rings) return {};
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() > most_rings) points.clear();
    return points;
}

/// Points are single pixels, hard to see: each gets a ring.
void draw_point_rings(const Marks& m) {
    if (m.run.frame.settings.stage != Stage::points) return;
    const float radius = std::max(4.0f * m.u, 0.75f * m.scale);
    for (const auto& [row, column] : visible_points(m)) {
        if (!m.has_room()) return;
        m.list->AddCircle(m.at(static_cast<float>(column), static_cast<float>(row)), radius,
                          m.colour(Meaning::pass, 0.8f), 0, 1.3f * m.u);
    }
}

/// A line in a colour, cased so that it can be seen on every picture.
void draw_cased_line(const Marks& m, ImVec2 a, ImVec2 b, ImU32 colour) {
    m.list->AddLine(a, b, dark_casing, 3.6f * m.u);
    m.list->AddLine(a, b, colour, 1.6f * m.u);
}

void draw_dashes(const Marks& m, ImVec2 a, ImVec2 b, ImU32 colour) {
    for_each_dash(a, b, {8.0f * m.u, 400.0f},
                  [&](ImVec2 from, ImVec2 to) { draw_cased_line(m, from, to, colour); });
}

/// How far an edge is walked, 0..1.
float walked_share(const RowHistory& history, int edge) {
    if (history.sample_count == 0) return 1.0f; // coverage walks no edges
    if (!history.last || edge > history.last->edge) return 0.0f;
    const int steps = history.edge_samples[static_cast<std::size_t>(edge)] - 1;
    if (edge < history.last->edge || steps < 1) return 1.0f;
    return static_cast<float>(history.last->sample) / static_cast<float>(steps);
}

/// The true edges: straight lines between the vertices, as far as they are walked; the rest is
/// dashed.
void draw_true_edges(const Marks& m, PolygonCorners vertices) {
    const int edges = static_cast<int>(vertices.size());
    for (int e = 0; e < edges; ++e) {
        const ImVec2 a = m.at(vertices[e]), b = m.at(vertices[(e + 1) % edges]);
        const float share = walked_share(m.run.rows, e);
        const ImVec2 here{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        if (share > 0.0f) draw_cased_line(m, a, here, m.colour(edge_meaning(e)));
        if (share < 1.0f) draw_dashes(m, here, b, m.colour(edge_meaning(e), 0.7f));
    }
}

/// The table on the picture: the pixels that are ends, in the colour of the edge that wrote them,
/// with a bar at the left of left ends and at the right of right ends.
void draw_row_ends(const Marks& m) {
    const RowHistory& history = m.run.rows;
    // Stage `rows` has already painted the ends: the tint needs a dark background there too.
    const bool is_painted = m.run.frame.settings.stage == Stage::rows;
    const float h = 0.5f * m.scale;
    const float bar = std::max(0.09f * m.scale, 2.0f * m.u);
    for (int i = 0; i < history.rows.size(); ++i) {
        const int row = history.rows.first_row + i;
        const int left = history.rows.left[i].column, right = history.rows.right[i].column;
        const ImVec2 row_at = m.at(0.0f, static_cast<float>(row));
        if (!history.left_by[i].is_set() || row_at.y < m.low.y - m.scale ||
            row_at.y > m.high.y + m.scale || !m.has_room()) {
            continue;
        }
        if (is_painted) {
            fill_pixel(m, left, row, IM_COL32(12, 13, 16, 255));
            fill_pixel(m, right, row, IM_COL32(12, 13, 16, 255));
        }
        fill_pixel(m, left, row, m.colour(edge_meaning(history.left_by[i].edge), row_end_tint));
        if (right != left) {
            fill_pixel(m, right, row,
                       m.colour(edge_meaning(history.right_by[i].edge), row_end_tint));
        }
        const ImVec2 l = m.at(static_cast<float>(left), static_cast<float>(row));
        const ImVec2 r = m.at(static_cast<float>(right), static_cast<float>(row));
        m.list->AddRectFilled({l.x - h, l.y - h}, {l.x - h + bar, l.y + h},
                              m.colour(Meaning::left_end));
        m.list->AddRectFilled({r.x + h - bar, r.y - h}, {r.x + h, r.y + h},
                              m.colour(Meaning::right_end));
    }
}

/// Every sample up to the cursor: a dot at its real position, before rounding.
void draw_samples(const Marks& m, int triangle) {
    const float radius = std::clamp(0.09f * m.scale, 1.6f * m.u, 4.5f * m.u);
    for (const EdgeSample& sample : edge_samples(m.run.frame, triangle, m.run.cursor)) {
        const ImVec2 p = m.at(sample.x, sample.y);
        if (!m.is_visible(p) || !m.has_room()) continue;
        m.list->AddCircleFilled(p, radius, m.colour(edge_meaning(sample.edge)));
    }
}

void draw_vertex_labels(const Marks& m, const std::vector<CanvasLabel>& labels) {
    for (const CanvasLabel& label : labels) {
        // The pixel below may be as bright as the letters.
        m.list->AddRectFilled(label.low, label.high, dark_casing, 3.0f * m.u);
        m.list->AddText(m.ui.fonts.bold, m.ui.fonts.bold->FontSize, label.text,
                        m.colour(Meaning::current), label.name.c_str());
    }
}

/// Where each vertex fell before it was rounded, joined to the pixel it became.
void draw_vertices(const Marks& m, int triangle, PolygonCorners vertices) {
    const Frame& frame = m.run.frame;
    const glm::mat3 rotation = camera_rotation(frame.settings.camera);
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const Viewport size = frame.settings.viewport;
    // For a triangle that was cut, the corners drawn are not the scene's.
    const bool is_whole = !frame.is_cut(triangle);
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
        const ImVec2 pixel = m.at(vertices[v]);
        if (is_whole && frame.scene->space == SceneSpace::world) {
            const ShadedVertex shaded =
                shade_vertex(frame.scene->corner(triangle, v), rotation, rules, frame.stages);
            const int middle_column = size.width / 2, middle_row = size.height / 2;
            // int() and floor() map everything from i to i + 1 to pixel i; a pixel that is rounded
            // to has its number in its middle.
            const bool is_rounded = frame.settings.vertex_rounding == VertexRounding::round;
            const float shift = is_rounded ? 0.0f : -0.5f;
            const ImVec2 real =
                m.at(shaded.in("projected").x + static_cast<float>(middle_column) + shift,
                     shaded.in("projected").y + static_cast<float>(middle_row) + shift);
            // The dark rims are for bright pixels, such as a white wall.
            m.list->AddLine(real, pixel, dark_casing, 2.8f * m.u);
            m.list->AddCircle(real, 4.0f * m.u, dark_casing, 0, 3.5f * m.u);
            m.list->AddLine(real, pixel, m.colour(Meaning::current, 0.7f), 1.2f * m.u);
            m.list->AddCircle(real, 4.0f * m.u, m.colour(Meaning::current), 0, 1.5f * m.u);
        }
        m.list->AddCircleFilled(pixel, 7.0f * m.u, dark_casing);
        m.list->AddCircleFilled(pixel, 5.5f * m.u, m.colour(Meaning::current));
    }
}

/// Bright, with a dark rim: it is seen on every picture.
void frame_current(const Marks& m, int column, int row) {
    frame_pixel(m, column, row, dark_casing, 4.5f * m.u);
    frame_pixel(m, column, row, m.colour(Meaning::current), 2.5f * m.u);
}

/// The piece of work that was just done.
void draw_current(const Marks& m) {
    if (!m.run.done || m.run.cursor == cursor_end) return;
    const Frame& frame = m.run.frame;
    const Cursor done = *m.run.done;
    if (is_square(done)) return; // see draw_squares()
    const Timeline timeline(frame);
    switch (done.phase) {
    case Phase::vertices: {
        const ProjectedVertex& vertex = frame.given_vertex(done.triangle, done.index);
        if (!vertex.has_pixel) break;
        frame_current(m, vertex.pixel.column, vertex.pixel.row);
        break;
    }
    case Phase::edges: {
        const Fragment sample = edge_samples(frame, done.triangle, m.run.cursor).back().fragment;
        frame_current(m, sample.column, sample.row);
        break;
    }
    case Phase::tests: {
        const PixelTest test = test_at_step(timeline.moments(done.triangle).rows.tested, done.index,
                                            done.step, frame.stages);
        frame_current(m, test.column, test.row);
        break;
    }
    case Phase::rows: {
        const PolygonRows& rows = timeline.moments(done.triangle).rows;
        const int row = rows.first_row + done.index;
        frame_current(m, rows.left[done.index].column + done.step, row);
        if (!has_fragments(frame.settings.stage)) {
            frame_current(m, rows.right[done.index].column, row);
        }
        break;
    }
    case Phase::resolve:
        frame_current(m, done.step, done.index);
        break;
    case Phase::clip:
    case Phase::cull:
        break; // none of it lies in the picture
    }
}

void draw_lit_row(const Marks& m, int row, float opacity) {
    const Viewport size = m.run.frame.settings.viewport;
    const ImVec2 left = m.at(-0.5f, static_cast<float>(row));
    const ImVec2 right = m.at(static_cast<float>(size.width) - 0.5f, static_cast<float>(row));
    const float h = std::max(0.5f * m.scale, 1.0f);
    m.list->AddRectFilled({left.x, left.y - h}, {right.x, right.y + h},
                          m.colour(Meaning::pass, opacity));
}

/// Does the picture's latest square have this triangle in it? Triangles that are drawn one after
/// another are always at work.
bool is_at_work(const ShownRun& run, const std::optional<int>& triangle) {
    if (run.frame.squares == nullptr) return true;
    return run.done && triangle_at(run.frame, *run.done) == triangle;
}

const ClipHistory* clip_of(const RunResults& run) {
    return run.inspected.clip ? &*run.inspected.clip : nullptr;
}

} // namespace

bool crosses(ImVec2 a, ImVec2 b, ImVec2 low, ImVec2 high) {
    // Clips it to the four sides.
    float from = 0.0f, to = 1.0f;
    const auto clip = [&](float p, float q) {
        // p is how fast the line leaves the side, q how far inside it starts.
        if (p == 0.0f) return q >= 0.0f;
        const float t = q / p;
        if (p < 0.0f) {
            from = std::max(from, t);
        } else {
            to = std::min(to, t);
        }
        return from <= to;
    };
    const float dx = b.x - a.x, dy = b.y - a.y;
    return clip(-dx, a.x - low.x) && clip(dx, high.x - a.x) && clip(-dy, a.y - low.y) &&
           clip(dy, high.y - a.y);
}

ShownRun run_a(const Ui& ui) {
    const RunResults& a = ui.results.a;
    return {a.frame, a.rows, a.whole_rows, a.cursor, a.done, ui.canvas.place, clip_of(a)};
}

ShownRun run_b(const Ui& ui, const PicturePlace& place) {
    const RunResults& b = *ui.results.b;
    return {b.frame, b.rows, b.whole_rows, b.cursor, b.done, place, clip_of(b)};
}

std::vector<CanvasLabel> draw_canvas_marks(const Ui& ui, const ShownRun& run, ImDrawList* list,
                                           ImVec2 low, ImVec2 high) {
    const Marks m{ui, run, list, low, high, ui.options.text_scale, run.place.scale};
    const Frame& frame = run.frame;
    std::vector<CanvasLabel> labels;
    // Anything marked would be where the previous frame has it.
    const bool is_old = ui.results.a.preview.is_shown && ui.results.a.is_frame_late;
    if (!is_old) draw_tested_pixels(m);
    if (m.is_large()) draw_grid(m);
    if (is_old) {
        if (m.is_large()) draw_ruler(m);
        return labels;
    }
    draw_point_rings(m);
    const bool is_picked = ui.session.selection.triangle.has_value();
    const bool is_walking = run.cursor != cursor_end;
    const bool is_elsewhere = is_walking && !is_picked && !is_at_work(run, ui.results.a.triangle);
    const bool has_triangle =
        ui.results.a.triangle && frame.is_drawn(*ui.results.a.triangle) && !is_elsewhere;
    const bool is_marked = m.is_large() || is_picked || is_walking;
    const bool has_clip = run.clip != nullptr && is_marked;
    if (has_clip) draw_clip_marks(m, *run.clip);
    const bool has_edges =
        has_triangle && is_marked && (run.clip == nullptr || !is_before_edges(m, *run.clip));
    PolygonCorners vertices;
    if (has_edges) {
        vertices = frame.triangle_vertices(*ui.results.a.triangle);
        if (m.is_large() && frame.settings.stage >= Stage::edges) draw_row_ends(m);
        draw_tested_box(m);
        draw_true_edges(m, vertices);
    }
    if (has_clip) draw_made_corners(m, *run.clip);
    if (has_edges && m.is_large()) {
        if (frame.settings.stage >= Stage::edges) draw_samples(m, *ui.results.a.triangle);
        draw_vertices(m, *ui.results.a.triangle, vertices);
        labels = vertex_labels(m);
        draw_vertex_labels(m, labels);
    }
    if (ui.inspector.hovered_row) draw_lit_row(m, *ui.inspector.hovered_row, 0.25f);
    if (ui.canvas.hovered_row) draw_lit_row(m, *ui.canvas.hovered_row, 0.25f);
    draw_squares(m);
    draw_current(m);
    // Side by side, what is pointed at in one picture is marked in both.
    if (ui.compare.place_of_b && ui.canvas.hovered_pixel) {
        frame_pixel(m, ui.canvas.hovered_pixel->x, ui.canvas.hovered_pixel->y,
                    IM_COL32(0, 0, 0, 160), 2.5f * m.u);
        frame_pixel(m, ui.canvas.hovered_pixel->x, ui.canvas.hovered_pixel->y,
                    m.colour(Meaning::current), 1.2f * m.u);
    }
    if (ui.session.selection.pixel) {
        const glm::ivec2 pixel = *ui.session.selection.pixel;
        frame_pixel(m, pixel.x, pixel.y, IM_COL32(0, 0, 0, 220), 4.0f * m.u);
        frame_pixel(m, pixel.x, pixel.y, m.colour(Meaning::pass), 2.0f * m.u);
    }
    if (m.is_large()) draw_ruler(m);
    return labels;
}

bool drag_bench_vertex(Ui& ui) {
    if (!is_bench(*ui.session.scene) || ui.session.scene->triangle_count() == 0) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const PicturePlace& place = ui.canvas.place;
    if (ImGui::IsMouseClicked(0)) {
        ui.canvas.dragged_vertex = -1;
        const float reach = std::max(10.0f * ui.options.text_scale, 0.6f * place.scale);
        for (int v = 0; v < triangle_corners; ++v) {
            const glm::vec3 p = ui.session.scene->corner(0, v).position;
            const ImVec2 at = place.middle_of(p.x, p.y);
            if (std::hypot(at.x - mouse.x, at.y - mouse.y) < reach) ui.canvas.dragged_vertex = v;
        }
    }
    if (ui.canvas.dragged_vertex < 0) return false;
    if (!ImGui::IsMouseDown(0)) {
        ui.canvas.dragged_vertex = -1;
        return false;
    }
    const glm::ivec2 pixel(std::floor((mouse.x - place.origin.x) / place.scale),
                           std::floor((mouse.y - place.origin.y) / place.scale));
    const glm::vec3 now = ui.session.scene->corner(0, ui.canvas.dragged_vertex).position;
    if (glm::ivec2(now.x, now.y) != pixel) {
        move_bench_vertex(ui.session, 0, ui.canvas.dragged_vertex, pixel);
    }
    return true;
}

} // namespace rasterwalk
