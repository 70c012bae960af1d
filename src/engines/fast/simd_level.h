#pragma once

// Which instructions of the processor the loops of the fast engine are compiled for.

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/enum_words.h"

namespace rasterwalk {

/// The loops are the same at every level; only how many lanes they have, and which instructions the
/// compiler may take for them, differs.
enum class SimdLevel : std::uint8_t {
    scalar, ///< plain C++ of 4 lanes: what the compiler makes of it for any processor
    sse2,   ///< 4 lanes: what every x86 of 64 bits can do
    clones, ///< plain C++ of 8 lanes, compiled for x86-64-v3: nothing is written for the processor
    avx2,   ///< 8 lanes, with fused multiply-add: x86-64-v3
    avx512, ///< 16 lanes: x86-64-v4
};
template <>
inline constexpr auto enum_words<SimdLevel> = word_list("scalar", "sse2", "clones", "avx2",
                                                        "avx512");
static_assert(words_match<SimdLevel>);

/// The levels that this build has and this processor can run, from the first to the last; never
/// empty.
std::vector<SimdLevel> simd_levels();

/// The last of them.
SimdLevel best_simd_level();

} // namespace rasterwalk
