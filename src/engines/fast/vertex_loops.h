#pragma once

// The work done once per vertex.

#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"
#include "engines/fast/light_lanes.h"

namespace {

using namespace rasterwalk::fast;

/// To the nearest 256th, halves up, as in stages/snap.h.
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
        // Compared as whole numbers, where NaN is larger than any number.
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
        const bool has_own = has_highlights && !(view.exponent > 0.0f);
        const LightShares shares =
            light_shares(to_lamp, all(1.0f), {normal.a, normal.b, normal.c}, to_eye, has_highlights,
                         has_own ? load(mesh.exponents + i) : all(view.exponent));
        for (int lane = 0; lane < lane_count; ++lane)
            mesh.light[i + lane] = {shares.diffuse[lane], shares.highlight[lane], {}};
    }
}

} // namespace
