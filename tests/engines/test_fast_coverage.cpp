// Which pixels the fast engine gives to which triangle, compared with integer arithmetic: tilings
// of the picture whose corners are exactly on 256ths of a pixel, and this file's own top-left rule.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engines/fast/fast_engine.h"
#include "engines/fast/simd_level.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr int parts = 256; // of a pixel

/// A place on the screen, 256ths of a pixel.
struct Place {
    std::int64_t x = 0, y = 0;
};
using PlacedTriangle = std::array<int, 3>; ///< indices of places

struct Tiling {
    Viewport size;
    std::vector<Place> places;
    std::vector<PlacedTriangle> triangles;
    std::int64_t shared_edges = 0;
};

std::int64_t double_area_of(const Place& a, const Place& b, const Place& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Does a triangle own the centre of a pixel? It owns what is inside it and what is on its left
/// edges or its level top edge.
bool owns_centre(Place a, Place b, Place c, int column, int row) {
    if (double_area_of(a, b, c) == 0) return false;
    if (double_area_of(a, b, c) < 0) std::swap(b, c);
    const Place centre{std::int64_t{parts} * column + parts / 2,
                       std::int64_t{parts} * row + parts / 2};
    const auto is_within = [&](const Place& from, const Place& to) {
        const std::int64_t side = double_area_of(from, to, centre);
        const bool is_top = from.y == to.y && to.x > from.x, is_left = to.y < from.y;
        return side > 0 || (side == 0 && (is_top || is_left));
    };
    return is_within(a, b) && is_within(b, c) && is_within(c, a);
}

/// For each pixel, row by row: the triangle that owns it, or -1; and how many do.
struct Owners {
    std::vector<int> owner, count;
};

/// @param triangles numbers of the triangles drawn
Owners owners_of(const Tiling& tiling, const std::vector<int>& triangles) {
    const int width = tiling.size.width, height = tiling.size.height;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Owners owners{std::vector<int>(pixels, -1), std::vector<int>(pixels, 0)};
    for (const int t : triangles) {
        const PlacedTriangle& triangle = tiling.triangles[static_cast<std::size_t>(t)];
        const auto place = [&](std::size_t corner) {
            return tiling.places[static_cast<std::size_t>(triangle[corner])];
        };
        const Place a = place(0), b = place(1), c = place(2);
        const auto pixel = [](std::int64_t coordinate, int side) {
            return static_cast<int>(std::clamp<std::int64_t>(coordinate / parts, 0, side - 1));
        };
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
        for (int row = pixel(top, height); row <= pixel(bottom, height); ++row) {
            for (int column = pixel(left, width); column <= pixel(right, width); ++column) {
                if (!owns_centre(a, b, c, column, row)) continue;
                const std::size_t at = static_cast<std::size_t>(row) * width + column;
                ++owners.count[at];
                owners.owner[at] = t;
            }
        }
    }
    return owners;
}

/// The borders of cells along one side of a picture: pixels at whole numbers or beyond both ends.
std::vector<std::int64_t> cell_borders(int side, int smallest, int largest, Random& random) {
    // With a shift of half a pixel, borders run through centres.
    constexpr int shifts[] = {0, parts / 2, parts / 16, 1};
    std::int64_t at =
        -std::int64_t{parts} * random.integer(-5, 2 * largest) + shifts[random.integer(0, 3)];
    const std::int64_t end = std::int64_t{parts} * (side + random.integer(-5, 2 * largest));
    std::vector<std::int64_t> borders{at};
    while (at < end)
        borders.push_back(at += std::int64_t{parts} * random.integer(smallest, largest));
    return borders;
}

/// Moves a border by less than a quarter of the smaller of the cells at its sides, so that no cell
/// folds, to a place on a grid of `grid` 256ths.
std::int64_t moved(const std::vector<std::int64_t>& borders, std::size_t i, int grid,
                   Random& random) {
    const std::int64_t before = i > 0 ? borders[i] - borders[i - 1] : INT64_MAX;
    const std::int64_t behind = i + 1 < borders.size() ? borders[i + 1] - borders[i] : INT64_MAX;
    const int most = static_cast<int>(std::min(before, behind) * 24 / 100);
    std::int64_t at = borders[i] + random.integer(-most, most);
    if (grid > 1) {
        // Pixels have their centres in the middle.
        const std::int64_t half = grid == parts ? parts / 2 : 0;
        at = (at - half + grid * 1000000LL) / grid * grid - grid * 1000000LL + half;
    }
    return std::abs(at - borders[i]) <= most ? at : borders[i];
}

/// A grid of cells of `smallest` to `largest` pixels whose corners are moved, each cell cut in two.
Tiling random_tiling(Viewport size, int smallest, int largest, Random& random) {
    Tiling tiling;
    tiling.size = size;
    const std::vector<std::int64_t> x = cell_borders(size.width, smallest, largest, random),
                                    y = cell_borders(size.height, smallest, largest, random);
    constexpr int grids[] = {1, parts / 16, parts};
    const int usual_grid = grids[random.integer(0, 2)];
    for (std::size_t j = 0; j < y.size(); ++j) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const int grid = random.integer(0, 3) == 0 ? grids[random.integer(0, 2)] : usual_grid;
            tiling.places.push_back({moved(x, i, grid, random), moved(y, j, grid, random)});
        }
    }
    const auto add = [&](PlacedTriangle triangle) {
        std::rotate(triangle.begin(), triangle.begin() + random.integer(0, 2), triangle.end());
        if (random.integer(0, 1) == 0) std::swap(triangle[1], triangle[2]);
        tiling.triangles.push_back(triangle);
    };
    const int columns = static_cast<int>(x.size()), rows = static_cast<int>(y.size());
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < columns; ++i) {
            const int a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
            if (random.integer(0, 1) == 0) {
                add({a, b, d});
                add({a, d, c});
            } else {
                add({a, b, c});
                add({b, d, c});
            }
            tiling.shared_edges += 1 + (i > 0 ? 1 : 0) + (j > 0 ? 1 : 0);
        }
    }
    for (std::size_t i = tiling.triangles.size(); i > 1; --i)
        std::swap(
            tiling.triangles[i - 1],
            tiling.triangles[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
    return tiling;
}

enum class Depths { one, several };

constexpr float focal_length = 256.0f;

/// The scene that shows the tiling to a camera at the origin. All depths are powers of two, so that
/// projection to the screen is exact.
Scene scene_of(const Tiling& tiling, const std::vector<int>& triangles, Depths depths,
               Random& random) {
    Scene scene;
    scene.viewport = tiling.size;
    scene.camera = {glm::vec3(0.0f), 0.0f, 0.0f, focal_length};
    scene.light = {{0.0f, 0.0f, 0.0f}, glm::vec3(50.0f), glm::vec3(0.5f)};
    for (const Place& place : tiling.places) {
        const float z =
            depths == Depths::one ? 4.0f : static_cast<float>(1 << random.integer(0, 4));
        const auto along = [&](std::int64_t coordinate, int side) {
            const std::int64_t from_middle = coordinate - std::int64_t{parts} * (side / 2);
            return static_cast<float>(from_middle) / parts * z / focal_length;
        };
        Vertex vertex;
        vertex.position = {along(place.x, tiling.size.width), along(place.y, tiling.size.height),
                           z};
        vertex.normal = {0.0f, 0.0f, -1.0f};
        scene.mesh.add_vertex(vertex);
    }
    for (const int t : triangles)
        scene.mesh.add_triangle(tiling.triangles[static_cast<std::size_t>(t)]);
    return scene;
}

/// Where a picture of some triangles of a tiling differs from integer arithmetic, in words.
std::string coverage_fault(const FastPicture& picture, const std::vector<int>& triangles,
                           const Owners& expected) {
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const std::size_t at = picture.at(column, row);
            const int number = picture.owner[at];
            const int owner = number < 0 ? -1 : triangles[static_cast<std::size_t>(number)];
            const int right =
                expected.owner[static_cast<std::size_t>(row) * picture.size.width + column];
            const bool is_painted = picture.colour[at] != 0, has_depth = picture.inv_z[at] > 0.0f;
            if (owner == right && is_painted == (right >= 0) && has_depth == (right >= 0)) continue;
            return fmt::format("column {}, row {}: owner {}, not {}; colour {:06x}, 1/z {}", column,
                               row, owner, right, picture.colour[at], picture.inv_z[at]);
        }
    }
    return {};
}

/// Draws some triangles of a tiling at every level.
void check_coverage(const Tiling& tiling, const std::vector<int>& triangles, const Owners& expected,
                    Random& random) {
    const Depths depths = random.integer(0, 1) == 0 ? Depths::one : Depths::several;
    const Scene scene = scene_of(tiling, triangles, depths, random);
    Settings settings = default_settings(scene);
    // Light that has a closed form, and light that is applied later.
    set_step(settings, random.integer(0, 1) == 0 ? StripStep::pixel_light
                                                 : StripStep{Stage::shade, Shading::unlit});
    for (const SimdLevel level : simd_levels()) {
        const FastPicture picture = fast_picture(scene, settings, {.level = level});
        const std::string fault = coverage_fault(picture, triangles, expected);
        if (!fault.empty()) FAIL(std::string(word_of(level)) + ", " + fault);
    }
}

std::vector<int> all_of(const Tiling& tiling) {
    std::vector<int> all;
    for (int t = 0; t < std::ssize(tiling.triangles); ++t)
        all.push_back(t);
    return all;
}

/// Tests tilings with cells of a given size until enough edges are shared.
void check_tilings(int smallest, int largest, int edges, std::uint32_t seed) {
    Random random(seed);
    std::int64_t shared = 0, owned = 0;
    while (shared < edges) {
        const Viewport size{random.integer(60, 330), random.integer(50, 260)};
        const Tiling tiling = random_tiling(size, smallest, largest, random);
        const Owners owners = owners_of(tiling, all_of(tiling));
        CAPTURE(shared, size.width, size.height);
        REQUIRE(std::all_of(owners.count.begin(), owners.count.end(),
                            [](int count) { return count <= 1; }));
        owned += std::count(owners.count.begin(), owners.count.end(), 1);
        check_coverage(tiling, all_of(tiling), owners, random);
        shared += tiling.shared_edges;
    }
    CHECK(owned > 0);
}

} // namespace

TEST_CASE("Each pixel of tiny triangles is owned by the right one") {
    check_tilings(1, 3, rounds(900000, 40000), 801);
}

TEST_CASE("Each pixel of small and medium triangles is owned by the right one") {
    check_tilings(5, 60, rounds(90000, 4000), 802);
}

TEST_CASE("Each pixel of large triangles is owned by the right one") {
    check_tilings(70, 400, rounds(10000, 600), 803);
}

TEST_CASE("Each pixel of triangles of all sizes is owned by the right one") {
    check_tilings(1, 150, rounds(20000, 1500), 804);
}

TEST_CASE("A triangle drawn alone covers what it owns of a tiling, and its neighbour the rest") {
    constexpr std::array<int, 2> sizes[] = {{1, 3}, {3, 9}, {20, 70}, {60, 400}};
    Random random(805);
    int covered = 0;
    for (int i = 0; i < rounds(4000, 300); ++i) {
        const auto [smallest, largest] = sizes[i % 4];
        const Viewport size{random.integer(9, 120), random.integer(9, 120)};
        const Tiling tiling = random_tiling(size, smallest, largest, random);
        const int count = static_cast<int>(tiling.triangles.size());
        const std::vector<int> one{random.integer(0, count - 1)};
        const Owners owners = owners_of(tiling, one);
        CAPTURE(i, one[0]);
        check_coverage(tiling, one, owners, random);
        covered += std::any_of(owners.count.begin(), owners.count.end(),
                               [](int count_of) { return count_of == 1; });
    }
    CHECK(covered > 100);
}

TEST_CASE("The rule of this test gives each centre on an edge or corner to one triangle") {
    // Eight triangles about the centre of pixel (1, 1): it is owned by one, below and to its right.
    const Place middle{parts + parts / 2, parts + parts / 2};
    int owners = 0;
    std::vector<Place> ring;
    for (const int angle : {0, 1, 2, 3, 4, 5, 6, 7}) {
        constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1};
        ring.push_back({middle.x + parts * x[angle], middle.y + parts * y[angle]});
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
        owners += owns_centre(middle, ring[i], ring[(i + 1) % ring.size()], 1, 1) ? 1 : 0;
    CHECK(owners == 1);
    CHECK(owns_centre(middle, ring[0], ring[1], 1, 1));
}
