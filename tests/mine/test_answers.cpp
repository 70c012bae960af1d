#include <limits>

#include "base/dice.h"
#include "mine/checked_student.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using namespace rasterwalk_kit;

namespace {

std::vector<double> good_answers() {
    static const std::vector<double> numbers = answers_of(handout_student(), asked_questions());
    return numbers;
}

Answers read(const std::vector<double>& numbers) {
    return read_answers(numbers, asked_questions());
}

/// The stream up to the answers of Interpolate.
std::vector<double> answers_before_lines() {
    std::vector<double> numbers;
    for (const double number : {double(part_globals), 0.0, end_of_part, double(part_vertex_shader),
                                not_written, end_of_part, double(part_interpolate)})
        numbers.push_back(number);
    return numbers;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("a good stream is read completely") {
    const Answers answers = read(good_answers());
    CHECK(answers.globals.end == PartEnd::complete);
    REQUIRE(answers.globals.answers.size() == 1);
    CHECK(answers.globals.answers[0].light_power == glm::vec3(14.0f));
    CHECK_FALSE(answers.globals.answers[0].camera.has_value());
    CHECK(answers.vertices.end == PartEnd::complete);
    CHECK(answers.lines.end == PartEnd::complete);
    CHECK(answers.polygons.end == PartEnd::complete);
    CHECK(answers.rows.end == PartEnd::complete);
    CHECK(answers.depths.end == PartEnd::complete);
    CHECK(answers.points.end == PartEnd::complete);
    REQUIRE(answers.lines.answers.size() == asked_questions().lines.size());
    const std::vector<PixelValues>& first = answers.lines.answers[0].pixels;
    REQUIRE(first.size() == 4);
    CHECK(first[1].x == 3.0);
    CHECK(first[1].y == 4.0);
}

TEST_CASE("no stream says that nothing was asked") {
    const Answers answers = read({});
    CHECK(answers.vertices.end == PartEnd::not_asked);
    for (const FunctionCheck& check : check_functions(asked_questions(), answers))
        CHECK(check.state == CheckState::not_asked);
}

TEST_CASE("a stream that ends anywhere keeps what was answered before") {
    const std::vector<double> whole = good_answers();
    Dice dice(9);
    for (int i = 0; i < 300; ++i) {
        const std::size_t size = dice.below(whole.size());
        const Answers answers = read({whole.begin(), whole.begin() + static_cast<long>(size)});
        CHECK(answers.vertices.end != PartEnd::unreadable);
        CHECK(answers.points.end != PartEnd::unreadable);
        CHECK(answers.points.end != PartEnd::complete);
        CHECK(answers.vertices.answers.size() <= asked_questions().vertices.size());
    }
}

TEST_CASE("a program that died in a function has died there, and its answers count") {
    std::vector<double> numbers = answers_before_lines();
    for (const double number : {0.0, 4.0})
        numbers.push_back(number);
    AnswerWriter writer;
    for (const auto& [x, y] :
         {std::pair(4, 2), std::pair(3, 4), std::pair(2, 6), std::pair(9, 9)}) {
        StudentPixel pixel;
        pixel.x = x;
        pixel.y = y;
        pixel.zinv = 0.5f;
        writer.put(pixel);
    }
    numbers.insert(numbers.end(), writer.numbers.begin(), writer.numbers.end());
    const Answers answers = read(numbers);
    CHECK(answers.lines.end == PartEnd::cut_short);
    REQUIRE(answers.lines.answers.size() == 1);
    const FunctionCheck check = check_interpolate(asked_questions(), answers);
    CHECK(check.state == CheckState::died);
    CHECK_FALSE(check.first.empty());
}

TEST_CASE("a count that is none makes a part unreadable") {
    for (const double count : {not_a_number, infinite, -infinite, 1e300, -4.0, 2.5}) {
        std::vector<double> numbers = answers_before_lines();
        numbers.insert(numbers.end(), {0.0, count, 15.0, 1.0, 2.0});
        const Answers answers = read(numbers);
        INFO(count);
        CHECK(answers.lines.end == PartEnd::unreadable);
        CHECK(answers.lines.answers.empty());
        CHECK(answers.vertices.end == PartEnd::not_written);
        CHECK(check_interpolate(asked_questions(), answers).state == CheckState::unreadable);
        // Where the next part begins is not known.
        CHECK(answers.polygons.end == PartEnd::unreadable);
    }
}

TEST_CASE("a huge count is kept as it is, and does not take memory") {
    for (const double count : {8193.0, 2147483648.0, 0x1p53}) {
        std::vector<double> numbers = answers_before_lines();
        numbers.insert(numbers.end(), {0.0, count});
        const Answers cut = read(numbers);
        CHECK(cut.lines.end == PartEnd::cut_short);
        CHECK(cut.lines.answers.empty());
        for (std::size_t i = 0; i < most_listed * doubles_in_pixel; ++i)
            numbers.push_back(1.0);
        const Answers listed = read(numbers);
        REQUIRE(listed.lines.answers.size() == 1);
        CHECK(listed.lines.answers[0].size == count);
        CHECK(listed.lines.answers[0].pixels.size() == most_listed);
        CHECK(check_interpolate(asked_questions(), listed).state == CheckState::died);
    }
}

TEST_CASE("answers in another order are unreadable") {
    std::vector<double> numbers = answers_before_lines();
    numbers.insert(numbers.end(), {1.0, 0.0}); // question 1 before question 0
    CHECK(read(numbers).lines.end == PartEnd::unreadable);
    // A part comes again, or before one that it follows.
    CHECK(read({double(part_vertex_shader), not_written, end_of_part, double(part_vertex_shader),
                not_written, end_of_part})
              .lines.end == PartEnd::unreadable);
    CHECK(read({double(part_interpolate), not_written, end_of_part, double(part_globals)})
              .points.end == PartEnd::unreadable);
    for (const double part : {not_a_number, infinite, -3.0, 0.0, 2.5, 8.0, 1e300})
        CHECK(read({part, 0.0, 0.0}).vertices.end == PartEnd::unreadable);
}

TEST_CASE("a part that ends before its last answer is unreadable") {
    std::vector<double> numbers = answers_before_lines();
    numbers.push_back(end_of_part);
    CHECK(read(numbers).lines.end == PartEnd::unreadable);
}

TEST_CASE("globals with a wrong number of values are unreadable, and odd values are not used") {
    CHECK(read({double(part_globals), 0.0, double(global_camera), 2.0, 1.0, 1.0, end_of_part})
              .globals.end == PartEnd::unreadable);
    CHECK(read({double(part_globals), 0.0, 77.0, 1.0, 1.0, end_of_part}).globals.end ==
          PartEnd::unreadable);
    CHECK(read({double(part_globals), 0.0, double(global_triangles), 1e15, 1.0}).globals.end ==
          PartEnd::cut_short);
    const Answers odd =
        read({double(part_globals), 0.0, double(global_camera), 3.0, not_a_number, 0.0, 0.0,
              double(global_focal_length), 1.0, 0.0, double(global_screen), 2.0, 1e9, 500.0,
              double(global_light_power), 1.0, 14.0, end_of_part});
    REQUIRE(odd.globals.end == PartEnd::complete);
    const KnownProgram before = asked_questions().program;
    const KnownProgram known = known_program(odd.globals.answers[0], before);
    CHECK(known.camera == before.camera);
    CHECK(known.viewport == before.viewport);
    CHECK(known.light.power == glm::vec3(14.0f));
    CHECK_FALSE(known.knows_light);
}

TEST_CASE("numbers that are not finite or huge are answers, and wrong ones") {
    const std::vector<double> whole = good_answers();
    Dice dice(10);
    constexpr double hostile[] = {not_a_number, infinite, -infinite, 1e300, -2147483648.0, 0.1};
    for (int turn = 0; turn < 12; ++turn) {
        std::vector<double> numbers = whole;
        for (int i = 0; i < 20; ++i)
            numbers[dice.below(numbers.size())] = hostile[dice.below(std::size(hostile))];
        // It is enough that it ends, and that nothing is called right that cannot be read.
        for (const FunctionCheck& check : check_functions(asked_questions(), read(numbers)))
            CHECK_FALSE(check.function.empty());
    }
}

TEST_CASE("random numbers are read without harm") {
    Dice dice(11);
    for (int turn = 0; turn < 200; ++turn) {
        std::vector<double> numbers;
        for (int i = 0; i < 400; ++i)
            numbers.push_back(static_cast<double>(dice.below(12)) - 2.0);
        const Answers answers = read(numbers);
        CHECK(answers.points.end != PartEnd::complete);
    }
}
