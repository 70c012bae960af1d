#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace rasterwalk {

/// A number for everything that was added to it, to see whether it has changed. It protects against
/// accidents, not against a search for two texts with the same number.
class Fingerprint {
  public:
    /// Adds a text, and its end: "ab", "c" and "a", "bc" differ.
    Fingerprint& add(std::string_view text) {
        for (const char letter : text)
            mix(static_cast<unsigned char>(letter));
        for (std::size_t size = text.size(), i = 0; i < sizeof size; ++i) {
            mix(static_cast<unsigned char>(size >> (8 * i)));
        }
        return *this;
    }

    /// Sixteen hexadecimal digits.
    std::string text() const { return fmt::format("{:016x}", state_); }

  private:
    // FNV-1a of 64 bits.
    void mix(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3; }

    std::uint64_t state_ = 0xcbf29ce484222325;
};

} // namespace rasterwalk
