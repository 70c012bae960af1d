#pragma once

#include <cstdint>
#include <random>

namespace rasterwalk::test {

/// Numbers that look random and are the same in every run, under every compiler.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    /// A whole number, both bounds included.
    int integer(int smallest, int largest) {
        const auto count = static_cast<std::uint32_t>(largest - smallest) + 1u;
        return smallest + static_cast<int>(engine_() % count);
    }

    /// A real number from `smallest` up to `largest`.
    double real(double smallest, double largest) {
        return smallest + (largest - smallest) * (engine_() / 4294967296.0);
    }
    float number(double smallest, double largest) {
        return static_cast<float>(real(smallest, largest));
    }

  private:
    std::mt19937 engine_;
};

} // namespace rasterwalk::test
