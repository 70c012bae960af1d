// Equally right functions are right, and their rules are recovered.

#include "mine/checked_student.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Rounded as std::round does.
int rounded(double value) {
    return static_cast<int>(std::round(value));
}

StudentLine line_in_double(const StudentPixel& a, const StudentPixel& b, int count) {
    const double steps = std::max(count - 1, 1);
    double x = a.x, y = a.y;
    return line_by(a, b, count, [&](int) {
        const std::pair<int, int> at(static_cast<int>(x), static_cast<int>(y));
        x += (b.x - a.x) / steps;
        y += (b.y - a.y) / steps;
        return at;
    });
}

StudentLine line_rounded(const StudentPixel& a, const StudentPixel& b, int count) {
    return line_by(a, b, count, [&](int i) {
        const float t = share(i, count);
        return std::pair(rounded(double{float(a.x) + t * float(b.x - a.x)}),
                         rounded(double{float(a.y) + t * float(b.y - a.y)}));
    });
}

StudentLine line_floored(const StudentPixel& a, const StudentPixel& b, int count) {
    const float steps = static_cast<float>(std::max(count - 1, 1));
    const float step_x = float(b.x - a.x) / steps, step_y = float(b.y - a.y) / steps;
    return line_by(a, b, count, [&](int i) {
        return std::pair(static_cast<int>(std::floor(float(a.x) + float(i) * step_x)),
                         static_cast<int>(std::floor(float(a.y) + float(i) * step_y)));
    });
}

StudentLine line_in_whole_numbers(const StudentPixel& a, const StudentPixel& b, int count) {
    const int steps = std::max(count - 1, 1);
    return line_by(a, b, count, [&](int i) {
        return std::pair(a.x + (b.x - a.x) * i / steps, a.y + (b.y - a.y) * i / steps);
    });
}

/// Bresenham's, with one error term for both axes; lines with another number of samples as the
/// handout has them.
StudentLine line_of_bresenham(const StudentPixel& a, const StudentPixel& b, int count) {
    const int dx = std::abs(b.x - a.x), dy = -std::abs(b.y - a.y);
    if (count != std::max(dx, -dy) + 1) return line_as_handout(a, b, count);
    int x = a.x, y = a.y, error = dx + dy;
    return line_by(a, b, count, [&](int) {
        const std::pair<int, int> at(x, y);
        const int twice = 2 * error;
        if (twice >= dy && x != b.x) error += dy, x += a.x < b.x ? 1 : -1;
        if (twice <= dx && y != b.y) error += dx, y += a.y < b.y ? 1 : -1;
        return at;
    });
}

StudentLine line_of_halves(const StudentPixel& a, const StudentPixel& b, int count) {
    return line_by(a, b, count, [&](int i) {
        const double t = count > 1 ? double(i) / (count - 1) : 0.0;
        return std::pair(static_cast<int>(a.x * (1.0 - t) + b.x * t + 0.5),
                         static_cast<int>(a.y * (1.0 - t) + b.y * t + 0.5));
    });
}

/// Where t is inexact, int() cuts a sample in the middle of a diagonal, and its row stays empty.
StudentLine line_by_double_shares(const StudentPixel& a, const StudentPixel& b, int count) {
    return line_by(a, b, count, [&](int i) {
        const double t = count > 1 ? double(i) / (count - 1) : 0.0;
        return std::pair(static_cast<int>(a.x + t * (b.x - a.x)),
                         static_cast<int>(a.y + t * (b.y - a.y)));
    });
}

} // namespace

TEST_CASE("a program written as the handout says is right, and B1 does not count as its mistake") {
    const Student student = handout_student();
    expect_right(student);
    const FunctionCheck check = check_of(student, line);
    CHECK_THAT(check.rule, Catch::Matchers::ContainsSubstring("the handout's own rule"));
    CHECK(check.rules[0] == std::pair<std::string, std::string>("line_walk", "accumulate"));
}

TEST_CASE("every equally right way to walk a line is right") {
    expect_right(student_with_line(line_in_double));
    expect_right(student_with_line(line_rounded));
    expect_right(student_with_line(line_floored));
    expect_right(student_with_line(line_in_whole_numbers));
    expect_right(student_with_line(line_of_bresenham));
    expect_right(student_with_line(line_of_halves));
    expect_right(student_with_line(line_by_double_shares));
}

TEST_CASE("Interpolate may count the samples itself") {
    Student student = handout_student();
    student.line = [](const StudentPixel& a, const StudentPixel& b, int) {
        return line_rounded(a, b, std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1);
    };
    expect_right(student);
    const auto says_so = Catch::Matchers::ContainsSubstring("it counts the samples itself");
    CHECK_THAT(check_of(student, line).rule, says_so);
    CHECK_THAT(check_of(handout_student(), line).rule, !says_so);
}

TEST_CASE("edges may be walked from any end, and stray samples clamped") {
    RowStyle style;
    style.from_top = true;
    expect_right(student_with_rows(style));
    style.clamps = true;
    expect_right(student_with_rows(style));
    RowStyle from_left;
    from_left.from_left = true;
    expect_right(student_with_line(line_rounded, from_left));
    RowStyle other_sentinels;
    other_sentinels.left_start = 100'000;
    other_sentinels.right_start = -100'000;
    expect_right(student_with_rows(other_sentinels));
}

TEST_CASE("every equally right rounding of a vertex is recovered") {
    const auto rule_of = [](const Student& student) {
        expect_right(student);
        return check_of(student, vertex).rules.back().second;
    };
    CHECK(rule_of(handout_student()) == "truncate");
    CHECK(rule_of(student_with_pixels([](glm::vec3 p) {
              return StudentPlace(500.0f * p.x / p.z + 250.0f, 500.0f * p.y / p.z + 250.0f);
          })) == "truncate_sum");
    CHECK(rule_of(student_with_pixels([](glm::vec3 p) {
              return StudentPlace(std::floor(p.x / p.z * 500.0f) + 250.0f,
                                  std::floor(p.y / p.z * 500.0f) + 250.0f);
          })) == "floor");
    CHECK(rule_of(student_with_pixels([](glm::vec3 p) {
              return StudentPlace(std::round(500.0f * p.x / p.z + 250.0f),
                                  std::round(500.0f * p.y / p.z + 250.0f));
          })) == "round");
}

TEST_CASE("equally right ways to carry and to light are right") {
    Student affine = handout_student();
    const auto handout = affine.vertex;
    affine.vertex = [handout](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        pixel.place = position;
        pixel.light = student_light(position, normal);
        return pixel;
    };
    affine.shade = [](const StudentPixel& pixel, glm::vec3, glm::vec3 colour) {
        return std::optional(StudentPut{pixel.x, pixel.y, colour * pixel.light});
    };
    expect_right(affine);
    expect_right(student_with_shade(
        [](const StudentPixel&, glm::vec3, glm::vec3 colour) { return colour; }));
    // pi = 3.14, in double.
    expect_right(
        student_with_shade([](const StudentPixel& pixel, glm::vec3 normal, glm::vec3 colour) {
            const glm::vec3 r = student_lamp - pixel.place / pixel.zinv;
            const double r2 = double{glm::dot(r, r)};
            const double cosine = std::max(double{glm::dot(r, normal)} / std::sqrt(r2), 0.0);
            return colour * (static_cast<float>(14.0 * cosine / (4.0 * 3.14 * r2)) + 0.5f);
        }));
    // Perspective within Interpolate.
    Student inside = handout_student();
    inside.line = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentPixel from = a, to = b;
        from.place *= a.zinv;
        to.place *= b.zinv;
        StudentLine samples = line_as_handout(from, to, count);
        for (StudentPixel& sample : samples)
            sample.place /= sample.zinv;
        return samples;
    };
    expect_right(inside);
}

TEST_CASE("what is put outside the picture does not show") {
    DrawStyle style;
    style.clips = false;
    expect_right(student_with_draw(style));
}

TEST_CASE("a lamp that is not known says nothing against the light") {
    Student student = handout_student();
    student.tells_light = false;
    for (const FunctionCheck& check : checks_of(student)) {
        INFO(described(check));
        CHECK(check.state == CheckState::right);
    }
    CHECK_FALSE(check_of(student, shade).notes.empty());
}

TEST_CASE("functions that are missing or empty are not wrong") {
    for (const FunctionCheck& check : checks_of(Student{})) {
        INFO(described(check));
        CHECK(check.state == CheckState::not_written);
    }
    Student empty = handout_student();
    empty.vertex = [](glm::vec3, glm::vec3, glm::vec3) { return StudentPixel{}; };
    empty.line = [](const StudentPixel&, const StudentPixel&, int count) {
        return StudentLine(static_cast<std::size_t>(count));
    };
    empty.rows = [](const StudentLine&) { return std::pair<StudentLine, StudentLine>{}; };
    empty.draw = [](const StudentLine&, const StudentLine&, glm::vec3) {
        return std::vector<StudentPut>{};
    };
    empty.depth = [](float, float&) { return false; };
    empty.shade = [](const StudentPixel&, glm::vec3, glm::vec3) {
        return std::optional<StudentPut>();
    };
    for (const FunctionCheck& check : checks_of(empty)) {
        INFO(described(check));
        CHECK(check.state == CheckState::not_written);
    }
}
