// Tries out what lessons/README.md says to authors.

#include <string>

#include "base/files.h"
#include "lessons/lesson.h"
#include "lessons/lesson_check.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The complete lesson of lessons/README.md has no faults") {
    const std::string text = read_file(lessons_folder() + "/README.md");
    const std::string opening = "````markdown\n";
    const std::size_t begin = text.find(opening);
    REQUIRE(begin != text.npos);
    const std::size_t from = begin + opening.size();
    const std::size_t to = text.find("````", from);
    REQUIRE(to != text.npos);
    const Lesson lesson =
        parse_lesson(text.substr(from, to - from), lessons_folder() + "/40-two-pixels.md");
    CHECK(lesson.tasks.size() == 1);
    CHECK(lesson.predictions.size() == 1);
    for (const Fault& fault : check_lesson(lesson, empty_session()))
        FAIL_CHECK(fault_text(lesson, fault));
}
