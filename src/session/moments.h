#pragma once

#include <string>

#include "base/language.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The moment that a text names, on the command line, in a link or in a lesson. In a row that
/// exists, a column that does not (`t12/r37`, `t12/r37/c9999`) stands for the next moment after it;
/// a fragment in a square stands for the square. Throws UsageError that says which moments exist.
/// @return with its pass
/// @param frame drawn in the pass of the moment
Cursor moment_of(const Frame& frame, const std::string& text);
Cursor moment_of(const Frame& frame, const Cursor& cursor);

/// The same in any pass of a picture: prepares the frame of that pass.
Cursor moment_of(const Scene& scene, const Settings& settings, const std::string& text);
Cursor moment_of(const Scene& scene, const Settings& settings, const Cursor& cursor);

/// The moment of a picture, or of a pass before it, at or after a cursor.
Cursor existing_moment(const Scene& scene, const Settings& settings, const Cursor& cursor);

/// A moment in words of a language, counted from 0: "triangles[20] of 30 (tall block) · edge 1 ·
/// line[13] of 104". A row is named by its place in the picture and in the table. Of a square:
/// "square w12 of 3021: columns 250 to 311, rows 0 to 61 · one surface: triangles[3] (floor)". In a
/// pass of the shadow map the face comes first. Fragments in squares are described too. What the
/// frame does not have, as when only another run does it, gets its moment_name().
std::string describe_moment(const Frame& frame, const Cursor& cursor,
                            const Language& language = english());

/// What becomes of a square, without its place: "square w12 · one surface: triangles[3]".
std::string describe_square_in_short(const Frame& frame, int square,
                                     const Language& language = english());

/// The same in short, for any cursor: "triangles[20], edge 1, line[13]"; for the end, "end of the
/// frame".
std::string moment_name(const Cursor& cursor, const Language& language = english());

} // namespace rasterwalk
