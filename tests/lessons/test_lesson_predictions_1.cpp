// The answers of the predictions of lessons 1 to 7, found in a different way: from the handout's
// numbers by arithmetic, and from row tables made by their definition.

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"
#include "session/content.h"
#include "session/session.h"
#include "support/oracle.h"
#include "support/prediction_checks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

// --- what the program says

Judgement judged(const std::string& lesson_id, const std::string& prediction_id,
                 const GivenAnswer& answer) {
    CAPTURE(lesson_id, prediction_id);
    record_question(lesson_id, prediction_id);
    static const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    const Lesson lesson = read_lesson(lessons_folder() + "/" + lesson_id + ".md");
    const LessonPrediction* const prediction = find_prediction(lesson, prediction_id);
    REQUIRE(prediction != nullptr);
    const Judgement judgement = judge(lesson, *prediction, answer, session);
    CHECK(judgement.fault.empty());
    CHECK_FALSE(judgement.because.empty());
    return judgement;
}

/// The program has this number, accepts it, and rejects a number a tenth larger.
void require_number(const std::string& lesson, const std::string& id, double expected,
                    double margin = 1e-9) {
    const Judgement judgement = judged(lesson, id, {expected});
    INFO(lesson << " " << id << ": the program has " << judgement.number);
    CHECK(judgement.number == Approx(expected).margin(margin));
    CHECK(judgement.is_right);
    CHECK_FALSE(judged(lesson, id, {expected * 1.1 + 0.5}).is_right);
}

/// This choice is the right one, of `count`, and no other is.
void require_choice(const std::string& lesson, const std::string& id, int expected, int count) {
    for (int choice = 0; choice < count; ++choice) {
        const Judgement judgement = judged(lesson, id, {choice});
        INFO(lesson << " " << id << ", choice " << choice);
        CHECK(judgement.choice == expected);
        CHECK(judgement.is_right == (choice == expected));
    }
}

// --- the handout's room

struct Place3 {
    double x = 0.0, y = 0.0, z = 0.0;
};
using Triangle3 = std::array<Place3, 3>;

/// Corners A to H: of the floor, then those above them.
using Corners = std::array<std::array<int, 3>, 8>;

constexpr Corners room{{{555, 0, 0},
                        {0, 0, 0},
                        {555, 0, 555},
                        {0, 0, 555},
                        {555, 555, 0},
                        {0, 555, 0},
                        {555, 555, 555},
                        {0, 555, 555}}};

Corners block(const std::array<std::array<int, 2>, 4>& foot, int height) {
    Corners corners{};
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = {foot[i][0], 0, foot[i][1]};
        corners[i + 4] = {foot[i][0], height, foot[i][1]};
    }
    return corners;
}

const Corners short_block = block({{{290, 114}, {130, 65}, {240, 272}, {82, 225}}}, 165);
const Corners tall_block = block({{{423, 247}, {265, 296}, {472, 406}, {314, 456}}}, 330);

Place3 scaled(const std::array<int, 3>& corner) {
    return {1.0 - 2.0 * corner[0] / 555.0, 1.0 - 2.0 * corner[1] / 555.0,
            2.0 * corner[2] / 555.0 - 1.0};
}

void add(std::vector<Triangle3>& triangles, const Corners& corners, const std::string& letters) {
    for (std::size_t i = 0; i + 2 < letters.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return scaled(corners[static_cast<std::size_t>(letters[i + k] - 'A')]);
        };
        triangles.push_back({corner(0), corner(1), corner(2)});
    }
}

/// The 30 triangles in the order of drawing.
std::vector<Triangle3> handout() {
    std::vector<Triangle3> triangles;
    add(triangles, room, "CBACDBAECCEGFBDHFDEFGFHGGDCGHD");
    for (const Corners* corners : {&short_block, &tall_block}) {
        add(triangles, *corners, "EBAEFBFDBFHDHCDHGCGECEACGFEGHF");
    }
    return triangles;
}

/// The lab's vertex shader, its camera at (0, 0, -3.001); floats as a student has them.
std::array<int, 2> lab_pixel(const Place3& p) {
    const float z = static_cast<float>(p.z) + 3.001f;
    const auto place = [&](double v) {
        return static_cast<int>(500.0f * static_cast<float>(v) * (1.0f / z)) + 250;
    };
    return {place(p.x), place(p.y)};
}

ScreenVertex at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    return vertex;
}

// --- row tables by definition

using Pixels = std::array<std::array<int, 2>, 3>;
using Table = std::map<int, rasterwalk::test::RowEnds>;

Table table_of(const Pixels& triangle, EdgeSamples samples = EdgeSamples::longest_axis,
               LineWalk walk = LineWalk::accumulate) {
    const std::array<ScreenVertex, 3> vertices{at(triangle[0][0], triangle[0][1]),
                                               at(triangle[1][0], triangle[1][1]),
                                               at(triangle[2][0], triangle[2][1])};
    rasterwalk::test::WalkRules rules;
    rules.samples = samples;
    rules.line.walk = walk;
    int outside = 0;
    return row_table(vertices, rules, outside);
}

/// Samples of edges that fall in no row of the table.
int outside_samples(const Pixels& triangle) {
    const std::array<ScreenVertex, 3> vertices{at(triangle[0][0], triangle[0][1]),
                                               at(triangle[1][0], triangle[1][1]),
                                               at(triangle[2][0], triangle[2][1])};
    int outside = 0;
    row_table(vertices, rasterwalk::test::WalkRules(), outside);
    return outside;
}

int pixel_count(const Table& table) {
    int count = 0;
    for (const auto& [row, ends] : table)
        count += ends.right - ends.left + 1;
    return count;
}

constexpr Pixels printed_triangle{{{10, 5}, {5, 10}, {15, 15}}};

const std::string lesson_1 = "01-pinhole-camera";
const std::string lesson_2 = "02-moving-the-camera";
const std::string lesson_3 = "03-points";
const std::string lesson_4 = "04-edges";
const std::string lesson_5 = "05-row-table";
const std::string lesson_6 = "06-filling";
const std::string lesson_7 = "07-painters-order";

} // namespace

PREDICTIONS_TEST("Predictions of lesson 1: one division makes the picture", "01-pinhole-camera",
                 "twice-as-far", "back-wall-width", "dolly-zoom", "column-at-3", "left-out") {
    // The back wall is at z = 1.
    REQUIRE(1.0 + 7.002 == Approx(2.0 * (1.0 + 3.001)));
    require_choice(lesson_1, "twice-as-far", 0, 3);
    require_number(lesson_1, "back-wall-width", 500.0 * 2.0 / 4.001, 1e-3);
    // The focal lengths at which the wall fills the picture are right to within two pixels.
    for (const double focal_length : {997.0, 1003.0})
        CHECK(std::abs(focal_length * 2.0 / 4.001 - 500.0) < 2.0);
    // The opening from 2.001 to 4.002, the wall from 4.001 to 6.002, f from 500 to 1000.
    REQUIRE(1000.0 / 6.002 > 500.0 / 4.001 + 1.0);
    require_choice(lesson_1, "dolly-zoom", 0, 3);
    require_number(lesson_1, "column-at-3", 500 * 1 / 2 + 250);

    int behind = 0;
    for (const Triangle3& triangle : handout()) {
        bool has_one = false;
        for (const Place3& corner : triangle)
            has_one = has_one || corner.z + 0.9 <= 0.0;
        behind += has_one ? 1 : 0;
    }
    require_number(lesson_1, "left-out", behind);
}

PREDICTIONS_TEST("Predictions of lesson 2: seen from a camera that moves and turns",
                 "02-moving-the-camera", "step-aside", "rotated-z", "transposed", "along-world-z") {
    require_number(lesson_2, "step-aside", std::floor(500.0 * 0.5 / 2.001) + 250);
    require_number(lesson_2, "rotated-z", std::sin(0.5) + 4.001 * std::cos(0.5), 1e-4);
    // R v: rows of R in place of columns, for the corner (1, -1, 4.001).
    const double c = std::cos(0.3), s = std::sin(0.3);
    REQUIRE(500.0 * (c + 4.001 * s) / (4.001 * c - s) + 250.0 > 500.0);
    const int right_way = static_cast<int>(500.0 * (c - 4.001 * s) / (4.001 * c + s));
    CHECK(right_way + 250 == 223); // as the lesson says,
    CHECK(250 - right_way == 277); // and mirrored
    require_choice(lesson_2, "transposed", 2, 3);
    const double x = std::cos(0.245) - 3.001 * std::sin(0.245);
    REQUIRE(500.0 * x / 3.001 > 10.0);
    require_choice(lesson_2, "along-world-z", 1, 3);
}

PREDICTIONS_TEST("Predictions of lesson 3: corners become pixels", "03-points", "rings",
                 "lost-rings", "eight-points", "uncovered") {
    std::set<std::array<int, 2>> places, outside;
    for (const Triangle3& triangle : handout()) {
        for (const Place3& corner : triangle) {
            places.insert(lab_pixel(corner));
            const double z = corner.z + 3.001;
            const auto rounded = [&](double v) {
                return static_cast<int>(std::lround(500.0 * v / z)) + 250;
            };
            const std::array<int, 2> pixel{rounded(corner.x), rounded(corner.y)};
            const auto is_out = [](int v) { return v < 0 || v > 499; };
            if (is_out(pixel[0]) || is_out(pixel[1])) outside.insert(pixel);
        }
    }
    require_number(lesson_3, "rings", static_cast<double>(places.size()));
    require_number(lesson_3, "lost-rings", static_cast<double>(outside.size()));

    std::set<int> columns;
    for (double x = -3.5; x <= 3.5; x += 1.0)
        columns.insert(static_cast<int>(x) + 8);
    require_number(lesson_3, "eight-points", static_cast<double>(columns.size()));

    std::set<std::array<int, 2>> covered;
    for (const Triangle3& triangle : handout()) {
        const Pixels pixels{lab_pixel(triangle[0]), lab_pixel(triangle[1]), lab_pixel(triangle[2])};
        for (const auto& [row, ends] : table_of(pixels)) {
            for (int column = ends.left; column <= ends.right; ++column)
                covered.insert({column, row});
        }
    }
    REQUIRE(covered.count({0, 1}) == 1); // as the lesson says
    require_number(lesson_3, "uncovered", 250000.0 - static_cast<double>(covered.size()));
}

PREDICTIONS_TEST("Predictions of lesson 4: samples of edges", "04-edges", "shallow-count",
                 "level-by-rows", "last-row", "multiplied") {
    require_number(lesson_4, "shallow-count", std::max(13 - 2, 9 - 4) + 1);
    require_number(lesson_4, "level-by-rows", (499 - 499) + 1);
    float y = 2.0f;
    for (int i = 0; i < 3; ++i) {
        volatile const float sum =
            y + (1.0f - 2.0f) / 3.0f; // rounded to float, whatever the machine
        y = sum;
    }
    REQUIRE(static_cast<int>(y) == 0);
    require_choice(lesson_4, "last-row", 1, 3);
    // Edge 0 from (0, 8) to (13, 1), its last sample by one product and one sum.
    volatile const float step = (1.0f - 8.0f) / 13.0f;
    volatile const float way = 13.0f * step;
    volatile const float end = 8.0f + way;
    CHECK(end == Approx(0.9999995).margin(5e-8)); // as the lesson says
    REQUIRE(static_cast<int>(end) == 0);
    require_choice(lesson_4, "multiplied", 1, 3);

    // Of the room's triangles these have a sample outside their rows, and one of them is the
    // task's.
    const std::vector<Triangle3> triangles = handout();
    std::set<std::size_t> with_outside;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Pixels pixels{lab_pixel(triangles[t][0]), lab_pixel(triangles[t][1]),
                            lab_pixel(triangles[t][2])};
        if (outside_samples(pixels) > 0) with_outside.insert(t);
    }
    CHECK(with_outside == std::set<std::size_t>{7, 15, 18, 19});
}

PREDICTIONS_TEST("Predictions of lesson 5: row tables", "05-row-table", "rows-of-it", "row-nine",
                 "passes-the-test", "index") {
    const auto thirty_one = table_of({{{10, 20}, {30, 10}, {20, 40}}});
    require_number(lesson_5, "rows-of-it", static_cast<double>(thirty_one.size()));
    const auto printed = table_of(printed_triangle);
    require_number(lesson_5, "row-nine", printed.at(9).right - printed.at(9).left + 1);

    const auto by_rows = table_of(printed_triangle, EdgeSamples::rows);
    for (const auto& [row, ends] : printed) {
        CHECK(by_rows.at(row).left == ends.left);
        CHECK(by_rows.at(row).right == ends.right);
    }
    require_choice(lesson_5, "passes-the-test", 2, 3);

    // The better test: which row of the other triangle loses the most, without drift as well.
    const Pixels better{{{4, 3}, {12, 6}, {4, 14}}};
    for (const LineWalk walk : {LineWalk::accumulate, LineWalk::exact}) {
        const auto right = table_of(better, EdgeSamples::longest_axis, walk);
        const auto wrong = table_of(better, EdgeSamples::rows, walk);
        std::map<int, int> lost;
        for (const auto& [row, ends] : right) {
            lost[row] = ends.right - wrong.at(row).right + wrong.at(row).left - ends.left;
            CHECK(wrong.at(row).left == ends.left); // only right ends are lost
        }
        CHECK(lost.at(4) == 3);
        CHECK(right.at(4).right == 9); // as the lesson says
        for (const auto& [row, pixels] : lost) {
            INFO("row " << row);
            if (row != 4) CHECK(pixels < 3);
        }
    }
    require_number(lesson_5, "index", 0 - 1);
}

PREDICTIONS_TEST("Predictions of lesson 6: rows become fragments", "06-filling", "fragments",
                 "no-area", "diagonal", "without-last", "overflow") {
    const auto printed = table_of(printed_triangle);
    // Twice the area by the corners' cross product; both ends of a row are whole pixels.
    const int twice_area = std::abs((5 - 10) * (15 - 5) - (10 - 5) * (15 - 10));
    CHECK(twice_area == 75); // as the lesson says
    REQUIRE(pixel_count(printed) > 38);
    require_choice(lesson_6, "fragments", 2, 3);
    require_number(lesson_6, "no-area", pixel_count(table_of({{{3, 4}, {9, 10}, {15, 16}}})));
    const int half = pixel_count(table_of({{{126, 126}, {374, 374}, {126, 374}}}));
    const int other = pixel_count(table_of({{{126, 126}, {374, 126}, {374, 374}}}));
    require_number(lesson_6, "diagonal", half + other - 249 * 249);
    require_number(lesson_6, "without-last",
                   pixel_count(printed) - static_cast<double>(printed.size()));
    // What both halves of a wall draw, with the right ends of rows and without them.
    const auto drawn_by_both = [](std::size_t first, bool has_last) {
        std::set<std::array<int, 2>> of_first, of_both;
        const std::vector<Triangle3> triangles = handout();
        for (std::size_t t = first; t < first + 2; ++t) {
            const Triangle3& corners = triangles[t];
            for (const auto& [row, ends] :
                 table_of({lab_pixel(corners[0]), lab_pixel(corners[1]), lab_pixel(corners[2])})) {
                for (int column = ends.left; column < ends.right + (has_last ? 1 : 0); ++column) {
                    if (t == first) {
                        of_first.insert({column, row});
                    } else if (of_first.count({column, row}) > 0) {
                        of_both.insert({column, row});
                    }
                }
            }
        }
        return of_both.size();
    };
    constexpr std::size_t floor = 0, back_wall = 8;
    CHECK(drawn_by_both(floor, true) == 374); // as the lesson says
    CHECK(drawn_by_both(floor, false) == 248);
    CHECK(drawn_by_both(back_wall, true) == 249);
    CHECK(drawn_by_both(back_wall, false) == 0);
    // The pixel with most fragments: of the back wall, of five red triangles, of two blue ones.
    std::map<std::array<int, 2>, std::vector<std::size_t>> fallen;
    const std::vector<Triangle3> triangles = handout();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle3& corners = triangles[t];
        for (const auto& [row, ends] :
             table_of({lab_pixel(corners[0]), lab_pixel(corners[1]), lab_pixel(corners[2])})) {
            for (int column = ends.left; column <= ends.right; ++column)
                fallen[{column, row}].push_back(t);
        }
    }
    for (const auto& [pixel, from] : fallen) {
        if (from.size() < 8) continue;
        CHECK(pixel == std::array<int, 2>{241, 334});
        CHECK(from == std::vector<std::size_t>{8, 10, 11, 16, 17, 18, 21, 22});
    }
    // Which triangle is the first to cover red.
    const auto covers_red = [](const std::vector<std::size_t>& from, std::size_t blue) {
        const auto is_red = [](std::size_t t) { return t >= 10 && t < 20; };
        return std::any_of(from.begin(), from.end(), is_red) &&
               std::find(from.begin(), from.end(), blue) != from.end();
    };
    CHECK(std::any_of(fallen.begin(), fallen.end(), [&](const auto& pixel) {
        return covers_red(pixel.second, 20); // the first of all blue ones
    }));
    const auto wrapped =
        static_cast<std::uint32_t>(-INT_MAX) - static_cast<std::uint32_t>(INT_MAX) + 1u;
    REQUIRE(wrapped == 3);
    require_choice(lesson_6, "overflow", 2, 3);
}

PREDICTIONS_TEST("Predictions of lesson 7: who is in front", "07-painters-order", "nearer",
                 "middle-depth", "wrong-crossing", "still-interpolated") {
    const auto nearest = [](const Corners& corners) {
        double z = 1e9;
        for (const auto& corner : corners)
            z = std::min(z, scaled(corner).z + 3.001);
        return z;
    };
    CHECK(nearest(short_block) == Approx(2.235).margin(5e-4)); // as the lesson says
    CHECK(nearest(tall_block) == Approx(2.891).margin(5e-4));
    require_choice(lesson_7, "nearer", 1, 3);

    const auto middle = [](const Triangle3& triangle) {
        return (triangle[0].z + triangle[1].z + triangle[2].z) / 3.0 + 3.001;
    };
    const std::vector<Triangle3> triangles = handout();
    require_number(lesson_7, "middle-depth", middle(triangles[0]), 1e-4);
    CHECK(middle(triangles[20]) == Approx(2.95).margin(5e-3));

    // The moments at which pixel (250, 400) becomes red and blue: row and column of the tables.
    const auto place_in_table = [&](std::size_t t) {
        const Table table = table_of(
            {lab_pixel(triangles[t][0]), lab_pixel(triangles[t][1]), lab_pixel(triangles[t][2])});
        return std::array<int, 2>{400 - table.begin()->first, 250 - table.at(400).left};
    };
    CHECK(place_in_table(10) == std::array<int, 2>{66, 9});
    CHECK(place_in_table(20) == std::array<int, 2>{182, 90});

    // The crossing at the top is wrong, the other two are not, and neither is a plain base.
    CHECK(judged(lesson_7, "wrong-crossing", {glm::ivec2(97, 52)}).is_right);
    CHECK_FALSE(judged(lesson_7, "wrong-crossing", {glm::ivec2(60, 140)}).is_right);
    CHECK_FALSE(judged(lesson_7, "wrong-crossing", {glm::ivec2(150, 130)}).is_right);
    CHECK_FALSE(judged(lesson_7, "wrong-crossing", {glm::ivec2(80, 25)}).is_right);

    // The rows of all triangles, whether anything nearer is there or not.
    int fragments = 0;
    for (const Triangle3& triangle : triangles)
        fragments += pixel_count(
            table_of({lab_pixel(triangle[0]), lab_pixel(triangle[1]), lab_pixel(triangle[2])}));
    CHECK(fragments == 328'789); // as the lesson says
    require_choice(lesson_7, "still-interpolated", 1, 3);
}
