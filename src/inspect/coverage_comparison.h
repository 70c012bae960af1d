#pragma once

// A polygon of a scene, covered in three ways: by a row table and by a fan of triangles, next to
// the pixels that lie inside. Without dents all three are the same.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/enum_words.h"
#include "pipeline/frame.h"
#include "stages/rectangle.h"
#include "stages/snap.h"

namespace rasterwalk {

/// Pixels are tested at their centres, by the frame's snap and fill rule; all count, even those
/// outside the picture.
struct CoverageComparison {
    int corners = 0;             ///< of its outline
    std::int64_t inside = 0;     ///< pixels inside, by the list of active edges
    std::int64_t table = 0;      ///< from the first to the last of them in every row: a row table
    int rows = 0;                ///< rows that have pixels inside
    int wrong_rows = 0;          ///< of those, rows in which the row table has others too
    std::int64_t fan = 0;        ///< pixels that a triangle of the fan covers
    std::int64_t fan_writes = 0; ///< the same, each as often as triangles cover it
    double area = 0.0;           ///< of the outline, square pixels; never negative
    double fan_area = 0.0;       ///< of all triangles of the fan together
};

/// The drawn corners of the polygon that a triangle of the frame belongs to; none if it belongs to
/// none, or if one of its triangles is cut, is left out, or was moved alone.
std::vector<ScreenVertex> outline_of(const Frame& frame, int triangle);

/// The same polygon in numbers; none if there is no outline.
std::optional<CoverageComparison> coverage_comparison(const Frame& frame, int triangle);

/// The ways to cover a polygon.
enum class CoverageMethod : std::uint8_t { table, fan, active_edges };

inline constexpr std::size_t coverage_method_count = enum_words<CoverageMethod>.size();

/// A pixel by one of the ways, compared with the inside.
enum class PolygonPixel : std::uint8_t {
    outside, ///< and not covered
    inside,  ///< and covered
    filled,  ///< covered, though it lies outside: wrong
    missed,  ///< inside, but not covered: wrong
};

/// The pixels that one way covers.
struct CoverageByMethod {
    std::int64_t covered = 0;         ///< pixels, each once
    std::int64_t wrong = 0;           ///< pixels that are filled or missed
    std::vector<PolygonPixel> pixels; ///< of the window, row by row
};

/// The polygon by each of the ways. The list of active edges decides what is inside: by the
/// even-odd rule, and on the outline by the fill rule.
struct PolygonPicture {
    Rectangle window;               ///< pixels of the picture
    std::vector<GridPoint> outline; ///< the snapped corners
    /// Indexed by CoverageMethod; the numbers are of the whole polygon.
    std::array<CoverageByMethod, coverage_method_count> methods;
};

/// The window of a PolygonPicture has at most this many columns and rows, about its middle.
inline constexpr int polygon_window_side = 128;

/// None if there is no outline; polygons of a scene have four corners or more.
std::optional<PolygonPicture> polygon_picture(const Frame& frame, int triangle);

} // namespace rasterwalk
