// Tests whether a task of a lesson can be solved by luck.

#include <cmath>

#include "lessons/lesson_check.h"
#include "lessons/lesson_list.h"
#include "lessons/task_luck.h"
#include "session/content.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"

using namespace rasterwalk;

namespace {

/// A lesson in the room with one task, and a slider of the focal length.
Lesson lesson_of_task(const std::string& task) {
    return parse_lesson(test::lesson_head() +
                            "<!-- control\nsetting = \"camera.focal_length\"\nfrom = 401\n"
                            "to = 600\nstep = 1\n-->\n\n<!-- task\nid = \"t\"\n" +
                            task + "\n-->\n> **Task.** Do it.\n",
                        lessons_folder() + "/99-task.md");
}

TaskLuck tried_at_random(const Lesson& lesson, int tries) {
    for (const Fault& fault : lesson.faults)
        FAIL(fault_text(lesson, fault));
    LessonTrial trial;
    return luck_of(lesson, lesson.tasks.at(0), tries, empty_session(), trial);
}

} // namespace

TEST_CASE("The share of random tries that solve a task is the share of its answers") {
    // 50 of the 200 stops.
    const TaskLuck quarter = tried_at_random(
        lesson_of_task("done = \"camera.focal_length > 550\"\n"
                       "recipe = [\"set:camera.focal_length=560\"]\n"
                       "not_yet = [{ when = \"camera.focal_length < 450\", says = \"Less.\" }]"),
        200);
    CHECK(quarter.control == "camera.focal_length");
    CHECK(quarter.tries == 200);
    CHECK(quarter.passed == Approx(50).margin(20));
    CHECK(quarter.ends_pass);
    // A hundred stops between 450 and 550 get no reply.
    CHECK(quarter.unanswered == Approx(100).margin(25));
    CHECK(quarter.unanswered_by.starts_with("camera.focal_length="));
    CHECK(is_luck(quarter));
    // The left half of the picture; right of it all is answered.
    const TaskLuck half =
        tried_at_random(lesson_of_task("done = \"pixel.column < 250\"\n"
                                       "recipe = [\"set:interpolation=affine\", \"pixel:3,3\"]\n"
                                       "not_yet = [{ when = \"pixel.column >= 250\", says = "
                                       "\"Farther left.\" }]"),
                        100);
    CHECK(half.control == "pixel");
    CHECK(half.passed == Approx(50).margin(15));
    CHECK_FALSE(half.ends_pass);
    CHECK(half.unanswered == 0);
    // Two of thirty triangles.
    const TaskLuck two =
        tried_at_random(lesson_of_task("done = \"triangle < 2 and triangle >= 0\"\n"
                                       "recipe = [\"triangle:1\"]"),
                        150);
    CHECK(two.control == "triangle");
    CHECK(two.passed == Approx(10).margin(8));
    CHECK_FALSE(is_luck(two));
    // The first of thirty triangles is a thirtieth of the time.
    const TaskLuck moment = tried_at_random(lesson_of_task("done = \"cursor.triangle == 0\"\n"
                                                           "recipe = [\"cursor:t0/v1\"]"),
                                            150);
    CHECK(moment.control == "moment");
    CHECK(moment.passed == Approx(5).margin(5));
    const TaskLuck word = tried_at_random(lesson_of_task("done = \"interpolation == affine\"\n"
                                                         "recipe = [\"set:interpolation=affine\"]"),
                                          100);
    CHECK(word.control.empty());
    CHECK(word.tries == 0);
}

TEST_CASE("No task of a lesson is solved by luck, and every try that misses is answered") {
    const Session session = empty_session();
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    LessonTrial trial;
    const int tries = test::rounds(300, 4);
    // With few tries, more can pass by chance: three deviations above a tenth.
    const double most = 0.1 * tries + (tries < 300 ? 3.0 * std::sqrt(0.09 * tries) : 0.0);
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonTask& task : lesson.tasks) {
            const TaskLuck found = luck_of(lesson, task, tries, session, trial);
            INFO(lesson.path << ":" << task.done_line << " " << task.id << ": " << found.passed
                             << " of " << found.tries << " tries of " << found.control
                             << " solve it; one without a reply: " << found.unanswered_by);
            CHECK_FALSE(task.because.empty());
            CHECK_FALSE(task.not_yet.empty());
            CHECK(found.passed <= most);
            CHECK_FALSE(found.ends_pass);
            CHECK(found.unanswered == 0);
        }
    }
}
