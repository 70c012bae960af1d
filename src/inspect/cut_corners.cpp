#include "inspect/cut_corners.h"

#include <algorithm>

#include "base/element_names.h"

namespace rasterwalk {

namespace {

/// How many corners the earlier planes make.
int made_before(const ClipHistory& history, int plane) {
    int count = 0;
    for (int p = 0; p < plane; ++p) {
        for (const ClipStep& step : history.planes[static_cast<std::size_t>(p)].steps)
            count += step.is_cut ? 1 : 0;
    }
    return count;
}

/// The corners that the first steps of a plane pass on.
std::vector<CutCorner> passed_on(const std::vector<CutCorner>& before, const PlaneHistory& plane,
                                 std::size_t steps, int made) {
    std::vector<CutCorner> after;
    for (std::size_t i = 0; i < steps; ++i) {
        const ClipStep& step = plane.steps[i];
        if (step.from < 0 || step.from >= static_cast<int>(before.size())) break;
        const CutCorner& from = before[static_cast<std::size_t>(step.from)];
        if (step.keeps_from) after.push_back(from);
        if (!step.is_cut) continue;
        // Where the polygon leaves, it continues along the plane; where it enters, along its edge.
        CutCorner corner = from;
        corner.vertex = step.cut;
        corner.place = CornerPlace::own;
        corner.vertex_index = -1;
        corner.new_index = made++;
        corner.plane = step.plane;
        corner.plane_edge = step.from;
        if (step.is_from_inside) {
            corner.edge = -1;
            corner.edge_plane = step.plane;
        }
        after.push_back(corner);
    }
    return after;
}

/// Puts the corners where these vertices are, if they are the same corners.
void move_to(std::span<const ClipVertex> vertices, CornerPlace place,
             std::vector<CutCorner>& corners) {
    if (vertices.size() != corners.size()) return;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i].vertex.position_clip == vertices[i].position_clip) continue;
        corners[i].vertex = vertices[i];
        corners[i].place = place;
        corners[i].number = static_cast<int>(i);
    }
}

/// The polygon left by a function that does not report its steps: its corners are all new.
std::vector<CutCorner> unexplained_corners(const ClipHistory& history) {
    std::vector<CutCorner> corners;
    for (const ClipVertex& vertex : history.polygon) {
        CutCorner corner;
        corner.vertex = vertex;
        corner.new_index = static_cast<int>(corners.size());
        corners.push_back(corner);
    }
    return corners;
}

} // namespace

std::vector<CutCorner> given_corners(const ClipHistory& history) {
    std::vector<CutCorner> corners;
    for (int i = 0; i < triangle_corners; ++i) {
        CutCorner corner;
        corner.vertex = history.corners[static_cast<std::size_t>(i)];
        corner.vertex_index = i;
        corner.edge = i;
        corners.push_back(corner);
    }
    return corners;
}

std::optional<ClipProgress> clip_progress(const ClipHistory& history,
                                          const std::optional<Cursor>& done) {
    if (!done || done->phase != Phase::clip || done->triangle != history.triangle)
        return std::nullopt;
    for (std::size_t p = 0; p < history.planes.size(); ++p) {
        if (static_cast<int>(history.planes[p].plane) == done->index)
            return ClipProgress{static_cast<int>(p), done->step + 1};
    }
    return std::nullopt;
}

std::vector<CutCorner> corners_before(const ClipHistory& history, int planes) {
    const auto all = static_cast<int>(history.planes.size());
    if (planes > 0 && all == 0 && history.clipped.is_cut) return unexplained_corners(history);
    std::vector<CutCorner> corners = given_corners(history);
    if (all > 0) move_to(history.planes.front().before, CornerPlace::changed, corners);
    for (int p = 0; p < std::min(planes, all); ++p) {
        const PlaneHistory& plane = history.planes[static_cast<std::size_t>(p)];
        corners = passed_on(corners, plane, plane.steps.size(), made_before(history, p));
    }
    if (planes > all) move_to(history.polygon, CornerPlace::handed_on, corners);
    return corners;
}

std::vector<CutCorner> corners_behind_camera(const ClipHistory& history) {
    std::vector<CutCorner> corners = given_corners(history);
    std::erase_if(corners,
                  [](const CutCorner& corner) { return !(corner.vertex.position_clip.w < 0.0f); });
    return corners;
}

int planes_before(const ClipHistory& history, ClipPlane plane) {
    return static_cast<int>(
        std::count_if(history.planes.begin(), history.planes.end(),
                      [plane](const PlaneHistory& other) { return other.plane < plane; }));
}

const PlaneHistory* work_of(const ClipHistory& history, ClipPlane plane) {
    const auto found =
        std::find_if(history.planes.begin(), history.planes.end(),
                     [plane](const PlaneHistory& other) { return other.plane == plane; });
    return found == history.planes.end() ? nullptr : &*found;
}

std::vector<ClipStep> plane_steps(const ClipHistory& history, ClipPlane plane) {
    if (const PlaneHistory* const work = work_of(history, plane)) return work->steps;
    const glm::vec4& coefficients = history.codes.planes[static_cast<std::size_t>(plane)];
    const std::vector<CutCorner> before = corners_before(history, planes_before(history, plane));
    std::vector<ClipStep> steps;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::size_t next = (i + 1) % before.size();
        ClipStep step;
        step.plane = plane;
        step.from = static_cast<int>(i);
        step.to = static_cast<int>(next);
        step.d_from = inner_distance(coefficients, before[i].vertex);
        step.d_to = inner_distance(coefficients, before[next].vertex);
        step.is_from_inside = step.is_to_inside = step.keeps_from = true;
        steps.push_back(step);
    }
    return steps;
}

std::vector<CutCorner> corners_passed(const ClipHistory& history, const ClipProgress& progress) {
    std::vector<CutCorner> corners = corners_before(history, progress.planes);
    if (progress.planes >= static_cast<int>(history.planes.size())) return corners;
    const PlaneHistory& plane = history.planes[static_cast<std::size_t>(progress.planes)];
    const auto steps = std::min(static_cast<std::size_t>(progress.steps), plane.steps.size());
    return passed_on(corners, plane, steps, made_before(history, progress.planes));
}

std::optional<CutCorner> corner_made(const ClipHistory& history, int plane, int edge) {
    for (const CutCorner& corner : corners_before(history, plane + 1)) {
        const bool is_of_plane =
            corner.plane == history.planes[static_cast<std::size_t>(plane)].plane;
        if (corner.is_new() && is_of_plane && corner.plane_edge == edge) return corner;
    }
    return std::nullopt;
}

std::string corner_name(const CutCorner& corner) {
    return corner.is_new() ? "n" + std::to_string(corner.new_index)
                           : vertex_name(corner.vertex_index);
}

std::string short_corner_name(const CutCorner& corner) {
    return corner.is_new() ? corner_name(corner) : short_vertex_name(corner.vertex_index);
}

std::vector<std::string> drawn_corner_names(const ClipHistory* history, int count, bool is_full) {
    std::vector<std::string> names;
    if (history != nullptr && history->clipped.is_cut) {
        for (const CutCorner& corner : corners_before(*history)) {
            names.push_back(is_full ? corner_name(corner) : short_corner_name(corner));
            if (is_full && corner.is_new()) names.back().append(", ").append(word_of(corner.plane));
        }
    }
    if (std::ssize(names) == count) return names;
    names.clear();
    for (int v = 0; v < count; ++v)
        names.push_back(is_full ? vertex_name(v) : short_vertex_name(v));
    return names;
}

} // namespace rasterwalk
