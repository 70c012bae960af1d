#pragma once

// Why nothing fell on a pixel: whose rows came nearest, and which rule would have brought them
// there.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/frame.h"

namespace rasterwalk {

/// One other rule under which a triangle would have covered the pixel.
struct OtherRule {
    std::string_view rule;   ///< as for --set: `rounding=floor`
    int left = 0, right = 0; ///< columns at which the triangle's row then begins and ends
};

/// A triangle that passes by an uncovered pixel.
struct NearTriangle {
    int triangle = -1;
    int first_row = 0, last_row = 0; ///< rows of the picture that its row table spans
    int row = 0;               ///< of the picture: the pixel's own, or the nearest of the table
    bool is_empty = false;     ///< nothing of that row is drawn; it has no ends
    bool is_by_samples = true; ///< its rows are made of edge samples
    bool is_left_out = false;  ///< because it is a single pixel and such rows are left out
    int left = 0, right = 0;   ///< columns at which that row begins and ends
    int columns_away = 0; ///< from the pixel to the nearer end, or, if the row is empty, to the box
                          ///< of the vertices; to the right is positive
    int rows_away = 0;    ///< from the pixel to that row; downward is positive
    std::vector<OtherRule> rules; ///< that would have covered the pixel, each by itself
};

/// The triangles whose rows come nearest to a pixel on which no fragment falls, nearest first, at
/// most `count`. Only stages from `fill` on have rows to ask; before, and in a scene in which
/// nothing is drawn, there are none. Of very many triangles only those are looked at whose boxes
/// are nearest.
std::vector<NearTriangle> nearest_triangles(const Frame& frame, const glm::ivec2& pixel,
                                            int count = 3);

/// The same in parts: the boxes of a part of the triangles at a time, then the rows of the few that
/// may be nearest.
class NearestSearch {
  public:
    /// The frame must live as long.
    NearestSearch(const Frame& frame, const glm::ivec2& pixel);

    /// Looks at this many further boxes.
    void look(int triangles);
    bool is_done() const { return next_ >= end_; }

    /// What is found; once is_done().
    std::vector<NearTriangle> found(int count = 3);

  private:
    using Box = std::pair<std::int64_t, int>; ///< squared distance, triangle
    const Frame* frame_;
    glm::ivec2 pixel_;
    std::vector<Box> boxes_;
    int next_ = 0;
    int end_ = 0; ///< 0 where there is nothing to look at
};

/// In words, why nothing falls on a pixel, as far as it is the same for all uncovered pixels of the
/// frame: "No row of any triangle reaches this pixel."
std::string uncovered_text(const Frame& frame, const glm::ivec2& pixel);

/// In words, what kept the triangle off the pixel: "row 250 begins at column 1, 1 column to the
/// right of the pixel".
std::string miss_text(const NearTriangle& near);

/// In words, what would have brought it there: "with rounding=floor it begins at column 0"; empty
/// if no rule does.
std::string rules_text(const NearTriangle& near, const glm::ivec2& pixel);

} // namespace rasterwalk
