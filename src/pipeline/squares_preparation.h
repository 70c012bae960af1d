#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pipeline/frame.h"

namespace rasterwalk {

/// Makes the squares of a frame whose polygons are complete, in parts; what comes out does not
/// depend on how many.
class SquaresPreparation {
  public:
    /// The frame must outlive it.
    explicit SquaresPreparation(const Frame& frame);

    /// Goes on with about this much work, in the unit of WorkLimit.
    void advance(double most);
    bool is_done() const;

    /// The squares, once it is done, for one call. Null: making them is too much, see
    /// base/limits.h.
    std::shared_ptr<const WarnockSquares> take();

  private:
    bool fits(int triangle);
    void add_table(int triangle);

    const Frame* frame_;
    WarnockSquares made_;
    std::vector<PixelSurface> surfaces_;      ///< of the drawn triangles, like the tables
    std::vector<int> triangles_;              ///< which they are
    std::optional<WarnockDivision> division_; ///< once all tables are made
    PolygonRows rows_;
    int next_ = 0;           ///< the triangle whose table is made next
    long long rows_sum_ = 0; ///< of all tables so far
    bool is_too_much_ = false;
};

/// About how much work it is to make the squares of a frame.
double squares_work(const Frame& frame);

} // namespace rasterwalk
