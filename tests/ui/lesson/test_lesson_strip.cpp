// The lesson as a strip above the canvas, in windows without room for a column.

#include <algorithm>

#include <imgui_internal.h>

#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "text/markdown_text.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

struct StripWindow {
    ImVec2 size;
    float text;
};

const std::vector<StripWindow> narrow_windows{
    {{1024, 640}, 1.5f}, {{1024, 640}, 1.0f}, {{800, 600}, 1.0f}, {{640, 480}, 1.0f}};

bool is_there(const Driver& driver, const std::string& name) {
    return driver.ui.widgets.count(name) > 0;
}

/// The number of the step that contains a prediction of a lesson.
int step_of_prediction(Driver& driver, const char* lesson, const char* id) {
    const Lesson* const found = driver.ui.lesson.lessons.find(lesson);
    REQUIRE(found != nullptr);
    return find_prediction(*found, id)->step;
}

/// Turns the cards of the current step until a prediction is asked.
void turn_to_prediction(Driver& driver, const std::string& id) {
    const std::string name = "lesson.prediction." + id;
    driver.hand.leave();
    for (int i = 0; i < 40 && !is_there(driver, name); ++i) {
        driver.hand.press(key::page_down);
        driver.hand.leave();
    }
}

/// The cards of the current step.
const std::vector<LessonCard>& cards(const Driver& driver) {
    return driver.ui.lesson.strip.cards;
}

/// How much of the current card is scrolled away, screen pixels.
float hidden_of_card() {
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
        const std::string_view name = window->Name;
        if (window->Active && name.find("lesson.strip.text") != name.npos)
            return window->ScrollMax.y;
    }
    FAIL("there is no card");
    return 0.0f;
}

/// The last card of the text that the current step begins with.
int last_card_of_text(const Driver& driver) {
    int last = 0;
    while (cards(driver)[static_cast<std::size_t>(last + 1)].part == 0)
        ++last;
    return last;
}

} // namespace

TEST_CASE("The strip asks a number, and says what the program says") {
    for (const StripWindow& window : narrow_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        const int step = step_of_prediction(driver, "05-row-table", "rows-of-it");
        open_lesson(driver.ui, "05-row-table", step);
        turn_to_prediction(driver, "rows-of-it");
        CHECK(driver.ui.session.step == step);
        const std::string name = "lesson.prediction.rows-of-it";
        REQUIRE(driver.hand.is_visible(name + ".number"));
        CHECK(driver.ui.widgets.at(name + ".number").is_whole);
        CHECK(driver.ui.widgets.at(name + ".answer").is_whole);
        driver.hand.click(name + ".number");
        driver.hand.type_text("30");
        driver.hand.press(key::enter); // by the keyboard alone
        driver.hand.leave();
        CHECK(driver.hand.is_visible(name + ".verdict"));
        driver.hand.click(name + ".show");
        driver.hand.leave();
        CHECK_FALSE(driver.ui.lesson.predictions.at("rows-of-it").judged->is_right);
        CHECK(driver.ui.lesson.predictions.at("rows-of-it").judged->number == 31.0);
        CHECK(driver.hand.is_visible(name + ".verdict"));
        driver.hand.click(name + ".again");
        driver.hand.click(name + ".number");
        driver.hand.type_text("31");
        driver.hand.click(name + ".answer");
        CHECK(driver.ui.lesson.predictions.at("rows-of-it").judged->is_right);
        // The text is one click away, and so is the answer.
        driver.hand.click("lesson.card.text");
        driver.hand.leave();
        CHECK_FALSE(is_there(driver, name + ".verdict"));
    }
}

TEST_CASE("A link in what the program says leads to the other lesson's own card") {
    Driver driver("lab-room.toml", {1024, 640});
    open_lesson(driver.ui, "03-points", step_of_prediction(driver, "03-points", "uncovered"));
    turn_to_prediction(driver, "uncovered");
    driver.hand.click("lesson.prediction.uncovered.number");
    driver.hand.type_text("998");
    driver.hand.press(key::enter);
    driver.hand.leave();
    const auto link =
        std::find_if(driver.ui.widgets.begin(), driver.ui.widgets.end(), [](const auto& widget) {
            return widget.first.starts_with("lesson.prediction.uncovered") &&
                   widget.first.find(".link.") != std::string::npos;
        });
    REQUIRE(link != driver.ui.widgets.end());
    driver.hand.click(std::string(link->first));
    CHECK(driver.ui.session.lesson == "12-float-traps");
    CHECK(driver.ui.lesson.strip.card == 0);
    CHECK(driver.ui.lesson.predictions.count("uncovered") == 0);
}

TEST_CASE("Every prediction of every lesson can be answered in the strip") {
    for (const StripWindow& window : test::some_of(narrow_windows, 1)) {
        Driver driver("lab-room.toml", window.size, window.text);
        const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
        int asked = 0;
        for (const Lesson& lesson : test::some_of(lessons, 3)) {
            for (const LessonPrediction& prediction : lesson.predictions) {
                INFO(lesson.id << ", " << prediction.id << " at " << window.size.x << " x "
                               << window.size.y << ", text " << window.text);
                open_lesson(driver.ui, lesson.id, prediction.step);
                turn_to_prediction(driver, prediction.id);
                const std::string name = "lesson.prediction." + prediction.id;
                if (prediction.kind == LessonPrediction::Kind::choice) {
                    for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
                        // A long list scrolls.
                        CHECK(driver.hand.find(name + ".choice." + std::to_string(i)).is_whole);
                    }
                    driver.hand.click(name + ".choice.0");
                } else if (prediction.kind == LessonPrediction::Kind::number) {
                    driver.hand.click(name + ".number");
                    driver.hand.type_text("7");
                    driver.hand.press(key::enter);
                } else {
                    driver.ui.session.selection.pixel = {1, 1};
                    driver.hand.leave();
                    driver.hand.click(name + ".answer");
                }
                driver.hand.leave();
                CHECK(driver.ui.lesson.predictions.at(prediction.id).judged.has_value());
                CHECK(is_there(driver, name + ".verdict"));
                ++asked;
            }
        }
        CHECK(asked > 5);
    }
}

TEST_CASE("The whole text opens in place of strip and table, and closes by its button, by Escape, "
          "by a choice") {
    for (const StripWindow& window : narrow_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        open_lesson(driver.ui, "05-row-table", 2);
        driver.hand.leave();
        const auto is_open = [&] {
            driver.hand.leave();
            return is_there(driver, "lesson.list");
        };
        REQUIRE_FALSE(is_open());
        const ImVec2 canvas = driver.ui.widgets.at("canvas").top_left;
        driver.hand.click("lesson.whole");
        REQUIRE(is_open());
        CHECK(driver.ui.widgets.at("canvas").top_left.x == canvas.x); // nothing jumps
        CHECK_FALSE(is_there(driver, "rows.header.left"));
        driver.hand.click("lesson.whole");
        CHECK_FALSE(is_open());
        CHECK(is_there(driver, "rows.header.left"));

        driver.hand.press('T');
        CHECK(is_open());
        driver.hand.press(key::escape);
        CHECK_FALSE(is_open());

        // It stays while the steps are walked, and closes when another lesson is chosen.
        driver.hand.press('T');
        for (int i = 0; i < 20 && driver.ui.session.step == 2; ++i)
            driver.hand.click("lesson.next");
        CHECK(is_open());
        CHECK(driver.ui.session.step == 3);
        driver.hand.press('L');
        driver.hand.click("lesson.item.06-filling");
        CHECK(driver.ui.session.lesson == "06-filling");
        CHECK_FALSE(is_open());
    }
}

TEST_CASE("A card that has no room is scrolled by the key before the next one comes") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "09-light-per-vertex", 7);
    driver.hand.leave();
    const LessonView& lesson = driver.ui.lesson;
    for (int i = 0; i < 30 && !lesson.has_more_below; ++i) {
        driver.hand.press(key::page_down);
        driver.hand.leave();
    }
    REQUIRE(lesson.has_more_below);
    const int card = lesson.strip.card;
    const std::string bar = "lesson.step.7";
    const float head = driver.hand.find(bar).top_left.y;
    driver.hand.press(key::page_down);
    driver.hand.leave();
    CHECK(lesson.strip.card == card);
    CHECK(lesson.has_more_above);
    // The title stays.
    CHECK(driver.ui.widgets.at(bar).is_whole);
    CHECK(driver.ui.widgets.at(bar).top_left.y == head);
    for (int i = 0; i < 5 && lesson.has_more_below; ++i) {
        driver.hand.press(key::page_down);
        driver.hand.leave();
    }
    driver.hand.press(key::page_down);
    driver.hand.leave();
    CHECK(lesson.strip.card == card + 1);
    CHECK_FALSE(lesson.has_more_above);
}

TEST_CASE("No card is scrolled for less than a line") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    const float line = 32.0f; // as high as code is set, screen pixels
    const std::vector<Lesson> all = driver.ui.lesson.lessons.all();
    std::vector<Lesson> lessons = test::some_of(all, 2);
    lessons.push_back(*driver.ui.lesson.lessons.find("04-edges"));
    for (const Lesson& lesson : lessons) {
        for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
            open_lesson(driver.ui, lesson.id, step);
            driver.hand.leave();
            for (int i = 0; i < static_cast<int>(cards(driver).size()); ++i) {
                INFO(lesson.id << ", step " << step << ", card " << i);
                driver.ui.lesson.strip.card = i;
                driver.hand.leave();
                const float hidden = hidden_of_card();
                CHECK((hidden < 1.0f || hidden > line));
            }
        }
    }
}

TEST_CASE(
    "A key turns the cards where a tab or the settings took the place of the list of lessons") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "05-row-table", 5);
    driver.hand.press('L');
    REQUIRE(is_there(driver, "lesson.item.05-row-table"));
    const auto turns_a_card = [&] {
        driver.hand.leave();
        const int card = driver.ui.lesson.strip.card;
        driver.hand.press(key::page_down);
        driver.hand.leave();
        CHECK(driver.ui.session.step == 5);
        CHECK(driver.ui.lesson.strip.card == card + 1);
    };
    SECTION("a tab") {
        open_tab(driver.ui, "rows");
        turns_a_card();
        driver.hand.press('T');
        driver.hand.leave();
        CHECK_FALSE(is_there(driver, "lesson.item.05-row-table"));
    }
    SECTION("the settings, which give it back") {
        driver.hand.press(key::comma, {.ctrl = true});
        REQUIRE(is_there(driver, "settings.close"));
        driver.hand.leave();
        turns_a_card();
        driver.hand.click("settings.close");
        driver.hand.leave();
        CHECK(is_there(driver, "lesson.item.05-row-table"));
    }
    SECTION("a window with room for both") {
        driver.resize({1900, 1000});
        REQUIRE(is_there(driver, "lesson.item.05-row-table"));
        driver.open("rows");
        CHECK(is_there(driver, "lesson.item.05-row-table"));
        driver.resize({1024, 640});
        turns_a_card();
    }
}

TEST_CASE("The list of lessons has a line for each in a strip's drawer") {
    for (const StripWindow& window : narrow_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        driver.hand.press('L');
        driver.hand.leave();
        int whole = 0;
        for (const auto& [name, place] : driver.ui.widgets) {
            if (!name.starts_with("lesson.item.")) continue;
            whole += place.is_whole ? 1 : 0;
            const float height = place.bottom_right.y - place.top_left.y;
            if (place.is_whole) CHECK(height < 3.5f * driver.ui.fonts.text->FontSize);
        }
        CHECK(whole >= 5);
    }
}

TEST_CASE("A session that reads the list of lessons begins with it, in a small window too") {
    for (const StripWindow& window : narrow_windows) {
        Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        session.page = SidePage::list;
        Driver driver(std::move(session), window.size, window.text);
        driver.hand.leave();
        CHECK(driver.hand.is_visible("lesson.item.01-pinhole-camera"));
        driver.hand.press('L');
        driver.hand.leave();
        CHECK_FALSE(is_there(driver, "lesson.item.01-pinhole-camera"));
    }
}

TEST_CASE("Steps, list and hints of a lesson are reached by the keyboard alone") {
    Driver driver("lab-room.toml", {1024, 640});
    driver.hand.press('L');
    driver.hand.leave();
    CHECK(is_there(driver, "lesson.item.05-row-table"));
    driver.hand.press('L');
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "lesson.item.05-row-table"));
    open_lesson(driver.ui, "05-row-table", 0);
    const Lesson* const lesson = open_lesson_of(driver.ui);
    const int last = static_cast<int>(lesson->steps.size()) - 1;
    driver.hand.leave();
    // Each key shows another card, or more of one that is scrolled, and each card of each step is
    // shown.
    std::size_t turned = 0, scrolled = 0, there = cards(driver).size();
    for (int step = 0; turned + scrolled < 500;) {
        const int card = driver.ui.lesson.strip.card;
        const int here = step;
        const bool has_more = driver.ui.lesson.has_more_below;
        driver.hand.press(key::page_down);
        driver.hand.leave();
        step = driver.ui.session.step;
        if (step == here && driver.ui.lesson.strip.card == card) {
            if (!has_more) break;
            ++scrolled;
            continue;
        }
        CHECK((step == here ? driver.ui.lesson.strip.card == card + 1
                            : step == here + 1 && driver.ui.lesson.strip.card == 0));
        if (step != here) there += cards(driver).size();
        ++turned;
    }
    CHECK(driver.ui.session.step == last);
    CHECK(turned + 1 == there);
    for (std::size_t i = 0; i < turned + scrolled; ++i) {
        driver.hand.press(key::page_up);
        driver.hand.leave();
    }
    driver.hand.leave();
    CHECK(driver.ui.session.step == 0);
    CHECK(driver.ui.lesson.strip.card == 0);
}

TEST_CASE("A step with a question begins with its text, and all of it comes before the question") {
    for (const bool is_lecture : {false, true}) {
        Driver driver("lab-room.toml", {1024, 640}, 1.5f);
        const int step = step_of_prediction(driver, "05-row-table", "passes-the-test");
        open_lesson(driver.ui, "05-row-table", step);
        if (is_lecture) driver.hand.press(key::f5);
        driver.hand.leave();
        const std::string name = "lesson.prediction.passes-the-test";
        std::string read;
        while (!is_there(driver, name)) {
            const LessonStrip& strip = driver.ui.lesson.strip;
            REQUIRE(strip.card + 1 < static_cast<int>(strip.cards.size()));
            read +=
                plain_text(cards(driver)[static_cast<std::size_t>(strip.card)].page.blocks) + ' ';
            driver.hand.click("lesson.next");
            driver.hand.leave();
        }
        CHECK(driver.ui.session.step == step);
        CHECK(read.find("This is the table") == 0);
        CHECK(read.find("one sample for each row") != std::string::npos);
        // The question goes on to the next step, in a lecture over its answer, and Page up comes
        // back to it.
        for (int i = 0; i < (is_lecture ? 8 : 1) && driver.ui.session.step == step; ++i) {
            driver.hand.press(key::page_down);
            driver.hand.leave();
        }
        CHECK(driver.ui.session.step == step + 1);
        driver.hand.press(key::page_up);
        driver.hand.leave();
        CHECK(driver.ui.session.step == step);
        if (!is_lecture) CHECK(is_there(driver, name));
    }
}

TEST_CASE("The whole text takes the strip's place, as high as the window lets it be") {
    for (const StripWindow& window : narrow_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        open_lesson(driver.ui, "05-row-table", 5);
        driver.hand.leave();
        const WidgetPlace next = driver.ui.widgets.at("lesson.next");
        const WidgetPlace canvas = driver.ui.widgets.at("canvas");
        driver.hand.press('T');
        driver.hand.leave();
        const WidgetPlace grid = driver.ui.widgets.at("canvas");
        CHECK(grid.is_whole);
        CHECK(grid.bottom_right.y - grid.top_left.y > canvas.bottom_right.y - canvas.top_left.y);
        CHECK(grid.bottom_right.x - grid.top_left.x >= 200.0f * driver.ui.options.text_scale);
        // The way on stays where it was, and so does what the step has.
        CHECK(driver.ui.widgets.at("lesson.next").top_left.x == next.top_left.x);
        CHECK(driver.ui.widgets.at("lesson.next").top_left.y == next.top_left.y);
        CHECK(is_there(driver, "lesson.card.text"));
        CHECK(driver.ui.widgets.at("lesson.whole").is_whole);
        // By the keyboard the text is read to its end before the next step comes.
        CHECK(driver.ui.lesson.has_more_below);
        int pages = 0;
        while (driver.ui.session.step == 5 && pages < 30) {
            driver.hand.press(key::page_down);
            driver.hand.leave();
            ++pages;
        }
        CHECK(pages > 1);
        CHECK(driver.ui.session.step == 6);
        CHECK_FALSE(driver.ui.lesson.has_more_above);
    }
}

TEST_CASE("A word leads to its part of the whole text, which opens at what the strip shows") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "05-row-table",
                step_of_prediction(driver, "05-row-table", "passes-the-test"));
    turn_to_prediction(driver, "passes-the-test");
    driver.hand.press('T');
    driver.hand.leave();
    const std::string name = "lesson.prediction.passes-the-test";
    CHECK(driver.hand.is_visible(name + ".choice.0"));
    driver.hand.click("lesson.card.text");
    driver.hand.leave();
    CHECK_FALSE(driver.ui.lesson.has_more_above);
    CHECK_FALSE(driver.hand.is_visible(name + ".choice.0"));
}

TEST_CASE("Strip and whole text each go on where the other was read") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    const LessonView& lesson = driver.ui.lesson;
    const auto press = [&](int what) {
        driver.hand.press(what);
        driver.hand.leave();
    };
    open_lesson(driver.ui, "05-row-table", 5);
    driver.hand.leave();
    const int last = last_card_of_text(driver);
    REQUIRE(last > 0);
    press('T');
    CHECK_FALSE(lesson.has_more_above);
    press('T');
    CHECK(lesson.strip.card == 0);
    for (int i = 0; i < last; ++i)
        press(key::page_down);
    REQUIRE(lesson.strip.card == last);
    press('T');
    CHECK(lesson.has_more_above); // within the first part
    press('T');
    CHECK(lesson.strip.card == last);
    // The strip continues where the whole text was scrolled to.
    press('T');
    while (lesson.has_more_above)
        press(key::page_up);
    press('T');
    CHECK(lesson.strip.card == 0);
    press('T');
    while (lesson.has_more_below)
        press(key::page_down);
    press('T');
    CHECK(lesson.strip.card + 1 == static_cast<int>(cards(driver).size()));
    // The list of lessons begins at its beginning all the same.
    press('T');
    press('L');
    CHECK_FALSE(lesson.has_more_above);
    press('L');
    // The same holds where another tab takes the text's place.
    press('T');
    driver.hand.click("lesson.card.text");
    driver.hand.leave();
    open_tab(driver.ui, "rows");
    driver.hand.leave();
    CHECK(lesson.strip.card == 0);
}

TEST_CASE("A window of another width leaves the strip at its place in the text") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "05-row-table", 5);
    driver.hand.leave();
    const int last = last_card_of_text(driver);
    REQUIRE(last > 0);
    for (int i = 0; i < last; ++i)
        driver.hand.press(key::page_down);
    driver.hand.leave();
    const std::string text = plain_text(cards(driver)[static_cast<std::size_t>(last)].page.blocks);
    REQUIRE(driver.ui.lesson.strip.card == last);
    driver.resize({1100, 640});
    driver.hand.leave();
    const auto card = static_cast<std::size_t>(driver.ui.lesson.strip.card);
    CHECK(plain_text(cards(driver)[card].page.blocks).find(text.substr(0, 20)) !=
          std::string::npos);
}

TEST_CASE("Page up in the whole text goes to the end of the previous step, and in a column to its "
          "beginning") {
    Driver driver("lab-room.toml", {1024, 640});
    const LessonView& lesson = driver.ui.lesson;
    open_lesson(driver.ui, "05-row-table", 6);
    driver.hand.press('T');
    driver.hand.leave();
    driver.hand.press(key::page_up);
    driver.hand.leave();
    CHECK(driver.ui.session.step == 5);
    CHECK(lesson.has_more_above);
    CHECK_FALSE(lesson.has_more_below);
    driver.hand.press('T');
    driver.hand.leave();
    CHECK(lesson.strip.card + 1 == static_cast<int>(cards(driver).size()));

    driver.resize({1600, 1000});
    driver.hand.leave();
    REQUIRE_FALSE(lesson.is_strip);
    driver.hand.press(key::page_up);
    driver.hand.leave();
    CHECK(driver.ui.session.step == 4);
    driver.resize({1024, 640});
    driver.hand.leave();
    REQUIRE(cards(driver).size() > 1);
    CHECK(lesson.strip.card == 0);
}

TEST_CASE("The strip has the way on at the same place in every step, 86 wide") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    std::optional<float> left;
    for (const Lesson& lesson : test::some_of(lessons, 2)) {
        for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
            open_lesson(driver.ui, lesson.id, step);
            driver.hand.rest();
            const bool is_end = step + 1 == static_cast<int>(lesson.steps.size());
            if (is_end && !is_there(driver, "lesson.next")) continue; // of the last lesson
            const WidgetPlace& next = driver.ui.widgets.at("lesson.next");
            INFO(lesson.id << ", step " << step);
            CHECK(next.is_whole);
            CHECK(next.bottom_right.x - next.top_left.x == Approx(86.0f * 1.5f));
            if (left) CHECK(next.top_left.x == *left);
            left = next.top_left.x;
        }
    }
}

TEST_CASE("A task is shown in the strip, ticked off there, and its hint can be asked for") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    const Lesson* const lesson = driver.ui.lesson.lessons.find("05-row-table");
    REQUIRE(lesson != nullptr);
    const LessonTask task = lesson->tasks.at(0);
    open_lesson(driver.ui, "05-row-table", task.step);
    const auto& parts = lesson->steps[static_cast<std::size_t>(task.step)].parts;
    std::size_t card = 0;
    while (parts[card].kind != LessonPart::Kind::task)
        ++card;
    driver.hand.leave();
    driver.hand.click("lesson.card." + std::to_string(card));
    driver.hand.click("lesson.task." + task.id + ".hint");
    CHECK(driver.ui.lesson.open_hints.count(task.id) == 1);
    CHECK_FALSE(driver.ui.lesson.progress.is_task_done("05-row-table", task.id));
    driver.ui.session.cursor = {0, Phase::edges, 2, 6};
    driver.hand.rest();
    CHECK(driver.ui.lesson.progress.is_task_done("05-row-table", task.id));
}

TEST_CASE("Without a lesson the strip walks through the stages") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.hand.press('1');
    for (int i = 1; i < stage_count; ++i) {
        driver.hand.click("lesson.next");
        CHECK(strip_place(step_of(driver.ui.session.a.settings)) == i);
    }
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "lesson.next"));
    driver.hand.click("lesson.previous");
    CHECK(strip_place(step_of(driver.ui.session.a.settings)) == stage_count - 2);
}

} // namespace rasterwalk
