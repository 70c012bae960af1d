#pragma once

#include <glm/vec2.hpp>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// The part of a triangle that is filled at a moment of its frame.
class FillProgress {
  public:
    /// @param frame    must outlive this
    /// @param triangle must be one of the frame
    FillProgress(const Frame& frame, const Cursor& cursor, int triangle);

    bool is_whole() const { return is_whole_; }
    bool is_empty() const { return !is_whole_ && (!has_rows_ || rows_.size() == 0); }

    /// Is what the camera sees at this point of its picture filled? The part must not be empty.
    /// @param pixel from the picture's corner
    bool has(const glm::dvec2& pixel) const;

  private:
    const Frame& frame_;
    Cursor cursor_;
    int triangle_;
    bool is_whole_, has_rows_ = false, has_columns_;
    PolygonRows rows_;
};

} // namespace rasterwalk
