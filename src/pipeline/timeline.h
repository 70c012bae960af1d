#pragma once

// The moments of a frame: which cursors exist, and how to go from one to another. The moments of a
// triangle go through the phases of phase_list: its three vertices; if planes cut it, each edge at
// each of them; if something culls, the answer; then, from stage `edges` onward, the samples of the
// edges of what is left or, if edge functions find the pixels, every pixel of the box that they
// test; then in stage `rows` one moment for every row, which shows its two ends, and from stage
// `fill` onward one moment for every fragment. Rows and fragments outside the picture have no
// moments, nor does a triangle that is left out; one removed by clip or cull ends there. Every
// question costs at most a triangle or two: the samples of their edges and their rows, or the rows
// of their boxes.
//
// Where pixels have several samples, the moments after those of all triangles resolve the pixels of
// the picture, row by row. They belong to resolve_triangle, which is treated like one more
// triangle.
//
// Where the picture is divided into squares, they are the moments, see square_steps.h: triangles
// have none.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/enum_words.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// How far one step goes.
enum class Granularity : std::uint8_t {
    moment,   ///< one vertex, edge sample, row end pair or fragment
    line,     ///< one edge or row (the pieces of a phase without steps are one line)
    triangle, ///< one triangle
    phase,    ///< from vertices to edges to rows to the next triangle
    code,     ///< a line of the code that does it, see lab_code/code_walk.h; in time, a moment
};

/// The size of a step in time alone.
constexpr Granularity in_time(Granularity step) {
    return step == Granularity::code ? Granularity::moment : step;
}

/// The moments of one phase of a triangle.
struct PhaseMoments {
    /// The steps of a piece that are moments: for a row, the columns, counted from its left end,
    /// that lie in the picture; for a row of the box, only those tested. 0 if the piece has no
    /// moments.
    struct Steps {
        int first = 0;
        int count = 0;
    };
    std::vector<Steps> pieces;
    std::vector<int> before{0}; ///< moments of all earlier pieces; one entry more than pieces

    int count() const { return before.back(); }
    void clear();
    void add(const Steps& piece);
};

/// The moments of one triangle. Which phases have pieces depends on the stage.
struct TriangleMoments {
    int triangle = -1;
    std::array<PhaseMoments, phase_count> phases; ///< indexed by Phase
    PolygonRows rows;                             ///< the finished row table
    int count = 0;                                ///< all moments of the triangle

    const PhaseMoments& of(Phase phase) const { return phases[static_cast<std::size_t>(phase)]; }
    PhaseMoments& of(Phase phase) { return phases[static_cast<std::size_t>(phase)]; }
};

/// Finds the moments of a frame. Keeps the last triangle it was asked about.
class Timeline {
  public:
    explicit Timeline(const Frame& frame) : frame_(&frame) {}

    /// The first moment; `end` for a frame in which nothing is drawn.
    Cursor first() const { return at_or_after(cursor_begin); }
    /// The moment itself if it exists, or the next one that does.
    Cursor at_or_after(const Cursor& cursor) const;
    bool exists(const Cursor& cursor) const;

    /// The beginning of the next or previous piece of this size; `end` after the last, the first
    /// moment before the first. Back from the middle of a piece goes to its beginning.
    Cursor next(const Cursor& cursor, Granularity step) const;
    Cursor previous(const Cursor& cursor, Granularity step) const;

    /// Place of a moment on the scrub bar, 0..1: triangles are equally wide, moments within them
    /// too. So are squares.
    double place(const Cursor& cursor) const;
    Cursor at_place(double place) const;

    /// The moments of a triangle, or of resolve_triangle; none if it is left out. Valid until the
    /// next question.
    const TriangleMoments& moments(int triangle) const;

    /// Number of a moment within its triangle, from 0, and back. Not of a square.
    int ordinal(const Cursor& cursor) const;
    Cursor at_ordinal(int triangle, int ordinal) const;

    const Frame& frame() const { return *frame_; }

  private:
    const Frame* frame_;
    mutable TriangleMoments cache_;

    const WarnockSquares* squares() const { return frame_->squares.get(); }
};

} // namespace rasterwalk
