// Advice on lessons: what it finds, what it leaves alone, and what the lessons of the program heed.

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"
#include "lessons/course.h"
#include "lessons/lesson_advice.h"
#include "lessons/lesson_check.h"
#include "lessons/lesson_list.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"

using namespace rasterwalk;

namespace {

const std::vector<Term> terms{{"depth buffer", "A picture of depths.", "Depth buffer"},
                              {"edge", "A side.", "Drawing edges", true},
                              {"z-buffer", "A depth buffer.", "Depth buffer"}};

/// A lesson whose steps have these texts.
Lesson lesson_of(const std::string& opening, const std::vector<std::string>& steps) {
    std::string text = test::lesson_head() + opening + "\n";
    for (const std::string& step : steps)
        text += "\n## A step\n\n" + step + "\n";
    return parse_lesson(text, "40-advice.md");
}

/// The advice that speaks of words.
std::vector<std::string> word_advice(const std::vector<Lesson>& lessons, std::size_t index) {
    std::vector<std::string> found;
    const std::vector<std::vector<Fault>> advice = advice_on(lessons, terms);
    for (const Fault& one : advice[index]) {
        if (one.sentence.find(" is used here") != std::string::npos) found.push_back(one.sentence);
    }
    return found;
}
std::size_t word_advice_count(const std::string& opening, const std::vector<std::string>& steps) {
    return word_advice({lesson_of(opening, steps)}, 0).size();
}

std::string repeated(const std::string& word, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += word + (i % 12 == 11 ? "\n" : " ");
    return text;
}

bool has_advice(const Lesson& lesson, const std::string& words) {
    const std::vector<Fault> advice = advice_on(std::vector<Lesson>{lesson}, terms).front();
    return std::any_of(advice.begin(), advice.end(), [&](const Fault& one) {
        return one.sentence.find(words) != std::string::npos;
    });
}

} // namespace

TEST_CASE("A word of the glossary that has not been explained is pointed out once, with its line") {
    const Lesson lesson = lesson_of("Words.\n\nThe depth buffer.", {"A depth buffer again."});
    const std::vector<Fault> advice = advice_on(std::vector<Lesson>{lesson}, terms).front();
    const auto found = std::find_if(advice.begin(), advice.end(), [](const Fault& one) {
        return one.sentence.find("depth buffer") != std::string::npos;
    });
    REQUIRE(found != advice.end());
    const int first_line = lesson.steps.front().parts.front().line;
    CHECK(found->line == first_line + 2);
    CHECK(found->sentence ==
          "'depth buffer' is used here and explained nowhere before. Explain it and emphasize it "
          "there, or link it: [depth buffer](term:depth%20buffer).");
    CHECK(word_advice_count("The depth buffer.", {"A depth buffer again."}) == 1);
}

TEST_CASE("Advice names the line of the file, below a comment as well") {
    const std::string text = test::lesson_head() + "Words.\n\n## A step\n\n<!-- step\n"
                                                   "tab = \"rows\"\n-->\n\nThe depth buffer.\n";
    const auto line =
        1 + std::count(text.begin(),
                       text.begin() + static_cast<std::ptrdiff_t>(text.find("The depth")), '\n');
    const std::vector<Lesson> lessons{parse_lesson(text, "40-advice.md")};
    CHECK(lessons.front().faults.empty());
    bool is_named = false;
    const std::vector<Fault> advice = advice_on(lessons, terms).front();
    for (const Fault& one : advice)
        is_named = is_named || one.line == line;
    CHECK(is_named);
}

TEST_CASE("Emphasis and links to the glossary explain a word, for the lessons that follow too") {
    CHECK(word_advice_count("The *depth buffer* is new.", {}) == 0);
    CHECK(word_advice_count("**Depth buffers** are new.", {}) == 0);
    CHECK(word_advice_count("The [memory](term:depth%20buffer).", {"A depth buffer."}) == 0);
    CHECK(word_advice_count("A [depth buffer](09-light.md).", {}) == 1);
    const Lesson explains = lesson_of("The *depth buffer* is new.", {});
    const Lesson uses = lesson_of("A depth buffer.", {});
    CHECK(word_advice({explains, uses}, 1).empty());
    CHECK(word_advice({uses, explains}, 0).size() == 1);
}

TEST_CASE("A word that is explained later in the lesson is pointed out, with the step") {
    const std::vector<std::string> found =
        word_advice({lesson_of("A depth buffer.", {"Nothing.", "The *depth buffer* is new."})}, 0);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "'depth buffer' is used here, but explained only in step 2.");
    CHECK(word_advice_count("A depth buffer.\n\nIt is called *depth buffer*.", {}) == 0);
}

TEST_CASE("Code, formulas, parts of words and everyday words need no explanation") {
    CHECK(word_advice_count("Write `depth buffer` or $z-buffer$.", {"```\ndepth buffer\n```"}) ==
          0);
    CHECK(word_advice_count("A depth buffered look, an xz-buffer.", {}) == 0);
    CHECK(word_advice_count("An edge.", {}) == 0);
    CHECK(word_advice_count("Depth Buffers.", {}) == 1);
    CHECK(word_advice_count("A list:\n\n* a depth buffer\n* more", {}) == 1);
    // A bullet is no emphasis, however far it is indented.
    CHECK(word_advice_count("A list:\n\n- one\n  * a depth buffer", {}) == 1);
}

TEST_CASE("A step of more than 130 words is pointed out, and what is no text does not count") {
    CHECK_FALSE(has_advice(lesson_of("Words.", {repeated("word", 130)}), "this step has"));
    CHECK(has_advice(lesson_of("Words.", {repeated("word", 131)}), "this step has 131 words."));
    CHECK(count_words(lesson_of("One, two - three.", {}).steps.front()) == 3);
}

TEST_CASE("The number of steps and the minutes are compared with the length") {
    const std::vector<std::string> steps(6, "Text.");
    CHECK_FALSE(has_advice(lesson_of("Words.", steps), "suits one sitting"));
    CHECK(has_advice(lesson_of("Words.", {"Text."}), "suits one sitting; this one has 1."));
    CHECK(has_advice(lesson_of("Words.", std::vector<std::string>(11, "Text.")), "has 11."));
    Lesson lesson = lesson_of("Words.", std::vector<std::string>(10, repeated("word", 130)));
    const double minutes = minutes_by_length(lesson);
    lesson.minutes = 12;
    CHECK_FALSE(has_advice(lesson, "minutes, not"));
    lesson.minutes = 13;
    CHECK(has_advice(lesson, "take about 10 minutes, not 13."));
    lesson.minutes = 7;
    CHECK(has_advice(lesson, "take about 10 minutes, not 7."));
    // Each of these takes a minute more.
    lesson.predictions.resize(1);
    lesson.tasks.resize(2);
    lesson.puzzles.resize(3);
    CHECK(minutes_by_length(lesson) == Approx(minutes + 6.0));
}

TEST_CASE("The lessons that come with the program heed the advice") {
    LessonList list;
    list.read_folder(lessons_folder());
    const std::vector<Lesson>& lessons = list.all();
    const std::vector<std::vector<Fault>> advice = advice_on(lessons, empty_session().glossary);
    REQUIRE(advice.size() == lessons.size());
    // Many short steps are right for a map and a tangent frame; programs that are compiled and
    // asked take their time.
    std::map<std::string, std::string> left_alone{{"29-normal-maps", "this one has 12"},
                                                  {"36-your-own-program", "not 17"}};
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        for (const Fault& one : advice[i]) {
            const auto left = left_alone.find(lessons[i].id);
            if (left != left_alone.end() && one.sentence.find(left->second) != std::string::npos) {
                left_alone.erase(left);
            } else {
                FAIL_CHECK(fault_text(lessons[i], one));
            }
        }
    }
    CHECK(left_alone.empty());
}

TEST_CASE("The template of a lesson has no fault") {
    const Lesson lesson = read_lesson(lessons_folder() + "/TEMPLATE.md");
    CHECK(lesson.tasks.size() == 1);
    CHECK(lesson.predictions.size() == 3);
    for (const Fault& fault : check_lesson(lesson, empty_session()))
        FAIL_CHECK(fault_text(lesson, fault));
}

TEST_CASE("Each plan of TEACHING.md takes as long as it says, and has all that its lessons need") {
    const Course course = read_course(lessons_folder());
    LessonList list;
    list.read_folder(lessons_folder());
    std::istringstream text(read_file(lessons_folder() + "/TEACHING.md"));
    const std::regex link(R"(\[(\d+)\]\(([^)]+)\.md\))"), time(R"(\| (\d+) minutes \|$)"),
        hours(R"(^\| (\d) hours: )");
    int plans = 0;
    for (std::string line; std::getline(text, line);) {
        std::smatch found;
        if (!std::regex_search(line, found, hours)) continue;
        ++plans;
        const int most = 60 * std::stoi(found[1]);
        INFO("plan of " << found[1] << " hours");
        std::set<std::string> taken;
        int minutes = 0;
        std::size_t order = 0;
        for (std::sregex_iterator i(line.begin(), line.end(), link), end; i != end; ++i) {
            const std::string id = (*i)[2];
            INFO(id);
            CHECK(std::stoi((*i)[1]) == lesson_number(id));
            const Lesson* const lesson = list.find(id);
            REQUIRE(lesson != nullptr);
            minutes += lesson->minutes;
            for (const std::string& need : needs_of(course, id))
                CHECK(taken.count(need) == 1);
            taken.insert(id);
            CHECK(place_in(course, id).order >= order);
            order = place_in(course, id).order;
        }
        REQUIRE(std::regex_search(line, found, time));
        CHECK(minutes == std::stoi(found[1]));
        CHECK(minutes <= most);
        CHECK(minutes > most - 30);
    }
    CHECK(plans == 3);
}
