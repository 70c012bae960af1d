#pragma once

// The test before and after the lessons: what is asked, how it is scored, and what is handed in.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

struct TestItem {
    std::string id;
    std::string lesson;   ///< id of the lesson that it is about
    std::string question; ///< plain text
    /// The first is right, the second is the attractive wrong one.
    std::vector<std::string> choices;
    std::vector<int> order; ///< the order they are offered in, see shuffled()
};

struct CourseTest {
    std::vector<TestItem> items;
};

/// What was said, by the id of the item.
using TestAnswers = std::map<std::string, std::string>;

/// Reads `[[item]]` tables. Throws InputError with file:line.
CourseTest parse_course_test(std::string_view text, const std::string& path);

/// The test that comes with the lessons. Throws AccessError or InputError.
CourseTest read_course_test();

/// How many items are answered with one of their choices, and how many of those are right.
struct TestScore {
    int answered = 0, right = 0;

    friend bool operator==(const TestScore&, const TestScore&) = default;
};
TestScore score_of_test(const CourseTest& test, const TestAnswers& answers);

/// Both sittings side by side, as a page to hand in or as text. Which answers are right is marked
/// once the second sitting is complete.
/// @param name of the student; may be empty
std::string test_page(const CourseTest& test, const TestAnswers& before, const TestAnswers& after,
                      std::string_view name);
std::string test_text(const CourseTest& test, const TestAnswers& before, const TestAnswers& after,
                      std::string_view name);

inline constexpr std::size_t most_test_items = 50;

} // namespace rasterwalk
