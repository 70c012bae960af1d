#pragma once

#include <glm/vec2.hpp>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// Which part of a triangle is filled at a moment of its frame.
class FilledPart {
  public:
    /// @param frame    must live as long
    /// @param triangle of the frame; must be one
    FilledPart(const Frame& frame, const Cursor& cursor, int triangle);

    bool is_whole() const { return is_whole_; }
    bool is_empty() const { return !is_whole_ && (!has_rows_ || rows_.size() == 0); }

    /// Is what the camera sees in this place of its picture filled? To be asked of a part that is
    /// not empty.
    /// @param pixel from its corner
    bool has(const glm::dvec2& pixel) const;

  private:
    const Frame& frame_;
    Cursor cursor_;
    int triangle_;
    bool is_whole_, has_rows_ = false, has_columns_;
    PolygonRows rows_;
};

} // namespace rasterwalk
