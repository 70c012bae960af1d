#pragma once

// Comparing pictures, and the ways in which a right one may come out turned or moved.

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

/// Do two pixels, of four bytes each, show the same? A step of 255 in a channel is none: a byte may
/// be cut or rounded, and both are right. Opacity is not looked at.
bool is_same_pixel(const std::uint8_t* a, const std::uint8_t* b);

/// Black, but for a step of 255?
bool is_black(const std::uint8_t* pixel);

/// Have both colours the same shares of red, green and blue, as the same surface has in white light
/// of any strength? What is nearly black has none.
bool has_same_hue(const std::uint8_t* a, const std::uint8_t* b);

/// How far two pictures of the same size lie apart.
struct ImageDistance {
    double mean = 0.0;          ///< steps of 255, over all channels of all pixels
    std::int64_t different = 0; ///< pixels that do not show the same
    double wrong = 0.0; ///< the same, but one that is only a little different counts as a part
    /// Part of the pixels that are not black in the other picture and have another hue in the
    /// first, or none, and a quarter of the part of its black ones that are not black: how little
    /// both show the same surfaces, whatever the light. 0..1.25.
    double other_surface = 0.0;
};

/// Compares a picture with another one of the same size, some rows at a time from the top.
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
    std::int64_t sum_ = 0, channels_ = 0, different_ = 0, wrong_ = 0;
    std::int64_t seen_ = 0, seen_otherwise_ = 0, black_ = 0, black_otherwise_ = 0;
    std::uint64_t print_ = no_fingerprint;
};

/// The picture in another size and in grey, and over it in orange what does not show the same in a
/// picture of the same size: be it one pixel, it is seen.
/// @param scale new pixels for each old one, above 0
Image with_differences_marked(const Image& image, const Image& other, float scale);

/// Where two pictures of the same size do not show the same.
struct Differences {
    std::int64_t pixels = 0;
    Rectangle area; ///< in which all of them lie
};
Differences differences_of(const Image& a, const Image& b);

/// The same in a sentence: "They are in columns 3 to 499 and rows 0 to 12." Empty if nothing
/// differs.
std::string place_words(const Differences& differences);

enum class Orientation : std::uint8_t { upright, mirrored, upside_down, half_turn };

/// What is said about an orientation.
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
