// A column leads to the questions and tasks of its step before the next step.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

bool leads_on_in_step() {
    return shows_words("to the question") || shows_words("to the task");
}

std::string name_of(const LessonPrediction& prediction) {
    return "lesson.prediction." + prediction.id;
}

/// The widgets of all questions and tasks of a step.
std::vector<std::string> open_parts(const Lesson& lesson, int step) {
    std::vector<std::string> names;
    for (const LessonPrediction& prediction : lesson.predictions)
        if (prediction.step == step) names.push_back(name_of(prediction));
    for (const LessonTask& task : lesson.tasks)
        if (task.step == step) names.push_back("lesson.task." + task.id);
    return names;
}

/// Is a question with all it needs for an answer on the screen, or a task with its hint?
bool is_whole(const Driver& driver, const std::string& name) {
    int parts = 0;
    for (const auto& [widget, place] : driver.ui.widgets) {
        if (!widget.starts_with(name)) continue;
        if (!place.visible || !place.is_whole) return false;
        ++parts;
    }
    return parts > 0;
}

} // namespace

TEST_CASE("No step of a column is left until all that is open was in sight, by button or by key") {
    for (const ImVec2 window : {ImVec2(1366, 768), ImVec2(1280, 720)}) {
        Driver driver("lab-room.toml", window);
        const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
        int led = 0;
        for (const Lesson& lesson : test::some_of(lessons, 3)) {
            for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
                INFO(lesson.id << ", step " << step << " at " << window.x << " x " << window.y);
                const std::vector<std::string> open = open_parts(lesson, step);
                if (open.empty()) continue;
                open_lesson(driver.ui, lesson.id, step);
                driver.hand.leave();
                if (driver.ui.lesson.is_strip) continue; // the step shows both views
                std::set<std::string> seen;
                const auto look = [&] {
                    for (const std::string& name : open)
                        if (is_whole(driver, name)) seen.insert(name);
                };
                look();
                const auto is_here = [&] {
                    return driver.ui.session.step == step && driver.ui.session.lesson == lesson.id;
                };
                for (std::size_t i = 0; i <= open.size() && leads_on_in_step(); ++i) {
                    if (step % 2 == 0) {
                        driver.hand.press(key::page_down);
                    } else {
                        driver.hand.click("lesson.next");
                    }
                    driver.hand.leave();
                    REQUIRE(is_here());
                    look();
                    ++led;
                }
                CHECK(seen.size() == open.size());
                CHECK_FALSE(leads_on_in_step());
                const bool is_end = step + 1 == static_cast<int>(lesson.steps.size());
                if (is_end) continue;
                driver.hand.press(key::page_down);
                CHECK_FALSE(is_here());
            }
        }
        CHECK(led > 0);
    }
}

TEST_CASE("A question that is answered is not led to") {
    Driver driver("lab-room.toml", {1366, 768});
    open_lesson(driver.ui, "02-moving-the-camera", 1);
    const LessonPrediction asked = open_lesson_of(driver.ui)->predictions.at(1);
    REQUIRE(asked.step == 1);
    REQUIRE(asked.kind == LessonPrediction::Kind::number);
    driver.hand.leave();
    REQUIRE(shows_words("to the question"));
    const std::string name = name_of(asked);
    driver.hand.click(name + ".number");
    driver.hand.type_text("7");
    driver.hand.press(key::enter);
    driver.hand.click(name + ".show");
    driver.hand.wheel("lesson.part0.link.0", 50.0f);
    driver.hand.leave();
    CHECK_FALSE(is_whole(driver, name));
    CHECK_FALSE(leads_on_in_step());
    driver.hand.press(key::page_down);
    CHECK(driver.ui.session.step == 2);
}

TEST_CASE("A task below the fold is led to, and no longer once it is done") {
    Driver driver("lab-room.toml", {1280, 720});
    // A step whose task alone is open, and out of sight.
    const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    int tried = 0;
    for (const Lesson& lesson : lessons) {
        for (const LessonTask& task : lesson.tasks) {
            if (tried == 2 || open_parts(lesson, task.step).size() != 1) continue;
            if (task.step + 1 == static_cast<int>(lesson.steps.size())) continue;
            INFO(lesson.id << ", " << task.id);
            open_lesson(driver.ui, lesson.id, task.step);
            driver.hand.leave();
            if (driver.ui.lesson.is_strip || !shows_words("to the task")) continue;
            ++tried;
            const std::string name = "lesson.task." + task.id;
            CHECK_FALSE(is_whole(driver, name));
            driver.hand.press(key::page_down);
            driver.hand.leave();
            CHECK(driver.ui.session.step == task.step);
            CHECK(is_whole(driver, name));
            driver.ui.lesson.progress.record_task(lesson.id, task.id);
            open_lesson(driver.ui, lesson.id, task.step);
            driver.hand.leave();
            CHECK_FALSE(leads_on_in_step());
            driver.hand.press(key::page_down);
            CHECK(driver.ui.session.step == task.step + 1);
        }
    }
    CHECK(tried > 0);
}

} // namespace rasterwalk
