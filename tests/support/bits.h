#pragma once

// Comparison of framebuffers bit by bit. NaN equals NaN of the same bits, and 0 is not -0.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

#include "pipeline/framebuffer.h"

namespace rasterwalk::test {

inline bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
inline bool same_bits(const glm::vec3& a, const glm::vec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
inline bool same_bits(const glm::vec2& a, const glm::vec2& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y);
}
inline bool same_bits(const Varyings& a, const Varyings& b) {
    bool same = true;
    for_each_varying([&](auto member) { same = same && same_bits(a.*member, b.*member); });
    return same;
}
inline bool same_bits(const Fragment& a, const Fragment& b) {
    return a.column == b.column && a.row == b.row && same_bits(a.depth, b.depth) &&
           same_bits(a.inv_w, b.inv_w) && same_bits(a.z, b.z) && same_bits(a.varyings, b.varyings);
}

inline bool same_bits(const RowEnd& a, const RowEnd& b) {
    return a.column == b.column && same_bits(a.depth, b.depth) && same_bits(a.inv_w, b.inv_w) &&
           same_bits(a.z, b.z) && same_bits(a.varyings, b.varyings);
}
inline bool same_bits(const ScreenVertex& a, const ScreenVertex& b) {
    return same_bits(a.position, b.position) && a.column == b.column && a.row == b.row &&
           same_bits(a.depth, b.depth) && same_bits(a.inv_w, b.inv_w) && same_bits(a.z, b.z) &&
           same_bits(a.varyings, b.varyings);
}

/// The first pixel and plane in which two framebuffers differ, with both values; empty if they are
/// the same bits.
inline std::string first_difference(const Framebuffer& a, const Framebuffer& b) {
    if (!(a.size == b.size)) return "the sizes differ";
    const auto report = [&](std::size_t pixel, const char* plane, double in_a, double in_b) {
        const auto width = static_cast<std::size_t>(a.size.width);
        char text[160];
        std::snprintf(text, sizeof text, "column %zu row %zu %s: %.9g and %.9g", pixel % width,
                      pixel / width, plane, in_a, in_b);
        return std::string(text);
    };
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        if (a.overdraw[i] != b.overdraw[i]) {
            return report(i, "overdraw", a.overdraw[i], b.overdraw[i]);
        }
        if (a.owner[i] != b.owner[i]) return report(i, "owner", a.owner[i], b.owner[i]);
        if (!same_bits(a.depth[i], b.depth[i])) return report(i, "depth", a.depth[i], b.depth[i]);
        for (int c = 0; c < 3; ++c) {
            if (!same_bits(a.colour[i][c], b.colour[i][c])) {
                return report(i, "colour", a.colour[i][c], b.colour[i][c]);
            }
        }
    }
    if (a.sample_colour.size() != b.sample_colour.size()) return "only one has samples";
    for (std::size_t i = 0; i < a.sample_colour.size(); ++i) {
        for (std::size_t s = 0; s < a.sample_colour[i].size(); ++s) {
            const float in_a = a.sample_depth[i][s], in_b = b.sample_depth[i][s];
            if (!same_bits(in_a, in_b)) return report(i, "depth of a sample", in_a, in_b);
            if (!same_bits(a.sample_colour[i][s], b.sample_colour[i][s]))
                return report(i, "red of a sample", a.sample_colour[i][s].r,
                              b.sample_colour[i][s].r);
        }
    }
    return {};
}

/// 64-bit FNV-1a of the bytes of a whole number, lowest first.
class Hash {
  public:
    void add(std::uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8) {
            state_ = (state_ ^ ((value >> shift) & 0xffu)) * 1099511628211u;
        }
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    std::string text() const {
        char hex[17];
        std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(state_));
        return hex;
    }

  private:
    std::uint64_t state_ = 14695981039346656037u;
};

/// The hash of every bit of a framebuffer.
inline std::string hash_text(const Framebuffer& framebuffer) {
    Hash hash;
    for (const glm::vec3& colour : framebuffer.colour) {
        hash.add(colour.r);
        hash.add(colour.g);
        hash.add(colour.b);
    }
    for (const float depth : framebuffer.depth)
        hash.add(depth);
    for (const std::int32_t owner : framebuffer.owner)
        hash.add(static_cast<std::uint32_t>(owner));
    for (const std::uint32_t overdraw : framebuffer.overdraw)
        hash.add(overdraw);
    return hash.text();
}

} // namespace rasterwalk::test
