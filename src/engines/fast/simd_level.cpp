#include "engines/fast/simd_level.h"

#if defined(RASTERWALK_X86_LOOPS)
#include <cpuid.h>
#endif

namespace rasterwalk {

#if defined(RASTERWALK_X86_LOOPS)
namespace {

/// The parts of x86-64-v3 that __builtin_cpu_supports() has no name for under clang 14.
bool has_rest_of_v3() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    constexpr unsigned movbe = 1u << 22, f16c = 1u << 29, lzcnt = 1u << 5;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & movbe) == 0 || (c & f16c) == 0) return false;
    return __get_cpuid(0x80000001u, &a, &b, &c, &d) != 0 && (c & lzcnt) != 0;
}

} // namespace
#endif

std::vector<SimdLevel> simd_levels() {
    std::vector<SimdLevel> levels{SimdLevel::scalar};
#if defined(RASTERWALK_X86_LOOPS)
    levels.push_back(SimdLevel::sse2);
    // Everything the loops are compiled for: what -march=x86-64-v3 and -v4 allow.
    __builtin_cpu_init();
    const bool has_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                        has_rest_of_v3();
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
