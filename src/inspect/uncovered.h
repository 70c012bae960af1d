#pragma once

// Why nothing fell on a pixel: the triangles whose rows came nearest, and the rules that would have
// brought them there.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/frame.h"

namespace rasterwalk {

/// A rule under which a triangle would have covered the pixel.
struct OtherRule {
    std::string_view rule;   ///< as for --set: `rounding=floor`
    int left = 0, right = 0; ///< columns where the triangle's row then begins and ends
};

/// A triangle that passes by an uncovered pixel.
struct NearTriangle {
    int triangle = -1;
    int first_row = 0, last_row = 0; ///< rows of the picture that its row table spans
    int row = 0;               ///< of the picture: the pixel's own, or the nearest of the table
    bool is_empty = false;     ///< nothing in that row is drawn; it has no ends
    bool is_by_samples = true; ///< its rows are made from edge samples
    bool has_samples = false;  ///< pixels have several samples
    bool is_left_out = false;  ///< because it is a single pixel, and such rows are left out
    int left = 0, right = 0;   ///< columns where that row begins and ends
    int columns_away = 0; ///< from the pixel to the nearer end, or, if the row is empty, to the box
                          ///< of the vertices; positive to the right
    int rows_away = 0;    ///< from the pixel to that row; positive downward
    std::vector<OtherRule> rules; ///< each alone would have covered the pixel
};

/// The triangles whose rows come nearest to a pixel on which no fragment falls, nearest first, at
/// most `count`. Only stages from `fill` onward have rows to look at; before, and in a scene where
/// nothing is drawn, there are none. Of very many triangles only those with the nearest boxes are
/// looked at.
std::vector<NearTriangle> nearest_triangles(const Frame& frame, const glm::ivec2& pixel,
                                            int count = 3);

/// The same in parts: the boxes of some triangles at a time, then the rows of the few that may be
/// nearest.
class NearestSearch {
  public:
    /// The frame must outlive this.
    NearestSearch(const Frame& frame, const glm::ivec2& pixel);

    /// Looks at this many further boxes.
    void look(int triangles);
    bool is_done() const { return next_ >= end_; }

    /// The result; once is_done().
    std::vector<NearTriangle> found(int count = 3);

  private:
    using Box = std::pair<std::int64_t, int>; ///< squared distance, triangle
    const Frame* frame_;
    glm::ivec2 pixel_;
    std::vector<Box> boxes_;
    int next_ = 0;
    int end_ = 0; ///< 0 if there is nothing to look at
};

/// In words, why nothing falls on a pixel, as far as that is the same for all uncovered pixels of
/// the frame: "No row of any triangle reaches this pixel."
std::string uncovered_text(const Frame& frame, const glm::ivec2& pixel);

/// In words, what kept the triangle off the pixel: "row 250 begins at column 1, 1 column to the
/// right of the pixel".
std::string miss_text(const NearTriangle& near);

/// In words, what would have brought it there: "with rounding=floor it begins at column 0"; empty
/// if no rule does.
std::string rules_text(const NearTriangle& near, const glm::ivec2& pixel);

} // namespace rasterwalk
