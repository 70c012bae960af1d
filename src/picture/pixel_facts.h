#pragma once

// What a framebuffer does not remember about its pixels, computed by drawing the frame again under
// an observer, and only as requested.

#include <cstdint>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// Which planes to compute.
struct FactsWanted {
    bool drawn_twice = false;
    bool depth = false;
    bool affine_error = false;
    bool mip_level = false;

    bool any() const { return drawn_twice || depth || affine_error || mip_level; }
    /// Does it include everything that `other` wants?
    bool includes(const FactsWanted& other) const {
        return (drawn_twice || !other.drawn_twice) && (depth || !other.depth) &&
               (affine_error || !other.affine_error) && (mip_level || !other.mip_level);
    }
    friend bool operator==(const FactsWanted&, const FactsWanted&) = default;
};

/// Two triangles that share an edge and both drew on one pixel; -1: there are none.
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

/// In PixelFacts::mip_level: there is no texture.
inline constexpr float no_mip_level = -1.0f;

/// The planes, row by row from the top; those that were not asked for are empty.
struct PixelFacts {
    FactsWanted known;

    /// The last two neighbours that drew on the pixel. Neighbours share two vertices and are on
    /// different sides of the edge between them, so no pixel should belong to both. Where one is
    /// folded over the other in the picture, they rightly cover each other and do not count.
    std::vector<DrawnTwice> drawn_twice;

    /// Also empty if no depth test is in force.
    std::vector<DepthVerdicts> depth;

    /// Distance between the affine and the perspective-correct position of the visible fragment,
    /// world units; 0 if there is none.
    std::vector<float> affine_error;

    /// The level of the mip chain that the texture of the visible fragment was read at; between two
    /// levels that were mixed, by their shares. no_mip_level if the pixel shows no texture.
    std::vector<float> mip_level;
};

/// Draws everything before `to` again and notes what is wanted. Only stages from `fill` onward have
/// fragments; before that, nothing is drawn twice and nothing has an error.
PixelFacts pixel_facts(const Frame& frame, const Cursor& to, const FactsWanted& wanted);

/// Of the triangles that share an edge, the later ones are compared with at most this many earlier
/// ones; a scene of sensible surfaces has two.
inline constexpr int most_on_an_edge = 4;

} // namespace rasterwalk
