// A column leads to the questions of its step before the next step.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/keys.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

bool says(const std::string& words) {
    const std::vector<ScreenText> texts = screen_text();
    return std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
        return text.words.find(words) != std::string::npos;
    });
}

/// Is a question with all that it is answered by on the screen?
bool is_whole(const Driver& driver, const LessonPrediction& prediction) {
    const std::string name = "lesson.prediction." + prediction.id;
    int parts = 0;
    for (const auto& [widget, place] : driver.ui.widgets) {
        if (!widget.starts_with(name)) continue;
        if (!place.visible || !place.is_whole) return false;
        ++parts;
    }
    return parts > 0;
}

} // namespace

TEST_CASE("No step of a column is left before its questions were in sight, by button or by key") {
    for (const ImVec2 window : {ImVec2(1366, 768), ImVec2(1280, 720)}) {
        Driver driver("lab-room.toml", window);
        const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
        int led = 0;
        for (const Lesson& lesson : test::some_of(lessons, 3)) {
            for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
                INFO(lesson.id << ", step " << step << " at " << window.x << " x " << window.y);
                std::vector<const LessonPrediction*> asked;
                for (const LessonPrediction& prediction : lesson.predictions)
                    if (prediction.step == step) asked.push_back(&prediction);
                if (asked.empty()) continue;
                open_lesson(driver.ui, lesson.id, step);
                driver.hand.leave();
                if (driver.ui.lesson.is_strip) continue; // the step shows both views
                std::set<std::string> seen;
                const auto look = [&] {
                    for (const LessonPrediction* const prediction : asked)
                        if (is_whole(driver, *prediction)) seen.insert(prediction->id);
                };
                look();
                const auto is_here = [&] {
                    return driver.ui.session.step == step && driver.ui.session.lesson == lesson.id;
                };
                for (std::size_t i = 0; i <= asked.size() && says("to the question"); ++i) {
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
                CHECK(seen.size() == asked.size());
                CHECK_FALSE(says("to the question"));
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
    const LessonPrediction asked = open_lesson_of(driver.ui)->predictions.at(0);
    REQUIRE(asked.step == 1);
    REQUIRE(asked.kind == LessonPrediction::Kind::number);
    driver.hand.leave();
    REQUIRE(says("to the question"));
    const std::string name = "lesson.prediction." + asked.id;
    driver.hand.click(name + ".number");
    driver.hand.type_text("7");
    driver.hand.press(key::enter);
    driver.hand.wheel("lesson.part0.link.0", 50.0f);
    driver.hand.leave();
    CHECK_FALSE(is_whole(driver, asked));
    CHECK_FALSE(says("to the question"));
    driver.hand.press(key::page_down);
    CHECK(driver.ui.session.step == 2);
}

} // namespace rasterwalk
