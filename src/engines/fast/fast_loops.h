// The loops of the fast engine, once for all levels of instructions.
//
// Included by each fast_loops_*.cpp behind lanes.h; compiled as often as there are levels. A
// picture is made as follows:
//
//   project_vertices   each vertex once, to whole 256ths of a pixel        lanes are vertices
//   light_vertices     where light is worked out at vertices               lanes are vertices
//   sort_triangles     by size on the screen                               lanes are triangles
//   draw_small         1/z and owner of each pixel                         lanes are triangles
//   draw_medium        the same                                            lanes are pixels
//   finish_rows        the same of large triangles, row by row; then the
//                      colour of each pixel, once                          lanes are pixels
//
// That which is seen is found first, and light is worked out for nothing else: the planes of 1/z
// and owner are a visibility buffer. Coverage is the same everywhere: the centre of a pixel is
// asked for the side of each edge on which it lies, in whole numbers and so without any error; what
// lies on an edge belongs to the triangle of which it is a top or a left edge.
//
// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", Computer Graphics 22(4),
// SIGGRAPH 1988; C. A. Burns, W. A. Hunt, "The Visibility Buffer", Journal of Computer Graphics
// Techniques 2(2), 2013. Lanes that are triangles: M. Abrash, "Rasterization on Larrabee", 2009,
// has the pixels of one triangle in lanes, which small triangles leave empty.

#include "engines/fast/fast_data.h"

namespace {

using namespace rasterwalk::fast;

// ---------------------------------------------------------------- vertices

/// To the nearest 256th, halves up, as stages/snap.h.
RASTERWALK_INLINE Ints to_subpixels(const Floats& pixels) {
    return floor_of(pixels * static_cast<float>(subpixels) + 0.5f);
}

void project_vertices(const Mesh& mesh, const View& view, std::int32_t first, std::int32_t count) {
    for (std::int32_t i = first; i < first + count; i += lane_count) {
        const Floats x = load(mesh.x + i) - view.eye[0], y = load(mesh.y + i) - view.eye[1],
                     z = load(mesh.z + i) - view.eye[2];
        const auto along = [&](const float(&axis)[3]) {
            return x * axis[0] + y * axis[1] + z * axis[2];
        };
        const Floats depth = along(view.axes[2]);
        const Floats inv_z = 1.0f / depth;
        const Floats scale = inv_z * view.focal_length;
        const Floats column = along(view.axes[0]) * scale + view.middle[0];
        const Floats row = along(view.axes[1]) * scale + view.middle[1];
        // As whole numbers, in which what is no number is larger than any.
        const Ints is_near = bits_of(depth) < bits_of(all(view.near));
        const Ints no_sign = all(0x7fffffff);
        const Ints guard = bits_of(all(guard_band));
        const Ints is_far_out =
            ((bits_of(column) & no_sign) >= guard) | ((bits_of(row) & no_sign) >= guard);
        const Floats mark = choose(is_near, all(behind_near), all(beyond_guard));
        const Ints is_out = is_near | is_far_out;
        const Ints sx = choose(is_out, Ints{}, to_subpixels(column));
        const Ints sy = choose(is_out, Ints{}, to_subpixels(row));
        const Floats depths = choose(is_out, mark, inv_z);
        for (int lane = 0; lane < lane_count; ++lane)
            mesh.screen[i + lane] = {sx[lane], sy[lane], depths[lane], 0.0f};
    }
}

// ---------------------------------------------------------------- light

struct Vector3 {
    Floats x, y, z;
};
RASTERWALK_INLINE Floats dot(const Vector3& a, const Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// log2(x) for x > 0, to about 1e-6: the exponent, and a series in (m - 1) / (m + 1).
RASTERWALK_INLINE Floats log2_of(const Floats& x) {
    const Ints bits = bits_of(x);
    const Ints exponent = (bits >> 23) - 127;
    const Floats m = floats_of((bits & all(0x007fffff)) | all(0x3f800000));
    const Floats s = (m - 1.0f) / (m + 1.0f), s2 = s * s;
    const Floats series =
        s * (2.885390082f +
             s2 * (0.961796694f + s2 * (0.577078016f + s2 * (0.412198583f + s2 * 0.320598898f))));
    return to_floats(exponent) + series;
}
/// 2^x for x <= 0.
RASTERWALK_INLINE Floats exp2_of(const Floats& given) {
    const Floats x = larger(given, all(-126.0f));
    const Ints whole = floor_of(x);
    const Floats f = x - to_floats(whole);
    const Floats series =
        1.0f + f * (0.693147181f +
                    f * (0.240226507f +
                         f * (0.0555041087f +
                              f * (0.00961812911f + f * (0.00133335581f + f * 0.000154035304f)))));
    return series * floats_of((whole + 127) << 23);
}

/// What of the light does not depend on power and reflectance.
struct LightShares {
    Floats diffuse;   ///< max(n . l, 0) / (4 pi r^2)
    Floats highlight; ///< max(n . h, 0)^e / (4 pi r^2), only where n . l > 0
};

constexpr float one_over_4_pi = 0.0795774715f;

/// @param to_lamp     scaled by `scale`
/// @param to_eye      any length
/// @param normal      any length
/// @param scale       what the vector to the lamp was multiplied by, above 0
RASTERWALK_INLINE LightShares light_shares(const Vector3& to_lamp, const Floats& scale,
                                           const Vector3& normal, const Vector3& to_eye,
                                           bool has_highlights, const Floats& exponent) {
    // At the lamp itself there is no direction to it, and no light.
    const Floats least = all(1e-30f);
    const Floats r2 = dot(to_lamp, to_lamp), n2 = dot(normal, normal);
    const Floats inv_r = inverse_root(larger(r2, least)), inv_n = inverse_root(larger(n2, least));
    const Floats along = dot(to_lamp, normal);
    const Floats cosine = larger(along * inv_r * inv_n, Floats{});
    const Floats inv_distance = inv_r * scale;
    const Floats spread = inv_distance * inv_distance * one_over_4_pi;
    LightShares shares{cosine * spread, Floats{}};
    if (!has_highlights) return shares;
    const Floats inv_e = inverse_root(larger(dot(to_eye, to_eye), least));
    const Vector3 half{to_lamp.x * inv_r + to_eye.x * inv_e, to_lamp.y * inv_r + to_eye.y * inv_e,
                       to_lamp.z * inv_r + to_eye.z * inv_e};
    const Floats inv_h = inverse_root(larger(dot(half, half), least));
    const Floats n_dot_h = larger(dot(normal, half) * inv_n * inv_h, least);
    const Floats power = exp2_of(smaller(log2_of(n_dot_h), Floats{}) * exponent);
    shares.highlight = choose(along > Floats{}, power * spread, Floats{});
    return shares;
}

void light_vertices(const Mesh& mesh, const View& view, std::int32_t first, std::int32_t count) {
    const Ints lanes = lane_numbers();
    for (std::int32_t i = first; i < first + count; i += lane_count) {
        const Vector3 place{load(mesh.x + i), load(mesh.y + i), load(mesh.z + i)};
        std::int32_t offsets[lane_count];
        spill(offsets_of(lanes + i), offsets);
        const RecordLanes normal = load_records(mesh.normals, offsets);
        const Vector3 to_lamp{view.lamp[0] - place.x, view.lamp[1] - place.y,
                              view.lamp[2] - place.z};
        const Vector3 to_eye{view.eye[0] - place.x, view.eye[1] - place.y, view.eye[2] - place.z};
        const bool has_highlights = view.has_highlights != 0 && mesh.exponents != nullptr;
        const LightShares shares =
            light_shares(to_lamp, all(1.0f), {normal.a, normal.b, normal.c}, to_eye, has_highlights,
                         has_highlights ? load(mesh.exponents + i) : all(1.0f));
        for (int lane = 0; lane < lane_count; ++lane)
            mesh.light[i + lane] = {shares.diffuse[lane], shares.highlight[lane], {}};
    }
}

// ---------------------------------------------------------------- triangles

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
/// Those from place i of a list on.
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

/// The first pixel whose centre does not lie before a coordinate.
RASTERWALK_INLINE Ints first_pixel(const Ints& coordinate) {
    return (coordinate + (subpixels / 2 - 1)) >> subpixel_bits;
}

/// The pixels that a triangle in each lane can cover; none where width or height is not above 0.
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

/// Three edge functions and the plane of 1/z of a triangle in each lane, at the first pixel of what
/// the picture shows of its box. Each edge lies opposite of the corner of its number.
struct SetUpLanes {
    Ints edge[3];           ///< at least 0 inside: 1 is taken away where the edge is not owned
    Ints right[3], down[3]; ///< what an edge function grows by
    Floats inv_z, inv_z_right, inv_z_down;
    Floats nearest, farthest; ///< 1/z of the corners: no pixel is beyond them
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
    // Corners that go round the other way: the second and the third change places.
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

/// Is the triangle of a lane drawn, as far as its sides tell?
RASTERWALK_INLINE Ints is_shown(const SetUpLanes& set, const View& view) {
    return view.culls_backs != 0 ? set.is_front : set.has_area;
}

/// The rows of a box that bands above have drawn. 1/z is counted from the first row in the picture,
/// not in the band: else the bits of a picture would depend on where its bands begin.
RASTERWALK_INLINE Ints rows_above(const BoxLanes& box, const Band& band, SetUpLanes& set) {
    const Ints rows = larger(all(band.first_row) - box.top, Ints{});
    for (int e = 0; e < 3; ++e)
        set.edge[e] += set.down[e] * rows;
    return rows;
}

/// Triangles of at most `size` pixels on each side, which all lanes go through pixel by pixel.
template <int size>
RASTERWALK_INLINE void draw_boxes(const Mesh& mesh, const View& view, const TriangleList& list,
                                  const Band& band, const Planes& planes) {
    // So many pixels of each triangle are tested before any is drawn: a bit for each lane of each.
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

/// Puts down the larger number of each pair.
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
                        // Beside the triangle stands 0, which is never seen.
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

// ---------------------------------------------------------------- large triangles

/// What a large triangle is in the rows of a block. A row's pixels are those whose centres lie from
/// the left edge on up to before the right one; both are worked out in double, where no place that
/// is not on the edge is so near to it that rounding could move it there: edges start at 256ths of
/// a pixel and are not higher than 2^22 of them, so such a place is at least 2^-31 away.
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

// ---------------------------------------------------------------- colour

/// The end of a run of pixels whose colour is to be worked out.
RASTERWALK_INLINE std::int32_t end_of_run(const std::int32_t* owner, std::int32_t x,
                                          std::int32_t end) {
    for (; x < end; x += lane_count) {
        const std::uint32_t other = sign_bits(load(owner + x));
        if (other != 0) {
            x += __builtin_ctz(other);
            return x < end ? x : end;
        }
    }
    return end;
}

/// Red, green and blue in lanes.
struct Colour3 {
    Floats red, green, blue;
};

RASTERWALK_INLINE Ints packed(const Floats& red, const Floats& green, const Floats& blue) {
    const Floats most = all(255.0f);
    return to_ints(smaller(red, most)) << 16 | to_ints(smaller(green, most)) << 8 |
           to_ints(smaller(blue, most));
}

/// Puts down a group of colours: the first `count` of them.
RASTERWALK_INLINE void store_colours(const Ints& colours, int count, std::uint32_t* to) {
    if (count >= lane_count)
        store(colours, to);
    else
        store_where(first_lanes(count), colours, to);
}

/// Where a row is drawn, from its first pixel on.
struct RowPlanes {
    float* inv_z;
    std::int32_t* owner;
    std::uint32_t* colour;
};

/// Goes along a row of a large triangle, lane_count pixels at a time, and calls
/// draw(mask, bits, x, inv_z, column) for those that are nearer than what is there.
template <class Draw>
RASTERWALK_INLINE void walk_row(const LargeRows& rows, int k, float* inv_z, Draw draw) {
    const std::int32_t begin = rows.begin[k], end = rows.end[k];
    if (begin >= end) return;
    const float step = static_cast<float>(rows.triangle->z_right);
    const Ints lanes = lane_numbers();
    // From a whole line of memory on.
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

/// A row of a triangle whose light has a closed form: large_triangle.h. Its colour is put at once,
/// and light is worked out again where something nearer follows: the nearest triangles come first.
RASTERWALK_INLINE void draw_flat_row(const LargeRows& rows, int k, std::int32_t number_in_scene,
                                     bool has_owner, const RowPlanes& row) {
    const LargeTriangle& triangle = *rows.triangle;
    // Taken before the loop: it writes to memory, and the compiler cannot know that not to these.
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
                 const Ints colour =
                     packed(share * gain.red + ambient.red, share * gain.green + ambient.green,
                            share * gain.blue + ambient.blue);
                 store_where(mask, bits, colour, row.colour + x);
                 if (has_owner) store_where(mask, bits, owner, row.owner + x);
             });
}

/// A row of any other: whose pixels they are is noted, and shade_row() finds it there.
RASTERWALK_INLINE void draw_row(const LargeRows& rows, int k, const RowPlanes& row) {
    const Ints owner = all(rows.triangle->number);
    walk_row(rows, k, row.inv_z,
             [&](const Ints& mask, std::uint32_t bits, std::int32_t x, const Floats&, const Floats&)
                 RASTERWALK_LAMBDA { store_where(mask, bits, owner, row.owner + x); });
}

/// The number of the texel in place `texel` of a line of `count`, as stages/texture_lookup.h.
RASTERWALK_INLINE std::int32_t wrapped(std::int32_t texel, std::int32_t count, Wrap wrap) {
    if (wrap == Wrap::clamp) return texel < 0 ? 0 : texel >= count ? count - 1 : texel;
    const std::int32_t period = wrap == Wrap::mirror ? 2 * count : count;
    std::int32_t rest = texel % period;
    if (rest < 0) rest += period;
    return rest < count ? rest : period - 1 - rest;
}

/// The colour of a texture at a place in each lane.
RASTERWALK_INLINE Colour3 texture_colour(const Texels& texture, const View& view, const Floats& u,
                                         const Floats& v) {
    // Beyond this a place is none, as in among_texels().
    const auto place = [](const Floats& coordinate, std::int32_t count) {
        const Floats at = coordinate * static_cast<float>(count);
        const Ints is_small = (bits_of(at) & all(0x7fffffff)) < bits_of(all(0x1p30f));
        return choose(is_small, at, Floats{});
    };
    Floats x = place(u, texture.width), y = place(v, texture.height);
    if (view.is_bilinear != 0) {
        x -= 0.5f;
        y -= 0.5f;
    }
    const Ints column = floor_of(x), row = floor_of(y);
    const auto texels = [&](std::int32_t right, std::int32_t down) {
        Ints taken = {};
        for (int lane = 0; lane < lane_count; ++lane) {
            const std::int32_t c = wrapped(column[lane] + right, texture.width, view.wrap);
            const std::int32_t r = wrapped(row[lane] + down, texture.height, view.wrap);
            taken[lane] = static_cast<std::int32_t>(
                texture.texels[static_cast<std::int64_t>(r) * texture.width + c]);
        }
        return taken;
    };
    const auto channels = [](const Ints& texel) {
        const Ints byte = all(255);
        return Colour3{to_floats(texel & byte), to_floats(texel >> 8 & byte),
                       to_floats(texel >> 16 & byte)};
    };
    constexpr float of_byte = 1.0f / 255.0f;
    Colour3 colour{};
    if (view.is_bilinear == 0) {
        colour = channels(texels(0, 0));
    } else {
        const Floats across = x - to_floats(column), along = y - to_floats(row);
        const auto add = [&](std::int32_t right, std::int32_t down, const Floats& weight) {
            const Colour3 texel = channels(texels(right, down));
            colour.red += texel.red * weight;
            colour.green += texel.green * weight;
            colour.blue += texel.blue * weight;
        };
        add(0, 0, (1.0f - across) * (1.0f - along));
        add(1, 0, across * (1.0f - along));
        add(0, 1, (1.0f - across) * along);
        add(1, 1, across * along);
    }
    return {colour.red * of_byte, colour.green * of_byte, colour.blue * of_byte};
}

/// R = reflectance (P D + N).
RASTERWALK_INLINE Colour3 reflected(const LightShares& shares, const Colour3& reflectance,
                                    const View& view) {
    return {reflectance.red * (shares.diffuse * view.power[0] + view.indirect[0]),
            reflectance.green * (shares.diffuse * view.power[1] + view.indirect[1]),
            reflectance.blue * (shares.diffuse * view.power[2] + view.indirect[2])};
}
RASTERWALK_INLINE void add_highlight(const LightShares& shares, const Material& material,
                                     const View& view, Colour3& lit) {
    lit.red += shares.highlight * (material.specular[0] * view.power[0]);
    lit.green += shares.highlight * (material.specular[1] * view.power[1]);
    lit.blue += shares.highlight * (material.specular[2] * view.power[2]);
}

/// What the weights of the corners make of their values.
struct CornerLanes {
    std::int32_t a[lane_count], b[lane_count], c[lane_count];
    Floats weight_a, weight_b, weight_c;

    template <class Values>
    RASTERWALK_INLINE_MEMBER RecordLanes mix(const Values* records) const {
        const RecordLanes p = load_records(records, a), q = load_records(records, b),
                          r = load_records(records, c);
        return {p.a * weight_a + q.a * weight_b + r.a * weight_c,
                p.b * weight_a + q.b * weight_b + r.b * weight_c,
                p.c * weight_a + q.c * weight_b + r.c * weight_c,
                p.d * weight_a + q.d * weight_b + r.d * weight_c};
    }
};

/// R of each corner, mixed: where corners have reflectances of their own.
RASTERWALK_INLINE Colour3 mix_light_of_colours(const CornerLanes& at, const Mesh& mesh,
                                               const View& view) {
    Colour3 sum{};
    const auto add = [&](const std::int32_t* corner, const Floats& weight) {
        const RecordLanes light = load_records(mesh.light, corner),
                          colour = load_records(mesh.colours, corner);
        const Colour3 lit = reflected({light.a, light.b}, {colour.a, colour.b, colour.c}, view);
        sum.red += lit.red * weight;
        sum.green += lit.green * weight;
        sum.blue += lit.blue * weight;
    };
    add(at.a, at.weight_a);
    add(at.b, at.weight_b);
    add(at.c, at.weight_c);
    return sum;
}

/// What is the same for a row of the picture.
struct RowRays {
    float start[3], right[3]; ///< the ray through the centre of pixel x: start + x right
    float row_centre;         ///< 256ths
};

/// Light and texture at a group of pixels, each of any triangle.
RASTERWALK_INLINE void shade_group(const Mesh& mesh, const View& view, const RowRays& rays,
                                   std::int32_t x, int count, std::int32_t row,
                                   const std::int32_t* owner, const float* inv_z,
                                   std::uint32_t* colour) {
    const Ints live = first_lanes(count);
    std::int32_t offsets[lane_count];
    spill(offsets_of(choose(live, load(owner + x), all(owner[x]))), offsets);
    const RecordLanes corners = load_records(mesh.triangles, offsets);
    CornerLanes at;
    spill(bits_of(corners.a), at.a);
    spill(bits_of(corners.b), at.b);
    spill(bits_of(corners.c), at.c);
    const Ints material = bits_of(corners.d);
    const RecordLanes p = load_records(mesh.screen, at.a), q = load_records(mesh.screen, at.b),
                      r = load_records(mesh.screen, at.c);
    // Twice the area of each corner's opposite triangle, by 1/z: perspective-correct weights.
    const Ints centre_x = ((lane_numbers() + x) << subpixel_bits) + subpixels / 2;
    const Ints centre_y = all((row << subpixel_bits) + subpixels / 2);
    const Floats px = to_floats(bits_of(p.a) - centre_x), py = to_floats(bits_of(p.b) - centre_y),
                 qx = to_floats(bits_of(q.a) - centre_x), qy = to_floats(bits_of(q.b) - centre_y),
                 rx = to_floats(bits_of(r.a) - centre_x), ry = to_floats(bits_of(r.b) - centre_y);
    const Floats wa = (qx * ry - rx * qy) * p.c, wb = (rx * py - px * ry) * q.c,
                 wc = (px * qy - qx * py) * r.c;
    const Floats inv_sum = 1.0f / (wa + wb + wc);
    at.weight_a = wa * inv_sum;
    at.weight_b = wb * inv_sum;
    at.weight_c = wc * inv_sum;

    LightShares shares{Floats{}, Floats{}};
    Vector3 ray{}, to_lamp{};
    RecordLanes normal{};
    const Floats depth = load(inv_z + x);
    if (view.light_at == LightAt::vertices) {
        const RecordLanes light = at.mix(mesh.light);
        shares = {light.a, light.b};
    } else if (view.light_at == LightAt::pixels) {
        const Floats columns = to_floats(lane_numbers()) + static_cast<float>(x);
        ray = {columns * rays.right[0] + rays.start[0], columns * rays.right[1] + rays.start[1],
               columns * rays.right[2] + rays.start[2]};
        // All by 1/z: the place is then the eye and the ray.
        to_lamp = {depth * (view.lamp[0] - view.eye[0]) - ray.x,
                   depth * (view.lamp[1] - view.eye[1]) - ray.y,
                   depth * (view.lamp[2] - view.eye[2]) - ray.z};
        normal = at.mix(mesh.normals);
    }
    Ints result = Ints{};
    std::uint32_t left = sign_bits(live);
    while (left != 0) {
        const std::int32_t number = material[__builtin_ctz(left)];
        const Material& of = mesh.materials[number];
        const Ints same = material == all(number);
        left &= ~sign_bits(same);
        Colour3 painted{all(1.0f), all(1.0f), all(1.0f)};
        if (of.texture >= 0 && view.shows_textures != 0) {
            const RecordLanes place = at.mix(mesh.texcoords);
            painted = texture_colour(mesh.textures[of.texture], view, place.a, place.b);
        }
        const bool shines = of.has_highlight != 0 && view.has_highlights != 0;
        Colour3 lit;
        if (view.light_at == LightAt::vertices) {
            // Light goes from corner to corner as a whole: with the reflectance, and the highlight.
            lit = of.has_colours != 0 ? mix_light_of_colours(at, mesh, view)
                                      : reflected(shares,
                                                  {all(of.reflectance[0]), all(of.reflectance[1]),
                                                   all(of.reflectance[2])},
                                                  view);
            if (shines) add_highlight(shares, of, view, lit);
            lit = {lit.red * painted.red, lit.green * painted.green, lit.blue * painted.blue};
        } else {
            Colour3 reflectance{painted.red * of.reflectance[0], painted.green * of.reflectance[1],
                                painted.blue * of.reflectance[2]};
            if (of.has_colours != 0) {
                const RecordLanes mixed = at.mix(mesh.colours);
                reflectance = {painted.red * mixed.a, painted.green * mixed.b,
                               painted.blue * mixed.c};
            }
            lit = reflectance;
            if (view.light_at == LightAt::pixels) {
                shares = light_shares(to_lamp, depth, {normal.a, normal.b, normal.c},
                                      {-ray.x, -ray.y, -ray.z}, shines, all(of.exponent));
                lit = reflected(shares, reflectance, view);
                if (shines) add_highlight(shares, of, view, lit);
            }
        }
        result =
            choose(same, packed(lit.red * 255.0f, lit.green * 255.0f, lit.blue * 255.0f), result);
    }
    store_colours(result, count, colour + x);
}

RASTERWALK_INLINE std::int32_t number_in_scene(const Mesh& mesh, const Band& band,
                                               std::int32_t number) {
    if (number >= mesh.triangle_count) number = band.cut_from[number - mesh.triangle_count];
    return band.source[number];
}

/// Light and texture of what has none yet.
/// @param x, right the columns of a strip
RASTERWALK_INLINE void shade_row(const Mesh& mesh, const View& view, const Band& band,
                                 std::int32_t row, std::int32_t x, std::int32_t right,
                                 bool keeps_owner, const RowPlanes& planes) {
    RowRays rays;
    for (int i = 0; i < 3; ++i) {
        const float step = 1.0f / view.focal_length;
        const float u = (0.5f - view.middle[0]) * step;
        const float v = (static_cast<float>(row) + 0.5f - view.middle[1]) * step;
        rays.start[i] = view.axes[2][i] + u * view.axes[0][i] + v * view.axes[1][i];
        rays.right[i] = view.axes[0][i] * step;
    }
    std::int32_t* const owner = planes.owner;
    while (x < right) {
        const std::uint32_t lit = sign_bits(load(owner + x));
        if (lit == all_bits) {
            x += lane_count;
            continue;
        }
        x += __builtin_ctz(~lit);
        const std::int32_t end = end_of_run(owner, x, right);
        for (; x < end; x += lane_count) {
            const int count = end - x < lane_count ? end - x : lane_count;
            shade_group(mesh, view, rays, x, count, row, owner, planes.inv_z, planes.colour);
            if (!keeps_owner) continue;
            for (int i = 0; i < count; ++i)
                owner[x + i] = ~number_in_scene(mesh, band, owner[x + i]);
        }
        x = end;
    }
}

/// What is seen of a row without the large triangles.
RASTERWALK_INLINE void begin_row(const View& view, std::int32_t row, const Planes& planes,
                                 bool has_owner, const RowPlanes& to) {
    for (std::int32_t x = 0; x < view.width; x += lane_count) {
        Ints depth = {}, number = all(no_owner);
        if (planes.visible != nullptr) {
            const Visible* const from =
                planes.visible + static_cast<std::int64_t>(row) * planes.stride + x;
            const LongLanes seen{load_longs(from), load_longs(from + lane_count / 2)};
            depth = upper_halves(seen);
            number = choose(depth != Ints{}, ~lower_halves(seen), number);
        }
        store(depth, to.inv_z + x);
        store(Ints{}, to.colour + x);
        if (has_owner) store(number, to.owner + x);
    }
}

/// Owners as they are kept: whatever was put is ~t.
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
            // One row of memory for all, where nothing of it is looked at again.
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
            // Strip by strip: rows above each other show the same triangles, whose corners are then
            // still near at hand.
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
