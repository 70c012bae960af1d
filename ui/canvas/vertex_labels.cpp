#include "ui/canvas/vertex_labels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/element_names.h"
#include "inspect/cut_corners.h"
#include "ui/canvas/marks.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// From this many screen pixels for each pixel there is room for "vertices[0]".
constexpr float full_name_zoom = 24.0f;

/// The number of directions from its vertex in which a name is tried.
constexpr int direction_count = 32;

/// What the names must stay clear of.
struct Surroundings {
    const Marks& m;
    std::vector<ImVec2> vertices; ///< in order, joined by the edges
    const PolygonRows& rows;      ///< of the triangle shown
    ImVec2 low, high;             ///< between which names are not cut off
    ImVec2 middle;                ///< of the triangle
};

/// Does a pixel of one of the triangle's rows lie under the rectangle?
bool covers_rows(const Surroundings& s, ImVec2 low, ImVec2 high) {
    const PicturePlace& place = s.m.run.place;
    const float scale = s.m.scale;
    const auto count = static_cast<float>(s.rows.size());
    const auto line_at = [&](float y) {
        const float line = std::floor((y - place.origin.y) / scale);
        return std::clamp(line - static_cast<float>(s.rows.first_row), -1.0f, count);
    };
    const int first = std::max(static_cast<int>(line_at(low.y)), 0);
    const int last = std::min(static_cast<int>(line_at(high.y)), s.rows.size() - 1);
    for (int i = first; i <= last; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int left = s.rows.left[at].column, right = s.rows.right[at].column;
        if (left > right) continue; // no sample reached it
        if (low.x < place.origin.x + scale * (static_cast<float>(right) + 1.0f) &&
            high.x > place.origin.x + scale * static_cast<float>(left)) {
            return true;
        }
    }
    return false;
}

bool covers_edge(const Surroundings& s, ImVec2 low, ImVec2 high) {
    for (std::size_t e = 0; e < s.vertices.size(); ++e) {
        if (crosses(s.vertices[e], s.vertices[(e + 1) % s.vertices.size()], low, high)) return true;
    }
    return false;
}

CanvasLabel label_towards(const Surroundings& s, std::size_t vertex, std::string name,
                          float angle) {
    const Marks& m = s.m;
    ImFont* const font = m.ui.fonts.bold;
    const float around = 3.0f * m.u;
    // Next to the vertex's own pixel and its dot.
    const float gap = std::max(7.0f * m.u, 0.5f * m.scale + 2.0f * m.u);
    const float width = text_width(font, name);
    const ImVec2 half{0.5f * width + around, 0.5f * font->FontSize};
    const float x = std::cos(angle), y = std::sin(angle);
    const float longer = std::max(std::abs(x), std::abs(y));
    const ImVec2 centre{s.vertices[vertex].x + x / longer * (gap + half.x),
                        s.vertices[vertex].y + y / longer * (gap + half.y)};
    CanvasLabel label;
    label.name = std::move(name);
    label.low = {std::round(centre.x - half.x), std::round(centre.y - half.y)};
    label.high = {label.low.x + 2.0f * half.x, label.low.y + 2.0f * half.y};
    label.text = {label.low.x + around, label.low.y};
    return label;
}

/// The free place nearest to straight outward.
/// @param is_strict also free of rows and edges; if not, only of other names
std::optional<CanvasLabel> find_label(const Surroundings& s, std::size_t vertex,
                                      const std::string& name,
                                      const std::vector<CanvasLabel>& others, bool is_strict) {
    const ImVec2 at = s.vertices[vertex];
    const float dx = at.x - s.middle.x, dy = at.y - s.middle.y;
    const float outwards = dx == 0.0f && dy == 0.0f ? -0.8f : std::atan2(dy, dx);
    const float turn = 2.0f * 3.14159265f / direction_count;
    for (int i = 0; i < direction_count; ++i) {
        // Outwards, then a little to one side, to the other, and further round.
        const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
        CanvasLabel label =
            label_towards(s, vertex, name, outwards + turn * static_cast<float>(step));
        const float border = 3.0f * s.m.u; // of the canvas
        const bool is_whole = label.low.x >= s.low.x && label.low.y >= s.low.y &&
                              label.high.x <= s.high.x - border &&
                              label.high.y <= s.high.y - border;
        if (!is_whole) continue;
        if (is_under_label(label.low, label.high, others)) continue;
        if (is_strict &&
            (covers_rows(s, label.low, label.high) || covers_edge(s, label.low, label.high)))
            continue;
        return label;
    }
    return std::nullopt;
}

/// @param is_full "vertices[0]", or else "v0"
/// @return none if one of them has no free place
std::optional<std::vector<CanvasLabel>> find_labels(const Surroundings& s, bool is_full) {
    std::vector<CanvasLabel> labels;
    const std::vector<std::string> names =
        drawn_corner_names(s.m.run.clip, static_cast<int>(s.vertices.size()), is_full);
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
        const ImVec2 at = s.vertices[v];
        if (at.x < s.low.x || at.x > s.high.x || at.y < s.low.y || at.y > s.high.y) continue;
        const std::string& name = names[v];
        std::optional<CanvasLabel> label = find_label(s, v, name, labels, true);
        if (!label && is_full) return std::nullopt;
        if (!label) label = find_label(s, v, name, labels, false);
        if (label) labels.push_back(*std::move(label));
    }
    return labels;
}

} // namespace

std::vector<CanvasLabel> vertex_labels(const Marks& m) {
    const std::optional<int>& triangle = m.ui.results.a.triangle;
    if (!triangle || !m.run.frame.is_drawn(*triangle) || !m.is_large()) return {};
    Surroundings s{m, {}, m.run.whole_rows, corner_of_labels(m), m.high, {}};
    for (const ScreenVertex& vertex : m.run.frame.triangle_vertices(*triangle)) {
        s.vertices.push_back(m.at(vertex));
        s.middle = {s.middle.x + s.vertices.back().x, s.middle.y + s.vertices.back().y};
    }
    const auto count = static_cast<float>(s.vertices.size());
    s.middle = {s.middle.x / count, s.middle.y / count};
    // With numbers in the cells a long name would cover those of its neighbours.
    const bool is_full =
        m.scale >= full_name_zoom * m.u && m.ui.session.canvas.numbers == CellNumbers::none;
    std::optional<std::vector<CanvasLabel>> labels;
    if (is_full) labels = find_labels(s, true);
    if (!labels) labels = find_labels(s, false);
    return *labels;
}

bool is_under_label(ImVec2 low, ImVec2 high, const std::vector<CanvasLabel>& labels) {
    return std::any_of(labels.begin(), labels.end(), [&](const CanvasLabel& label) {
        return low.x < label.high.x && high.x > label.low.x && low.y < label.high.y &&
               high.y > label.low.y;
    });
}

} // namespace rasterwalk
