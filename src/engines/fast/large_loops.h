#pragma once

// Large triangles, row by row.

#include "engines/fast/colour_lanes.h"
#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"

namespace {

using namespace rasterwalk::fast;

/// A large triangle in the rows of a block. A row's pixels are those whose centres lie at or after
/// the left edge and before the right one. Both are worked out in double, where no centre off an
/// edge is so near to it that rounding could move it there: edges start at 256ths of a pixel and
/// are not higher than 2^22 of them, so such a centre is at least 2^-31 away.
RASTERWALK_INLINE void cross_block(const LargeTriangle& triangle, std::int32_t first_row,
                                   std::int32_t width, LargeRows& rows) {
    constexpr double half_and_less = 0.5 + 0x1p-33;
    double left[block_rows], right[block_rows];
    for (int k = 0; k < block_rows; ++k) {
        left[k] = 0.0;
        right[k] = width;
    }
    for (int e = 0; e < triangle.edge_count; ++e) {
        const double slope = triangle.edge_slope[e], x0 = triangle.edge_x[e] - half_and_less,
                     y0 = triangle.edge_y[e] - 0.5;
        if (triangle.edge_is_left[e] != 0) {
            for (int k = 0; k < block_rows; ++k) {
                const double x = x0 + slope * (static_cast<double>(first_row + k) - y0);
                left[k] = left[k] > x ? left[k] : x;
            }
        } else {
            for (int k = 0; k < block_rows; ++k) {
                const double x = x0 + slope * (static_cast<double>(first_row + k) - y0);
                right[k] = right[k] < x ? right[k] : x;
            }
        }
    }
    for (int k = 0; k < block_rows; ++k) {
        // Both lie from 0 to the width, or the row is empty: ceil as a whole number.
        const double l = left[k] < width ? left[k] : width, r = right[k] > -1.0 ? right[k] : -1.0;
        const auto lw = static_cast<std::int32_t>(l);
        const auto rw = static_cast<std::int32_t>(r + 1.0);
        const std::int32_t begin = lw + (static_cast<double>(lw) < l ? 1 : 0);
        const std::int32_t whole = rw - 1;
        const std::int32_t end = whole + (static_cast<double>(whole) < r ? 1 : 0);
        const std::int32_t row = first_row + k;
        const bool has_row = row >= triangle.first_row && row < triangle.end_row;
        rows.begin[k] = begin;
        rows.end[k] = has_row ? end : 0;
        rows.inv_z[k] =
            static_cast<float>(triangle.z_start + triangle.z_right * begin + triangle.z_down * row);
    }
    rows.triangle = &triangle;
    if (triangle.has_flat_light == 0) return;
    for (int k = 0; k < block_rows; ++k) {
        const float row = static_cast<float>(first_row + k);
        float square = 0.0f, mixed = 0.0f;
        for (int i = 0; i < 3; ++i) {
            const float reach = triangle.reach_start[i] + triangle.reach_down[i] * row;
            square += reach * reach;
            mixed += reach * triangle.reach_right[i];
        }
        rows.quadratic_0[k] = square;
        rows.quadratic_1[k] = 2.0f * mixed;
    }
}

/// The planes of a row, starting at its first pixel.
struct RowPlanes {
    float* inv_z;
    std::int32_t* owner;
    std::uint32_t* colour;
};

/// Goes along a row of a large triangle, lane_count pixels at a time, and calls
/// draw(mask, bits, x, inv_z, column) for those that are nearer than what is already there.
template <class Draw>
RASTERWALK_INLINE void walk_row(const LargeRows& rows, int k, float* inv_z, Draw draw) {
    const std::int32_t begin = rows.begin[k], end = rows.end[k];
    if (begin >= end) return;
    const float step = static_cast<float>(rows.triangle->z_right);
    const Ints lanes = lane_numbers();
    // Start at a line of the cache.
    std::int32_t x = begin & ~(lane_count - 1);
    Floats depth = to_floats(lanes + (x - begin)) * step + rows.inv_z[k];
    Floats column = to_floats(lanes + x);
    const auto group = [&](const Ints& is_in) RASTERWALK_LAMBDA {
        const Ints is_nearer = (depth > load(inv_z + x)) & is_in;
        const std::uint32_t bits = sign_bits(is_nearer);
        if (bits != 0) {
            store_where(is_nearer, bits, depth, inv_z + x);
            draw(is_nearer, bits, x, depth, column);
        }
        depth += step * static_cast<float>(lane_count);
        column += static_cast<float>(lane_count);
        x += lane_count;
    };
    group((lanes + x >= all(begin)) & (lanes + x < all(end)));
    while (x + lane_count <= end)
        group(all(-1));
    if (x < end) group(first_lanes(end - x));
}

template <bool has_owner, bool may_be_white>
RASTERWALK_INLINE void draw_flat_row_as(const LargeRows& rows, int k, std::int32_t number_in_scene,
                                        const RowPlanes& row) {
    const LargeTriangle& triangle = *rows.triangle;
    // Loaded before the loop: it writes to memory, and the compiler cannot know that these stay
    // unchanged.
    const Floats q0 = all(rows.quadratic_0[k]), q1 = all(rows.quadratic_1[k]),
                 q2 = all(triangle.reach_square);
    const Colour3 gain{all(triangle.gain[0]), all(triangle.gain[1]), all(triangle.gain[2])};
    const Colour3 ambient{all(triangle.ambient[0]), all(triangle.ambient[1]),
                          all(triangle.ambient[2])};
    const Ints owner = all(~number_in_scene);
    walk_row(rows, k, row.inv_z,
             [=](const Ints& mask, std::uint32_t bits, std::int32_t x, const Floats& depth,
                 const Floats& column) RASTERWALK_LAMBDA {
                 const Floats reach2 = (column * q2 + q1) * column + q0;
                 const Floats t = depth * rough_inverse_root(reach2);
                 const Floats share = t * t * t;
                 const Colour3 lit{share * gain.red + ambient.red,
                                   share * gain.green + ambient.green,
                                   share * gain.blue + ambient.blue};
                 const Ints colour = may_be_white ? packed(at_most_white(lit)) : packed(lit);
                 store_where(mask, bits, colour, row.colour + x);
                 if constexpr (has_owner) store_where(mask, bits, owner, row.owner + x);
             });
}

/// A row of a triangle whose light has a closed form: large_triangle.h. Its colour is stored at
/// once, and light is worked out again if something nearer follows: the nearest triangles come
/// first.
RASTERWALK_INLINE void draw_flat_row(const LargeRows& rows, int k, std::int32_t number_in_scene,
                                     bool has_owner, const RowPlanes& row) {
    // Separate loops, so that none has to check at every pixel.
    if (has_owner)
        draw_flat_row_as<true, true>(rows, k, number_in_scene, row);
    else if (rows.triangle->may_be_white != 0)
        draw_flat_row_as<false, true>(rows, k, number_in_scene, row);
    else
        draw_flat_row_as<false, false>(rows, k, number_in_scene, row);
}

/// A row of any other: its pixels only note their owner, for shade_row() to find.
RASTERWALK_INLINE void draw_row(const LargeRows& rows, int k, const RowPlanes& row) {
    const Ints owner = all(rows.triangle->number);
    walk_row(rows, k, row.inv_z,
             [&](const Ints& mask, std::uint32_t bits, std::int32_t x, const Floats&, const Floats&)
                 RASTERWALK_LAMBDA { store_where(mask, bits, owner, row.owner + x); });
}

} // namespace
