#pragma once

// The moments of a frame by plain loops over everything there is.

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/polygon_corners.h"
#include "support/clip_oracle.h"
#include "support/moved_point.h"
#include "support/walks.h"

namespace rasterwalk::test {

/// The pixels that edge functions test, triangle by triangle of the fan, by the places of its
/// corners.
inline void add_tests(const Frame& frame, int t, std::vector<Cursor>& moments) {
    const Settings& settings = frame.settings;
    const int first = settings.bounds == Bounds::excludes_zero ? 1 : 0;
    const PolygonCorners v = frame.triangle_vertices(t);
    // In pixels, on the grid that is set; whole pixels are at their centres. Testing pixels at
    // their corners is as if everything were half a pixel further on.
    const double moved = settings.pixel_sample == PixelSample::corner ? 0.5 : 0.0;
    const auto place = [&](const ScreenVertex& vertex, int axis) {
        const double parts = settings.snap == Snap::sixteenth ? 16.0 : 256.0;
        if (settings.snap == Snap::pixel)
            return (axis == 0 ? vertex.column : vertex.row) + 0.5 + moved;
        return std::floor(static_cast<double>(vertex.position[axis]) * parts + 0.5) / parts + moved;
    };
    int index = 0;
    for (std::size_t i = 2; i < v.size(); ++i) {
        const auto [left, right] =
            std::minmax({place(v[0], 0), place(v[i - 1], 0), place(v[i], 0)});
        const auto [top, bottom] =
            std::minmax({place(v[0], 1), place(v[i - 1], 1), place(v[i], 1)});
        const int begin = static_cast<int>(std::floor(left));
        const auto on_grid = [&](const ScreenVertex& vertex) {
            const double parts = static_cast<double>(grid_parts);
            return GridPoint{std::llround(place(vertex, 0) * parts),
                             std::llround(place(vertex, 1) * parts)};
        };
        const std::vector<GridPoint> corners{on_grid(v[0]), on_grid(v[i - 1]), on_grid(v[i])};
        const bool has_area = side(corners[0], corners[1], corners[2]) != 0;
        const auto is_asked = [&](int column, int row) {
            const GridPoint centre{pixel_centre(column), pixel_centre(row)};
            return settings.box_walk == BoxWalk::all ||
                   (has_area && is_covered(corners, centre, FillRule::inclusive));
        };
        for (int row = static_cast<int>(std::floor(top)); row <= std::floor(bottom); ++row) {
            for (int column = begin; column <= std::floor(right); ++column) {
                const bool is_in = column >= first && column < settings.viewport.width &&
                                   row >= first && row < settings.viewport.height;
                if (is_in && is_asked(column, row))
                    moments.push_back({t, Phase::tests, index, column - begin});
            }
            ++index;
        }
    }
}

/// Every moment of a frame, in order, without `end`.
inline std::vector<Cursor> all_moments(const Frame& frame) {
    std::vector<Cursor> moments;
    const Settings& settings = frame.settings;
    const Viewport size = settings.viewport;
    const int first = settings.bounds == Bounds::excludes_zero ? 1 : 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const Rejection rejection = frame.rejection(t);
        const bool is_clipped_away = rejection == Rejection::clipped_away;
        const bool is_culled = rejection == Rejection::back_facing;
        if (rejection != Rejection::none && !is_clipped_away && !is_culled) continue;
        for (int v = 0; v < 3; ++v)
            moments.push_back({t, Phase::vertices, v, 0});
        const OracleClip clip = oracle_clip(frame, t);
        for (int p = 0; p < 6; ++p) {
            for (int s = 0; s < clip.steps[static_cast<std::size_t>(p)]; ++s)
                moments.push_back({t, Phase::clip, p, s});
        }
        // By the normals of fragments no triangle is culled.
        const bool is_asked = settings.cull != Cull::none && settings.cull != Cull::fragment_normal;
        if (is_asked && !is_clipped_away) moments.push_back({t, Phase::cull, 0, 0});
        if (settings.stage == Stage::points || is_clipped_away || is_culled) continue;
        const PolygonCorners vertices = frame.triangle_vertices(t);
        const int corners = static_cast<int>(vertices.size());
        const bool is_walked =
            settings.coverage == Coverage::rows || settings.stage == Stage::edges;
        for (int e = 0; is_walked && e < corners; ++e) {
            if (settings.edge_samples == EdgeSamples::no_last_edge &&
                settings.line == LineAlgorithm::interpolate && e == corners - 1)
                continue;
            int count =
                edge_sample_count(vertices[e], vertices[(e + 1) % corners], settings.edge_samples);
            if (settings.edge_samples == EdgeSamples::without_last) --count;
            for (int s = 0; s < count; ++s)
                moments.push_back({t, Phase::edges, e, s});
        }
        if (settings.stage == Stage::edges) continue;
        if (settings.coverage == Coverage::edge_functions) add_tests(frame, t, moments);
        PolygonRows rows;
        compute_polygon_rows(vertices, settings, rows);
        for (int r = 0; r < rows.size(); ++r) {
            const int row = rows.first_row + r;
            if (row < first || row >= size.height || rows.is_empty_row(r)) continue;
            if (settings.stage == Stage::rows) {
                moments.push_back({t, Phase::rows, r, 0});
                continue;
            }
            int last = rows.right[r].column;
            if (!is_walked) {
                for (int c = rows.left[r].column; c <= last; ++c) {
                    if (c >= first && c < size.width)
                        moments.push_back({t, Phase::rows, r, c - rows.left[r].column});
                }
                continue;
            }
            if (settings.spans == Spans::last_dropped) --last;
            if (settings.spans == Spans::single_skipped && rows.left[r].column == last) continue;
            for (int c = rows.left[r].column; c <= last; ++c) {
                if (c >= first && c < size.width)
                    moments.push_back({t, Phase::rows, r, c - rows.left[r].column});
            }
        }
    }
    return moments;
}

} // namespace rasterwalk::test
