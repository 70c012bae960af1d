#include "base/letter_case.h"

#include "base/image_format.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("ASCII capitals become small letters, and every other byte is kept") {
    CHECK(in_small_letters("AZ az [\\]^_` @ 09 \xC3\x84") == "az az [\\]^_` @ 09 \xC3\x84");
    CHECK(contains_in_any_case("A Row Table", "row t"));
    CHECK(contains_in_any_case("anything", ""));
    CHECK_FALSE(contains_in_any_case("row", "rows"));
}

TEST_CASE("A picture is recognized by its file extension, in capitals or not") {
    for (const char* const name : {"a.png", "A.PNG", "b.Jpeg", "c.tga", "d.ppm", ".pgm"})
        CHECK(has_image_ending(name));
    for (const char* const name : {"png", "a.png.txt", "a.tif", "", "a.jpgx"})
        CHECK_FALSE(has_image_ending(name));
}

TEST_CASE("A format that keeps every pixel is recognized by the file extension") {
    for (const char* const name : {"a.png", "A.PNG", "c.tga", "e.Bmp", "d.ppm", ".pgm"})
        CHECK(has_exact_image_ending(name));
    for (const char* const name : {"b.jpg", "b.Jpeg", "a.png.jpg", "a.tif", "", "png"})
        CHECK_FALSE(has_exact_image_ending(name));
}
