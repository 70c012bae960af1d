#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

namespace rasterwalk {

/// Samples of a pixel that has more than one.
inline constexpr int sample_count = 4;

/// Something of each sample of a pixel.
template <class Value>
using OfSamples = std::array<Value, static_cast<std::size_t>(sample_count)>;

using SampleColours = OfSamples<glm::vec3>;
using SampleDepths = OfSamples<float>;

/// Some of the samples of a pixel: bit i stands for sample i.
using SampleMask = std::uint8_t;

constexpr bool has_sample(SampleMask mask, int sample) {
    return (mask >> sample & 1) != 0;
}

constexpr SampleMask mask_of(int sample) {
    return static_cast<SampleMask>(1U << static_cast<unsigned>(sample));
}

/// How many there are, 0 to sample_count.
constexpr int count_samples(SampleMask mask) {
    int count = 0;
    for (int sample = 0; sample < sample_count; ++sample)
        count += has_sample(mask, sample) ? 1 : 0;
    return count;
}

/// The first of them; sample 0 if there are none.
constexpr int first_sample(SampleMask mask) {
    for (int sample = 0; sample < sample_count; ++sample) {
        if (has_sample(mask, sample)) return sample;
    }
    return 0;
}

/// A colour for each sample, or a depth.
template <class Value>
constexpr OfSamples<Value> for_all_samples(const Value& value) {
    OfSamples<Value> all{};
    all.fill(value);
    return all;
}

} // namespace rasterwalk
