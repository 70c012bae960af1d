#pragma once

// The processor instructions that the loops of the fast engine are compiled for.

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/enum_words.h"

namespace rasterwalk {

/// The loops are the same at every level; only the number of lanes and the instructions that the
/// compiler may use differ.
enum class SimdLevel : std::uint8_t {
    scalar, ///< plain C++ with 4 lanes, compiled for any processor
    sse2,   ///< 4 lanes: instructions that every 64-bit x86 has
    clones, ///< plain C++ with 8 lanes, compiled for x86-64-v3, without intrinsics
    avx2,   ///< 8 lanes, with fused multiply-add: x86-64-v3
    avx512, ///< 16 lanes: x86-64-v4
};

/// The levels that this build has and this processor can run, in order; never empty.
std::vector<SimdLevel> simd_levels();

/// The last of them.
SimdLevel best_simd_level();

} // namespace rasterwalk
