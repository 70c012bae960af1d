#pragma once

// Compares pictures, and makes the ways in which a right one may come out turned or moved.

#include <array>
#include <cstdint>
#include <string>

#include "base/image.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The fingerprint of a picture without pixels.
inline constexpr std::uint64_t no_fingerprint = 14695981039346656037u;

/// The same number for the same pixels, and hardly ever for different ones.
std::uint64_t fingerprint(const Image& image);

/// Do two pixels, of four bytes each, show the same? One step of 255 in a channel is not a
/// difference: a byte may be cut or rounded, and both are right. Opacity is ignored.
bool is_same_pixel(const std::uint8_t* a, const std::uint8_t* b);

/// Is it black, except for a step of 255?
bool is_black(const std::uint8_t* pixel);

/// Do both colours have the same shares of red, green and blue, like the same surface in white
/// light of any strength? A colour that is nearly black has none.
bool has_same_hue(const std::uint8_t* a, const std::uint8_t* b);

/// How different two pictures of the same size are.
struct ImageDistance {
    double mean = 0.0;          ///< steps of 255, over all channels of all pixels
    std::int64_t different = 0; ///< pixels that do not show the same
    double wrong = 0.0; ///< the same, but one that is only a little different counts in part
    /// The part of the pixels not black in the other picture that have a different hue or none in
    /// the first, plus a quarter of the part of its black ones that are not black: how little both
    /// show the same surfaces, whatever the light. 0..1.25.
    double other_surface = 0.0;
};

/// Compares a picture with another of the same size, some rows at a time from the top.
class ImageMeasure {
  public:
    /// Continues up to, not including, this row.
    void measure_to(const Image& image, const Image& other, int row);

    /// The number of rows measured.
    int rows() const { return rows_; }

    ImageDistance distance() const;
    /// The fingerprint of the first of the two pictures.
    std::uint64_t print() const { return print_; }

  private:
    int rows_ = 0;
    std::int64_t sum_ = 0, channels_ = 0, different_ = 0, wrong_ = 0;
    std::int64_t visible_ = 0, visible_otherwise_ = 0, black_ = 0, black_otherwise_ = 0;
    std::uint64_t print_ = no_fingerprint;
};

/// The picture in another size and in grey, with every pixel in orange that differs in a picture of
/// the same size, so that even a single one can be seen.
/// @param scale new pixels for each old one, above 0
Image with_differences_marked(const Image& image, const Image& other, float scale);

/// Where two pictures of the same size differ.
struct Differences {
    std::int64_t pixels = 0;
    Rectangle area; ///< that contains all of them
};
Differences differences_of(const Image& a, const Image& b);

/// The same as a sentence: "They are in columns 3 to 499 and rows 0 to 12." Empty if nothing
/// differs.
std::string place_words(const Differences& differences);

enum class Orientation : std::uint8_t { upright, mirrored, upside_down, half_turn };

/// The words for an orientation.
struct OrientationInfo {
    Orientation orientation;
    const char *id, *name;
};

/// All of them; the first is upright.
const std::array<OrientationInfo, 4>& orientation_list();

/// The picture turned; and moved by some pixels, black where no pixel has moved to.
Image oriented(const Image& image, Orientation orientation);
Image shifted(const Image& image, int columns, int rows);

} // namespace rasterwalk
