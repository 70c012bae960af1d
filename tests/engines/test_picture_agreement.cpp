#include "engines/picture_agreement.h"

#include <stdexcept>

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

constexpr std::uint32_t grey = 0x808080;

EnginePicture grey_picture() {
    return {{100, 100}, std::vector<std::uint32_t>(10'000, grey)};
}

/// With these first pixels of row 7 in another colour.
EnginePicture with_patch(int pixels, std::uint32_t colour) {
    EnginePicture picture = grey_picture();
    for (int i = 0; i < pixels; ++i)
        picture.colour[static_cast<std::size_t>(703 + i)] = colour;
    return picture;
}

} // namespace

TEST_CASE("A channel that differs by 1 is rounded differently, one that differs by 2 is wrong") {
    const EnginePicture picture = grey_picture();
    for (const std::uint32_t close : {0x818080U, 0x807f80U, 0x80807fU, 0x7f817fU}) {
        const PictureDifference difference = difference_of(with_patch(50, close), picture);
        CHECK(difference.different == 0);
        CHECK(difference.largest == 1);
        CHECK(do_agree(difference));
    }
    for (const std::uint32_t other : {0x828080U, 0x807e80U, 0x808082U}) {
        const PictureDifference difference = difference_of(picture, with_patch(50, other));
        CHECK(difference ==
              PictureDifference{.pixels = 10'000, .different = 50, .largest = 2, .first = {3, 7}});
        CHECK_FALSE(do_agree(difference));
    }
}

TEST_CASE("Two pixels of ten thousand may differ, three may not") {
    CHECK(do_agree(difference_of(with_patch(2, 0), grey_picture())));
    const PictureDifference three = difference_of(with_patch(3, 0), grey_picture());
    CHECK_FALSE(do_agree(three));
    CHECK(difference_text(three) ==
          "3 of 10000 pixels differ (0.03 %), by up to 128/255, the first at 3,7");
    CHECK(difference_text(difference_of(grey_picture(), grey_picture())) == "no pixel differs");
}

TEST_CASE("Engines' pictures of different sizes are not compared") {
    const EnginePicture other{{50, 200}, std::vector<std::uint32_t>(10'000, grey)};
    CHECK_THROWS_AS(difference_of(grey_picture(), other), std::invalid_argument);
}
