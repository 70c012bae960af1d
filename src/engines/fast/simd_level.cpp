#include "engines/fast/simd_level.h"

namespace rasterwalk {

std::vector<SimdLevel> simd_levels() {
    std::vector<SimdLevel> levels{SimdLevel::scalar};
#if defined(RASTERWALK_X86_LOOPS)
    levels.push_back(SimdLevel::sse2);
    // All that the loops are compiled for: what -march=x86-64-v3 and -v4 allow.
    __builtin_cpu_init();
    const bool has_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    if (!has_v3) return levels;
    levels.push_back(SimdLevel::clones);
    levels.push_back(SimdLevel::avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        levels.push_back(SimdLevel::avx512);
#endif
    return levels;
}

SimdLevel best_simd_level() {
    return simd_levels().back();
}

} // namespace rasterwalk
