// Questions that are asked twice, tasks that are judged at rest, and the end of a lesson.

#include <string>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/shown_number.h"
#include "text/markdown_text.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

constexpr const char* lesson_with_questions = R"(<!-- lesson
title = "Questions"
section = "Drawing points"
minutes = 5
about = "It is made for a test."
program = "nothing"
scene = "scenes/lab-room.toml"
set = ["stage=edges"]
tab = "vertices"
sources = ["An Author, *A Title*, 1990"]
-->
# Questions

It begins.

## Asked

<!-- prediction
id = "count"
kind = "number"
answer = "triangle.count"
unit = "triangles"
then = { tab = "rows", set = ["stage=depth"] }
because = "There are {answer}. Five walls have two each. Two blocks have ten each. None has a bottom. You would not see it. So it is left out. That saves four triangles, and the time to draw them. It saves no pixel."
misconceptions = [{ answer = "15", says = "Those are the rectangles." }]
-->
> **Prediction.** How many triangles?

<!-- prediction
id = "colour"
kind = "choice"
choices = ["red", "green", "blue"]
right = ["triangle.count == 1", "triangle.count == 30", "triangle.count == 2"]
because = "It is green."
misconceptions = [{ answer = "red", says = "That is the block." }, { answer = "blue", says = "That is the other block." }]
-->
> **Prediction.** What colour is the floor?

## Turned

<!-- control
setting = "camera.focal_length"
from = 400
to = 600
step = 10
-->

<!-- task
id = "turn"
done = "camera.focal_length == 550"
recipe = ["set:camera.focal_length=550"]
because = "It is {camera.focal_length} now."
not_yet = [{ when = "camera.focal_length != 500", says = "it is {camera.focal_length}." }]
-->
> **Task.** Make it 550.

<!-- task
id = "later"
done = "cursor == t3"
recipe = ["cursor:t3"]
because = "It is there."
not_yet = [{ when = "cursor != end", says = "not there." }]
-->
> **Task.** Go there.
)";

struct Questions {
    test::TemporaryFolder folder;
    Driver driver;
    Ui& ui = driver.ui;

    explicit Questions(int step, ImVec2 window = {1600, 1000}, float text_scale = 1.0f)
        : driver("lab-room.toml", window, text_scale) {
        folder.write("01-questions.md", lesson_with_questions);
        folder.write("02-after.md", lesson_with_questions);
        ui.lesson.lessons.read_folder(folder.file(""));
        open_lesson(ui, "01-questions", step);
        driver.hand.leave();
        driver.hand.frames(2 * frames_to_rest);
        REQUIRE(ui.session.notice.empty());
    }
    void answer(const std::string& number) {
        driver.hand.enter("lesson.prediction.count.number", number);
        driver.hand.leave();
    }
    bool is_there(const std::string& name) const { return ui.widgets.count(name) > 0; }
    std::string said(const std::string& name) { return shown_text(driver, name); }
    const FirstAnswer& kept(const std::string& id) const {
        return ui.lesson.progress.of("01-questions").answers.at(id);
    }
    bool is_done(const std::string& task) const {
        return ui.lesson.progress.is_task_done("01-questions", task);
    }
};

constexpr const char* count = "lesson.prediction.count";

} // namespace

TEST_CASE(
    "A wrong first answer gets a reply, and the question is asked once more before the answer") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Questions q(1, window.size, window.text_scale);
        const std::string name = count;
        q.answer("15");
        CHECK(q.said(name + ".verdict") == "You said: 15 triangles.");
        CHECK(q.said(name + ".says") == "Those are the rectangles.");
        CHECK_FALSE(q.is_there(name + ".again"));
        CHECK(q.is_there(name + ".show"));
        CHECK(q.ui.session.a.settings.stage == Stage::edges); // the answer is not shown yet
        CHECK(q.ui.lesson.predictions.at("count").typed.empty());
        q.answer("30");
        CHECK(q.said(name + ".verdict") == "Right on the second try: 30 triangles.");
        CHECK(q.is_there(name + ".again"));
        CHECK_FALSE(q.is_there(name + ".show"));
        CHECK(q.ui.session.a.settings.stage == Stage::depth);
        // The first answer is the one that is kept.
        CHECK(q.kept("count") == FirstAnswer{"15 triangles", false, false, "30 triangles"});
        // Asked again, the field is empty and the answer off the screen.
        q.driver.hand.click(name + ".again");
        CHECK(q.ui.lesson.predictions.at("count").typed.empty());
        CHECK(q.ui.session.a.settings.stage == Stage::edges);
        q.answer("12");
        CHECK(q.said(name + ".verdict") ==
              "You said: 12 triangles. The program says: 30 triangles.");
        // The second answer is kept, too: it comes back with the step, and with its picture on
        // request.
        open_lesson(q.ui, "02-after", 0);
        q.driver.hand.rest();
        open_lesson(q.ui, "01-questions", 1);
        q.driver.hand.leave();
        if (q.ui.lesson.is_strip) q.driver.hand.click("lesson.card.0");
        q.driver.hand.frames(2 * frames_to_rest);
        CHECK(q.said(name + ".verdict") == "Right on the second try: 30 triangles.");
        CHECK(q.ui.session.a.settings.stage == Stage::edges);
        q.driver.hand.click(name + ".show");
        q.driver.hand.leave();
        CHECK(q.ui.session.a.settings.stage == Stage::depth);
        CHECK_FALSE(q.is_there(name + ".show"));
    }
}

TEST_CASE("Two wrong answers, or the wish to see it, show the answer") {
    Questions q(1);
    const std::string name = count;
    q.answer("15");
    q.answer("16");
    CHECK(q.said(name + ".verdict") == "You said: 16 triangles. The program says: 30 triangles.");
    CHECK(q.kept("count") == FirstAnswer{"15 triangles", false, false, "16 triangles"});
    const std::string colour = "lesson.prediction.colour";
    q.driver.hand.click(colour + ".choice.0");
    q.driver.hand.leave();
    CHECK(q.said(colour + ".says") == "That is the block.");
    // What was chosen cannot be chosen again.
    CHECK_FALSE(q.is_there(colour + ".choice.0"));
    CHECK(q.is_there(colour + ".choice.1"));
    q.driver.hand.click(colour + ".show");
    q.driver.hand.leave();
    CHECK(q.said(colour + ".verdict") == "You said: “red”. The program says: “green”.");
    CHECK_FALSE(q.kept("colour").has_second_try);
}

TEST_CASE("A wrong answer that was not foreseen has a second try all the same") {
    Questions q(1);
    q.answer("7");
    CHECK_FALSE(q.said(std::string(count) + ".says").empty());
    CHECK(q.is_there(std::string(count) + ".show"));
}

TEST_CASE("A second try that was left is there when the step is opened again") {
    Questions q(1);
    q.answer("15");
    open_lesson(q.ui, "01-questions", 0);
    q.driver.hand.rest();
    open_lesson(q.ui, "02-after", 0);
    q.driver.hand.rest();
    open_lesson(q.ui, "01-questions", 1);
    q.driver.hand.leave();
    q.driver.hand.rest();
    CHECK(q.said(std::string(count) + ".says") == "Those are the rectangles.");
    CHECK(q.is_there(std::string(count) + ".number"));
}

TEST_CASE("A task is not solved by what a slider passes on its way, and says what a try misses") {
    Questions q(2);
    const std::string slider = "lesson.control.camera.focal_length";
    const float& f = q.ui.session.a.settings.camera.focal_length;
    const WidgetPlace place = q.driver.hand.find(slider);
    const float middle = 0.5f * (place.top_left.y + place.bottom_right.y);
    CHECK_FALSE(q.is_there("lesson.task.turn.words"));
    q.driver.hand.hover(slider);
    play_mouse_button(0, true);
    q.driver.hand.frames(2);
    bool was_there = false;
    for (float x = place.top_left.x; x < place.bottom_right.x + 40.0f; x += 1.0f) {
        play_pointer({x, middle});
        q.driver.hand.frames(2);
        was_there = was_there || f == 550.0f;
        CHECK_FALSE(q.is_done("turn"));
    }
    CHECK(was_there);
    REQUIRE(f == 600.0f);
    play_mouse_button(0, false);
    q.driver.hand.rest();
    q.driver.hand.leave();
    CHECK_FALSE(q.is_done("turn"));
    CHECK(q.said("lesson.task.turn.words") == "it is 600.");
    q.driver.hand.enter(slider, "550");
    q.driver.hand.leave();
    CHECK(q.is_done("turn"));
    CHECK(q.said("lesson.task.turn.words") == "It is 550 now.");
    // What it says stays true of the moment when it was solved.
    q.driver.hand.enter(slider, "420");
    q.driver.hand.leave();
    CHECK(q.is_done("turn"));
    CHECK(q.said("lesson.task.turn.words") == "It is 550 now.");
}

TEST_CASE("A task is not solved by time that runs past its moment") {
    Questions q(2);
    q.driver.hand.press(key::home);
    q.ui.session.play.granularity = Granularity::triangle;
    q.driver.hand.press(key::space);
    REQUIRE(q.ui.session.play.running);
    const Cursor wanted{3, Phase::vertices, 0, 0};
    bool was_there = false;
    for (int i = 0; i < 4000 && q.ui.session.play.running; ++i) {
        q.driver.hand.frames(1, 0.02f);
        was_there = was_there || q.ui.results.a.cursor == wanted;
    }
    CHECK(was_there);
    CHECK_FALSE(q.is_done("later"));
    q.driver.hand.press(key::home);
    for (int i = 0; i < 3; ++i)
        q.driver.hand.press(key::right_bracket);
    q.driver.hand.rest();
    REQUIRE(q.ui.session.cursor == wanted);
    CHECK(q.is_done("later"));
}

TEST_CASE("The last step says what was done, where to go next, and what the lesson is based on") {
    Questions q(1);
    q.answer("30");
    q.driver.hand.click("lesson.prediction.colour.choice.0");
    q.driver.hand.click("lesson.prediction.colour.choice.1");
    open_lesson(q.ui, "01-questions", 2);
    q.driver.hand.enter("lesson.control.camera.focal_length", "550");
    q.driver.hand.leave();
    const std::string end = q.said("lesson.end");
    CHECK(end.find("1 of 2 predictions right on the first try, 1 of 2 tasks done.") != end.npos);
    CHECK(end.find("Next: lesson 2, [Questions](02-after.md).") != end.npos);
    CHECK(end.find("An Author, *A Title*, 1990") != end.npos);
    q.driver.hand.click("lesson.end.link.0");
    CHECK(q.ui.session.lesson == "02-after");
    // Not on any other step.
    q.driver.hand.leave();
    CHECK_FALSE(q.is_there("lesson.end"));
}

TEST_CASE("In a strip a long reason is paged to its last sentence, and so is the end") {
    Questions q(1, {1024, 640}, 1.5f);
    REQUIRE(q.ui.lesson.is_strip);
    q.answer("30");
    const LessonStrip& strip = q.ui.lesson.strip;
    const auto card = [&] { return strip.cards.at(static_cast<std::size_t>(strip.card)); };
    const int part = card().part;
    std::string read = plain_text(card().page.blocks);
    int cards = 1;
    for (; cards < 20; ++cards) {
        q.driver.hand.press(key::page_down);
        q.driver.hand.leave();
        if (q.ui.session.step != 1 || card().part != part) break;
        read += " " + plain_text(card().page.blocks);
    }
    CHECK(cards > 1);
    const std::string& because = q.ui.lesson.predictions.at("count").judged->because;
    CHECK(read == plain_text(parse_markdown(because).blocks));
    open_lesson(q.ui, "01-questions", 2);
    q.driver.hand.leave();
    REQUIRE(q.is_there("lesson.card.end"));
    q.driver.hand.click("lesson.card.end");
    const auto end_part = static_cast<int>(open_lesson_of(q.ui)->steps.back().parts.size());
    std::string end;
    for (const LessonCard& one : strip.cards) {
        if (one.part == end_part) end += plain_text(one.page.blocks);
    }
    CHECK(end.find("1990") != end.npos);
}

TEST_CASE("A second try is made by the keyboard alone, and no key gives the answer away") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.0f}}) {
        INFO(window.size.x);
        Questions q(1, window.size, window.text_scale);
        const std::string name = "lesson.prediction.colour";
        if (q.ui.lesson.is_strip) q.driver.hand.click("lesson.card.1");
        const std::vector<int> order = open_lesson_of(q.ui)->predictions.at(1).order;
        const int first = order.front() == 1 ? order.at(1) : order.front(); // 1 is right
        REQUIRE(q.driver.tab_to(name + ".choice." + std::to_string(first)));
        q.driver.hand.press(key::enter);
        q.driver.hand.rest();
        CHECK(q.kept("colour").has_second_try);
        // The frame is on a choice that is left.
        const int left = order.front() == first ? order.at(1) : order.front();
        CHECK(q.ui.focus.name == name + ".choice." + std::to_string(left));
        q.driver.hand.press(key::enter);
        q.driver.hand.rest();
        CHECK_FALSE(q.kept("colour").has_second_try);
        CHECK(q.ui.focus.name == name + ".again");
    }
}

TEST_CASE("Progress that is forgotten takes the reasons off the strip's cards") {
    Questions q(1, {1024, 640}, 1.5f);
    q.answer("30");
    REQUIRE(q.ui.lesson.strip.cards.size() > 2);
    reset_progress(q.ui);
    q.driver.hand.rest();
    for (const LessonCard& card : q.ui.lesson.strip.cards)
        CHECK(plain_text(card.page.blocks).find("bottom") == std::string::npos);
}

TEST_CASE("Two answers that were kept come back to the strip, each with its reason") {
    Questions q(1, {1024, 640}, 1.5f);
    q.answer("30");
    q.driver.hand.click("lesson.card.1");
    q.driver.hand.click("lesson.prediction.colour.choice.1");
    q.driver.hand.leave();
    const auto said = [&] {
        std::string all;
        for (const LessonCard& card : q.ui.lesson.strip.cards)
            all += plain_text(card.page.blocks);
        return all;
    };
    const std::string before = said();
    REQUIRE(before.find("It is green.") != before.npos);
    open_lesson(q.ui, "02-after", 0);
    q.driver.hand.rest();
    open_lesson(q.ui, "01-questions", 1);
    q.driver.hand.leave();
    q.driver.hand.frames(2 * frames_to_rest);
    CHECK(said() == before);
}

TEST_CASE("The word for the end leads there in the whole text, too") {
    Questions q(2, {1024, 640}, 1.5f);
    q.driver.hand.press('T');
    q.driver.hand.leave();
    REQUIRE(q.ui.lesson.drawer_is_open);
    q.driver.hand.click("lesson.card.end");
    q.driver.hand.frames(2 * frames_to_rest);
    CHECK(q.driver.hand.is_visible("lesson.end"));
}

TEST_CASE("After a wrong number the field is ready for another, and no digit goes elsewhere") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.0f}}) {
        INFO(window.size.x);
        Questions q(1, window.size, window.text_scale);
        q.driver.hand.click(std::string(count) + ".number");
        q.driver.hand.type_text("15");
        q.driver.hand.press(key::enter);
        const StripStep stage = step_of(q.ui.session.a.settings);
        q.driver.hand.rest();
        q.driver.hand.type_text("30");
        CHECK(q.ui.lesson.predictions.at("count").typed == "30");
        CHECK(step_of(q.ui.session.a.settings) == stage);
        q.driver.hand.press(key::enter);
        q.driver.hand.rest();
        CHECK(q.kept("count").second == "30 triangles");
        // Asked again, it is ready too.
        q.driver.hand.click(std::string(count) + ".again");
        q.driver.hand.rest();
        q.driver.hand.type_text("29");
        CHECK(q.ui.lesson.predictions.at("count").typed == "29");
    }
}

TEST_CASE("In a lecture Page down shows the answer that has not been given to a question") {
    Questions q(1, {1280, 800});
    q.driver.hand.press(key::f5);
    q.driver.hand.leave();
    q.driver.hand.rest();
    const std::string name = count;
    REQUIRE(q.is_there(name + ".number"));
    q.driver.hand.press(key::page_down);
    q.driver.hand.rest();
    CHECK(q.said(name + ".verdict") == "The program says: 30 triangles.");
    CHECK(q.ui.session.a.settings.stage == Stage::depth);
    // It does not count as an answer.
    CHECK(q.ui.lesson.progress.of("01-questions").answers.empty());
    const std::string colour = "lesson.prediction.colour";
    for (int i = 0; i < 8 && !q.is_there(colour + ".choice.0"); ++i) {
        q.driver.hand.press(key::page_down);
        q.driver.hand.rest();
    }
    REQUIRE(q.is_there(colour + ".choice.0"));
    q.driver.hand.press(key::page_down);
    q.driver.hand.rest();
    CHECK(q.said(colour + ".verdict") == "The program says: “green”.");
    CHECK(q.ui.session.step == 1);
}

} // namespace rasterwalk
