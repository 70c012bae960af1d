#include "tests/support/compare_images.h"

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Image plain_image(int width, int height, std::uint8_t value) {
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                      value);
    return image;
}

std::uint8_t& channel(Image& image, int column, int row, int index) {
    return image.rgba.at(static_cast<std::size_t>(4 * (row * image.width + column) + index));
}

} // namespace

TEST_CASE("The same picture twice differs in nothing") {
    const Image image = plain_image(7, 5, 90);
    const ImageDifference found = compare_images(image, image, {});
    CHECK(found.same_size);
    CHECK(found.largest == 0);
    CHECK(found.mean == 0.0);
    CHECK(found.pixels_beyond == 0);
    CHECK(found.worst.empty());
    CHECK(found.is_within_tolerance);
    CHECK(describe_difference(image, image, {}) == "  The pictures are the same.\n");
}

TEST_CASE("Pictures of different size are never the same") {
    const Tolerance everything{255, 255.0, 1000};
    const ImageDifference found =
        compare_images(plain_image(4, 6, 0), plain_image(6, 4, 0), everything);
    CHECK_FALSE(found.same_size);
    CHECK_FALSE(found.is_within_tolerance);
    CHECK(describe_difference(plain_image(4, 6, 0), plain_image(6, 4, 0), everything) ==
          "  The picture is 4 x 6 pixels, expected 6 x 4.\n");
    const Image shown = difference_image(plain_image(4, 6, 0), plain_image(6, 4, 0), everything);
    CHECK(shown.width == 6);
    CHECK(shown.height == 6);
}

TEST_CASE("A difference counts from one more than the tolerance, up and down") {
    const Image expected = plain_image(10, 10, 100);
    for (const int change : {-4, -3, 3, 4}) {
        for (int index = 0; index < 4; ++index) {
            Image actual = expected;
            channel(actual, 3, 8, index) = static_cast<std::uint8_t>(100 + change);
            const ImageDifference found = compare_images(actual, expected, {3, 1.0, 0});
            const bool is_beyond = change == 4 || change == -4;
            CHECK(found.largest == (change > 0 ? change : -change));
            CHECK(found.pixels_beyond == (is_beyond ? 1 : 0));
            CHECK(found.is_within_tolerance == !is_beyond);
            REQUIRE(found.worst.size() == 1);
            CHECK(found.worst[0].column == 3);
            CHECK(found.worst[0].row == 8);
        }
    }
}

TEST_CASE("As many pixels may be beyond as the tolerance says, and not one more") {
    const Image expected = plain_image(20, 20, 0);
    Image actual = expected;
    channel(actual, 1, 1, 0) = 200;
    channel(actual, 2, 1, 1) = 200;
    const Tolerance two{3, 1.0, 2};
    CHECK(compare_images(actual, expected, two).is_within_tolerance);
    channel(actual, 3, 1, 2) = 4;
    const ImageDifference found = compare_images(actual, expected, two);
    CHECK(found.pixels_beyond == 3);
    CHECK_FALSE(found.is_within_tolerance);
}

TEST_CASE("Many small differences are found by their mean") {
    const Image expected = plain_image(10, 10, 50);
    const Image actual = plain_image(10, 10, 52);
    const ImageDifference found = compare_images(actual, expected, {3, 1.5, 0});
    CHECK(found.pixels_beyond == 0);
    CHECK(found.mean == 2.0);
    CHECK_FALSE(found.is_within_tolerance);
    CHECK(compare_images(actual, expected, {3, 2.0, 0}).is_within_tolerance);
}

TEST_CASE("The worst pixels come first, and are listed with both colours and their place") {
    const Image expected = plain_image(100, 50, 10);
    Image actual = expected;
    for (int column = 0; column < 20; ++column)
        channel(actual, column, 40, 0) = 20;
    channel(actual, 99, 49, 1) = 210;
    channel(actual, 0, 0, 2) = 60;
    const ImageDifference found = compare_images(actual, expected, {3, 0.02, 0});
    CHECK(found.pixels_beyond == 22);
    REQUIRE(found.worst.size() == 8);
    CHECK(found.worst[0].column == 99);
    CHECK(found.worst[0].row == 49);
    CHECK(found.worst[1].difference == 50);
    CHECK(found.worst[2].column == 0);
    CHECK(found.worst[7].column == 5);

    const std::string text = describe_difference(actual, expected, {3, 0.02, 0});
    CHECK(text.find("22 pixels differ by more than 3 (0 may), the largest difference is 200") !=
          std::string::npos);
    CHECK(text.find("(  99,  49)  actual ( 10 210  10  10)  expected ( 10  10  10  10)") !=
          std::string::npos);
    // The map is 72 characters wide: its last one stands for the last pixel, its first for the
    // first.
    CHECK(text.find("#|\n") != std::string::npos);
    CHECK(text.find("  |O") != std::string::npos);
}

TEST_CASE("The difference picture tells unchanged, small and large differences apart") {
    const Image expected = plain_image(3, 1, 120);
    Image actual = expected;
    channel(actual, 1, 0, 0) = 122;
    channel(actual, 2, 0, 0) = 220;
    Image shown = difference_image(actual, expected, interface_tolerance);
    CHECK(channel(shown, 0, 0, 0) == 30);
    CHECK(channel(shown, 0, 0, 2) == 30);
    CHECK(channel(shown, 1, 0, 2) == 200);
    CHECK(channel(shown, 2, 0, 0) == 255);
    CHECK(channel(shown, 2, 0, 2) == 0);
}
