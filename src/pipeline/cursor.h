#pragma once

#include <array>
#include <climits>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/element_names.h"
#include "base/enum_words.h"

namespace rasterwalk {

/// The kinds of work a moment can be, in the order a triangle goes through them; then the one that
/// comes after all triangles.
enum class Phase : std::uint8_t { vertices, clip, cull, edges, tests, rows, resolve };

/// The words for a phase, and how its moments are written. A phase has pieces and a piece has
/// steps; the moments are the steps, or the pieces if they have none.
struct PhaseInfo {
    Phase phase;
    std::string_view word;  ///< in data: "edges"
    char letter;            ///< in the text of a moment: t12/e2
    bool is_numbered;       ///< the letter is followed by the number of the piece
    std::string_view piece; ///< what a piece is called, with '#' for its number: "edge #"
    char step_letter;       ///< t12/e2/s14; 0: a piece is a single moment
    std::string_view step;  ///< what a step is called: "line[#]"; empty if there are none
};

/// Every phase; indexed by Phase.
inline constexpr std::array phase_list{
    PhaseInfo{Phase::vertices, "vertices", 'v', true, vertex_form, 0, ""},
    PhaseInfo{Phase::clip, "clip", 'p', true, plane_form, 's', edge_form},
    PhaseInfo{Phase::cull, "cull", 'k', false, "front or back", 0, ""},
    PhaseInfo{Phase::edges, "edges", 'e', true, edge_form, 's', sample_form},
    PhaseInfo{Phase::tests, "tests", 'b', true, box_row_form, 'c', box_pixel_form},
    PhaseInfo{Phase::rows, "rows", 'r', true, entry_form, 'c', fragment_form},
    PhaseInfo{Phase::resolve, "resolve", 's', true, picture_row_form, 'c', picture_column_form},
};
inline constexpr int phase_count = static_cast<int>(phase_list.size());

constexpr bool phases_are_in_order() {
    for (std::size_t i = 0; i < phase_list.size(); ++i) {
        if (phase_list[i].phase != static_cast<Phase>(i)) return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (phase_list[i].letter == phase_list[j].letter) return false;
        }
    }
    return spelling<static_cast<Phase>(phase_count)>().empty(); // no phase without a row
}
static_assert(phases_are_in_order(),
              "phase_list lacks a phase, is not in the order of Phase, or has a letter twice");

constexpr const PhaseInfo& phase_info(Phase phase) {
    return phase_list[static_cast<std::size_t>(phase)];
}

/// Before the picture, the faces of a shadow map may be drawn: each in a pass of its own.
inline constexpr int early_pass_count = 6;

/// A moment in the drawing of a frame: the next piece of work to be done. Everything before it is
/// done, and nothing else. Totally ordered; counts from 0.
///
/// Each pass draws a frame of its own. What belongs to a frame (Timeline, draw(), reports) counts
/// its moments with pass 0, whichever pass it is drawn in; in a session, a link or a file a moment
/// has its pass. in_pass() and in_frame() lead from one to the other.
struct Cursor {
    int pass = 0;     ///< 0: the picture; -6 to -1, in texts p1 to p6: a pass before it
    int square = -1;  ///< of the picture, see Frame::squares; -1: the frame is not made of squares
    int triangle = 0; ///< -1: a square itself, which comes before the fragments in it;
                      ///< resolve_triangle: none, after all triangles
    Phase phase = Phase::vertices;
    int index = 0; ///< the piece: which vertex, plane, edge, row of the box or of the row table, or
                   ///< of the picture
    int step = 0;  ///< of the piece: which sample, or which column from the row's left end

    constexpr Cursor() = default;
    constexpr Cursor(int in_triangle, Phase in_phase, int at_index, int at_step, int in_pass = 0,
                     int in_square = -1)
        : pass(in_pass), square(in_square), triangle(in_triangle), phase(in_phase), index(at_index),
          step(at_step) {}

    friend auto operator<=>(const Cursor&, const Cursor&) = default;
};

/// The first moment of every frame.
inline constexpr Cursor cursor_begin{};

/// The moment after the last of every frame.
inline constexpr Cursor cursor_end{INT_MAX, Phase::vertices, 0, 0, INT_MAX};

/// A moment of the frame that is drawn in a pass, with that pass. The end of a pass before the
/// picture is a moment too: what it has drawn is complete.
constexpr Cursor in_pass(Cursor cursor, int pass) {
    if (cursor != cursor_end || pass < 0) cursor.pass = pass;
    return cursor;
}

/// The moment of the frame drawn in `pass` at which a moment of any pass finds it: the same, or its
/// beginning or end if that pass comes later or is over.
constexpr Cursor in_frame(Cursor cursor, int pass) {
    const int of_cursor = cursor == cursor_end ? 0 : cursor.pass;
    if (of_cursor != pass) return of_cursor < pass ? cursor_begin : cursor_end;
    if (cursor == in_pass(cursor_end, pass)) return cursor_end;
    cursor.pass = 0;
    return cursor;
}

/// The number of a pass before the picture in texts, 1 to 6.
constexpr int pass_number(int pass) {
    return pass + early_pass_count + 1;
}

/// Where the moments of a triangle begin; those of earlier triangles have ended.
constexpr Cursor beginning_of(int triangle) {
    return {triangle, Phase::vertices, 0, 0};
}

/// In place of a triangle, for the moments that come after all of them and belong to none.
inline constexpr int resolve_triangle = INT_MAX - 1;

/// The moment at which a pixel of the picture is resolved: its samples become one colour.
constexpr Cursor moment_of_resolve(int row, int column) {
    return {resolve_triangle, Phase::resolve, row, column};
}

/// Is it such a moment?
constexpr bool is_resolve(const Cursor& cursor) {
    return cursor.triangle == resolve_triangle && cursor.phase == Phase::resolve;
}

/// The moment of a square of the picture.
constexpr Cursor moment_of_square(int square) {
    return {-1, Phase::vertices, 0, 0, 0, square};
}

/// Is it the moment of a square, not a piece of work in it?
constexpr bool is_square(const Cursor& cursor) {
    return cursor.square >= 0 && cursor.triangle < 0;
}

/// The text form: `t12/v1`, `t12/p0/s2`, `t12/k`, `t12/e2/s14`, `t12/b4/c7`, `t12/r37/c5`, `end`;
/// of a square of the picture `w12`, and of a fragment in it `w12/t3/r37/c5`; of a pixel of the
/// picture that is resolved `s37/c5`; of a pass before the picture, with its number in front,
/// `p1:t12/v1` and `p1:end`.
std::string to_text(const Cursor& cursor);

/// The piece and the step alone, for tight spaces: "v1", "e2 [14]" for edge 2, line[14], "r37 [5]"
/// for entry [37], fragments[5]; "k" for a phase whose piece has no number; "w12" for a square;
/// "s37 [5]" for row 37, column 5 of the picture.
std::string short_place(const Cursor& cursor);

/// Reads the text form; parts left out are 0: `t12` is `t12/v0`, `t12/r37` is `t12/r37/c0`.
std::optional<Cursor> parse_cursor(std::string_view text);

} // namespace rasterwalk
