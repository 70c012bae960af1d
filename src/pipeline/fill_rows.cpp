#include "pipeline/fill_rows.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

DepthResult test_depth(Drawing& d, const Fragment& fragment, std::size_t pixel) {
    d.depth.owner = d.target.owner[pixel];
    return call<depth_test, no_depth_test>(d.stages.depth_test, fragment, d.target.depth[pixel],
                                           d.depth);
}

glm::vec3 shade(Drawing& d, const Fragment& fragment, const Surface& surface) {
    ++d.tally.shaded;
    return d.stages.pixel_shader(fragment, surface, d.pixels, d.stages);
}

/// Does the fragment's pixel have a place in the depth buffer? Counts those tested without one.
bool has_cell(Drawing& d, const Fragment& fragment) {
    const bool has_one = d.all_have_cells || has_depth_cell(d.stages, fragment.column, fragment.row,
                                                            d.frame.settings.viewport);
    if (!has_one && d.is_depth_tested) ++d.tally.depth_outside;
    return has_one;
}

void put_pixel(Drawing& d, std::size_t pixel, int triangle, const glm::vec3& colour, float alpha) {
    d.target.colour[pixel] =
        alpha < 1.0f ? d.stages.blend(colour, alpha, d.target.colour[pixel]) : colour;
    d.target.owner[pixel] = triangle;
}

/// A fragment left out before the depth test changes no plane but the overdraw.
template <bool is_watched>
void leave_out(Drawing& d, const Cursor& cursor, const Fragment& fragment, std::size_t pixel,
               Fate fate, float alpha) {
    ++d.target.overdraw[pixel];
    if constexpr (is_watched) {
        const glm::vec3& colour = d.target.colour[pixel];
        d.observer->fragment(
            {cursor, fragment, fate, fragment.depth, d.target.depth[pixel], colour, colour, alpha});
    }
}

bool is_culled(const Drawing& d, const Fragment& fragment) {
    return d.culls_fragments && d.stages.cull_fragment(fragment, d.rays, d.stages);
}

/// Cull, cut out, depth test, pixel shader, put pixel.
/// @param pixel where the fragment is in the planes
template <bool is_watched>
void draw_fragment(Drawing& d, const Cursor& cursor, const Fragment& fragment, std::size_t pixel,
                   const Surface& surface) {
    if (is_culled(d, fragment))
        return leave_out<is_watched>(d, cursor, fragment, pixel, Fate::back_facing, surface.alpha);
    const FragmentAlpha alpha = fragment_alpha(fragment, surface, d.pixels, d.stages);
    if (alpha.is_cut)
        return leave_out<is_watched>(d, cursor, fragment, pixel, Fate::cut_out, alpha.alpha);
    const float stored = d.target.depth[pixel];
    const glm::vec3 before = d.target.colour[pixel];
    glm::vec3 colour(0.0f);
    if (d.shades_first) colour = shade(d, fragment, surface);
    const bool is_stored = has_cell(d, fragment);
    const DepthResult test = test_depth(d, fragment, pixel);
    ++d.target.overdraw[pixel];
    if (test.passed) {
        if (!d.shades_first) colour = shade(d, fragment, surface);
        if (is_stored) d.target.depth[pixel] = test.depth;
        put_pixel(d, pixel, cursor.triangle, colour, alpha.alpha);
    }
    if constexpr (is_watched) {
        const Fate fate = test.passed ? Fate::written : Fate::depth_failed;
        d.observer->fragment({cursor, fragment, fate, test.depth, stored, before,
                              d.target.colour[pixel], alpha.alpha});
    }
}

/// Consecutive fragments of a row; all must lie in the scissor.
template <bool is_watched>
void draw_fragments(Drawing& d, Cursor cursor, std::span<const LineSample> fragments,
                    const Surface& surface) {
    const Fragment& first = fragments.front().fragment;
    std::size_t pixel = d.target.at(first.column, first.row);
    d.tally.fragments += static_cast<std::int64_t>(fragments.size());
    for (const LineSample& sample : fragments) {
        draw_fragment<is_watched>(d, cursor, sample.fragment, pixel, surface);
        ++cursor.step;
        ++pixel;
    }
}

/// The columns of a row that lie in the window and in the scissor, counted from its left end.
PieceRange columns_in_window(const Drawing& d, const Cursor& row, const RowSpan& span) {
    if (span.drawn <= 0) return {0, 0};
    const PieceRange columns = clamp_to_window(d.window, row, &Cursor::step, span.drawn);
    // In 64 bits: a row that no sample has reached begins at INT_MAX.
    const std::int64_t left = span.left;
    const std::int64_t first = std::max<std::int64_t>(columns.first, d.scissor.left - left);
    const std::int64_t last = std::min<std::int64_t>(columns.last, d.scissor.right - left);
    if (first >= last) return {0, 0};
    return {static_cast<int>(first), static_cast<int>(last)};
}

/// The fragments of a row of the table in these of its columns.
std::span<const LineSample> interpolate_row(Drawing& d, const PolygonRows& rows, int index,
                                            const RowSpan& span, const PieceRange& columns,
                                            VaryingSet carried) {
    const auto i = static_cast<std::size_t>(index);
    const Row row{rows.left[i], rows.right[i], rows.first_row + index, span.count, &rows.tested};
    const std::span<LineSample> fragments = samples_of(d.fragments, columns.last - columns.first);
    call<row_fragments, fragments_by_weights>(d.stages.row_fragments, d.stages, row, columns.first,
                                              carried, fragments);
    return fragments;
}

/// Counts the fragments of a row if none of them is nearer than what its pixel shows; returns
/// whether it did.
bool skip_occluded_row(Drawing& d, std::span<const LineSample> fragments) {
    const Fragment& first = fragments.front().fragment;
    const std::size_t begin = d.target.at(first.column, first.row);
    std::size_t pixel = begin;
    for (const LineSample& sample : fragments) {
        if (depth_test(sample.fragment, d.target.depth[pixel++], d.depth).passed) return false;
    }
    d.tally.fragments += static_cast<std::int64_t>(fragments.size());
    for (pixel = begin; pixel < begin + fragments.size(); ++pixel)
        ++d.target.overdraw[pixel];
    return true;
}

/// The fragments of a row in these of its columns, all at once.
void draw_row_at_once(Drawing& d, const PolygonRows& rows, int triangle, int index,
                      const RowSpan& span, const PieceRange& columns, const Surface& surface) {
    const auto i = static_cast<std::size_t>(index);
    const RowPart part{.left = rows.left[i],
                       .right = rows.right[i],
                       .count = span.count,
                       .first = columns.first,
                       .drawn = columns.last - columns.first,
                       .pixel = d.target.at(span.left + columns.first, rows.first_row + index),
                       .triangle = triangle};
    d.tally.fragments += part.drawn;
    d.tally.shaded += d.row_kernel(part, {surface, d.pixels, d.stages}, d.target);
}

} // namespace

void fill_rows(Drawing& d, const PolygonRows& rows, const Surface& surface, const Cursor& begin) {
    d.depth.triangle = begin.triangle;
    const PieceRange range = clamp_to_window(d.window, begin, &Cursor::index, rows.size());
    // The row above the first that begins in the window may end in it; its columns decide.
    const int first_row = std::max({range.first - 1, d.scissor.top - rows.first_row, 0});
    const int last_row = std::min(range.last, d.scissor.bottom - rows.first_row);
    for (int r = first_row; r < last_row; ++r) {
        const RowSpan span = row_span(d.stages, rows, r);
        Cursor cursor = begin;
        cursor.index = r;
        const PieceRange columns = columns_in_window(d, cursor, span);
        if (columns.first >= columns.last) continue;
        if (d.row_kernel != nullptr) {
            draw_row_at_once(d, rows, begin.triangle, r, span, columns, surface);
            continue;
        }
        if (d.skips_hidden && skip_occluded_row(d, interpolate_row(d, rows, r, span, columns, {})))
            continue;
        const std::span<const LineSample> fragments =
            interpolate_row(d, rows, r, span, columns, d.carried);
        cursor.step = columns.first;
        if (d.observer == nullptr || !d.observer->fragment)
            draw_fragments<false>(d, cursor, fragments, surface);
        else
            draw_fragments<true>(d, cursor, fragments, surface);
    }
}

} // namespace rasterwalk
