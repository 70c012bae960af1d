#pragma once

// Warnock's algorithm: the picture is divided until each part of it is simple.
//
// In:  the rows of every polygon: where each begins and ends, and how deep it is there.
// Out: squares, one after another in time; each is drawn, stays background, or is divided.
// Picture: look at the picture through a frame. If you see nothing, or one surface, or one that
//          covers everything else, you are done. Otherwise look at each quarter of it in the same
//          way. In the end the frame is a single pixel, and the nearest surface there wins.
//
// A polygon is disjoint from a square, surrounds it, or does something in between: it intersects
// it. What is disjoint from a square is disjoint from each of its parts, so the list of polygons
// becomes shorter on the way down. The work follows what the picture shows: a surface without
// anything in front of it costs a few large squares, an edge many small ones.
//
// The classic mistake is to draw the surrounding polygon that is nearest at one place only: it must
// be nearest in the whole square. Where two surfaces go through each other neither is.
//
// Polygons are the pixels that their rows cover, so that every rule of coverage counts here too.
// All surfaces are opaque: what a texture cuts out of one shows the background.
//
// Source: J. E. Warnock, "A Hidden Surface Algorithm for Computer Generated Halftone Pictures",
// University of Utah, TR 4-15, 1969; Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles
// and Practice, 2nd edition, section 15.7.1.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_words.h"
#include "stages/rectangle.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// How a polygon and a square of pixels lie.
enum class SquareRelation : std::uint8_t {
    disjoint,     ///< no pixel in common
    intersecting, ///< some
    surrounding,  ///< the polygon covers every pixel of the square
};

/// Why a square is done, or is not.
enum class SquareReason : std::uint8_t { empty, one_surface, one_in_front, one_pixel, divide };

/// The words for a reason.
struct SquareReasonWords {
    SquareReason reason;
    std::string_view in_short;
    std::string_view sentence; ///< without a full stop
};

/// Every reason; indexed by SquareReason.
inline constexpr std::array square_reason_list{
    SquareReasonWords{SquareReason::empty, "empty", "no polygon meets it, so it stays background"},
    SquareReasonWords{SquareReason::one_surface, "one surface",
                      "only one polygon meets it: that is drawn, and the rest stays background"},
    SquareReasonWords{SquareReason::one_in_front, "one in front",
                      "one polygon surrounds it and is in front of all others everywhere in it"},
    SquareReasonWords{SquareReason::one_pixel, "one pixel",
                      "it cannot be divided, so the polygon nearest there is drawn"},
    SquareReasonWords{SquareReason::divide, "divided",
                      "several polygons meet it, and none surrounds it in front of all others"},
};
static_assert(is_indexed_by(square_reason_list, &SquareReasonWords::reason));

constexpr const SquareReasonWords& words(SquareReason reason) {
    return square_reason_list[static_cast<std::size_t>(reason)];
}

/// A row of a polygon. Depth is linear from pixel to pixel.
struct SurfaceRow {
    int left = 0;       ///< its first column, perhaps beyond the picture
    int end = 0;        ///< after its last column; <= left: the row has no pixels
    double depth = 0.0; ///< at the first column, see ClipDepth
    double step = 0.0;  ///< from column to column

    double depth_at(int column) const {
        return depth + step * (static_cast<double>(column) - static_cast<double>(left));
    }
};

/// A polygon as the pixels it covers.
struct PixelSurface {
    int first_row = 0; ///< of the picture
    std::vector<SurfaceRow> rows;
    Rectangle box; ///< around all its pixels

    const SurfaceRow& row(int of_picture) const {
        return rows[static_cast<std::size_t>(of_picture - first_row)];
    }
};

/// Sets the box of a polygon whose rows are complete.
void find_box(PixelSurface& surface);

/// How a polygon lies to a square that is not empty.
SquareRelation relation_to(const PixelSurface& surface, const Rectangle& square);

/// Is a polygon that surrounds a square in front of another one, wherever that has pixels in the
/// square? Both depths are linear along a row, so the ends of each row decide.
/// @param wins_ties whether it is in front where both are equally near
bool is_in_front(const PixelSurface& surface, const PixelSurface& other, const Rectangle& square,
                 ClipDepth kind, bool wins_ties);

/// A square of the picture; its sides may differ by what halving them has rounded.
struct WarnockSquare {
    Rectangle pixels;
    SquareReason reason = SquareReason::empty;
    int surface = -1; ///< the polygon that is drawn in it; -1: none
    int depth = 0;    ///< how often the picture was divided to get it
    int parent = -1;  ///< the square it is a part of; -1: it is the whole picture
    int below = 0;    ///< its parts, their parts and so on: they come next in time

    friend bool operator==(const WarnockSquare&, const WarnockSquare&) = default;
};

/// The parts of a square in the order in which they are looked at: top left, top right, bottom
/// left, bottom right. The left and the top half are the smaller ones; a side of 1 is not divided.
/// @return how many of them there are: 4, 2, or 0 for a single pixel
int divide(const Rectangle& square, std::array<Rectangle, 4>& parts);

/// Divides a picture, some squares at a time.
class WarnockDivision {
  public:
    /// Polygons have the numbers of their places in `surfaces`, which must outlive this; one
    /// without rows is never met. Of two that are equally near, the earlier one wins.
    WarnockDivision(std::span<const PixelSurface> surfaces, const Rectangle& picture,
                    ClipDepth kind);

    /// Goes on until this many rows have been looked at, or more by one square.
    void advance(double most);
    bool is_done() const { return waiting_.empty(); }

    /// Is it too much: more than most_warnock_squares or most_warnock_steps? The rest is then left.
    bool is_too_much() const;

    /// All squares so far, in order of time.
    const std::vector<WarnockSquare>& squares() const { return squares_; }
    std::vector<WarnockSquare> take_squares() { return std::move(squares_); }
    /// Of a polygon with a square, and of two polygons in one.
    std::int64_t comparisons() const { return comparisons_; }
    /// Rows looked at.
    std::int64_t steps() const { return steps_; }

  private:
    /// A square that is looked at later.
    struct Waiting {
        Rectangle pixels;
        int depth, parent;
        std::size_t list_begin, list_end; ///< in lists_: what meets the square it is a part of
    };
    void look_at(const Waiting& waiting);
    SquareReason reason_of(const Rectangle& pixels, int& surface);
    int nearest_surrounding(const Rectangle& square);

    std::span<const PixelSurface> surfaces_;
    ClipDepth kind_;
    std::vector<WarnockSquare> squares_;
    std::vector<Waiting> waiting_; ///< the next one last
    std::vector<int> lists_;       ///< of the squares that are being divided, one after another
    struct Met {
        int surface;
        SquareRelation relation;
    };
    std::vector<Met> met_; ///< what meets the square at work
    std::int64_t comparisons_ = 0, steps_ = 0;
};

} // namespace rasterwalk
