#pragma once

// Colours of the points of a model. OBJ has none; programs write them in two ways: after the
// coordinates of a point, "v x y z r g b" (MeshLab and others), or in comments "#MRGB" (ZBrush).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rasterwalk {

/// Gathers the colours while a model is read. What their numbers mean is known only at its end.
class PointColours {
  public:
    /// The numbers that follow the coordinates of a point: r g b; or w r g b, or r g b a.
    /// @param point   index of the point; larger than in the last call
    /// @param numbers three or four
    /// @param line    of the statement, from 1
    void add(std::size_t point, std::span<const double> numbers, int line);

    /// The text after "#MRGB": for each point, one after another, two hexadecimal digits each for
    /// a mask, red, green and blue. Ends at anything that is no such digit, or at
    /// `most_model_points`.
    void add_polypaint(std::string_view text);

    /// Do the numbers go up to 255? Yes, if one of them is 2 or more; numbers a little above 1
    /// count as 1.
    bool are_bytes() const { return largest_ >= 2.0; }
    /// The line of the first number that shows it, from 1.
    int line_of_bytes() const { return line_of_bytes_; }

    /// Red, green and blue of each point, 0..1; white where a point has none. Empty if no point
    /// has a colour. Of four numbers the first is a weight if it is 1 in all points.
    /// @param points how many there are
    std::vector<glm::vec3> colours(std::size_t points) const;

  private:
    std::vector<glm::vec4> given_; ///< after a point; NaN where nothing is given
    std::vector<std::uint32_t> polypaint_;
    bool is_weight_first_ = true; ///< in all points so far, four numbers begin with 1
    bool is_alpha_last_ = true;   ///< in all points so far, they end with 1
    double largest_ = 0.0;
    int line_of_bytes_ = 0;
};

} // namespace rasterwalk
