#include "lessons/puzzle_exam.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rasterwalk {

namespace {

/// Whole numbers that look random and are the same everywhere.
struct ExamDice {
    std::uint32_t state = 1;

    /// From `low` to `high`, both included.
    int roll(int low, int high) {
        state = state * 1664525u + 1013904223u;
        return low + static_cast<int>((state >> 16) % static_cast<std::uint32_t>(high - low + 1));
    }
};

std::string point_words(float x, float y) {
    return fmt::format("({}, {})", x, y);
}

// --- interpolate

constexpr std::string_view before_interpolate = R"(vector<float> given;
vector<float> answer;
)";

constexpr std::string_view after_interpolate = R"(
void Ask() {
    ivec2 a(int(given[0]), int(given[1]));
    ivec2 b(int(given[2]), int(given[3]));
    vector<ivec2> result(int(given[4]));
    Interpolate(a, b, result);
    for (int i = 0; i < result.size(); ++i) {
        answer.push_back(result[i].x);
        answer.push_back(result[i].y);
    }
}
)";

std::vector<PuzzleQuestion> interpolate_questions() {
    std::vector<PuzzleQuestion> questions;
    const auto ask = [&](float ax, float ay, float bx, float by, float n) {
        questions.push_back({fmt::format("From {} to {} with {} sample{}", point_words(ax, ay),
                                         point_words(bx, by), n, n == 1 ? "" : "s"),
                             {ax, ay, bx, by, n}});
    };
    ask(4, 2, 1, 8, 4);
    ask(1, 8, 13, 5, 13);
    ask(3, 3, 3, 3, 1);
    ask(0, 7, 10, 7, 5);
    ExamDice dice{4};
    for (int i = 0; i < 8; ++i) {
        const int ax = dice.roll(0, 40), ay = dice.roll(0, 40);
        const int bx = dice.roll(0, 40), by = dice.roll(0, 40), n = dice.roll(2, 20);
        ask(static_cast<float>(ax), static_cast<float>(ay), static_cast<float>(bx),
            static_cast<float>(by), static_cast<float>(n));
    }
    return questions;
}

// --- polygon_rows

constexpr std::string_view before_rows = R"(struct Pixel {
    int x;
    int y;
};
vector<float> given;
vector<float> answer;
void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
    int n = result.size();
    float gaps = max(n - 1, 1);
    float stepX = (b.x - a.x) / gaps;
    float stepY = (b.y - a.y) / gaps;
    float x = a.x;
    float y = a.y;
    for (int i = 0; i < n; ++i) {
        result[i].x = int(x);
        result[i].y = int(y);
        x += stepX;
        y += stepY;
    }
}
int SmallestY(const vector<Pixel>& v) {
    int y = v[0].y;
    for (int i = 1; i < v.size(); ++i)
        y = min(y, v[i].y);
    return y;
}
int LargestY(const vector<Pixel>& v) {
    int y = v[0].y;
    for (int i = 1; i < v.size(); ++i)
        y = max(y, v[i].y);
    return y;
}
)";

constexpr std::string_view after_rows = R"(
void Ask() {
    vector<Pixel> v(given.size() / 2);
    for (int i = 0; i < v.size(); ++i) {
        v[i].x = int(given[2 * i]);
        v[i].y = int(given[2 * i + 1]);
    }
    int rows = LargestY(v) - SmallestY(v) + 1;
    vector<Pixel> left(rows);
    vector<Pixel> right(rows);
    ComputePolygonRows(v, left, right);
    for (int r = 0; r < left.size(); ++r) {
        answer.push_back(left[r].x);
        answer.push_back(right[r].x);
    }
}
)";

std::vector<PuzzleQuestion> rows_questions() {
    std::vector<PuzzleQuestion> questions;
    const auto ask = [&](std::vector<float> points) {
        std::vector<std::string> words;
        for (std::size_t i = 0; i + 1 < points.size(); i += 2)
            words.push_back(point_words(points[i], points[i + 1]));
        questions.push_back(
            {fmt::format("The polygon {}", fmt::join(words, ", ")), std::move(points)});
    };
    ask({10, 5, 5, 10, 15, 15});
    ask({4, 3, 12, 6, 4, 14});
    ask({0, 2, 3, 1, 5, 6}); // its first edge ends above its first row
    ask({4, 5, 15, 5, 9, 15});
    ExamDice dice{5};
    for (int i = 0; i < 8; ++i) {
        std::vector<float> points;
        for (int corner = 0; corner < 3 + i / 5; ++corner) {
            points.push_back(static_cast<float>(dice.roll(0, 30)));
            points.push_back(static_cast<float>(dice.roll(0, 20)));
        }
        ask(std::move(points));
    }
    return questions;
}

// --- depth

constexpr std::string_view before_depth = R"(const int WIDTH = 4;
const int HEIGHT = 3;
struct Pixel {
    int x;
    int y;
    float zinv;
    int colour;
};
float depth[HEIGHT][WIDTH];
int picture[HEIGHT][WIDTH];
vector<float> given;
vector<float> answer;
)";

constexpr std::string_view after_depth = R"(
void Ask() {
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            depth[y][x] = 9;
            picture[y][x] = 0;
        }
    vector<Pixel> all(given.size() / 4);
    for (int i = 0; i < all.size(); ++i) {
        all[i].x = int(given[4 * i]);
        all[i].y = int(given[4 * i + 1]);
        all[i].zinv = given[4 * i + 2];
        all[i].colour = int(given[4 * i + 3]);
    }
    Draw(all);
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            answer.push_back(picture[y][x]);
            answer.push_back(depth[y][x]);
        }
}
)";

constexpr std::size_t depth_columns = 4; // WIDTH

std::vector<PuzzleQuestion> depth_questions() {
    std::vector<PuzzleQuestion> questions;
    questions.push_back(
        {"A far fragment, then a near one, both on (0, 0)", {0, 0, 0.25f, 1, 0, 0, 0.5f, 2}});
    questions.push_back(
        {"A near fragment, then a far one, both on (0, 0)", {0, 0, 0.5f, 1, 0, 0, 0.25f, 2}});
    questions.push_back({"Two equally near fragments on (1, 1)", {1, 1, 0.5f, 1, 1, 1, 0.5f, 2}});
    questions.push_back({"One fragment on (1, 2)", {1, 2, 0.5f, 1}});
    questions.push_back({"One fragment on (3, 0)", {3, 0, 0.5f, 1}});
    questions.push_back(
        {"Fragments outside, on (4, 0) and (1, 3)", {4, 0, 0.5f, 1, 1, 3, 0.5f, 2}});
    questions.push_back(
        {"Fragments outside, on (-1, 1) and (2, -1)", {-1, 1, 0.5f, 1, 2, -1, 0.5f, 2}});
    ExamDice dice{8};
    std::vector<float> many;
    for (int i = 0; i < 40; ++i) {
        many.push_back(static_cast<float>(dice.roll(0, 3)));
        many.push_back(static_cast<float>(dice.roll(0, 2)));
        many.push_back(static_cast<float>(dice.roll(1, 8)) / 8.0f);
        many.push_back(static_cast<float>(i + 1));
    }
    questions.push_back({"Forty fragments", std::move(many)});
    return questions;
}

// --- line

constexpr std::string_view before_line = R"(vector<float> given;
vector<float> answer;
void Plot(int x, int y) {
    answer.push_back(x);
    answer.push_back(y);
}
)";

constexpr std::string_view after_line = R"(
void Ask() {
    DrawLine(int(given[0]), int(given[1]), int(given[2]), int(given[3]));
}
)";

std::vector<PuzzleQuestion> line_questions() {
    std::vector<PuzzleQuestion> questions;
    const auto ask = [&](float x, float y, float l, float s) {
        questions.push_back(
            {fmt::format("From {}, {} to the right and {} down", point_words(x, y), l, s),
             {x, y, l, s}});
    };
    ask(0, 0, 8, 3);
    ask(2, 1, 6, 0);
    ask(1, 4, 5, 5);
    ask(0, 0, 4, 2); // a tie
    ask(3, 3, 0, 0);
    for (const float s : {1.0f, 4.0f, 6.0f, 9.0f})
        ask(5, 2, 11, s);
    return questions;
}

// --- cosine and light

constexpr std::string_view before_light = R"(const float pi = 3.14159265f;
vec3 lightPos(0, -0.5f, -0.7f);
vec3 lightPower(14, 12, 10);
vec3 indirect(0.5f, 0.4f, 0.3f);
vector<float> given;
vector<float> answer;
)";

constexpr std::string_view after_cosine = R"(
void Ask() {
    vec3 v(given[0], given[1], given[2]);
    vec3 normal(given[3], given[4], given[5]);
    answer.push_back(Cosine(v, normal));
}
)";

constexpr std::string_view after_light = R"(
void Ask() {
    vec3 v(given[0], given[1], given[2]);
    vec3 normal(given[3], given[4], given[5]);
    vec3 R = Light(v, normal, vec3(0.75f, 0.5f, 0.15f));
    answer.push_back(R.x);
    answer.push_back(R.y);
    answer.push_back(R.z);
}
)";

std::vector<PuzzleQuestion> light_questions() {
    std::vector<PuzzleQuestion> questions;
    const auto ask = [&](const char* words, std::vector<float> given) {
        questions.push_back({words, std::move(given)});
    };
    ask("A floor below the lamp", {0, 1, -0.7f, 0, -1, 0});
    ask("A floor to the side of the lamp", {0.8f, 1, 0.3f, 0, -1, 0});
    ask("A wall to the left of the lamp", {-1, 0, 0, 1, 0, 0});
    ask("A side that faces away from the lamp", {0.5f, 0.2f, 0.4f, 0, 0, 1});
    ask("A slanted side", {0.2f, 0.7f, 0.1f, 0.6f, -0.8f, 0});
    return questions;
}

// --- middle and positions

constexpr std::string_view before_middle = R"(struct Pixel {
    float zinv;
    vec3 pos3d;
};
vector<float> given;
vector<float> answer;
)";

constexpr std::string_view after_middle = R"(
void Ask() {
    Pixel a;
    Pixel b;
    a.zinv = 1 / given[2];
    b.zinv = 1 / given[5];
    a.pos3d = vec3(given[0], given[1], given[2]) * a.zinv;
    b.pos3d = vec3(given[3], given[4], given[5]) * b.zinv;
    vec3 middle = Middle(a, b);
    answer.push_back(middle.x);
    answer.push_back(middle.y);
    answer.push_back(middle.z);
}
)";

constexpr std::string_view before_positions = R"(vector<float> given;
vector<float> answer;
)";

constexpr std::string_view after_positions = R"(
void Ask() {
    vec3 a(given[0], given[1], given[2]);
    vec3 b(given[3], given[4], given[5]);
    vector<vec3> result(5);
    Positions(a, b, result);
    for (int i = 0; i < result.size(); ++i) {
        answer.push_back(result[i].x);
        answer.push_back(result[i].y);
        answer.push_back(result[i].z);
    }
}
)";

std::vector<PuzzleQuestion> position_questions() {
    std::vector<PuzzleQuestion> questions;
    const auto ask = [&](const char* words, std::vector<float> given) {
        questions.push_back({words, std::move(given)});
    };
    ask("From (1, 1, 2) to (3, -1, 6)", {1, 1, 2, 3, -1, 6});
    ask("From (0, 2, 8) to (1, 2, 2)", {0, 2, 8, 1, 2, 2});
    ask("From (-2, 0, 4) to (2, 1, 4)", {-2, 0, 4, 2, 1, 4});
    return questions;
}

std::vector<PuzzleExam> make_exams() {
    return {
        {"interpolate",
         before_interpolate,
         after_interpolate,
         interpolate_questions(),
         {"result[#].x", "result[#].y"}},
        {"polygon_rows", before_rows, after_rows, rows_questions(), {"left[#].x", "right[#].x"}},
        {"depth",
         before_depth,
         after_depth,
         depth_questions(),
         {"the colour of pixel #", "the depth of pixel #"},
         depth_columns},
        {"line",
         before_line,
         after_line,
         line_questions(),
         {"the x of pixel #", "the y of pixel #"}},
        {"cosine", before_light, after_cosine, light_questions(), {"the cosine"}},
        {"light",
         before_light,
         after_light,
         light_questions(),
         {"the red of the light", "the green of the light", "the blue of the light"}},
        {"middle", before_middle, after_middle, position_questions(), {"its x", "its y", "its z"}},
        {"positions",
         before_positions,
         after_positions,
         position_questions(),
         {"result[#].x", "result[#].y", "result[#].z"}},
    };
}

const std::vector<PuzzleExam>& all_exams() {
    static const std::vector<PuzzleExam> exams = make_exams();
    return exams;
}

} // namespace

const PuzzleExam* find_exam(std::string_view name) {
    const std::vector<PuzzleExam>& exams = all_exams();
    const auto found = std::find_if(exams.begin(), exams.end(),
                                    [&](const PuzzleExam& exam) { return exam.name == name; });
    return found == exams.end() ? nullptr : &*found;
}

std::vector<std::string_view> exam_names() {
    std::vector<std::string_view> names;
    for (const PuzzleExam& exam : all_exams())
        names.push_back(exam.name);
    return names;
}

} // namespace rasterwalk
