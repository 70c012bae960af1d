// The page that the program shows the first time, and what later starts do.

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"
#include "session/content.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/actions.h"
#include "ui/actions/open_lesson.h"
#include "ui/start/start_choice.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

void begin(Driver& driver) {
    begin_at_start(driver.ui);
    driver.hand.rest();
}

bool is_open(Driver& driver) {
    driver.hand.frames();
    return driver.ui.start.is_open && driver.hand.is_visible("start.lessons");
}

} // namespace

TEST_CASE("The first start shows the start page, and nothing of the workplace") {
    Driver driver;
    CHECK_FALSE(driver.ui.start.is_open);
    begin(driver);
    REQUIRE(is_open(driver));
    for (const char* choice : {"start.lessons", "start.stages", "start.picture"}) {
        INFO(choice);
        CHECK(driver.hand.is_visible(choice));
    }
    for (const char* behind : {"walk.play", "stage.depth", "status.pixel", "canvas.fit"}) {
        INFO(behind);
        CHECK_FALSE(driver.hand.is_visible(behind));
    }
    CHECK(driver.hand.is_visible("menu.Scene"));
}

TEST_CASE(
    "On the start page the text grows and shrinks, by keys and in a small window by buttons") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}}) {
        INFO(window.x);
        Driver driver("lab-room.toml", window);
        begin(driver);
        REQUIRE(is_open(driver));
        const auto wished = [&] { return driver.ui.options.wished_text_scale; };
        driver.hand.press(key::equal, {.ctrl = true});
        CHECK(wished() > 1.0f);
        driver.hand.press(key::minus, {.ctrl = true});
        CHECK(wished() == 1.0f);
        driver.hand.click("text.larger");
        CHECK(wished() > 1.0f);
        driver.hand.click("text.smaller");
        CHECK(wished() == 1.0f);
        CHECK(is_open(driver));
    }
}

TEST_CASE("While nothing is answered the page does not recount the lessons that are done") {
    Driver driver;
    begin(driver);
    REQUIRE(is_open(driver));
    const std::uint64_t number = driver.ui.lesson.scores.number();
    REQUIRE(number > 0);
    driver.hand.frames(10);
    CHECK(driver.ui.lesson.scores.number() == number);
}

TEST_CASE("A click on the first card begins the first lesson") {
    Driver driver;
    begin(driver);
    driver.hand.click("start.lessons");
    CHECK_FALSE(is_open(driver));
    CHECK(driver.ui.session.lesson == "01-pinhole-camera");
    CHECK(driver.ui.options.start_choice == StartChoice::lessons);
    CHECK(driver.hand.is_visible("walk.play"));
}

TEST_CASE("A click on the second card shows the room without a lesson") {
    Driver driver;
    begin(driver);
    driver.hand.click("start.stages");
    CHECK_FALSE(is_open(driver));
    CHECK(driver.ui.session.lesson.empty());
    CHECK(driver.ui.options.start_choice == StartChoice::stages);
    // The walk begins at the beginning, with a light that shows the last stages.
    CHECK(driver.ui.session.a.settings.stage == Stage::points);
    CHECK(driver.ui.session.tab == "vertices");
    driver.hand.click("stage.pixel_light");
    CHECK(driver.ui.session.a.settings.light.power == glm::vec3(14.0f));
}

TEST_CASE("From the start page it is three clicks to what is wrong with a picture") {
    const test::TemporaryFolder folder;
    write_file(folder.file("mine.txt"), "Start: (10,5). End: (10,5).\n");
    Driver driver;
    driver.ui.sheets.files.folder = folder.file(".");
    begin(driver);
    driver.hand.click("start.picture");
    CHECK_FALSE(is_open(driver));
    CHECK(driver.ui.options.start_choice == StartChoice::picture);
    driver.hand.click("files.entry.mine.txt");
    driver.hand.click("files.do");
    driver.hand.rest();
    CHECK((driver.hand.is_visible("lab.diagnosis") || driver.hand.is_visible("lab.result.fault")));
}

TEST_CASE("If you choose no file yet, you read what can be checked") {
    Driver driver;
    begin(driver);
    driver.hand.click("start.picture");
    driver.hand.press(key::escape);
    CHECK(driver.hand.is_visible("mine.choose"));
    CHECK(driver.hand.is_visible("mine.path"));
}

TEST_CASE("A click on a stage shows the scene at that stage") {
    Driver driver;
    for (const StageInfo& info : stage_list()) {
        INFO(info.name);
        driver.ui.start.is_open = true;
        driver.hand.rest();
        driver.hand.click(std::string("start.stage.").append(info.name));
        CHECK_FALSE(is_open(driver));
        CHECK(step_of(driver.ui.session.a.settings) == info.step);
    }
}

TEST_CASE("Enter begins the lessons; Tab frames their button first, and then the other ways") {
    Driver driver;
    begin(driver);
    CHECK_FALSE(driver.ui.focus.is_shown);
    driver.hand.press(key::tab);
    CHECK(driver.ui.focus.is_shown);
    CHECK(driver.ui.start.chosen == StartChoice::lessons);
    driver.hand.press(key::right);
    CHECK(driver.ui.start.chosen == StartChoice::stages);
    driver.hand.press(key::tab);
    CHECK(driver.ui.start.chosen == StartChoice::picture);
    driver.hand.press(key::tab, {.shift = true});
    CHECK(driver.ui.start.chosen == StartChoice::stages);
    driver.hand.press(key::left);
    CHECK(driver.ui.start.chosen == StartChoice::lessons);
    SECTION("Tab and Enter") {
        driver.hand.press(key::enter);
        CHECK_FALSE(is_open(driver));
        CHECK(driver.ui.session.lesson == "01-pinhole-camera");
    }
    SECTION("another way") {
        driver.hand.press(key::tab);
        driver.hand.press(key::enter);
        CHECK_FALSE(is_open(driver));
        CHECK(driver.ui.options.start_choice == StartChoice::stages);
        CHECK(driver.ui.session.lesson.empty());
    }
    SECTION("Escape leaves the page") {
        driver.hand.press(key::escape);
        CHECK_FALSE(is_open(driver));
        CHECK_FALSE(driver.ui.options.start_choice);
    }
    SECTION("a picture at a stage") {
        for (int i = 0; i < 30 && driver.ui.focus.name != "start.stage.rows"; ++i)
            driver.hand.press(key::tab, {.shift = true});
        driver.hand.press(key::enter);
        CHECK_FALSE(is_open(driver));
        CHECK(driver.ui.session.a.settings.stage == Stage::rows);
    }
}

TEST_CASE("Enter alone begins the lessons") {
    Driver driver;
    begin(driver);
    driver.hand.press(key::enter);
    CHECK_FALSE(is_open(driver));
    CHECK(driver.ui.session.lesson == "01-pinhole-camera");
}

TEST_CASE("Over the start page one Escape closes one thing") {
    Driver driver;
    begin(driver);
    driver.hand.press(key::f1);
    REQUIRE(driver.ui.sheets.is_open(Sheet::keys));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::keys));
    REQUIRE(is_open(driver));
    driver.hand.click("menu.Scene");
    REQUIRE(driver.hand.is_visible("scene.fence"));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.hand.is_visible("scene.fence"));
    REQUIRE(is_open(driver));
    driver.hand.press(key::escape);
    CHECK_FALSE(is_open(driver));
}

TEST_CASE("Choosing anything but the lessons leaves the lesson that was open") {
    for (const StartChoice choice : {StartChoice::stages, StartChoice::picture}) {
        Driver driver;
        open_lesson(driver.ui, "05-row-table", 0);
        driver.ui.start.is_open = true;
        driver.hand.rest();
        driver.hand.click(std::string("start.").append(word_of(choice)));
        driver.hand.rest();
        CHECK(driver.ui.session.lesson.empty());
        CHECK(driver.ui.options.start_choice == choice);
    }
}

TEST_CASE("Behind the start page no key moves anything") {
    Driver driver;
    begin(driver);
    const SessionInputs before = driver.ui.session;
    for (const int pressed : {int{key::space}, int{key::home}, int{key::period}, int{'P'}, int{'W'},
                              int{'4'}, int{'C'}, int{key::up}, int{key::page_down}}) {
        driver.hand.press(pressed);
        INFO(pressed);
        const SessionInputs& now = driver.ui.session;
        CHECK(now == before);
        CHECK(is_open(driver));
    }
    CHECK_FALSE(driver.ui.session.play.running);
}

TEST_CASE("What a menu opens or sets closes the start page; the menu of help brings it back") {
    Driver driver;
    begin(driver);
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.one-triangle");
    CHECK_FALSE(is_open(driver));
    CHECK(driver.ui.session.scene->space == SceneSpace::pixels);

    driver.hand.click("menu.Help");
    driver.hand.click("menu.help.start");
    REQUIRE(is_open(driver));
    open_lesson(driver.ui, "05-row-table", 0);
    CHECK_FALSE(is_open(driver));

    driver.ui.start.is_open = true;
    REQUIRE(is_open(driver));
    driver.hand.click("menu.Stage");
    driver.hand.click("menu.stage.edges");
    CHECK_FALSE(is_open(driver));
}

TEST_CASE("A later start goes on where the student stopped") {
    SECTION("in the lesson that was left") {
        Driver driver;
        driver.ui.lesson.progress.record_step("04-edges", 2);
        begin(driver);
        CHECK_FALSE(is_open(driver));
        CHECK(driver.ui.session.lesson == "04-edges");
        CHECK(driver.ui.session.step == 2);
    }
    SECTION("with the stages") {
        Driver driver;
        driver.ui.options.start_choice = StartChoice::stages;
        driver.ui.lesson.progress.record_step("04-edges", 2);
        begin(driver);
        CHECK_FALSE(is_open(driver));
        CHECK(driver.ui.session.lesson.empty());
    }
    SECTION("with a program of one's own") {
        Driver driver;
        driver.ui.options.start_choice = StartChoice::picture;
        begin(driver);
        CHECK(driver.hand.is_visible("mine.path"));
    }
    SECTION("with a lesson that was opened from the list") {
        Driver driver;
        driver.ui.options.start_choice = StartChoice::stages;
        open_lesson(driver.ui, "05-row-table", 0);
        driver.hand.frames();
        CHECK(driver.ui.options.start_choice == StartChoice::lessons);
    }
}

TEST_CASE("The stages are drawn once, and each is a different picture") {
    Driver driver;
    const int before = driver.textures.uploads;
    begin(driver);
    // Two of the ways have pictures on their cards.
    const int drawn = driver.textures.uploads;
    CHECK(drawn == before + stage_count + 6);
    driver.hand.frames(5);
    CHECK(driver.textures.uploads == drawn);
    driver.hand.press(key::escape);
    // In a low window the cards have none: the last is the room with light per pixel, with
    // more shades than the room has colours.
    driver.resize({1024, 640});
    driver.ui.start.is_open = true;
    driver.hand.rest();
    const Image& lit = driver.textures.last;
    REQUIRE(lit.width > 50);
    CHECK(std::abs(lit.width - lit.height) <= 1);
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i + 3 < lit.rgba.size(); i += 4)
        colours.insert(lit.rgba[i] + 256U * lit.rgba[i + 1] + 65536U * lit.rgba[i + 2]);
    CHECK(colours.size() > 300);
    const std::set<ImTextureID> textures(driver.ui.start.pictures.textures.begin(),
                                         driver.ui.start.pictures.textures.end());
    CHECK(textures.size() == stage_count);
}

TEST_CASE("The cards show what their ways lead to") {
    Driver driver;
    begin(driver);
    driver.hand.leave();
    const StartPictures& pictures = driver.ui.start.start_pictures;
    CHECK_FALSE(pictures.is_shown[static_cast<std::size_t>(StartChoice::lessons)]);
    std::set<ImTextureID> textures;
    for (const StartChoice choice : {StartChoice::stages, StartChoice::picture}) {
        CHECK(pictures.is_shown[static_cast<std::size_t>(choice)]);
        for (const ImTextureID texture : pictures.textures[static_cast<std::size_t>(choice)])
            textures.insert(texture);
    }
    CHECK(textures.size() == 6);
    // The last of them marks where the picture without a depth test differs: some of it, not most.
    const Image& marked = driver.textures.last;
    REQUIRE(marked.width == pictures.side);
    const ImVec4 fail = colour_of(Meaning::fail, driver.ui.options.theme);
    std::size_t different = 0;
    for (std::size_t i = 0; i + 3 < marked.rgba.size(); i += 4)
        different += std::abs(marked.rgba[i] - 255.0f * fail.x) < 1.0f &&
                             std::abs(marked.rgba[i + 1] - 255.0f * fail.y) < 1.0f
                         ? 1
                         : 0;
    const std::size_t all = marked.rgba.size() / 4;
    CHECK(different > all / 200);
    CHECK(different < all / 4);
    // The lessons that come next are named, each on a separate line.
    int named = 0;
    for (const ScreenText& text : screen_text())
        for (int i = 0; i < 3; ++i)
            named +=
                text.words == driver.ui.lesson.lessons.all()[static_cast<std::size_t>(i)].title;
    CHECK(named == 3);
}

TEST_CASE("A triangle alone cannot be half drawn, and hides nothing: its cards have no pictures") {
    Driver driver("one-triangle.toml");
    begin(driver);
    for (const bool is_shown : driver.ui.start.start_pictures.is_shown)
        CHECK_FALSE(is_shown);
}

TEST_CASE("A scene that takes long to draw leaves the pictures out, and the ways stay") {
    Driver driver;
    auto scene = std::make_shared<Scene>(*driver.ui.session.scene);
    for (int i = 0; i < 3000; ++i)
        scene->mesh.add_triangle({0, 1, 2});
    driver.ui.session.scene = scene;
    driver.hand.rest();
    driver.ui.start.is_open = true;
    driver.hand.rest();
    CHECK_FALSE(driver.ui.start.pictures.is_drawn);
    CHECK(driver.hand.is_visible("start.stages"));
}

} // namespace rasterwalk
