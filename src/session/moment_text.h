#pragma once

#include <string>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// A moment in words, counted from 1: "triangle 21 of 30 (tall block) · edge 2 of 3 · sample 14 of
/// 104". The moment must exist in the frame and not be the end.
std::string describe_moment(const Frame& frame, const Cursor& cursor);

} // namespace rasterwalk
