#pragma once

// The colours of visible pixels that have no closed form.

#include "engines/fast/colour_lanes.h"
#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"
#include "engines/fast/large_loops.h"
#include "engines/fast/light_lanes.h"

namespace {

using namespace rasterwalk::fast;

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

/// The corners and their weights, to mix values with.
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

/// R of each corner, mixed: if corners have their own reflectances.
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

/// Values that are the same for a row of the picture.
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
        // All by 1/z: the position is then the eye and the ray.
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
            // Light is interpolated as a whole: with the reflectance, and the highlight.
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
                                      {-ray.x, -ray.y, -ray.z}, shines,
                                      all(view.exponent > 0.0f ? view.exponent : of.exponent));
                lit = reflected(shares, reflectance, view);
                if (shines) add_highlight(shares, of, view, lit);
            }
        }
        const Colour3 bytes{lit.red * 255.0f, lit.green * 255.0f, lit.blue * 255.0f};
        result = choose(same, packed(at_most_white(bytes)), result);
    }
    store_colours(result, count, colour + x);
}

RASTERWALK_INLINE std::int32_t number_in_scene(const Mesh& mesh, const Band& band,
                                               std::int32_t number) {
    if (number >= mesh.triangle_count) number = band.cut_from[number - mesh.triangle_count];
    return band.source[number];
}

/// Light and texture for pixels that have none yet.
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

} // namespace
