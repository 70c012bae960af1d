#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "stages/warnock.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// A rectangle of pixels of one depth.
PixelSurface rectangle_at(const Rectangle& pixels, double depth, double step = 0.0) {
    PixelSurface surface;
    surface.first_row = pixels.top;
    for (int row = pixels.top; row < pixels.bottom; ++row)
        surface.rows.push_back({pixels.left, pixels.right, depth, step});
    find_box(surface);
    return surface;
}

struct Divided {
    std::vector<WarnockSquare> squares;
    std::int64_t comparisons;
};
Divided divide_picture(const std::vector<PixelSurface>& surfaces, const Rectangle& picture,
                       double part = std::numeric_limits<double>::infinity()) {
    WarnockDivision division(surfaces, picture, ClipDepth::inv_z);
    while (!division.is_done())
        division.advance(part);
    return {division.take_squares(), division.comparisons()};
}

} // namespace

TEST_CASE("A polygon is disjoint from a square, surrounds it or intersects it") {
    const PixelSurface surface = rectangle_at({2, 3, 8, 9}, 1.0);
    CHECK(relation_to(surface, {2, 3, 8, 9}) == SquareRelation::surrounding);
    CHECK(relation_to(surface, {4, 4, 5, 5}) == SquareRelation::surrounding);
    CHECK(relation_to(surface, {1, 3, 8, 9}) == SquareRelation::intersecting);
    CHECK(relation_to(surface, {2, 3, 8, 10}) == SquareRelation::intersecting);
    CHECK(relation_to(surface, {0, 0, 2, 20}) == SquareRelation::disjoint);
    CHECK(relation_to(surface, {0, 9, 20, 20}) == SquareRelation::disjoint);

    PixelSurface with_gap = surface; // a row that no sample has reached
    with_gap.rows[2] = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 0.0, 0.0};
    find_box(with_gap);
    CHECK(with_gap.box == surface.box);
    CHECK(relation_to(with_gap, {3, 4, 5, 7}) == SquareRelation::intersecting);
    CHECK(relation_to(with_gap, {3, 5, 5, 6}) == SquareRelation::disjoint);

    // In the box, but not in the triangle.
    PixelSurface triangle;
    triangle.rows = {{0, 1, 1.0, 0.0}, {0, 2, 1.0, 0.0}, {0, 3, 1.0, 0.0}, {0, 4, 1.0, 0.0}};
    find_box(triangle);
    CHECK(relation_to(triangle, {2, 0, 4, 2}) == SquareRelation::disjoint);
}

TEST_CASE("The ends of each row decide which polygon is in front in a square") {
    const Rectangle square{0, 0, 8, 2};
    const PixelSurface rising = rectangle_at(square, 1.0, 0.25);
    const PixelSurface level = rectangle_at({2, 0, 4, 2}, 1.25);
    CHECK(is_in_front(rising, level, square, ClipDepth::inv_z, false)); // 1.5 and more there
    CHECK_FALSE(is_in_front(rising, rectangle_at(square, 1.25), square, ClipDepth::inv_z, true));
    CHECK(is_in_front(rising, rectangle_at(square, 1.0), square, ClipDepth::inv_z, true));
    CHECK_FALSE(is_in_front(rising, rectangle_at(square, 1.0), square, ClipDepth::inv_z, false));
    // Of ndc z the smaller one is nearer.
    CHECK_FALSE(is_in_front(rising, level, square, ClipDepth::ndc, true));
    CHECK(is_in_front(level, rising, {2, 0, 4, 2}, ClipDepth::ndc, false));
}

TEST_CASE("A square has four parts, or two, or none") {
    std::array<Rectangle, 4> parts;
    REQUIRE(divide({0, 0, 5, 3}, parts) == 4);
    CHECK(parts ==
          std::array<Rectangle, 4>{{{0, 0, 2, 1}, {2, 0, 5, 1}, {0, 1, 2, 3}, {2, 1, 5, 3}}});
    REQUIRE(divide({7, 2, 8, 5}, parts) == 2);
    CHECK(parts[0] == Rectangle{7, 2, 8, 3});
    CHECK(parts[1] == Rectangle{7, 3, 8, 5});
    REQUIRE(divide({7, 2, 9, 3}, parts) == 2);
    CHECK(parts[0] == Rectangle{7, 2, 8, 3});
    CHECK(parts[1] == Rectangle{8, 2, 9, 3});
    CHECK(divide({7, 2, 8, 3}, parts) == 0);
}

TEST_CASE("A pixel in front of a surface is found by dividing twice") {
    const std::vector<PixelSurface> surfaces{rectangle_at({0, 0, 4, 4}, 1.0),
                                             rectangle_at({0, 0, 1, 1}, 2.0)};
    const Divided found = divide_picture(surfaces, {0, 0, 4, 4});
    using enum SquareReason;
    CHECK(found.squares == std::vector<WarnockSquare>{
                               {{0, 0, 4, 4}, divide, -1, 0, -1, 8},
                               {{0, 0, 2, 2}, divide, -1, 1, 0, 4},
                               {{0, 0, 1, 1}, one_pixel, 1, 2, 1, 0},
                               {{1, 0, 2, 1}, one_surface, 0, 2, 1, 0},
                               {{0, 1, 1, 2}, one_surface, 0, 2, 1, 0},
                               {{1, 1, 2, 2}, one_surface, 0, 2, 1, 0},
                               {{2, 0, 4, 2}, one_surface, 0, 1, 0, 0},
                               {{0, 2, 2, 4}, one_surface, 0, 1, 0, 0},
                               {{2, 2, 4, 4}, one_surface, 0, 1, 0, 0},
                           });
    // Two polygons with each of the nine squares, and with each other in the three where both are.
    CHECK(found.comparisons == 9 * 2 + 3);
    for (const double part : {0.5, 1.0, 7.0}) {
        const Divided in_parts = divide_picture(surfaces, {0, 0, 4, 4}, part);
        CHECK(in_parts.squares == found.squares);
        CHECK(in_parts.comparisons == found.comparisons);
    }
}

TEST_CASE("Behind a surface nothing is divided") {
    const std::vector<PixelSurface> surfaces{rectangle_at({1, 1, 2, 2}, 1.0),
                                             rectangle_at({-5, -5, 40, 40}, 2.0),
                                             rectangle_at({0, 0, 8, 8}, 2.0)};
    const Divided found = divide_picture(surfaces, {0, 0, 8, 8});
    REQUIRE(found.squares.size() == 1);
    CHECK(found.squares[0].reason == SquareReason::one_in_front);
    CHECK(found.squares[0].surface == 1); // of two that are equally near, the earlier one
}

TEST_CASE("A polygon alone is drawn in one square, and without any all is background") {
    const Divided alone = divide_picture({rectangle_at({3, 3, 5, 4}, 1.0)}, {0, 0, 8, 8});
    REQUIRE(alone.squares.size() == 1);
    CHECK(alone.squares[0].reason == SquareReason::one_surface);
    const Divided none = divide_picture({rectangle_at({9, 3, 12, 4}, 1.0)}, {0, 0, 8, 8});
    REQUIRE(none.squares.size() == 1);
    CHECK(none.squares[0].reason == SquareReason::empty);
    CHECK(none.squares[0].surface == -1);
    CHECK(none.comparisons == 0);
    CHECK(divide_picture({}, {0, 0, 0, 0}).squares.empty());
}

TEST_CASE("Surfaces that go through each other are divided along the line where they meet") {
    const std::vector<PixelSurface> surfaces{rectangle_at({0, 0, 16, 16}, 1.0, 0.5),
                                             rectangle_at({0, 0, 16, 16}, 4.75)};
    for (const WarnockSquare& square : divide_picture(surfaces, {0, 0, 16, 16}).squares) {
        if (square.surface < 0) continue;
        // The first is in front from column 8 on.
        CHECK(square.surface == (square.pixels.left >= 8 ? 0 : 1));
        CHECK((square.pixels.right <= 8 || square.pixels.left >= 8));
    }
}
