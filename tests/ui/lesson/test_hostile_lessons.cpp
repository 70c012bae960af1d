// A hostile lesson in the list: it is refused with a sentence, and the lesson that was open stays.

#include <cstdio>
#include <filesystem>

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

const std::string good_text = test::lesson_head() + "It is good.\n\n## A step\n\nAnd goes on.\n";

/// The interface with a good lesson, which is open, and others.
struct HostileClassroom {
    test::TemporaryFolder folder;
    Driver driver;
    Ui& ui = driver.ui;

    HostileClassroom() { folder.write("01-good.md", good_text); }

    void open_good() {
        ui.lesson.lessons.read_folder(folder.file(""));
        open_lesson(ui, "01-good", 1);
        driver.hand.rest();
        REQUIRE(ui.session.lesson == "01-good");
        REQUIRE(ui.session.notice.empty());
    }
    bool shows_faults() const { return ui.widgets.count("lesson.faults") > 0; }
};

std::string file_name(std::size_t number) {
    char name[40];
    std::snprintf(name, sizeof name, "%02zu-hostile.md", number);
    return name;
}

} // namespace

TEST_CASE("The column shows the fault of every hostile lesson, and the open lesson stays") {
    HostileClassroom room;
    const std::vector<test::HostileLesson> all = test::hostile_lessons();
    REQUIRE(all.size() < 90);
    for (std::size_t i = 0; i < all.size(); ++i)
        room.folder.write(file_name(i + 2), all[i].text);
    room.open_good();
    Ui& ui = room.ui;
    for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(all[i].about);
        const std::string name = file_name(i + 2);
        const std::string id = name.substr(0, name.size() - 3);
        room.driver.hand.click("lesson.list");
        REQUIRE(ui.widgets.count("lesson.item." + id) == 1);
        // What only rasterwalk check finds is not a fault for the reader.
        const Lesson read = *ui.lesson.lessons.find(id);
        const std::string sentence = read.faults.empty() ? "" : fault_text(read, read.faults[0]);
        room.driver.hand.click("lesson.item." + id);
        if (all[i].is_readable) {
            CHECK(ui.session.lesson == id);
            CHECK(room.shows_faults() == !sentence.empty());
            open_lesson(ui, "01-good", 1);
            room.driver.hand.rest();
        } else {
            CHECK(sentence.find(all[i].sentence) != std::string::npos);
            CHECK(ui.session.notice == sentence);
        }
        CHECK(ui.session.lesson == "01-good");
        CHECK(ui.session.step == 1);
        CHECK_FALSE(room.shows_faults());
    }
}

TEST_CASE("A good lesson that is made hostile while it is open stays, with the fault above it") {
    for (const test::HostileLesson& hostile : test::hostile_lessons()) {
        if (hostile.is_readable) continue;
        INFO(hostile.about);
        HostileClassroom room;
        room.open_good();
        room.folder.write("01-good.md", hostile.text);
        room.driver.hand.rest();
        const Lesson* const lesson = open_lesson_of(room.ui);
        REQUIRE(lesson != nullptr);
        CHECK(lesson->steps.size() == 2);
        CHECK(room.ui.session.step == 1);
        REQUIRE_FALSE(lesson->faults.empty());
        CHECK(lesson->faults.front().sentence == hostile.sentence);
        CHECK(room.shows_faults());
        room.folder.write("01-good.md", good_text);
        room.driver.hand.rest();
        CHECK_FALSE(room.shows_faults());
    }
}

TEST_CASE("Tiring texts are drawn, or refused") {
    for (const test::HostileLesson& tiring : test::some_of(test::tiring_lessons(), 6)) {
        INFO("'" << tiring.about << "'");
        HostileClassroom room;
        room.folder.write("02-tiring.md", tiring.text);
        room.open_good();
        open_lesson(room.ui, "02-tiring", 0);
        room.driver.hand.frames(2);
        const bool is_reported =
            room.ui.session.lesson == "01-good" && !room.ui.session.notice.empty();
        CHECK((room.ui.session.lesson == "02-tiring" || is_reported));
    }
}

TEST_CASE("A folder in the place of a lesson is reported in the status line") {
    HostileClassroom room;
    std::filesystem::create_directory(room.folder.file("02-folder.md"));
    room.open_good();
    open_lesson(room.ui, "02-folder", 0);
    room.driver.hand.rest();
    CHECK(room.ui.session.notice ==
          room.folder.file("02-folder.md") + ": the file cannot be read: Is a directory.");
    CHECK(room.ui.session.lesson == "01-good");
}

TEST_CASE("Links of a hostile lesson do nothing but say so") {
    HostileClassroom room;
    room.folder.write("02-links.md", test::lesson_head() +
                                         "[a](../../../../etc/passwd) [b](/etc/passwd) "
                                         "[c](file:///etc/passwd) [d](http://example.org/) "
                                         "[e](cursor:t999/e1) [f](set:stage=never) "
                                         "[g](99-gone.md) [h](show:nothing.here) "
                                         "[i](javascript:alert) [j](preset:no) [k](bug:B0)\n");
    room.open_good();
    open_lesson(room.ui, "02-links", 0);
    room.driver.hand.rest();
    const Settings settings = room.ui.session.a.settings;
    for (int link = 0; link < 11; ++link) {
        INFO(link);
        room.ui.session.notice.clear();
        room.driver.hand.click("lesson.part0.link." + std::to_string(link));
        CHECK_FALSE(room.ui.session.notice.empty());
        CHECK(room.ui.session.lesson == "02-links");
        CHECK(room.ui.session.a.settings == settings);
    }
}

} // namespace rasterwalk
