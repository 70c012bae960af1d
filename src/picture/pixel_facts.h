#pragma once

// What a framebuffer does not remember of its pixels: worked out by drawing the frame again under
// an observer, and only what is asked for.

#include <cstdint>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// Which planes are worked out.
struct FactsWanted {
    bool drawn_twice = false;
    bool depth = false;
    bool affine_error = false;

    bool any() const { return drawn_twice || depth || affine_error; }
    /// Is everything that `other` wants among it?
    bool includes(const FactsWanted& other) const {
        return (drawn_twice || !other.drawn_twice) && (depth || !other.depth) &&
               (affine_error || !other.affine_error);
    }
    friend bool operator==(const FactsWanted&, const FactsWanted&) = default;
};

/// Two triangles with an edge in common that both drew on one pixel; -1: no such two did.
struct DrawnTwice {
    int first = -1;  ///< triangle drawn earlier
    int second = -1; ///< triangle drawn later

    explicit operator bool() const { return second >= 0; }
    friend bool operator==(const DrawnTwice&, const DrawnTwice&) = default;
};

/// How many fragments of a pixel passed the depth test, and how many failed.
struct DepthVerdicts {
    std::uint32_t passed = 0;
    std::uint32_t failed = 0;

    friend bool operator==(const DepthVerdicts&, const DepthVerdicts&) = default;
};

/// The planes, row by row from the top; those that were not asked for are empty.
struct PixelFacts {
    FactsWanted known;

    /// The last two neighbours that drew on the pixel. Neighbours have two vertices in common and
    /// lie on different sides of the edge between them, so that no pixel should be due to both.
    /// Where one is folded over the other in the picture they cover each other rightly, and do not
    /// count.
    std::vector<DrawnTwice> drawn_twice;

    /// Empty as well where no depth test is in force.
    std::vector<DepthVerdicts> depth;

    /// Distance between the affine and the perspective-correct position of the visible fragment,
    /// world units; 0 where there is none.
    std::vector<float> affine_error;
};

/// Draws everything before `to` again and notes what is wanted. Only stages from `fill` on have
/// fragments: before, nothing is drawn twice and nothing has an error.
PixelFacts pixel_facts(const Frame& frame, const Cursor& to, const FactsWanted& wanted);

/// Of so many triangles with one edge in common at most, the later ones are compared with these
/// earlier ones; a scene made of sensible surfaces has two.
inline constexpr int most_on_an_edge = 4;

} // namespace rasterwalk
