// An answer as repeated to the student, and reading it back.

#include "lessons/lesson_run.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

using Kind = LessonPrediction::Kind;

LessonPrediction prediction_of(Kind kind, const std::string& unit = {}) {
    LessonPrediction prediction;
    prediction.kind = kind;
    prediction.unit = unit;
    prediction.choices = {"the floor", "pixel (1, 2)", "12"};
    return prediction;
}

} // namespace

TEST_CASE("Every answer is found again in the words in which it was repeated back") {
    for (const std::string unit : {"", "pixels", "12"}) {
        const LessonPrediction number = prediction_of(Kind::number, unit);
        for (const std::string typed : {"12", "-0.5", "1/3", "0,5", "500*2"}) {
            INFO(typed << " " << unit);
            const double value = *read_answer(typed);
            const auto found = answer_in_words(number, answer_words(number, {value}, typed));
            REQUIRE(found);
            CHECK(std::get<double>(found->value) == value);
        }
    }
    const LessonPrediction choice = prediction_of(Kind::choice);
    for (int i = 0; i < 3; ++i) {
        const auto found = answer_in_words(choice, answer_words(choice, {i}));
        REQUIRE(found);
        CHECK(std::get<int>(found->value) == i);
    }
    const LessonPrediction pixel = prediction_of(Kind::pixel);
    for (const glm::ivec2 place : {glm::ivec2(0, 0), glm::ivec2(250, 131), glm::ivec2(-3, 7)}) {
        const auto found = answer_in_words(pixel, answer_words(pixel, {place}));
        REQUIRE(found);
        CHECK(std::get<glm::ivec2>(found->value) == place);
    }
}

TEST_CASE("A computed answer below zero has a minus sign, and is read again") {
    for (const double number : {-0.5, -12.0, -2.5e-7, -1e300, 3.0}) {
        INFO(number);
        const std::string text = answer_text(number);
        CHECK(text.find('-') == std::string::npos);
        CHECK(read_answer(text) == number);
    }
    CHECK(answer_text(-5.0) == "−5");
    CHECK(answer_text(-1.25, 2) == "−1.25");
    // The typed answer looks like the program's.
    CHECK(answer_words(prediction_of(Kind::number), {-5.0}, "-5") == answer_text(-5.0));
}

TEST_CASE("Words that are no answer of this prediction give none") {
    CHECK_FALSE(answer_in_words(prediction_of(Kind::choice), "the ceiling"));
    CHECK_FALSE(answer_in_words(prediction_of(Kind::number, "pixels"), "pixels"));
    CHECK_FALSE(answer_in_words(prediction_of(Kind::number), ""));
    CHECK_FALSE(answer_in_words(prediction_of(Kind::number), "many"));
    for (const char* said : {"", "pixel ", "pixel (", "pixel )", "pixel (1, 2", "(1, 2)",
                             "pixel (1)", "pixel (a, b)", "pixel (1, 99999999999)"}) {
        INFO(said);
        CHECK_FALSE(answer_in_words(prediction_of(Kind::pixel), said));
    }
}
