#pragma once

// Which predictions of the lessons have been worked out a second time, without the program.

#include <initializer_list>
#include <set>
#include <string>

#include "tests/support/catch.h"

namespace rasterwalk::test {

/// "lesson/prediction" of every test that was written with PREDICTIONS_TEST.
std::set<std::string>& checked_predictions();

/// Adds predictions of a lesson to them.
struct CheckedPredictions {
    CheckedPredictions(const std::string& lesson, std::initializer_list<const char*> ids);
};

/// To be called by a test whenever it asks the program for its answer to a prediction.
void record_question(const std::string& lesson, const std::string& prediction);
void forget_questions();

/// Fails unless the test has asked for these and no others.
void require_questions(const std::string& lesson, std::initializer_list<const char*> ids);

} // namespace rasterwalk::test

#define RASTERWALK_PREDICTIONS_TEST(function, checked, title, lesson, ...)                         \
    static void function();                                                                        \
    static const rasterwalk::test::CheckedPredictions checked(lesson, {__VA_ARGS__});              \
    TEST_CASE(title) {                                                                             \
        rasterwalk::test::forget_questions();                                                      \
        function();                                                                                \
        rasterwalk::test::require_questions(lesson, {__VA_ARGS__});                                \
    }                                                                                              \
    static void function()
#define RASTERWALK_JOINED_(a, b) a##b
#define RASTERWALK_JOINED(a, b) RASTERWALK_JOINED_(a, b)

/// A test case about predictions of one lesson: title, id of the lesson, ids of the predictions. It
/// must ask for each of them. A test demands that every prediction of every lesson has one.
/// Several files may be compiled as one, where two tests can be on the same line: hence
/// __COUNTER__.
#define PREDICTIONS_TEST(title, lesson, ...)                                                       \
    RASTERWALK_PREDICTIONS_TEST(RASTERWALK_JOINED(predictions_test_, __COUNTER__),                 \
                                RASTERWALK_JOINED(checked_predictions_, __COUNTER__), title,       \
                                lesson, __VA_ARGS__)
