#pragma once

// Checks the functions of a student of answering.h, and what is expected of the checks.

#include "mine/answering.h"
#include "mine/functions/function_checks.h"
#include "support/catch.h"
#include "support/samples.h"

namespace rasterwalk::test {

inline const Questions& asked_questions() {
    static const Questions questions = [] {
        const Scene room = lab_room();
        const BenchTriangle example{glm::vec3(3, 2, 1), glm::vec3(9, 14, 1), glm::vec3(21, 5, 1)};
        return make_questions(room, std::span(&example, 1),
                              {room.camera, room.light, room.viewport, false, {}});
    }();
    return questions;
}

inline std::vector<FunctionCheck> checks_of(const Student& student) {
    const std::vector<double> numbers = answers_of(student, asked_questions());
    return check_functions(asked_questions(), read_answers(numbers, asked_questions()));
}

/// The places of the functions among the checks.
enum CheckedFunction { vertex, line, rows, draw, depth, shade };

inline FunctionCheck check_of(const Student& student, CheckedFunction function) {
    return checks_of(student)[function];
}

using Names = std::vector<std::string>;

/// Everything that is found, for a message.
inline std::string described(const FunctionCheck& check) {
    std::string text = check.function + ": " + check.rule + " | " + check.first;
    for (const Names* const list : {&check.bugs, &check.together, &check.causes, &check.notes}) {
        for (const std::string& one : *list)
            text += " | " + one;
    }
    return text;
}

inline void expect_right(const Student& student) {
    for (const FunctionCheck& check : checks_of(student)) {
        INFO(described(check));
        CHECK(check.state == CheckState::right);
        CHECK(check.right == check.asked);
        CHECK(check.bugs.empty());
        CHECK(check.together.empty());
        CHECK(check.causes.empty());
        CHECK(check.first.empty());
        CHECK_FALSE(check.rule.empty());
    }
}

/// The function is wrong, it is this mistake of the laboratory, and no other is named.
inline void expect_bugs(const Student& student, CheckedFunction function, const Names& bugs) {
    const FunctionCheck check = check_of(student, function);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.bugs == bugs);
    CHECK(check.causes.empty());
    CHECK_FALSE(check.first.empty());
    CHECK(check.difference.question >= 0);
    CHECK(check.right < check.asked);
}

/// The function is wrong, and this is why, although the laboratory has no name for it.
inline void expect_cause(const Student& student, CheckedFunction function,
                         const std::string& part) {
    const FunctionCheck check = check_of(student, function);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.bugs.empty());
    REQUIRE(check.causes.size() == 1);
    CHECK_THAT(check.causes[0], Catch::Matchers::ContainsSubstring(part));
    CHECK_FALSE(check.first.empty());
    CHECK(check.right < check.asked);
}

/// The function is wrong, for an unknown reason.
inline void expect_unknown(const Student& student, CheckedFunction function) {
    const FunctionCheck check = check_of(student, function);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.bugs.empty());
    CHECK(check.together.empty());
    CHECK(check.causes.empty());
    CHECK_FALSE(check.first.empty());
    CHECK(check.right < check.asked);
}

/// A student whose lines, and the rows made from them, are these.
inline Student student_with_line(const decltype(Student::line)& walked,
                                 const RowStyle& style = {}) {
    Student student = handout_student();
    student.line = walked;
    student.rows = [walked, style](const StudentLine& corners) {
        return rows_with(corners, walked, style);
    };
    return student;
}

inline Student student_with_rows(const RowStyle& style) {
    return student_with_line(line_as_handout, style);
}

inline Student student_with_draw(const DrawStyle& style) {
    Student student = handout_student();
    student.draw = [style](const StudentLine& left, const StudentLine& right, glm::vec3 colour) {
        return draw_with(left, right, colour, style);
    };
    return student;
}

/// A student whose vertices fall on the pixels that `pixel_at` makes of a point in camera space.
template <class PixelAt>
Student student_with_pixels(PixelAt pixel_at) {
    Student student = handout_student();
    const auto handout = student.vertex;
    student.vertex = [handout, pixel_at](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        const auto [x, y] = pixel_at(position - glm::vec3(0.0f, 0.0f, -3.001f));
        pixel.x = static_cast<int>(x);
        pixel.y = static_cast<int>(y);
        return pixel;
    };
    return student;
}

/// Pixels before int() cuts their fractions.
using StudentPlace = std::pair<float, float>;

/// A student whose pixels have the colours of `light`.
template <class Light>
Student student_with_shade(Light light) {
    Student student = handout_student();
    student.shade = [light](const StudentPixel& pixel, glm::vec3 normal, glm::vec3 colour) {
        return std::optional(StudentPut{pixel.x, pixel.y, light(pixel, normal, colour)});
    };
    return student;
}

} // namespace rasterwalk::test
