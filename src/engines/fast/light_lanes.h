#pragma once

// Light, for several points at once: see stages/light.h and stages/highlight.h.

#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"

namespace {

using namespace rasterwalk::fast;

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

/// The parts of the light that do not depend on power and reflectance.
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
    // At the lamp itself there is no direction, and no light.
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

} // namespace
