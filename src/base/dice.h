#pragma once

#include <cstddef>
#include <cstdint>

namespace rasterwalk {

/// Random numbers that are the same everywhere.
/// Source: G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA
/// 2014: splitmix64.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : state_(seed) {}

    /// A number below `count`, which must not be 0.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

    /// From 0 up to, not including, 1.
    double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  private:
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace rasterwalk
