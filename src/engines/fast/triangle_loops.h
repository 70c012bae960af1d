#pragma once

// Triangles by their size, and the pixels that all but the large ones cover.

#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"

namespace {

using namespace rasterwalk::fast;

/// The corners of a triangle in each lane.
struct TriangleLanes {
    Ints x[3], y[3]; ///< 256ths of a pixel
    Floats inv_z[3];
};

/// @param a, b, c their corners, as in Corners
RASTERWALK_INLINE TriangleLanes load_triangles(const Mesh& mesh, const std::int32_t* a,
                                               const std::int32_t* b, const std::int32_t* c) {
    TriangleLanes triangle;
    const std::int32_t* const corners[] = {a, b, c};
    for (int i = 0; i < 3; ++i) {
        const RecordLanes vertex = load_records(mesh.screen, corners[i]);
        triangle.x[i] = bits_of(vertex.a);
        triangle.y[i] = bits_of(vertex.b);
        triangle.inv_z[i] = vertex.c;
    }
    return triangle;
}
/// Those of a list, starting at place i.
RASTERWALK_INLINE TriangleLanes load_triangles(const Mesh& mesh, const TriangleList& list,
                                               std::int32_t i) {
    return load_triangles(mesh, list.a + i, list.b + i, list.c + i);
}

template <class Lanes>
RASTERWALK_INLINE Lanes smallest(const Lanes (&of)[3]) {
    return smaller(of[0], smaller(of[1], of[2]));
}
template <class Lanes>
RASTERWALK_INLINE Lanes largest(const Lanes (&of)[3]) {
    return larger(of[0], larger(of[1], of[2]));
}

/// The first pixel whose centre is at or after a coordinate.
RASTERWALK_INLINE Ints first_pixel(const Ints& coordinate) {
    return (coordinate + (subpixels / 2 - 1)) >> subpixel_bits;
}

/// The pixels that a triangle in each lane can cover; none unless width and height are above 0.
struct BoxLanes {
    Ints left, top, width, height;
};
RASTERWALK_INLINE BoxLanes box_of(const TriangleLanes& triangle) {
    const Ints left = first_pixel(smallest(triangle.x)), top = first_pixel(smallest(triangle.y));
    return {left, top, first_pixel(largest(triangle.x)) - left,
            first_pixel(largest(triangle.y)) - top};
}
/// The part of a box that lies in these rows of the picture.
RASTERWALK_INLINE BoxLanes part_of(const BoxLanes& box, std::int32_t width, std::int32_t first_row,
                                   std::int32_t end_row) {
    const Ints left = larger(box.left, Ints{}), top = larger(box.top, all(first_row));
    return {left, top, smaller(box.left + box.width, all(width)) - left,
            smaller(box.top + box.height, all(end_row)) - top};
}

void sort_triangles(const Mesh& mesh, const View& view, std::int32_t first, std::int32_t end,
                    const BandLists* bands, std::int32_t band_count, TriangleList& cut) {
    std::int32_t numbers[lane_count], offsets[lane_count];
    std::int32_t a[lane_count], b[lane_count], c[lane_count];
    for (std::int32_t i = first; i < end; i += lane_count) {
        const Ints exists = first_lanes(end - i);
        const Ints number = choose(exists, lane_numbers() + i, all(i));
        spill(number, numbers);
        spill(offsets_of(number), offsets);
        const RecordLanes corners = load_records(mesh.triangles, offsets);
        spill(bits_of(corners.a), a);
        spill(bits_of(corners.b), b);
        spill(bits_of(corners.c), c);
        const TriangleLanes triangle = load_triangles(mesh, a, b, c);
        const auto add = [&](std::uint32_t bits, TriangleList& list) {
            const std::int32_t count = list.count;
            append(number, numbers, bits, list.number + count);
            append(bits_of(corners.a), a, bits, list.a + count);
            append(bits_of(corners.b), b, bits, list.b + count);
            append(bits_of(corners.c), c, bits, list.c + count);
            list.count = count + __builtin_popcount(bits);
        };
        const Floats nearest = largest(triangle.inv_z), farthest = smallest(triangle.inv_z);
        const Ints is_whole = farthest > Floats{};
        const Ints is_behind = (nearest == Floats{}) & (farthest == Floats{});
        add(sign_bits(exists & ~is_whole & ~is_behind), cut);
        const BoxLanes box = box_of(triangle);
        const BoxLanes seen = part_of(box, view.width, 0, view.height);
        const Ints is_drawn = exists & is_whole & (seen.width > Ints{}) & (seen.height > Ints{});
        if (sign_bits(is_drawn) == 0) continue;
        const Ints size = larger(box.width, box.height);
        const std::uint32_t larger_than[] = {sign_bits(size > all(tiny_size)),
                                             sign_bits(size > all(small_size)),
                                             sign_bits(size > all(medium_size))};
        for (std::int32_t band = 0; band < band_count; ++band) {
            const BandLists& lists = bands[band];
            std::uint32_t drawn = sign_bits(is_drawn & (box.top < all(lists.end_row)) &
                                            (box.top + box.height > all(lists.first_row)));
            add(drawn & ~larger_than[0], *lists.tiny);
            drawn &= larger_than[0];
            if (drawn == 0) continue;
            add(drawn & ~larger_than[1], *lists.small);
            drawn &= larger_than[1];
            if (drawn == 0) continue;
            add(drawn & ~larger_than[2], *lists.medium);
            add(drawn & larger_than[2], *lists.large);
        }
    }
}

/// Three edge functions and the plane of 1/z of a triangle in each lane, at the first pixel of its
/// box in the picture. Each edge lies opposite the corner with its number.
struct SetUpLanes {
    Ints edge[3];           ///< 0 or more inside: 1 is subtracted if the edge is not owned
    Ints right[3], down[3]; ///< how much an edge function grows
    Floats inv_z, inv_z_right, inv_z_down;
    Floats nearest, farthest; ///< 1/z of the corners: all pixels are between them
    Ints is_front;            ///< corners go round clockwise on the screen
    Ints has_area;
};

/// @param triangle of at most medium_size pixels on each side: then 32 bits hold everything
RASTERWALK_INLINE SetUpLanes set_up(const TriangleLanes& given, const BoxLanes& box) {
    const Ints centre_x = (box.left << subpixel_bits) + subpixels / 2;
    const Ints centre_y = (box.top << subpixel_bits) + subpixels / 2;
    Ints x[3], y[3];
    for (int i = 0; i < 3; ++i) {
        x[i] = given.x[i] - centre_x;
        y[i] = given.y[i] - centre_y;
    }
    const Ints area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    SetUpLanes set;
    set.is_front = area > Ints{};
    set.has_area = area != Ints{};
    // If the corners go round the other way, the second and the third are swapped.
    const Ints turned = area < Ints{};
    const auto change = [&](auto& second, auto& third) {
        const auto kept = second;
        second = choose(turned, third, second);
        third = choose(turned, kept, third);
    };
    Floats inv_z[3] = {given.inv_z[0], given.inv_z[1], given.inv_z[2]};
    change(x[1], x[2]);
    change(y[1], y[2]);
    change(inv_z[1], inv_z[2]);
    const Floats inv_area = 1.0f / to_floats(choose(turned, -area, area));
    set.inv_z = set.inv_z_right = set.inv_z_down = Floats{};
    for (int i = 0; i < 3; ++i) {
        const int from = (i + 1) % 3, to = (i + 2) % 3;
        const Ints dx = x[to] - x[from], dy = y[to] - y[from];
        const Ints edge = dy * x[from] - dx * y[from];
        const Ints is_owned = (dy < Ints{}) | ((dy == Ints{}) & (dx > Ints{}));
        set.edge[i] = edge + ~is_owned;
        set.right[i] = -(dy << subpixel_bits);
        set.down[i] = dx << subpixel_bits;
        const Floats weight = inv_z[i] * inv_area;
        set.inv_z += to_floats(edge) * weight;
        set.inv_z_right += to_floats(set.right[i]) * weight;
        set.inv_z_down += to_floats(set.down[i]) * weight;
    }
    set.nearest = largest(inv_z);
    set.farthest = smallest(inv_z);
    return set;
}

/// Is the triangle of a lane drawn, judging by its side?
RASTERWALK_INLINE Ints is_shown(const SetUpLanes& set, const View& view) {
    return view.culls_backs != 0 ? set.is_front : set.has_area;
}

/// The rows of a box that belong to bands above. 1/z is counted from the first row in the picture,
/// not in the band: otherwise the bits of a picture would depend on where its bands begin.
RASTERWALK_INLINE Ints rows_above(const BoxLanes& box, const Band& band, SetUpLanes& set) {
    const Ints rows = larger(all(band.first_row) - box.top, Ints{});
    for (int e = 0; e < 3; ++e)
        set.edge[e] += set.down[e] * rows;
    return rows;
}

/// Triangles of at most `size` pixels on each side, all lanes going through them pixel by pixel.
template <int size>
RASTERWALK_INLINE void draw_boxes(const Mesh& mesh, const View& view, const TriangleList& list,
                                  const Band& band, const Planes& planes) {
    // This many pixels of each triangle are tested before any is drawn: a bit for each lane of
    // each.
    constexpr int tests = 4;
    static_assert(size * size % tests == 0 && tests % size == 0 && tests * lane_count <= 64);
    std::int32_t pixels[tests * lane_count];
    Visible mine[tests * lane_count];
    for (std::int32_t i = 0; i < list.count; i += lane_count) {
        const TriangleLanes triangle = load_triangles(mesh, list, i);
        const BoxLanes whole = part_of(box_of(triangle), view.width, 0, view.height);
        const BoxLanes box = part_of(whole, view.width, band.first_row, band.end_row);
        SetUpLanes set = set_up(triangle, whole);
        const Floats first_row = to_floats(rows_above(whole, band, set));
        const std::uint32_t drawn =
            sign_bits(is_shown(set, view) & first_lanes(list.count - i) & (box.height > Ints{}));
        if (drawn == 0) continue;
        const Ints number = ~load(list.number + i);
        Ints at_left = box.top * planes.stride + box.left;
        for (int row = 0; row < size;) {
            std::uint64_t covered = 0;
            for (int test = 0; test < tests; ++row) {
                const std::uint32_t has_row = drawn & sign_bits(all(row) < box.height);
                Ints edge[3] = {set.edge[0], set.edge[1], set.edge[2]};
                Floats depth = set.inv_z + (first_row + static_cast<float>(row)) * set.inv_z_down;
                for (int column = 0; column < size; ++column, ++test) {
                    const std::uint64_t inside = ~sign_bits(edge[0] | edge[1] | edge[2]) & has_row &
                                                 sign_bits(all(column) < box.width);
                    covered |= inside << (test * lane_count);
                    const Floats inv_z = smaller(larger(depth, set.farthest), set.nearest);
                    const LongLanes pair = join_halves(number, bits_of(inv_z));
                    store_longs(pair.first, mine + test * lane_count);
                    store_longs(pair.second, mine + test * lane_count + lane_count / 2);
                    store(at_left + column, pixels + test * lane_count);
                    depth += set.inv_z_right;
                    for (int e = 0; e < 3; ++e)
                        edge[e] += set.right[e];
                }
                at_left += planes.stride;
                for (int e = 0; e < 3; ++e)
                    set.edge[e] += set.down[e];
            }
            for (; covered != 0; covered &= covered - 1) {
                const int bit = __builtin_ctzll(covered);
                Visible& seen = planes.visible[pixels[bit]];
                seen = mine[bit] > seen ? mine[bit] : seen;
            }
            if ((drawn & sign_bits(all(row) < box.height)) == 0) break;
        }
    }
}

void draw_tiny(const Mesh& mesh, const View& view, const TriangleList& list, const Band& band,
               const Planes& planes) {
    draw_boxes<tiny_size>(mesh, view, list, band, planes);
}
void draw_small(const Mesh& mesh, const View& view, const TriangleList& list, const Band& band,
                const Planes& planes) {
    draw_boxes<small_size>(mesh, view, list, band, planes);
}

/// Stores the larger number of each pair.
RASTERWALK_INLINE void store_larger(const LongLanes& lanes, Visible* to) {
    store_longs(larger(lanes.first, load_longs(to)), to);
    store_longs(larger(lanes.second, load_longs(to + lane_count / 2)), to + lane_count / 2);
}

void draw_medium(const Mesh& mesh, const View& view, const TriangleList& list, const Band& band,
                 const Planes& planes) {
    std::int32_t left[lane_count], top[lane_count], width[lane_count], height[lane_count];
    std::int32_t edges[3][lane_count], rights[3][lane_count], downs[3][lane_count];
    float depths[lane_count], depth_rights[lane_count], depth_downs[lane_count];
    float nearests[lane_count], farthests[lane_count], first_rows[lane_count];
    const Ints lanes = lane_numbers();
    const Floats lane_steps = to_floats(lanes);
    for (std::int32_t i = 0; i < list.count; i += lane_count) {
        const TriangleLanes triangle = load_triangles(mesh, list, i);
        const BoxLanes whole = part_of(box_of(triangle), view.width, 0, view.height);
        const BoxLanes box = part_of(whole, view.width, band.first_row, band.end_row);
        SetUpLanes set = set_up(triangle, whole);
        store(to_floats(rows_above(whole, band, set)), first_rows);
        std::uint32_t drawn =
            sign_bits(is_shown(set, view) & first_lanes(list.count - i) & (box.height > Ints{}));
        store(box.left, left);
        store(box.top, top);
        store(box.width, width);
        store(box.height, height);
        for (int e = 0; e < 3; ++e) {
            store(set.edge[e], edges[e]);
            store(set.right[e], rights[e]);
            store(set.down[e], downs[e]);
        }
        store(set.inv_z, depths);
        store(set.inv_z_right, depth_rights);
        store(set.inv_z_down, depth_downs);
        store(set.nearest, nearests);
        store(set.farthest, farthests);
        for (; drawn != 0; drawn &= drawn - 1) {
            const int t = __builtin_ctz(drawn);
            const Ints number = all(~list.number[i + t]);
            const Floats nearest = all(nearests[t]), farthest = all(farthests[t]);
            Ints edge[3], right[3];
            for (int e = 0; e < 3; ++e) {
                edge[e] = all(edges[e][t]) + lanes * rights[e][t];
                right[e] = all(rights[e][t] * lane_count);
            }
            const Floats at_left = all(depths[t]) + lane_steps * depth_rights[t];
            const Floats depth_right = all(depth_rights[t] * static_cast<float>(lane_count));
            Visible* seen = planes.visible + top[t] * planes.stride + left[t];
            for (int row = 0; row < height[t]; ++row, seen += planes.stride) {
                Ints e0 = edge[0], e1 = edge[1], e2 = edge[2];
                Floats z = at_left + (first_rows[t] + static_cast<float>(row)) * depth_downs[t];
                for (int column = 0; column < width[t]; column += lane_count) {
                    const Ints is_inside =
                        ~((e0 | e1 | e2) >> 31) & (lanes < all(width[t] - column));
                    if (sign_bits(is_inside) != 0) {
                        const Floats mine = smaller(larger(z, farthest), nearest);
                        // Outside the triangle the value is 0, which is never visible.
                        store_larger(join_halves(number & is_inside, bits_of(mine) & is_inside),
                                     seen + column);
                    }
                    e0 += right[0];
                    e1 += right[1];
                    e2 += right[2];
                    z += depth_right;
                }
                for (int e = 0; e < 3; ++e)
                    edge[e] += downs[e][t];
            }
        }
    }
}

} // namespace
