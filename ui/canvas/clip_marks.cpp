#include "ui/canvas/clip_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "outside/label_places.h"
#include "outside/outside_marks.h"
#include "ui/canvas/marks.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The colour of planes and of what they make.
constexpr Meaning plane_ink = Meaning::left_end;

/// An edge has no position on the screen where it crosses the camera plane: it is drawn up to this
/// part of the greater w of its ends.
constexpr float least_w_share = 1e-4f;

/// Lines are not drawn farther than this beyond the canvas, design pixels.
constexpr float canvas_margin = 40.0f;

struct ScreenLine {
    ImVec2 from, to;
};

/// Where a corner in clip space lies in the picture; w must not be 0.
ImVec2 place_of(const Marks& m, const glm::vec4& clip) {
    const Frame& frame = m.run.frame;
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const glm::vec2 place = frame.stages.perspective_divide(clip, 1.0f / clip.w) +
                            glm::vec2(frame.stages.viewport_middle(rules));
    // Like the corners that were not rounded: see draw_vertices().
    const bool is_rounded = frame.settings.vertex_rounding == VertexRounding::round;
    const float shift = is_rounded ? 0.0f : -0.5f;
    return m.at(place.x + shift, place.y + shift);
}

/// The part of a line within a rectangle, by the method of Liang and Barsky; none if there is none.
std::optional<ScreenLine> cut_to(const ScreenLine& line, ImVec2 low, ImVec2 high) {
    double from = 0.0, to = 1.0;
    const double dx = static_cast<double>(line.to.x) - static_cast<double>(line.from.x);
    const double dy = static_cast<double>(line.to.y) - static_cast<double>(line.from.y);
    const auto cut = [&](double p, double q) {
        if (p == 0.0) return q >= 0.0;
        const double t = q / p;
        (p < 0.0 ? from : to) = p < 0.0 ? std::max(from, t) : std::min(to, t);
        return from <= to;
    };
    const auto wide = [](float a, float b) {
        return static_cast<double>(a) - static_cast<double>(b);
    };
    const bool is_seen = cut(-dx, wide(line.from.x, low.x)) && cut(dx, wide(high.x, line.from.x)) &&
                         cut(-dy, wide(line.from.y, low.y)) && cut(dy, wide(high.y, line.from.y));
    if (!is_seen || !std::isfinite(dx) || !std::isfinite(dy)) return std::nullopt;
    const auto at = [&](double t) {
        return ImVec2(line.from.x + static_cast<float>(t * dx),
                      line.from.y + static_cast<float>(t * dy));
    };
    return ScreenLine{at(from), at(to)};
}

/// An edge between two points in clip space, as far as it lies in front of the camera and within
/// the canvas.
std::optional<ScreenLine> visible_edge(const Marks& m, glm::vec4 a, glm::vec4 b) {
    const float least = least_w_share * std::max(a.w, b.w);
    if (!(least > 0.0f)) return std::nullopt;
    const auto cut = [&](glm::vec4& end, const glm::vec4& other) {
        if (end.w < least) end = other + (other.w - least) / (other.w - end.w) * (end - other);
        end.w = std::max(end.w, least);
    };
    cut(a, b);
    cut(b, a);
    const float beside = canvas_margin * m.u;
    return cut_to({place_of(m, a), place_of(m, b)}, {m.low.x - beside, m.low.y - beside},
                  {m.high.x + beside, m.high.y + beside});
}

void draw_visible_edge(const Marks& m, const CutCorner& a, const CutCorner& b, ImU32 colour,
                       float width) {
    const auto line = visible_edge(m, a.vertex.position_clip, b.vertex.position_clip);
    if (!line) return;
    m.list->AddLine(line->from, line->to, dark_casing, (width + 2.0f) * m.u);
    m.list->AddLine(line->from, line->to, colour, width * m.u);
}

/// The uncut triangle, in the colour of what is taken away: what is left is drawn over it.
void draw_outline_before(const Marks& m, const ClipHistory& history) {
    const std::vector<CutCorner> corners = given_corners(history);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto line = visible_edge(m, corners[i].vertex.position_clip,
                                       corners[(i + 1) % corners.size()].vertex.position_clip);
        if (!line) continue;
        for_each_dash(line->from, line->to, {6.0f * m.u, 300.0f}, [&](ImVec2 from, ImVec2 to) {
            if (!m.has_room()) return;
            m.list->AddLine(from, to, dark_casing, 3.4f * m.u);
            m.list->AddLine(from, to, m.colour(Meaning::fail), 1.6f * m.u);
        });
    }
}

/// The edges that lie on planes, wide enough to be seen next to the lines drawn on them.
void draw_plane_edges(const Marks& m, const std::vector<CutCorner>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i].edge >= 0) continue;
        draw_visible_edge(m, corners[i], corners[(i + 1) % corners.size()], m.colour(plane_ink),
                          5.0f);
    }
}

void draw_fan(const Marks& m, const std::vector<CutCorner>& corners) {
    for (std::size_t i = 2; i + 1 < corners.size(); ++i)
        draw_visible_edge(m, corners[0], corners[i], m.colour(Meaning::current, 0.8f), 1.0f);
}

/// The polygon while planes are working on it.
void draw_polygon_at_work(const Marks& m, const std::vector<CutCorner>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Meaning meaning = corners[i].edge >= 0 ? edge_meaning(corners[i].edge) : plane_ink;
        draw_visible_edge(m, corners[i], corners[(i + 1) % corners.size()], m.colour(meaning),
                          1.8f);
    }
}

void draw_diamond(const Marks& m, ImVec2 at, float reach, ImU32 colour) {
    m.list->AddQuadFilled({at.x, at.y - reach}, {at.x + reach, at.y}, {at.x, at.y + reach},
                          {at.x - reach, at.y}, colour);
}

/// A name to be written next to a point on the canvas.
struct PlaceName {
    ImVec2 at;
    std::string text;
    ImU32 colour;
};

/// @param lines names keep away from these where they can; from the canvas's top left corner
void draw_place_names(const Marks& m, const std::vector<PlaceName>& names, float distance,
                      const std::vector<OutsideLine>& lines) {
    ImFont* const font = m.ui.fonts.small;
    const float around = 3.0f * m.u;
    std::vector<OutsideLabel> labels;
    std::vector<OutsideBox> taken;
    for (const PlaceName& name : names) {
        const glm::vec2 at(name.at.x - m.low.x, name.at.y - m.low.y);
        const glm::vec2 extent(text_width(font, name.text) + 2.0f * around,
                               font->FontSize + 2.0f * around);
        labels.push_back(
            {.point = at, .size = extent, .distance = distance, .line_distance = 2.0f * m.u});
        taken.push_back({at - distance, at + distance});
    }
    const auto places =
        label_places(labels, std::move(taken), lines, {m.high.x - m.low.x, m.high.y - m.low.y});
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!places[i]) continue;
        const ImVec2 low{std::round(m.low.x + places[i]->x), std::round(m.low.y + places[i]->y)};
        m.list->AddRectFilled(low, {low.x + labels[i].size.x, low.y + labels[i].size.y},
                              dark_casing, 3.0f * m.u);
        m.list->AddText(font, font->FontSize, {low.x + around, low.y + around}, names[i].colour,
                        names[i].text.c_str());
    }
}

/// The visible parts of a polygon's edges, from the canvas's top left corner.
std::vector<OutsideLine> visible_edges(const Marks& m, const std::vector<CutCorner>& corners) {
    std::vector<OutsideLine> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto line = visible_edge(m, corners[i].vertex.position_clip,
                                       corners[(i + 1) % corners.size()].vertex.position_clip);
        if (!line) continue;
        edges.push_back({.kind = OutsideLineKind::edge,
                         .from = {line->from.x - m.low.x, line->from.y - m.low.y},
                         .to = {line->to.x - m.low.x, line->to.y - m.low.y}});
    }
    return edges;
}

/// From far away with the names of the planes; close up the names of all corners are written.
void draw_new_corners(const Marks& m, const std::vector<CutCorner>& corners,
                      const std::vector<OutsideLine>& edges, bool has_names) {
    const float reach = 5.5f * m.u;
    std::vector<PlaceName> names;
    for (const CutCorner& corner : corners) {
        if (!corner.is_new() || !(corner.vertex.position_clip.w > 0.0f)) continue;
        const ImVec2 at = place_of(m, corner.vertex.position_clip);
        if (at.x < m.low.x || at.x > m.high.x || at.y < m.low.y || at.y > m.high.y) continue;
        draw_diamond(m, at, reach + 1.8f * m.u, dark_casing);
        draw_diamond(m, at, reach, m.colour(plane_ink));
        names.push_back({at, std::string(word_of(corner.plane)), m.colour(plane_ink)});
    }
    if (has_names) draw_place_names(m, names, reach + 1.5f * m.u, edges);
}

/// Where the division would put what lies behind the camera if it were not cut off first: on the
/// other side of the picture, so the triangle turns inside out.
void draw_divided_corners(const Marks& m, const ClipHistory& history,
                          const std::vector<OutsideLine>& edges) {
    const float radius = 5.0f * m.u;
    std::vector<PlaceName> names;
    for (const CutCorner& corner : corners_behind_camera(history)) {
        const ImVec2 at = place_of(m, corner.vertex.position_clip);
        if (!(at.x >= m.low.x && at.x <= m.high.x && at.y >= m.low.y && at.y <= m.high.y)) continue;
        m.list->AddCircle(at, radius, dark_casing, 0, 4.0f * m.u);
        m.list->AddCircle(at, radius, m.colour(Meaning::fail), 0, 1.8f * m.u);
        names.push_back(
            {at, "dividing puts " + short_corner_name(corner) + " here", m.colour(Meaning::fail)});
    }
    draw_place_names(m, names, radius + 1.5f * m.u, edges);
}

/// The edge that the last step worked on.
void draw_step_at_work(const Marks& m, const ClipHistory& history, const ClipProgress& progress) {
    const PlaneHistory& plane = history.planes[static_cast<std::size_t>(progress.planes)];
    const auto last = static_cast<std::size_t>(progress.steps - 1);
    if (progress.steps < 1 || last >= plane.steps.size()) return;
    const std::vector<CutCorner> before = corners_before(history, progress.planes);
    const ClipStep& step = plane.steps[last];
    draw_visible_edge(m, before[static_cast<std::size_t>(step.from)],
                      before[static_cast<std::size_t>(step.to)], m.colour(Meaning::current), 3.0f);
}

/// Which way round the corners go: an arrow on each edge, and in the middle what culling decided.
void draw_cull_answer(const Marks& m, const ClipHistory& history) {
    const std::vector<CutCorner> corners = corners_before(history);
    ImVec2 middle{0.0f, 0.0f};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec4& a = corners[i].vertex.position_clip;
        const glm::vec4& b = corners[(i + 1) % corners.size()].vertex.position_clip;
        if (!(a.w > 0.0f) || !(b.w > 0.0f)) return; // they have no order on the screen
        draw_visible_edge(m, corners[i], corners[(i + 1) % corners.size()],
                          m.colour(Meaning::current), 1.6f);
        const ImVec2 from = place_of(m, a), to = place_of(m, b);
        middle = {middle.x + from.x, middle.y + from.y};
        const float length = std::hypot(to.x - from.x, to.y - from.y);
        if (!(length > 24.0f * m.u) || !std::isfinite(length)) continue;
        const float reach = 7.0f * m.u;
        const ImVec2 along{reach * (to.x - from.x) / length, reach * (to.y - from.y) / length};
        const ImVec2 at{0.5f * (from.x + to.x), 0.5f * (from.y + to.y)};
        m.list->AddTriangleFilled(
            {at.x + along.x, at.y + along.y}, {at.x - along.x - along.y, at.y - along.y + along.x},
            {at.x - along.x + along.y, at.y - along.y - along.x}, m.colour(Meaning::current));
    }
    const auto count = static_cast<float>(corners.size());
    const bool is_back = history.cull.is_back;
    draw_place_names(m,
                     {{{middle.x / count, middle.y / count},
                       is_back ? "back" : "front",
                       m.colour(is_back ? Meaning::fail : Meaning::pass)}},
                     2.0f * m.u, visible_edges(m, corners));
}

bool is_culling(const Marks& m, const ClipHistory& history) {
    const std::optional<Cursor>& done = m.run.done;
    return done && done->phase == Phase::cull && done->triangle == history.triangle;
}

} // namespace

bool is_before_edges(const Marks& m, const ClipHistory& history) {
    return clip_progress(history, m.run.done).has_value() || is_culling(m, history);
}

void draw_clip_marks(const Marks& m, const ClipHistory& history) {
    if (!history.planes.empty()) {
        const std::optional<ClipProgress> progress = clip_progress(history, m.run.done);
        draw_outline_before(m, history);
        if (progress) {
            draw_polygon_at_work(m, corners_before(history, progress->planes));
            draw_step_at_work(m, history, *progress);
        } else {
            const std::vector<CutCorner> corners = corners_before(history);
            draw_plane_edges(m, corners);
            draw_fan(m, corners);
        }
    }
    if (is_culling(m, history)) draw_cull_answer(m, history);
}

void draw_made_corners(const Marks& m, const ClipHistory& history) {
    if (history.planes.empty()) return;
    std::vector<OutsideLine> edges = visible_edges(m, given_corners(history));
    const auto add = [&](const std::vector<CutCorner>& corners) {
        const std::vector<OutsideLine> more = visible_edges(m, corners);
        edges.insert(edges.end(), more.begin(), more.end());
    };
    if (const auto progress = clip_progress(history, m.run.done)) {
        add(corners_before(history, progress->planes));
        draw_divided_corners(m, history, edges);
        draw_new_corners(m, corners_passed(history, *progress), edges, true);
        return;
    }
    const std::vector<CutCorner> corners = corners_before(history);
    add(corners);
    draw_new_corners(m, corners, edges, !m.is_large() || !m.run.frame.is_drawn(history.triangle));
}

} // namespace rasterwalk
