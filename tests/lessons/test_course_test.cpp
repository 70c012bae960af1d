// The test before and after the lessons.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "lessons/course_test.h"
#include "lessons/lesson_list.h"
#include "lessons/progress.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

CourseTest small_test() {
    return parse_course_test(R"([[item]]
id = "one"
lesson = "04-edges"
question = "Is 1 < 2 & 3 > 2?"
right = "yes"
wrong = ["no", "<b>"]

[[item]]
id = "two"
lesson = "05-row-table"
question = "How many?"
right = "2"
wrong = ["3"]
)",
                             "test.toml");
}

std::string refusal(const std::string& text) {
    try {
        parse_course_test(text, "test.toml");
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "taken";
}

const TestItem& item_of(const CourseTest& test, const std::string& id) {
    for (const TestItem& item : test.items) {
        if (item.id == id) return item;
    }
    FAIL("There is no item " << id << ".");
    return test.items.front();
}

/// Of a text in UTF-8.
std::ptrdiff_t letter_count(const std::string& text) {
    return std::count_if(text.begin(), text.end(),
                         [](char byte) { return (static_cast<unsigned char>(byte) >> 6) != 2; });
}

} // namespace

TEST_CASE("The test has an item for each of the first twelve lessons, with an attractive wrong "
          "answer") {
    const CourseTest test = read_course_test();
    REQUIRE(test.items.size() == 12);
    std::array<int, 3> right_at{};
    for (std::size_t i = 0; i < test.items.size(); ++i) {
        const TestItem& item = test.items[i];
        INFO(item.id);
        CHECK(lesson_number(item.lesson) == static_cast<int>(i) + 1);
        CHECK(std::filesystem::exists(lessons_folder() + "/" + item.lesson + ".md"));
        CHECK(item.choices.size() == 3);
        CHECK(item.question.ends_with('?'));
        for (std::size_t place = 0; place < item.order.size(); ++place) {
            if (item.order[place] == 0) ++right_at.at(place);
        }
    }
    // The place of the right answer gives nothing away.
    for (const int count : right_at) {
        CHECK(count >= 3);
        CHECK(count <= 5);
    }
}

TEST_CASE("The length of the right answer gives nothing away") {
    const CourseTest test = read_course_test();
    int longest = 0, with_words = 0;
    for (const TestItem& item : test.items) {
        INFO(item.id);
        const std::ptrdiff_t right = letter_count(item.choices.front());
        if (right < 5) continue; // a number
        ++with_words;
        bool is_longest = true;
        for (std::size_t i = 1; i < item.choices.size(); ++i) {
            const std::ptrdiff_t wrong = letter_count(item.choices[i]);
            INFO(item.choices[i]);
            CHECK(2 * right <= 3 * wrong);
            CHECK(2 * wrong <= 3 * right);
            is_longest = is_longest && right > wrong;
        }
        longest += is_longest ? 1 : 0;
    }
    CHECK(with_words == 9);
    CHECK(2 * longest <= with_words);
}

TEST_CASE("The numbers of the test are what a program computes") {
    const CourseTest test = read_course_test();
    const auto right = [&](const char* id) { return item_of(test, id).choices.at(0); };
    const auto wrong = [&](const char* id) { return item_of(test, id).choices.at(1); };
    CHECK(right("cut-to-int") == std::to_string(static_cast<int>(-0.7)));
    CHECK(right("samples-of-a-line") == std::to_string(std::max(9 - 2, 5 - 3) + 1));
    CHECK(wrong("samples-of-a-line") == std::to_string(std::max(9 - 2, 5 - 3)));
    CHECK(right("halfway-in-depth") == std::to_string(std::lround(1.0 / ((0.5 + 1.0 / 6.0) / 2))));
    CHECK(wrong("halfway-in-depth") == std::to_string((2 + 6) / 2));
    volatile float value = 2.0f;
    for (int i = 0; i < 3; ++i)
        value = value - 1.0f / 3.0f;
    CHECK(right("a-third-at-a-time").starts_with(std::to_string(static_cast<int>(value)) + ","));
}

TEST_CASE("A test is read strictly") {
    CHECK(small_test().items.at(1).choices == std::vector<std::string>{"2", "3"});
    const std::string head = "[[item]]\nid = \"a\"\nlesson = \"04-edges\"\nquestion = \"Q?\"\n";
    CHECK(refusal(head + "right = \"x\"\nwrong = []\n").find("at least one wrong answer") !=
          std::string::npos);
    CHECK(refusal(head + "right = \"x\"\nwrong = [\"x\"]\n") ==
          "test.toml:6: There are two answers 'x'.");
    CHECK(refusal(head + "right = \"x\"\nwrong = [3]\n") ==
          "test.toml:6: A wrong answer must be text.");
    CHECK(refusal(head + "wrong = [\"x\"]\n").find("'right'") != std::string::npos);
    const std::string good = head + "right = \"x\"\nwrong = [\"y\"]\n";
    CHECK(refusal(good) == "taken");
    CHECK(refusal(good + good).find("There are two items 'a'.") != std::string::npos);
}

TEST_CASE("Answers are counted, and those that are no longer offered are not") {
    const CourseTest test = small_test();
    CHECK(score_of_test(test, {}) == TestScore{0, 0});
    CHECK(score_of_test(test, {{"one", "no"}, {"two", "2"}}) == TestScore{2, 1});
    CHECK(score_of_test(test, {{"one", "yes"}, {"two", "4"}, {"three", "yes"}}) == TestScore{1, 1});
}

TEST_CASE("The report has both sittings, as a page and as text") {
    const CourseTest test = small_test();
    const TestAnswers before{{"one", "<b>"}}, after{{"one", "yes"}, {"two", "2"}};
    const std::string text = test_text(test, before, after, "A. Student");
    CHECK(text == "Rasterwalk: the test before and after\nA. Student\n"
                  "Before the lessons: 0 of 2 right, 1 answered.\n"
                  "After the lessons: 2 of 2 right.\n"
                  "\n4. Is 1 < 2 & 3 > 2?\n   before: ✗ <b>\n   after:  ✓ yes\n"
                  "\n5. How many?\n   before: –\n   after:  ✓ 2\n");
    const std::string page = test_page(test, before, after, "A <i>");
    CHECK(page.find("<p>A &lt;i&gt;</p>") != page.npos);
    CHECK(page.find("<tr><td>4</td><td>Is 1 &lt; 2 &amp; 3 &gt; 2?</td><td>✗ &lt;b&gt;</td>"
                    "<td>✓ yes</td></tr>") != page.npos);
    CHECK(page.find("After the lessons: 2 of 2 right.") != page.npos);
    CHECK(test_text(test, {}, after, "").find("Before the lessons: not taken.") !=
          std::string::npos);
    // Before the second sitting is complete, neither of them says which answers are right.
    for (const TestAnswers& open : {TestAnswers{}, TestAnswers{{"one", "yes"}}}) {
        for (const std::string& report :
             {test_text(test, before, open, ""), test_page(test, before, open, "")}) {
            CHECK(report.find("✓") == report.npos);
            CHECK(report.find("✗") == report.npos);
            CHECK(report.find("0 of 2 right, 1 answered") != report.npos);
        }
    }
}

TEST_CASE("The answers of the test are kept with the progress, and merged with another window's") {
    Progress progress;
    progress.test_before = {{"one", "say \"no\""}};
    progress.test_after = {{"one", "yes"}, {"two", "2"}};
    CHECK(parse_progress(progress_text(progress), "p.toml") == progress);
    CHECK_THROWS_AS(parse_progress("[test_before]\none = 3\n", "p.toml"), InputError);
    const test::TemporaryFolder folder;
    const std::string path = folder.file("progress.toml");
    write_progress({}, progress, path);
    Progress mine = progress;
    mine.test_before["one"] = "yes"; // changed
    mine.test_after.erase("two");    // taken again
    Progress theirs = progress;
    theirs.test_before["two"] = "3";
    write_progress(progress, theirs, path);
    const Progress kept = write_progress(progress, mine, path);
    CHECK(kept.test_before == TestAnswers{{"one", "yes"}, {"two", "3"}});
    CHECK(kept.test_after == TestAnswers{{"one", "yes"}});
}
