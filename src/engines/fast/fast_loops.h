#pragma once

// The loops of the fast engine, once for all levels of instructions.
//
// Included by each fast_loops_*.cpp, so it is compiled once for each level. A picture is made as
// follows:
//
//   project_vertices   each vertex once, to whole 256ths of a pixel        lanes are vertices
//   light_vertices     where light is worked out at vertices               lanes are vertices
//   sort_triangles     by size on the screen                               lanes are triangles
//   draw_tiny, draw_small   1/z and owner of each pixel                    lanes are triangles
//   draw_medium        the same                                            lanes are pixels
//   finish_rows        the same for large triangles, row by row; then the
//                      colour of each pixel, once                          lanes are pixels
//
// Visibility comes first, and light is worked out only for visible pixels: 1/z and owner form a
// visibility buffer. Coverage follows one rule everywhere: the centre of a pixel is tested against
// each edge without any rounding error, and a centre on an edge belongs to the triangle that has it
// as a top or a left edge.
//
// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", Computer Graphics 22(4),
// SIGGRAPH 1988; C. A. Burns, W. A. Hunt, "The Visibility Buffer", Journal of Computer Graphics
// Techniques 2(2), 2013. On lanes that are triangles: M. Abrash, "Rasterization on Larrabee", 2009,
// has the pixels of one triangle in lanes, which small triangles leave empty.

#include "engines/fast/fast_data.h"
#include "engines/fast/large_loops.h"
#include "engines/fast/shade_loops.h"
#include "engines/fast/triangle_loops.h"
#include "engines/fast/vertex_loops.h"

namespace {

using namespace rasterwalk::fast;

/// The visible part of a row without the large triangles.
RASTERWALK_INLINE void begin_row(const View& view, std::int32_t row, const Planes& planes,
                                 bool has_owner, const RowPlanes& to) {
    if (planes.visible == nullptr) {
        const auto bytes = static_cast<std::size_t>(view.width) * sizeof(float);
        __builtin_memset(to.inv_z, 0, bytes);
        __builtin_memset(to.colour, 0, bytes);
        for (std::int32_t x = 0; has_owner && x < view.width; x += lane_count)
            store(all(no_owner), to.owner + x);
        return;
    }
    for (std::int32_t x = 0; x < view.width; x += lane_count) {
        const Visible* const from =
            planes.visible + static_cast<std::int64_t>(row) * planes.stride + x;
        const LongLanes seen{load_longs(from), load_longs(from + lane_count / 2)};
        const Ints depth = upper_halves(seen);
        store(depth, to.inv_z + x);
        store(Ints{}, to.colour + x);
        if (has_owner)
            store(choose(depth != Ints{}, ~lower_halves(seen), all(no_owner)), to.owner + x);
    }
}

/// Owners in their final form: those already drawn are ~t.
RASTERWALK_INLINE void keep_owners(const View& view, std::int32_t* owner) {
    for (std::int32_t x = 0; x < view.width; x += lane_count) {
        const Ints of = load(owner + x);
        store(choose(of == all(no_owner), all(-1), ~of), owner + x);
    }
}

constexpr std::int32_t strip_width = 64;

void finish_rows(const Mesh& mesh, const View& view, const Band& band, const Planes& planes) {
    for (std::int32_t block = band.first_row - band.first_row % block_rows; block < band.end_row;
         block += block_rows) {
        std::int32_t active = 0;
        bool leaves_light = planes.visible != nullptr;
        for (std::int32_t i = 0; i < band.large_count; ++i) {
            const LargeTriangle& triangle = band.large[i];
            if (triangle.first_row >= block + block_rows || triangle.end_row <= block) continue;
            cross_block(triangle, block, view.width, band.rows[active++]);
            leaves_light |= triangle.has_flat_light == 0;
        }
        const bool keeps_owner = planes.is_kept != 0;
        const bool has_owner = leaves_light || keeps_owner;
        const std::int32_t first = block > band.first_row ? block : band.first_row;
        const std::int32_t end =
            block + block_rows < band.end_row ? block + block_rows : band.end_row;
        const auto row_planes = [&](std::int32_t row) {
            // One row of memory for all rows, if none is looked at again.
            const std::int32_t kept = keeps_owner ? row : leaves_light ? row - block : 0;
            const std::int64_t offset = static_cast<std::int64_t>(kept) * planes.stride;
            return RowPlanes{planes.inv_z + offset, planes.owner + offset,
                             planes.colour + static_cast<std::int64_t>(row) * planes.stride};
        };
        for (std::int32_t row = first; row < end; ++row) {
            const RowPlanes to = row_planes(row);
            begin_row(view, row, planes, has_owner, to);
            for (std::int32_t i = 0; i < active; ++i) {
                const LargeRows& rows = band.rows[i];
                if (rows.triangle->has_flat_light == 0)
                    draw_row(rows, row - block, to);
                else
                    draw_flat_row(rows, row - block,
                                  number_in_scene(mesh, band, rows.triangle->number), has_owner,
                                  to);
            }
        }
        if (leaves_light) {
            // Strip by strip: neighbouring rows show the same triangles, whose corners are then
            // still in the cache.
            for (std::int32_t x = 0; x < view.width; x += strip_width) {
                const std::int32_t right =
                    x + strip_width < view.width ? x + strip_width : view.width;
                for (std::int32_t row = first; row < end; ++row)
                    shade_row(mesh, view, band, row, x, right, keeps_owner, row_planes(row));
            }
        }
        for (std::int32_t row = first; keeps_owner && row < end; ++row)
            keep_owners(view, row_planes(row).owner);
    }
}

constexpr Loops loops{project_vertices, light_vertices, sort_triangles, draw_tiny,
                      draw_small,       draw_medium,    finish_rows};

} // namespace
