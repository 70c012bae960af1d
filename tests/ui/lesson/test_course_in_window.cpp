// The course in the window: tracks in the list, the order of the buttons, the end of a track, and
// answers that are kept back.

#include <string>

#include "lessons/lesson_list.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/lesson/lesson_end.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

std::string asking_lesson(const std::string& title) {
    return "<!-- lesson\ntitle = \"" + title +
           "\"\nsection = \"Drawing points\"\nminutes = 25\nabout = \"About " + title + R"(."
program = "nothing"
scene = "scenes/lab-room.toml"
-->
# It begins

<!-- prediction
id = "count"
kind = "number"
answer = "triangle.count"
because = "There are {answer}."
misconceptions = [{ answer = "15", says = "Those are the rectangles." }]
-->
> **Prediction.** How many triangles?
)";
}

/// Three lessons, in an order that is not that of their names.
struct CourseWindow {
    test::TemporaryFolder folder;
    Driver driver{"lab-room.toml", {1600, 1000}};
    Ui& ui = driver.ui;

    explicit CourseWindow(const std::string& head = "") {
        for (const char* const id : {"01-a", "02-b", "03-c", "04-d"})
            folder.write(std::string(id) + ".md", asking_lesson(id));
        folder.write("course.toml", head + R"([[track]]
title = "Firsts"
about = "What comes first."
needs = "Nothing at all."
lessons = [{ id = "01-a" }, { id = "03-c" }]
[[track]]
title = "Seconds"
about = "What comes then."
needs = "The firsts."
lessons = [{ id = "02-b", needs = ["03-c"] }]
)");
        ui.lesson.lessons.read_folder(folder.file(""));
    }
    float top_of(const std::string& name) { return driver.hand.find(name).top_left.y; }
};

} // namespace

TEST_CASE("The list of lessons has its tracks, with their times and what they need") {
    CourseWindow window;
    window.driver.hand.press('L');
    window.driver.hand.leave();
    for (const char* const words :
         {"Firsts", "2 lessons, 50 min", "What comes first.", "Needs: Nothing at all.", "Seconds",
          "1 lesson, 25 min", "Needs: The firsts.", "Other lessons"}) {
        INFO(words);
        CHECK(shows_words(words, "lesson"));
    }
    CHECK_FALSE(shows_words("to come"));
    CHECK(window.top_of("lesson.item.01-a") < window.top_of("lesson.item.03-c"));
    CHECK(window.top_of("lesson.item.03-c") < window.top_of("lesson.item.02-b"));
    CHECK(window.top_of("lesson.item.02-b") < window.top_of("lesson.item.04-d"));
}

TEST_CASE("The list says why a course cannot be read") {
    CourseWindow window;
    window.folder.write("course.toml", "track = 5\n");
    window.ui.lesson.lessons.refresh();
    window.driver.hand.press('L');
    window.driver.hand.leave();
    CHECK(shows_words("course.toml:1:", "lesson"));
}

TEST_CASE("The next lesson is the next of the course, and the end of a track is said") {
    CourseWindow window;
    CHECK(lesson_after(window.ui, "01-a") == "03-c");
    CHECK(lesson_after(window.ui, "03-c") == "02-b");
    CHECK(lesson_after(window.ui, "02-b") == "04-d");
    CHECK(lesson_after(window.ui, "04-d").empty());
    const auto end_of = [&](const char* id) {
        const Lesson lesson = *window.ui.lesson.lessons.find(id);
        return end_of_lesson(window.ui, lesson);
    };
    CHECK(end_of("01-a").find("ends here") == std::string::npos);
    CHECK(end_of("03-c").find("*Firsts* ends here, and *Seconds* begins. Next: lesson 2, ") !=
          std::string::npos);
    CHECK(end_of("02-b").find("ends here") == std::string::npos); // the next is in no track
}

TEST_CASE("A course can keep answers back until there were two tries") {
    for (const bool keeps : {false, true}) {
        INFO(keeps);
        CourseWindow window(keeps ? "answers = \"after_tries\"\n" : "");
        open_lesson(window.ui, "01-a", 0);
        window.driver.hand.leave();
        const std::string name = "lesson.prediction.count";
        window.driver.hand.enter(name + ".number", "15");
        window.driver.hand.leave();
        CHECK(shown_text(window.driver, name + ".says") == "Those are the rectangles.");
        CHECK(window.ui.widgets.count(name + ".show") == (keeps ? 0 : 1));
        window.driver.hand.enter(name + ".number", "12");
        window.driver.hand.leave();
        CHECK(shown_text(window.driver, name + ".verdict") ==
              "You said: 12. The program says: 30.");
    }
}

TEST_CASE("The start page counts the lessons of the track that comes next") {
    CourseWindow window;
    window.ui.start.is_open = true;
    window.driver.hand.rest();
    CHECK(shows_words("Firsts: 0 of 2, 50 min · 0 of 4 lessons done · 1 h 40 min in all"));
}

TEST_CASE("The map of the course shows each lesson under its track, and opens it") {
    CourseWindow window;
    window.driver.hand.press('L');
    window.driver.hand.click("lesson.map");
    window.driver.hand.leave();
    REQUIRE(window.ui.sheets.is_open(Sheet::map));
    const WidgetPlace a = window.driver.hand.find("map.lesson.01-a");
    const WidgetPlace c = window.driver.hand.find("map.lesson.03-c");
    const WidgetPlace b = window.driver.hand.find("map.lesson.02-b");
    const WidgetPlace d = window.driver.hand.find("map.lesson.04-d");
    CHECK(a.top_left.x == c.top_left.x);
    CHECK(a.bottom_right.y < c.top_left.y);
    CHECK(c.bottom_right.x < b.top_left.x);
    CHECK(a.top_left.y == b.top_left.y);
    CHECK(b.bottom_right.x < d.top_left.x);
    CHECK(shows_words("Firsts", "map"));
    CHECK(shows_words("2 lessons, 50 min", "map"));
    window.driver.hand.hover("map.lesson.02-b");
    window.driver.hand.rest();
    CHECK(shows_words("Builds on 3 (03-c)."));
    window.driver.hand.click("map.lesson.02-b");
    window.driver.hand.leave();
    CHECK(window.ui.session.lesson == "02-b");
    CHECK_FALSE(window.ui.sheets.is_open(Sheet::map));
}

TEST_CASE("The whole map of the course is seen in a large window") {
    Driver driver("lab-room.toml", {1600, 1000});
    driver.ui.sheets.show(Sheet::map);
    driver.hand.leave();
    for (const Lesson& lesson : driver.ui.lesson.lessons.all()) {
        INFO(lesson.id);
        const WidgetPlace place = driver.hand.find("map.lesson." + lesson.id);
        CHECK(place.is_whole);
        CHECK(place.text == lesson.title);
        CHECK(shows_words(lesson.title, "map"));
    }
}

} // namespace rasterwalk
