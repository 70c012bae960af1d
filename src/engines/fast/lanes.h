#pragma once

// Lanes: several adjacent numbers that one instruction works on.
//
// Each fast_loops_*.cpp defines how many lanes there are (RASTERWALK_LANES), and whether it names
// instructions that the compiler does not find (RASTERWALK_NAMES_INSTRUCTIONS). All of it is in an
// unnamed namespace, because each level needs its own lanes.
//
// These are the vector types that g++ and clang++ share: + - * / < work on all lanes; a comparison
// gives -1 in lanes where it is true and 0 in the others, so masks are whole numbers that & | ~
// combine.

#include <cstdint>

#if defined(__x86_64__) && RASTERWALK_NAMES_INSTRUCTIONS
#include <immintrin.h>
#endif

#define RASTERWALK_INLINE static inline __attribute__((always_inline))
#define RASTERWALK_INLINE_MEMBER inline __attribute__((always_inline))
#define RASTERWALK_LAMBDA __attribute__((always_inline))

namespace {

constexpr int lane_count = RASTERWALK_LANES;
typedef float Floats __attribute__((vector_size(4 * RASTERWALK_LANES)));
typedef std::int32_t Ints __attribute__((vector_size(4 * RASTERWALK_LANES)));
/// Half as many lanes, of twice the size.
typedef std::int64_t Longs __attribute__((vector_size(4 * RASTERWALK_LANES)));

// Lists of lanes for __builtin_shufflevector(), which takes them from two vectors, one after the
// other.
#if RASTERWALK_LANES == 16
#define RASTERWALK_LOWER_OF_BOTH 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define RASTERWALK_UPPER_OF_BOTH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#define RASTERWALK_EVEN 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30
#define RASTERWALK_ODD 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31
#elif RASTERWALK_LANES == 8
#define RASTERWALK_LOWER_OF_BOTH 0, 8, 1, 9, 2, 10, 3, 11
#define RASTERWALK_UPPER_OF_BOTH 4, 12, 5, 13, 6, 14, 7, 15
#define RASTERWALK_EVEN 0, 2, 4, 6, 8, 10, 12, 14
#define RASTERWALK_ODD 1, 3, 5, 7, 9, 11, 13, 15
#else
#define RASTERWALK_LOWER_OF_BOTH 0, 4, 1, 5
#define RASTERWALK_UPPER_OF_BOTH 2, 6, 3, 7
#define RASTERWALK_EVEN 0, 2, 4, 6
#define RASTERWALK_ODD 1, 3, 5, 7
#endif

RASTERWALK_INLINE Floats all(float value) {
    return Floats{} + value;
}
RASTERWALK_INLINE Ints all(std::int32_t value) {
    return Ints{} + value;
}

/// 0 1 2 3 ...
RASTERWALK_INLINE Ints lane_numbers() {
    Ints numbers = {};
    for (int i = 0; i < lane_count; ++i)
        numbers[i] = i;
    return numbers;
}

template <class Lanes, class Number>
RASTERWALK_INLINE Lanes load(const Number* from) {
    Lanes lanes;
    __builtin_memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
RASTERWALK_INLINE Floats load(const float* from) {
    return load<Floats>(from);
}
RASTERWALK_INLINE Ints load(const std::int32_t* from) {
    return load<Ints>(from);
}
template <class Lanes, class Number>
RASTERWALK_INLINE void store(const Lanes& lanes, Number* to) {
    static_assert(sizeof(Number) == 4);
    __builtin_memcpy(to, &lanes, sizeof lanes);
}

RASTERWALK_INLINE Longs load_longs(const std::int64_t* from) {
    return load<Longs>(from);
}
RASTERWALK_INLINE void store_longs(const Longs& lanes, std::int64_t* to) {
    __builtin_memcpy(to, &lanes, sizeof lanes);
}

template <class Lanes>
RASTERWALK_INLINE Lanes choose(const Ints& mask, const Lanes& yes, const Lanes& no) {
    return mask ? yes : no;
}
template <class Lanes>
RASTERWALK_INLINE Lanes smaller(const Lanes& a, const Lanes& b) {
    return a < b ? a : b;
}
template <class Lanes>
RASTERWALK_INLINE Lanes larger(const Lanes& a, const Lanes& b) {
    return a > b ? a : b;
}

RASTERWALK_INLINE Floats to_floats(const Ints& lanes) {
    return __builtin_convertvector(lanes, Floats);
}
/// Toward 0.
RASTERWALK_INLINE Ints to_ints(const Floats& lanes) {
    return __builtin_convertvector(lanes, Ints);
}
RASTERWALK_INLINE Ints floor_of(const Floats& lanes) {
    const Ints whole = to_ints(lanes);
    return whole + (to_floats(whole) > lanes);
}
/// The bits of floats as whole numbers: from 0 up, they have the same order.
RASTERWALK_INLINE Ints bits_of(const Floats& lanes) {
    return (Ints)lanes;
}
RASTERWALK_INLINE Floats floats_of(const Ints& lanes) {
    return (Floats)lanes;
}

/// Numbers of 64 bits that lie one after the other in memory, by their halves.
struct LongLanes {
    Longs first, second;
};
RASTERWALK_INLINE LongLanes join_halves(const Ints& lower, const Ints& upper) {
    return {(Longs)__builtin_shufflevector(lower, upper, RASTERWALK_LOWER_OF_BOTH),
            (Longs)__builtin_shufflevector(lower, upper, RASTERWALK_UPPER_OF_BOTH)};
}
RASTERWALK_INLINE Ints lower_halves(const LongLanes& lanes) {
    return __builtin_shufflevector((Ints)lanes.first, (Ints)lanes.second, RASTERWALK_EVEN);
}
RASTERWALK_INLINE Ints upper_halves(const LongLanes& lanes) {
    return __builtin_shufflevector((Ints)lanes.first, (Ints)lanes.second, RASTERWALK_ODD);
}

/// A bit for each lane, set if the lane's highest bit is; the first lane in the lowest bit.
RASTERWALK_INLINE std::uint32_t sign_bits(const Ints& lanes) {
#if RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 16
    return _mm512_movepi32_mask((__m512i)lanes);
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 8
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)lanes));
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 4
    return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)lanes));
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < lane_count; ++i)
        bits |= static_cast<std::uint32_t>(lanes[i] < 0) << i;
    return bits;
#endif
}
constexpr std::uint32_t all_bits = (std::uint32_t{1} << lane_count) - 1;

/// The first `count` lanes, as a mask.
RASTERWALK_INLINE Ints first_lanes(int count) {
    return lane_numbers() < all(count);
}

/// Stores the lanes of a mask, and leaves the memory of the others unchanged. That memory must
/// exist, because without a masked store its old values are written back.
template <class Lanes, class Number>
RASTERWALK_INLINE void store_where(const Ints& mask, const Lanes& lanes, Number* to) {
    static_assert(sizeof(Number) == 4);
#if RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 16
    _mm512_mask_storeu_epi32(to, _mm512_movepi32_mask((__m512i)mask), (__m512i)lanes);
#else
    store(choose(mask, lanes, load<Lanes>(to)), to);
#endif
}
/// The same with the mask's sign_bits() at hand: most masks are full, and then nothing is read.
template <class Lanes, class Number>
RASTERWALK_INLINE void store_where(const Ints& mask, std::uint32_t bits, const Lanes& lanes,
                                   Number* to) {
    if (__builtin_expect(bits == all_bits, 1))
        store(lanes, to);
    else
        store_where(mask, lanes, to);
}

/// 1 / sqrt(x), to about 12 bits if the processor has that.
RASTERWALK_INLINE Floats rough_inverse_root(const Floats& x) {
#if RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 16
    return (Floats)_mm512_rsqrt14_ps((__m512)x);
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 8
    return (Floats)_mm256_rsqrt_ps((__m256)x);
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 4
    return (Floats)_mm_rsqrt_ps((__m128)x);
#else
    Floats root;
    for (int i = 0; i < lane_count; ++i)
        root[i] = 1.0f / __builtin_sqrtf(x[i]);
    return root;
#endif
}
/// The same to about 22 bits: a step of Newton's method.
RASTERWALK_INLINE Floats inverse_root(const Floats& x) {
    const Floats rough = rough_inverse_root(x);
    return rough * (1.5f - 0.5f * x * rough * rough);
}

/// Lanes as numbers to be looked up one by one. They go through memory: taking each out of the
/// vector, as g++ would, needs two dependent instructions.
RASTERWALK_INLINE void spill(const Ints& lanes, std::int32_t (&to)[lane_count]) {
    store(lanes, to);
    asm volatile("" : "+m"(to));
}

/// Four lanes each, of the four numbers of a record.
struct RecordLanes {
    Floats a, b, c, d;
};

/// Records have 16 bytes.
RASTERWALK_INLINE Ints offsets_of(const Ints& numbers) {
    return numbers << 4;
}

/// A record for each lane: the one that begins this many bytes after the first.
RASTERWALK_INLINE RecordLanes load_records(const void* records, const std::int32_t* offsets) {
    const char* const from = static_cast<const char*>(records);
    RecordLanes lanes;
#if RASTERWALK_NAMES_INSTRUCTIONS
    const auto record = [&](int lane) RASTERWALK_LAMBDA {
        return _mm_load_ps(reinterpret_cast<const float*>(from + offsets[lane]));
    };
#endif
#if RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 16
    // Lane i of each quarter: records i, i + 4, i + 8, i + 12.
    const auto quarters = [&](int lane) RASTERWALK_LAMBDA {
        __m512 four = _mm512_castps128_ps512(record(lane));
        four = _mm512_insertf32x4(four, record(lane + 4), 1);
        four = _mm512_insertf32x4(four, record(lane + 8), 2);
        return _mm512_insertf32x4(four, record(lane + 12), 3);
    };
    const __m512 q0 = quarters(0), q1 = quarters(1), q2 = quarters(2), q3 = quarters(3);
    const __m512d low01 = _mm512_castps_pd(_mm512_unpacklo_ps(q0, q1));
    const __m512d low23 = _mm512_castps_pd(_mm512_unpacklo_ps(q2, q3));
    const __m512d high01 = _mm512_castps_pd(_mm512_unpackhi_ps(q0, q1));
    const __m512d high23 = _mm512_castps_pd(_mm512_unpackhi_ps(q2, q3));
    lanes.a = (Floats)_mm512_unpacklo_pd(low01, low23);
    lanes.b = (Floats)_mm512_unpackhi_pd(low01, low23);
    lanes.c = (Floats)_mm512_unpacklo_pd(high01, high23);
    lanes.d = (Floats)_mm512_unpackhi_pd(high01, high23);
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 8
    const auto halves = [&](int lane) RASTERWALK_LAMBDA {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(record(lane)), record(lane + 4), 1);
    };
    const __m256 h0 = halves(0), h1 = halves(1), h2 = halves(2), h3 = halves(3);
    const __m256d low01 = _mm256_castps_pd(_mm256_unpacklo_ps(h0, h1));
    const __m256d low23 = _mm256_castps_pd(_mm256_unpacklo_ps(h2, h3));
    const __m256d high01 = _mm256_castps_pd(_mm256_unpackhi_ps(h0, h1));
    const __m256d high23 = _mm256_castps_pd(_mm256_unpackhi_ps(h2, h3));
    lanes.a = (Floats)_mm256_unpacklo_pd(low01, low23);
    lanes.b = (Floats)_mm256_unpackhi_pd(low01, low23);
    lanes.c = (Floats)_mm256_unpacklo_pd(high01, high23);
    lanes.d = (Floats)_mm256_unpackhi_pd(high01, high23);
#elif RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 4
    __m128 r0 = record(0), r1 = record(1), r2 = record(2), r3 = record(3);
    _MM_TRANSPOSE4_PS(r0, r1, r2, r3);
    lanes = {(Floats)r0, (Floats)r1, (Floats)r2, (Floats)r3};
#else
    for (int i = 0; i < lane_count; ++i) {
        float record[4];
        __builtin_memcpy(record, from + offsets[i], sizeof record);
        lanes.a[i] = record[0];
        lanes.b[i] = record[1];
        lanes.c[i] = record[2];
        lanes.d[i] = record[3];
    }
#endif
    return lanes;
}

/// Stores the lanes of a set of bits one after the other. There must be room for all lanes.
/// @param spilled the same lanes in memory
RASTERWALK_INLINE void append(const Ints& lanes, const std::int32_t (&spilled)[lane_count],
                              std::uint32_t bits, std::int32_t* to) {
#if RASTERWALK_NAMES_INSTRUCTIONS && RASTERWALK_LANES == 16
    static_cast<void>(spilled);
    _mm512_storeu_si512(to,
                        _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), (__m512i)lanes));
#else
    static_cast<void>(lanes);
    for (; bits != 0; bits &= bits - 1)
        *to++ = spilled[__builtin_ctz(bits)];
#endif
}

} // namespace
