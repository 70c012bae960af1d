#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr const char* lesson_text = R"(<!-- lesson
title = "A tiny lesson"
section = "Drawing edges"
minutes = 10
about = "It is made for a test."
program = "nothing"
scene = "scenes/lab-room.toml"
set = ["stage=depth"]
-->
# A tiny lesson

It begins with the [edges](set:stage=edges) and a note.[^1]

## Look at rows
<!-- step
set = ["stage=rows"]
tab = "vertices"
triangle = 20
-->

<!-- task
id = "affine"
done = "interpolation == affine"
recipe = ["set:interpolation=affine"]
hint = "The key P does it."
-->
> **Task.** Make it affine.

<!-- prediction
id = "how-many"
kind = "number"
answer = "triangle.count"
unit = "triangles"
then = { tab = "settings" }
because = "There are {answer}."
-->
> **Prediction.** How many triangles are there?

<!-- prediction
id = "who"
kind = "choice"
choices = ["the floor", "the tall block"]
right = ["triangle < 20", "triangle >= 20"]
-->
> **Prediction.** What is selected?

<!-- prediction
id = "black"
kind = "pixel"
where = "pixel.uncovered"
recipe = "0,0"
wrong = "250,250"
-->
> **Prediction.** Which pixel stays black?

[^1]: A note to the text.
)";

/// The interface with the lessons of a separate folder.
struct Classroom {
    test::TemporaryFolder folder;
    std::string file = folder.file("01-tiny.md");
    Driver driver;

    explicit Classroom(ImVec2 window = {1600, 1000}) : driver("lab-room.toml", window) {
        write(lesson_text);
        driver.ui.lesson.lessons.read_folder(folder.file(""));
    }
    void write(const std::string& text) const { std::ofstream(file) << text; }
    void open() {
        driver.hand.click("lesson.list");
        driver.hand.click("lesson.item.01-tiny");
    }
};

} // namespace

TEST_CASE("A lesson is opened from the list and walked by its buttons") {
    Classroom room;
    Ui& ui = room.driver.ui;
    Hand& hand = room.driver.hand;
    room.open();
    CHECK(ui.session.lesson == "01-tiny");
    CHECK(ui.session.step == 0);
    CHECK(ui.session.a.settings.stage == Stage::depth);
    hand.click("lesson.part0.link.0");
    CHECK(ui.session.a.settings.stage == Stage::edges);

    hand.click("lesson.next");
    CHECK(ui.session.step == 1);
    CHECK(ui.session.a.settings.stage == Stage::rows);
    CHECK(ui.session.tab == "vertices");
    CHECK(ui.session.selection.triangle == 20);
    hand.click("lesson.previous");
    CHECK(ui.session.step == 0);
    CHECK(ui.session.a.settings.stage == Stage::depth);
    hand.click("lesson.step.1");
    CHECK(ui.session.step == 1);

    hand.click("stage.fill");
    hand.press('R');
    CHECK(ui.session.a.settings.stage == Stage::rows);
    hand.press(key::page_up);
    CHECK(ui.session.step == 0);
    hand.press(key::page_down);
    CHECK(ui.session.step == 1);
}

TEST_CASE("A task is ticked off when it is solved, and stays so") {
    Classroom room;
    Ui& ui = room.driver.ui;
    room.open();
    room.driver.hand.click("lesson.next");
    room.driver.hand.click("lesson.task.affine.hint");
    CHECK_FALSE(ui.lesson.progress.is_task_done("01-tiny", "affine"));
    room.driver.hand.press('P');
    CHECK(ui.session.a.settings.interpolation == Interpolation::affine);
    CHECK(ui.lesson.progress.is_task_done("01-tiny", "affine"));
    room.driver.hand.press('P');
    CHECK(ui.lesson.progress.is_task_done("01-tiny", "affine"));
}

TEST_CASE("A prediction is answered before the program shows, and the first answer is kept") {
    Classroom room;
    Ui& ui = room.driver.ui;
    Hand& hand = room.driver.hand;
    room.open();
    hand.click("lesson.next");
    const auto answers = [&] { return ui.lesson.progress.of("01-tiny").answers; };

    SECTION("a number") {
        CHECK(ui.session.tab == "vertices");
        hand.click("lesson.prediction.how-many.number");
        hand.type_text("12");
        hand.click("lesson.prediction.how-many.answer");
        CHECK_FALSE(answers().at("how-many").is_right);
        CHECK(ui.lesson.predictions.at("how-many").judged->number == 30.0);
        CHECK(ui.session.tab == "vertices");
        hand.click("lesson.prediction.how-many.show");
        CHECK(ui.session.tab == "settings"); // what the reveal shows
        hand.click("lesson.prediction.how-many.again");
        CHECK_FALSE(ui.lesson.predictions.at("how-many").judged);
        hand.click("lesson.prediction.how-many.number");
        hand.type_text("30");
        hand.click("lesson.prediction.how-many.answer");
        CHECK(ui.lesson.predictions.at("how-many").judged->is_right);
        CHECK_FALSE(answers().at("how-many").is_right);
        CHECK(answers().at("how-many").said == "12 triangles");
    }
    SECTION("one of several") {
        hand.click("lesson.prediction.who.choice.1");
        CHECK(answers().at("who").is_right);
        CHECK(answers().at("who").said == "the tall block");
    }
    SECTION("a pixel") {
        hand.click_picture(250, 250);
        hand.click("lesson.prediction.black.answer");
        CHECK_FALSE(answers().at("black").is_right);
    }
}

TEST_CASE("A search looks through lessons and glossary") {
    Classroom room;
    room.driver.hand.click("lesson.list");
    room.driver.hand.click("lesson.search");
    room.driver.hand.type_text("affine");
    CHECK(room.driver.ui.widgets.count("lesson.hit.0") == 1);
    CHECK(room.driver.ui.widgets.count("lesson.item.01-tiny") == 0);
    // Terms come first, the step after them.
    int hits = 0;
    while (room.driver.ui.widgets.count("lesson.hit." + std::to_string(hits)) > 0)
        ++hits;
    // Preceded by the number of its lesson.
    const std::string last = "lesson.hit." + std::to_string(hits - 1);
    const WidgetPlace place = room.driver.hand.find(last);
    const std::vector<ScreenText> texts = screen_text();
    CHECK(std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
        return text.words == "1" && text.low.x >= place.top_left.x &&
               text.low.y >= place.top_left.y && text.high.y <= place.bottom_right.y;
    }));
    room.driver.hand.click(last);
    CHECK(room.driver.ui.session.lesson == "01-tiny");
    CHECK(room.driver.ui.session.step == 1);
}

TEST_CASE("A lesson that is edited is read again, and keeps its place") {
    Classroom room;
    Ui& ui = room.driver.ui;
    room.open();
    room.driver.hand.click("lesson.next");
    std::string text = lesson_text;
    text.replace(text.find("Look at rows"), 12, "See the rows of it");
    CHECK_FALSE(lesson_was_edited(ui));
    room.write(text);
    CHECK(lesson_was_edited(ui));
    room.driver.hand.rest();
    CHECK(ui.session.step == 1);
    CHECK(open_lesson_of(ui)->steps[1].heading == "See the rows of it");
}

TEST_CASE("Progress is kept in a file, taken up again, and forgotten on request") {
    const test::TemporaryFolder state;
    const std::string file = state.file("new/progress.toml");
    {
        Classroom room;
        keep_progress(room.driver.ui, file);
        room.open();
        room.driver.hand.click("lesson.next");
        room.driver.hand.click("lesson.prediction.who.choice.0");
        room.driver.hand.rest();
    }
    Classroom room;
    keep_progress(room.driver.ui, file);
    CHECK(room.driver.ui.session.notice.empty());
    const LessonProgress& own = room.driver.ui.lesson.progress.of("01-tiny");
    CHECK(own.steps == std::set<int>{0, 1});
    CHECK(own.answers.at("who") == FirstAnswer{"the floor", false, true});
    open_lesson_to_go_on(room.driver.ui);
    CHECK(room.driver.ui.session.step == 1);
    room.driver.hand.rest();
    room.driver.hand.click("lesson.list");
    room.driver.hand.click("lesson.reset");
    room.driver.hand.click("lesson.reset.yes");
    CHECK(room.driver.ui.lesson.progress == Progress{});
}

TEST_CASE("Progress that cannot be kept is reported once, and nothing is lost") {
    Classroom room;
    keep_progress(room.driver.ui, "/proc/nowhere/progress.toml");
    room.open();
    room.driver.hand.rest();
    CHECK(room.driver.ui.session.notice.find("will not be kept") != std::string::npos);
    CHECK(room.driver.ui.lesson.progress.was_step_shown("01-tiny", 0));
    // It is tried again, but not reported again.
    room.driver.ui.session.notice.clear();
    room.driver.hand.frames(12, 1.0f);
    CHECK(room.driver.ui.session.notice.empty());
}

TEST_CASE("In a small window the whole text stays in front when a step opens a tab") {
    Classroom room({1024, 640});
    room.driver.hand.click("lesson.whole");
    room.open();
    room.driver.hand.click("lesson.whole");
    room.driver.hand.click("lesson.next");
    CHECK(room.driver.ui.session.tab == "vertices");
    CHECK(room.driver.hand.is_visible("lesson.list"));
    room.driver.open("vertices");
    CHECK_FALSE(room.driver.hand.is_visible("lesson.list"));
    CHECK(room.driver.hand.is_visible("lesson.previous"));
}

TEST_CASE("Every widget that a lesson points at is in the window at that step, or the way to it") {
    struct Case {
        ImVec2 window;
        float text;
        bool is_lecture;
    };
    const std::vector<Case> cases{
        {{1600, 1000}, 1.0f, false}, {{1024, 640}, 1.5f, false}, {{1024, 640}, 1.0f, true}};
    int shift = 0;
    for (const Case& c : test::some_of(cases, 3)) {
        Driver driver("lab-room.toml", c.window, c.text);
        if (c.is_lecture) driver.hand.press(key::f5);
        const bool is_wide = c.window.x > 1500.0f;
        const auto is_shown = [&](const std::string& widget) {
            const std::string& shown = driver.ui.lesson.pointed_at;
            return driver.ui.widgets.count(shown) > 0 && (shown == widget || !is_wide);
        };
        // A copy, because opening a lesson may read it again.
        std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
        REQUIRE(lessons.size() >= 13);
        // At little effort each window takes different lessons, so each is seen in one of them.
        std::rotate(lessons.begin(), lessons.begin() + shift++, lessons.end());
        for (const Lesson& lesson : test::some_of(lessons, 7)) {
            for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
                for (const LinkPlace& link : lesson.steps[i].links) {
                    if (!link.target.starts_with("show:")) continue;
                    INFO(lesson.path << ":" << link.line << ": " << link.target);
                    open_lesson(driver.ui, lesson.id, static_cast<int>(i));
                    driver.hand.rest();
                    follow_link(driver.ui, link.target);
                    driver.hand.frames(2 * frames_to_rest);
                    CHECK(is_shown(link.target.substr(5)));
                    CHECK(driver.ui.session.notice.empty());
                }
                const std::string pointed = lesson.steps[i].state.point_at.value_or("");
                if (pointed.empty()) continue;
                INFO(lesson.path << ": step " << i << " points at " << pointed);
                open_lesson(driver.ui, lesson.id, static_cast<int>(i));
                driver.hand.frames(2 * frames_to_rest);
                CHECK(is_shown(pointed));
            }
        }
    }
}

TEST_CASE("Answers that were given before are shown again with the program's replies") {
    const test::TemporaryFolder state;
    const std::string file = state.file("progress.toml");
    const char* const ids[] = {"how-many", "who", "black"};
    std::map<std::string, PredictionView> before;
    {
        Classroom room;
        Hand& hand = room.driver.hand;
        keep_progress(room.driver.ui, file);
        room.open();
        hand.click("lesson.next");
        hand.click("lesson.prediction.how-many.number");
        hand.type_text("1/2");
        hand.click("lesson.prediction.how-many.answer");
        hand.click("lesson.prediction.how-many.show");
        hand.click("lesson.prediction.who.choice.0");
        hand.click("lesson.prediction.who.show");
        hand.press('R'); // what the reveal shows is a different picture
        hand.click_picture(250, 250);
        hand.click("lesson.prediction.black.answer");
        hand.click("lesson.prediction.black.show");
        before = room.driver.ui.lesson.predictions;
    }
    Classroom room;
    Ui& ui = room.driver.ui;
    keep_progress(ui, file);
    open_lesson_to_go_on(ui);
    room.driver.hand.rest();
    CHECK(ui.session.tab == "vertices"); // the step's own, not the reveal's
    for (const char* id : ids) {
        INFO(id);
        const PredictionView& view = ui.lesson.predictions.at(id);
        REQUIRE(view.judged);
        CHECK(view.said == before.at(id).said);
        CHECK(view.judged->is_right == before.at(id).judged->is_right);
        CHECK(view.judged->answer == before.at(id).judged->answer);
        CHECK(view.judged->because == before.at(id).judged->because);
        room.driver.hand.find(std::string("lesson.prediction.") + id + ".verdict");
    }
    // It can be answered again, and is then not shown once more.
    room.driver.hand.click("lesson.prediction.who.again");
    room.driver.hand.frames(5);
    CHECK_FALSE(ui.lesson.predictions.at("who").judged);
    room.driver.hand.click("lesson.prediction.who.choice.1");
    CHECK(ui.lesson.predictions.at("who").judged->is_right);
}

TEST_CASE("The text stays where it is read while the lesson moves to make room for both views") {
    Classroom room({1600, 640});
    Hand& hand = room.driver.hand;
    Ui& ui = room.driver.ui;
    room.open();
    hand.click("lesson.next");
    const auto is_at_the_end = [&] {
        hand.frames(6);
        return hand.is_visible("lesson.prediction.black") && !hand.is_visible("lesson.task.affine");
    };
    const auto is_at_the_start = [&] {
        hand.frames(6);
        return hand.is_visible("lesson.task.affine") && !hand.is_visible("lesson.prediction.black");
    };
    REQUIRE(is_at_the_start());
    hand.find("lesson.prediction.black"); // scrolls there
    hand.wheel("lesson.prediction.black", -20.0f);
    REQUIRE(is_at_the_end());
    for (int i = 0; i < 2; ++i) {
        hand.press('9');
        REQUIRE(ui.lesson.is_strip);
        hand.press('T'); // the whole text, in a drawer
        CHECK(is_at_the_end());
        hand.press('T');
        hand.press('9');
        if (ui.lesson.is_strip) hand.press('8');
        REQUIRE_FALSE(ui.lesson.is_strip);
        CHECK(is_at_the_end());
        CHECK(ui.session.step == 1);
    }
    // Another step begins at its start.
    hand.press(key::page_up);
    hand.press(key::page_down);
    CHECK(is_at_the_start());
}

TEST_CASE("The first page of a lesson says what the next one is about") {
    Driver driver;
    for (const Lesson& lesson : std::vector<Lesson>(driver.ui.lesson.lessons.all())) {
        open_lesson(driver.ui, lesson.id, 0);
        driver.hand.rest();
        INFO(lesson.id);
        // Next to two views it is a strip, whose last card says so.
        if (driver.ui.lesson.is_strip) continue;
        // If it is too long, as far as it fits.
        CHECK(shows_words(lesson.steps[1].heading.substr(0, 6), "lesson"));
    }
}

TEST_CASE("No frame judges more than one of the answers that were kept") {
    Classroom room;
    Ui& ui = room.driver.ui;
    for (const char* const id : {"how-many", "who", "black"}) {
        const char* const said = std::string_view(id) == "how-many" ? "12 triangles"
                                 : std::string_view(id) == "who"    ? "the floor"
                                                                    : "pixel (250, 250)";
        ui.lesson.progress.record_answer("01-tiny", id, {said, false});
    }
    const auto judged = [&] {
        int count = 0;
        for (const auto& [id, view] : ui.lesson.predictions)
            count += view.judged ? 1 : 0;
        return count;
    };
    room.open();
    open_lesson(ui, "01-tiny", 1);
    int before = judged(), most = 0;
    REQUIRE(before == 0);
    int frames = 0;
    do {
        room.driver.hand.frames(1);
        most = std::max(most, judged() - before);
        before = judged();
    } while (is_answer_waiting(ui) && ++frames < 20);
    CHECK(judged() == 3);
    CHECK(most == 1);
    CHECK_FALSE(is_animating(ui));
    room.driver.hand.find("lesson.prediction.black.verdict");
}

TEST_CASE("When asked whether to forget all, the main button keeps it") {
    Classroom room;
    Hand& hand = room.driver.hand;
    hand.click("lesson.list");
    hand.click("lesson.reset");
    hand.leave();
    const ImU32 accent = packed(palette(room.driver.ui.options.theme).accent);
    CHECK(shown_colours(hand.find("lesson.reset.no")).count(accent) == 1);
    CHECK(shown_colours(hand.find("lesson.reset.yes")).count(accent) == 0);
}

TEST_CASE("The buttons to the next and the last step stay where they are, whatever they say") {
    Driver driver;
    const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    using Ends = std::pair<float, float>;
    std::map<std::string, std::map<Ends, std::string>> ends; // and a step that has them
    for (const Lesson& lesson : test::some_of(lessons, 4)) {
        for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
            open_lesson(driver.ui, lesson.id, step);
            driver.hand.frames(2);
            if (driver.ui.lesson.is_strip) continue; // where canvas and view from outside need room
            for (const char* name : {"lesson.next", "lesson.previous"}) {
                const auto found = driver.ui.widgets.find(name);
                if (found == driver.ui.widgets.end()) continue;
                const Ends both{found->second.top_left.x, found->second.bottom_right.x};
                ends[name][both] = lesson.id + ", step " + std::to_string(step + 1);
            }
        }
    }
    for (const auto& [name, all] : ends)
        for (const auto& [both, step] : all)
            UNSCOPED_INFO(name << " from " << both.first << " to " << both.second << ": " << step);
    CHECK(ends["lesson.next"].size() == 1);
    CHECK(ends["lesson.previous"].size() == 1);
}

TEST_CASE("What a lesson is about is broken between words, never within a number") {
    std::vector<SmallWindow> windows(small_windows.begin(), small_windows.end());
    windows.push_back({{1280, 800}, 1.0f});
    windows.push_back({{1600, 1000}, 1.5f});
    int with_lists = 0;
    for (const SmallWindow& window : windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.hand.press('L');
        // If there is room for only one line each, it is shown next to the pointer.
        if (driver.ui.lesson.is_strip) {
            driver.hand.hover("lesson.item.01-pinhole-camera");
            driver.hand.rest();
        } else {
            ++with_lists;
        }
        CHECK(shows_words("−3.001"));
    }
    CHECK(with_lists > 0);
}

TEST_CASE("In a small window each lesson of the list has one line, cut between words") {
    for (const ImVec2 window : {ImVec2{1024, 640}, ImVec2{800, 600}}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window, 1.5f);
        driver.hand.press('L');
        driver.hand.leave();
        float height = 0.0f;
        for (const Lesson& lesson : driver.ui.lesson.lessons.all()) {
            INFO(lesson.title);
            const WidgetPlace place = driver.hand.find("lesson.item." + lesson.id);
            // Only a part of one at the edge of the list is seen.
            height = std::max(height, place.bottom_right.y - place.top_left.y);
            if (place.text == lesson.title) continue;
            const std::string end = " …";
            REQUIRE(place.text.ends_with(end));
            const std::size_t kept = place.text.size() - end.size();
            CHECK(kept > 4);
            CHECK(lesson.title.starts_with(place.text.substr(0, kept)));
            const std::string between = " ,;:";
            CHECK(between.find(lesson.title[kept]) != std::string::npos);
        }
        CHECK(height > 0.0f);
        CHECK(height < 3.0f * driver.ui.fonts.text->FontSize);
    }
}

} // namespace rasterwalk
