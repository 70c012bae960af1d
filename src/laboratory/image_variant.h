#pragma once

// Pictures held against each other, and the ways in which a right one may come out turned or moved.

#include <array>
#include <cstdint>
#include <string>

#include "base/image.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The fingerprint of a picture without pixels.
inline constexpr std::uint64_t no_fingerprint = 14695981039346656037u;

/// The same number for the same pixels, and hardly ever for others.
std::uint64_t fingerprint(const Image& image);

/// How far two pictures of the same size lie apart.
struct ImageDistance {
    double mean = 0.0;          ///< steps of 255, over all channels of all pixels
    std::int64_t different = 0; ///< pixels
};

/// A picture held against another one of the same size, some rows at a time from the top.
class ImageMeasure {
  public:
    /// Goes on to this row, which is not measured itself.
    void measure_to(const Image& image, const Image& other, int row);

    /// The rows that are measured.
    int rows() const { return rows_; }

    ImageDistance distance() const;
    /// The fingerprint of the first of the two pictures.
    std::uint64_t print() const { return print_; }

  private:
    int rows_ = 0;
    std::int64_t sum_ = 0, channels_ = 0, different_ = 0;
    std::uint64_t print_ = no_fingerprint;
};

/// The picture in another size and in grey, and over it in orange what is not so in a picture of
/// the same size: be it one pixel, it is seen.
/// @param scale new pixels for each old one, above 0
Image with_differences_marked(const Image& image, const Image& other, float scale);

/// Where two pictures of the same size differ.
struct Differences {
    std::int64_t pixels = 0;
    Rectangle area; ///< in which all of them lie
};
Differences differences_of(const Image& a, const Image& b);

/// The same in a sentence: "They are in columns 3 to 499 and rows 0 to 12." Empty if nothing
/// differs.
std::string place_words(const Differences& differences);

enum class Orientation : std::uint8_t { upright, mirrored, upside_down, half_turn };

/// What is said of an orientation.
struct OrientationInfo {
    Orientation orientation;
    const char *id, *name;
};

/// All of them; the first is upright.
const std::array<OrientationInfo, 4>& orientation_list();

/// The picture turned; and moved by some pixels, black where nothing comes from.
Image oriented(const Image& image, Orientation orientation);
Image shifted(const Image& image, int columns, int rows);

} // namespace rasterwalk
