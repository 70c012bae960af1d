// The outline of what a step of a lesson points at.

#include <catch2/catch.hpp>

#include "tests/ui/driver.h"
#include "ui/actions/keys.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The number of the first step of a lesson, after its opening, that points at a widget.
int step_that_points(const Lesson& lesson) {
    for (std::size_t i = 1; i < lesson.steps.size(); ++i) {
        if (lesson.steps[i].state.point_at) return static_cast<int>(i);
    }
    return -1;
}

} // namespace

TEST_CASE("A step that is walked to by keys outlines what it points at, until the next key") {
    Driver driver;
    const LessonView& view = driver.ui.lesson;
    const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    int tried = 0;
    for (const Lesson& lesson : lessons) {
        const int step = step_that_points(lesson);
        if (step < 0) continue;
        INFO(lesson.id << ", step " << step);
        ++tried;
        const std::string widget = *lesson.steps[static_cast<std::size_t>(step)].state.point_at;
        open_lesson(driver.ui, lesson.id, step - 1);
        driver.hand.frames(frames_to_rest);
        driver.hand.hold(key::page_down, 5); // as a person does, for several frames
        CHECK(driver.ui.session.step == step);
        CHECK(view.pointed_at == widget);
        driver.hand.frames(20);
        CHECK(view.pointed_at == widget);
        if (step + 1 < static_cast<int>(lesson.steps.size())) {
            driver.hand.press(key::page_down);
            driver.hand.press(key::page_up);
            CHECK(view.pointed_at == widget);
        }
        driver.hand.press('G');
        CHECK(view.pointed_at.empty());
    }
    CHECK(tried > 3);
}

} // namespace rasterwalk
