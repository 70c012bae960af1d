// The predictions and the figures of lesson 26, found a second time: a painter and a BSP tree of
// this file's own, in double, and pictures that are made of the fragments of each pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/files.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/pixel_fragments.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace hidden_lesson {

using Triangle = std::array<glm::dvec3, 3>;

Scene scene_named(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name + ".toml");
}

std::vector<Triangle> triangles_of(const Scene& scene) {
    std::vector<Triangle> triangles;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        Triangle& triangle = triangles.emplace_back();
        for (int i = 0; i < 3; ++i)
            triangle[static_cast<std::size_t>(i)] = glm::dvec3(scene.corner(t, i).position);
    }
    return triangles;
}

Settings settings_of(const Scene& scene, std::initializer_list<std::string> set) {
    Settings settings = default_settings(scene);
    for (const std::string& text : set)
        set_from_text(settings, text);
    return settings;
}

/// How far ahead of the camera the middle of each triangle is. Equal ones differ by what doubles
/// round, so digits that do not count are cut.
std::vector<double> middles(const Scene& scene, const glm::dvec3& camera,
                            const glm::dvec3& forward) {
    std::vector<double> depths;
    for (const Triangle& t : triangles_of(scene)) {
        const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
        depths.push_back(std::round(1e5 * glm::dot(middle - camera, forward)) / 1e5);
    }
    return depths;
}

std::vector<double> negated(std::vector<double> numbers) {
    for (double& number : numbers)
        number = -number;
    return numbers;
}

/// The comparisons of merging runs of 1, 2, 4 ... numbers, without sorting: a merge compares until
/// one run is used up, so all but the rest of the other.
int merge_comparisons(const std::vector<double>& depths) {
    const auto count = depths.size();
    std::vector<std::size_t> rank(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j)
            rank[i] += depths[j] > depths[i] || (depths[j] == depths[i] && j < i) ? 1 : 0;
    }
    int comparisons = 0;
    for (std::size_t run = 1; run < count; run *= 2) {
        for (std::size_t begin = 0; begin + run < count; begin += 2 * run) {
            const auto at = [&](std::size_t i) {
                return rank.begin() + static_cast<std::ptrdiff_t>(std::min(i, count));
            };
            const std::size_t left = *std::max_element(at(begin), at(begin + run));
            const std::size_t right = *std::max_element(at(begin + run), at(begin + 2 * run));
            const std::size_t used_up = std::min(left, right);
            for (auto i = at(begin); i != at(begin + 2 * run); ++i)
                comparisons += *i <= used_up ? 1 : 0;
        }
    }
    return comparisons;
}

/// A tree that is only counted.
struct CountedTree {
    struct Piece {
        int triangle;
        Triangle corners;
    };
    int planes = 0, pieces = 0;
    std::map<int, std::vector<int>> cut; ///< by whose plane; which triangles
    int cut_pieces = 0;                  ///< drawn, of those that were cut
    std::vector<bool> is_cut = std::vector<bool>(30);

    explicit CountedTree(const Scene& scene) {
        std::vector<Piece> all;
        for (const Triangle& triangle : triangles_of(scene))
            all.push_back({static_cast<int>(all.size()), triangle});
        divide(all);
    }

    void divide(const std::vector<Piece>& left) {
        if (left.empty()) return;
        ++planes;
        const Triangle& first = left.front().corners;
        const glm::dvec3 normal =
            glm::normalize(glm::cross(first[2] - first[0], first[1] - first[0]));
        std::vector<Piece> front, back;
        for (const Piece& piece : left) {
            std::array<double, 3> ahead{};
            for (std::size_t i = 0; i < 3; ++i) {
                const double d = glm::dot(normal, piece.corners[i] - first[0]);
                ahead[i] = std::abs(d) < 1e-6 ? 0.0 : d;
            }
            const auto [low, high] = std::minmax_element(ahead.begin(), ahead.end());
            if (*low == 0.0 && *high == 0.0) {
                ++pieces;
                cut_pieces += is_cut[static_cast<std::size_t>(piece.triangle)] ? 1 : 0;
            } else if (*low >= 0.0) {
                front.push_back(piece);
            } else if (*high <= 0.0) {
                back.push_back(piece);
            } else {
                cut[left.front().triangle].push_back(piece.triangle);
                is_cut[static_cast<std::size_t>(piece.triangle)] = true;
                clip(piece, ahead, 1.0, front);
                clip(piece, ahead, -1.0, back);
            }
        }
        divide(front);
        divide(back);
    }

    /// The part of a piece on one side, as triangles about its first corner.
    static void clip(const Piece& piece, const std::array<double, 3>& ahead, double side,
                     std::vector<Piece>& to) {
        std::vector<glm::dvec3> outline;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const double a = side * ahead[i], b = side * ahead[j];
            if (a >= 0.0) outline.push_back(piece.corners[i]);
            if (a * b < 0.0)
                outline.push_back((piece.corners[i] * b - piece.corners[j] * a) / (b - a));
        }
        for (std::size_t i = 2; i < outline.size(); ++i)
            to.push_back({piece.triangle, {outline[0], outline[i - 1], outline[i]}});
    }
};

std::string lesson_text() {
    return read_file(lessons_folder() + "/26-hidden-surfaces.md");
}

void require_figures(std::initializer_list<const char*> figures) {
    const std::string said = lesson_text();
    for (const char* figure : figures) {
        INFO(figure);
        CHECK(said.find(figure) != std::string::npos);
    }
}

constexpr glm::dvec3 room_camera(0.0, 0.0, -3.001), along_z(0.0, 0.0, 1.0);

PREDICTIONS_TEST("Lesson 26: what the painter gets wrong in the room", "26-hidden-surfaces",
                 "painted-over") {
    const Scene room = scene_named("lab-room");
    const std::vector<double> depths = middles(room, room_camera, along_z);
    CHECK(depths[21] == Approx(3.01).margin(0.005));
    CHECK(depths[20] == Approx(2.95).margin(0.005));
    CHECK(depths[0] == Approx(2.67).margin(0.005));
    CHECK(depths[10] == Approx(2.35).margin(0.005));
    CHECK(depths[11] == Approx(2.29).margin(0.005));

    const PixelFragments pixels(room, settings_of(room, {}));
    const std::vector<int> nearest = pixels.nearest(), painted = pixels.painted(negated(depths));
    CHECK(pixels.wrong(painted, nearest) == 1758);
    int covered = 0, red_lost = 0;
    for (std::size_t i = 0; i < painted.size(); ++i) {
        covered += nearest[i] >= 20 && painted[i] == 0 ? 1 : 0;
        red_lost += nearest[i] >= 10 && nearest[i] < 20 && painted[i] <= 1 ? 1 : 0;
    }
    CHECK(covered > 1700); // nearly all of them
    CHECK(red_lost == 0);

    // Of the pixels where the floor comes after the blue block, the lesson takes those for right
    // that are not on its diagonal; of all others, none.
    const Questions lesson("26-hidden-surfaces");
    int asked = 0;
    for (int row = 375; row < 440; row += 5) {
        for (int column = 140; column < 260; column += 8) {
            const auto i = static_cast<std::size_t>(row * pixels.width + column);
            const double below = row - 374.0 - (column - 126.0) * 126.0 / 374.0; // the diagonal
            if (std::abs(below) < 3.0) continue;
            const bool is_wrong = nearest[i] >= 20 && painted[i] <= 1;
            CAPTURE(column, row);
            CHECK(lesson.answered("painted-over", {glm::ivec2(column, row)}).is_right == is_wrong);
            asked += is_wrong ? 1 : 0;
        }
    }
    CHECK(asked > 10);
    for (const glm::ivec2 right : {glm::ivec2(300, 450), glm::ivec2(60, 480), glm::ivec2(200, 300),
                                   glm::ivec2(300, 340), glm::ivec2(250, 50)})
        CHECK_FALSE(lesson.answered("painted-over", {right}).is_right);
    CHECK(merge_comparisons(depths) == 100);
    require_figures(
        {"| blue front, `[21]` and `[20]` | 3.01, 2.95 |", "| floor, near half, `[0]` | 2.67 |",
         "| red front, `[10]` and `[11]` | 2.35, 2.29 |", "The painter compares depths 100 times",
         "| painter | 100 | 240 |", "| depth buffer | 328 789 | 1 000 000 |"});
    std::size_t fragments = 0;
    for (const auto& pixel : pixels.pixels)
        fragments += pixel.size();
    CHECK(fragments == 328'789);
}

PREDICTIONS_TEST("Lesson 26: three needles of one depth", "26-hidden-surfaces", "to-the-right") {
    const Scene needles = scene_named("three-needles");
    const glm::dvec3 right(0.5, 0.0, 0.0);
    for (const glm::dvec3& camera : {glm::dvec3(0.0), right}) {
        for (const double depth : middles(needles, camera, along_z))
            CHECK(depth == Approx(2.67).margin(0.005));
        CHECK(middles(needles, camera, along_z)[0] == middles(needles, camera, along_z)[1]);
        CHECK(middles(needles, camera, along_z)[0] == middles(needles, camera, along_z)[2]);
    }
    // No order is right, not even for one of the two cameras.
    for (const char* camera : {"camera.position=0,0,0", "camera.position=0.5,0,0"}) {
        const PixelFragments pixels(needles, settings_of(needles, {camera}));
        std::vector<double> places{0.0, 1.0, 2.0};
        do
            CHECK(pixels.wrong(pixels.painted(places), pixels.nearest()) > 50);
        while (std::next_permutation(places.begin(), places.end()));
    }
    // At the top the blue tip falls on the orange base, which is nearer.
    const PixelFragments pixels(needles, settings_of(needles, {}));
    const auto top = static_cast<std::size_t>(45 * pixels.width + 100);
    CHECK(pixels.nearest()[top] == 0);
    CHECK(pixels.painted({0.0, 0.0, 0.0})[top] == 2);
    const Questions lesson("26-hidden-surfaces");
    lesson.require_choice("to-the-right", 0);
}

PREDICTIONS_TEST("Lesson 26: what planes cut", "26-hidden-surfaces", "pieces", "questions") {
    const CountedTree needles(scene_named("three-needles"));
    CHECK(needles.cut == std::map<int, std::vector<int>>{{0, {1, 2}}, {1, {2}}});
    CHECK(needles.pieces == 9);
    const Questions lesson("26-hidden-surfaces");
    lesson.require_number("pieces", needles.pieces, 0.0, 6.0);
    CHECK_FALSE(lesson.answered("pieces", {12.0}).is_right);

    const CountedTree room(scene_named("lab-room"));
    CHECK(room.cut == std::map<int, std::vector<int>>{{14, {20, 21, 26, 27, 28}}});
    CHECK(room.pieces == 40);
    CHECK(room.planes == 18);
    CHECK(room.cut_pieces == 15);
    lesson.require_number("questions", room.planes, 0.0, 40.0);
    CHECK_FALSE(lesson.answered("questions", {720.0}).is_right);
    CHECK(room.planes * room.pieces == 720);
    // Of a node its plane, both sides and where its pieces begin; of a piece its triangle, and the
    // corners if they are new. Of a painter a depth and a number.
    constexpr int word = 4;
    CHECK(word * (7 * room.planes + room.pieces + 9 * room.cut_pieces) == 1204);
    CHECK(word * 2 * 30 == 240);
    require_figures({"cuts five of its triangles", "So 40 are drawn in place of 30",
                     "so the tree has 18", "| BSP tree | 18 | 1204 |", "90 · 30 = 2700 pairs"});
    CHECK(3 * 30 * 30 == 2700);
}

/// The squares that a part of a picture takes, the part itself among them: asked of all fragments.
int squares_of(const PixelFragments& picture, int left, int top, int width, int height) {
    if (width == 0 || height == 0) return 0;
    std::map<int, int> pixels, nearest; // of each triangle
    for (int row = top; row < top + height; ++row) {
        for (int column = left; column < left + width; ++column) {
            double most = 0.0;
            const auto& fragments =
                picture.pixels[static_cast<std::size_t>(row * picture.width + column)];
            for (const PixelFragments::Fragment& fragment : fragments)
                most = std::max(most, fragment.zinv);
            for (const PixelFragments::Fragment& fragment : fragments) {
                ++pixels[fragment.triangle];
                nearest[fragment.triangle] += fragment.zinv == most ? 1 : 0;
            }
        }
    }
    if (pixels.size() <= 1 || width * height == 1) return 1;
    for (const auto& [triangle, count] : nearest) {
        if (count == width * height) return 1;
    }
    const int w = width / 2, h = height / 2;
    return 1 + squares_of(picture, left, top, w, h) +
           squares_of(picture, left + w, top, width - w, h) +
           squares_of(picture, left, top + h, w, height - h) +
           squares_of(picture, left + w, top + h, width - w, height - h);
}

PREDICTIONS_TEST("Lesson 26: the squares of the needles", "26-hidden-surfaces", "small-squares") {
    const Scene needles = scene_named("three-needles");
    const PixelFragments pixels(needles, settings_of(needles, {}));
    const int squares = squares_of(pixels, 0, 0, pixels.width, pixels.height);
    CHECK(squares == 363);
    CHECK(pixels.width * pixels.height == 40'000);
    const Questions lesson("26-hidden-surfaces");
    lesson.require_choice("small-squares", 1);
    require_figures({"| Warnock | 62 795 | 83 920 |"});
}

TEST_CASE("Lesson 26: the plane of the red block's right side, and the camera") {
    const std::vector<Triangle> room = triangles_of(scene_named("lab-room"));
    const Triangle& side = room[12];
    const glm::dvec3 normal = glm::normalize(glm::cross(side[2] - side[0], side[1] - side[0]));
    CHECK(normal.x == Approx(0.958).margin(5e-4));
    CHECK(normal.y == Approx(0.0).margin(1e-6));
    CHECK(normal.z == Approx(-0.287).margin(5e-4));
    const auto ahead = [&](const glm::dvec3& place) { return glm::dot(normal, place - side[0]); };
    CHECK(ahead(room_camera) == Approx(0.133).margin(5e-4));
    CHECK(ahead({-0.13, 0.0, -3.001}) > 0.0);
    CHECK(ahead({-0.14, 0.0, -3.001}) < 0.0);
    CHECK(ahead({-0.15, 0.0, -3.001}) < -0.009); // the second stop is too far
    // The blue block is behind it, and of the red one all but the side itself.
    for (std::size_t t = 10; t < room.size(); ++t) {
        for (const glm::dvec3& corner : room[t])
            CHECK(ahead(corner) < 1e-6);
    }
    require_figures({"n \\cdot C - d = 0.133", "n is (0.958, 0, −0.287)"});
}

TEST_CASE("Lesson 26: where the painter is right, both blocks are in view, and so they are next to "
          "it") {
    const Scene room = scene_named("lab-room");
    for (const double x : {-0.9, -0.5, 0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.9}) {
        const glm::dvec3 camera(x, -0.8, -1.8), target(0.0, 0.5, 0.0);
        const PixelFragments pixels(
            room, settings_of(room, {"camera.position=" + std::to_string(x) + ",-0.8,-1.8",
                                     "camera.aim=look_at", "camera.target=0,0.5,0"}));
        const std::vector<double> depths = middles(room, camera, glm::normalize(target - camera));
        const std::vector<int> nearest = pixels.nearest(),
                               painted = pixels.painted(negated(depths));
        const int wrong = pixels.wrong(painted, nearest);
        CAPTURE(x, wrong);
        CHECK((wrong < 5) == (x == 0.1 || x == 0.15));
        std::map<int, int> parts; // 1: the red block, 2: the blue one
        std::map<std::array<int, 2>, int> covered;
        for (std::size_t i = 0; i < nearest.size(); ++i) {
            ++parts[nearest[i] / 10];
            if (nearest[i] >= 10 && painted[i] < 10) ++covered[{nearest[i] / 10, painted[i] / 2}];
        }
        CHECK(parts[1] > 20000);
        CHECK(parts[2] > 20000);
        // As `because` says: on the left the right wall covers red, on the right the left one blue.
        constexpr int left_wall = 1, right_wall = 2;
        if (x == 0.0) CHECK(covered[{1, right_wall}] > 50);
        if (x == 0.25) CHECK(covered[{2, left_wall}] > 400);
    }
}

} // namespace hidden_lesson
} // namespace
