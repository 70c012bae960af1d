#pragma once

#include <string>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// A moment in words, counted from 0: "triangles[20] of 30 (tall block) · edge 1 · line[13] of
/// 104". A row is named by its place in the picture and in the table. The moment must exist in the
/// frame and must not be the end.
std::string describe_moment(const Frame& frame, const Cursor& cursor);

/// The same in short, for any cursor: "triangles[20], edge 1, line[13]"; for the end, "end of the
/// frame".
std::string moment_name(const Cursor& cursor);

} // namespace rasterwalk
