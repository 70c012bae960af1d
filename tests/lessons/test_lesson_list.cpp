#include "lessons/lesson_list.h"

#include <filesystem>
#include <fstream>

#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
namespace fs = std::filesystem;

namespace {

std::string lesson_text(const std::string& words) {
    return test::lesson_head() + words + "\n\n## A step\n\nMore.\n";
}

/// The first words of a lesson.
std::string words_of(const Lesson* lesson) {
    if (lesson == nullptr || lesson->steps.front().parts.empty()) return {};
    return lesson->steps.front().parts.front().text;
}

} // namespace

TEST_CASE("The lessons of a folder are those whose names begin with two digits") {
    const test::TemporaryFolder folder;
    for (const char* name : {"02-b.md", "01-a.md", "10-c.md", "README.md", "1-x.md", "03-x.txt",
                             "ab-x.md", "04-.md", "05-x.md~", "presets.toml"}) {
        folder.write(name, lesson_text(name));
    }
    fs::create_directory(folder.file("06-folder.md"));
    LessonList list;
    list.read_folder(folder.file(""));
    std::vector<std::string> ids;
    for (const Lesson& lesson : list.all())
        ids.push_back(lesson.id);
    CHECK(ids == std::vector<std::string>{"01-a", "02-b", "06-folder", "10-c"});
    CHECK(words_of(list.find("02-b")) == "02-b.md");
    CHECK(list.find("03-x") == nullptr);
    CHECK(list.find("") == nullptr);
    CHECK_FALSE(is_readable(*list.find("06-folder")));
}

TEST_CASE("A lesson that changes is read again; others stay as they are") {
    const test::TemporaryFolder folder;
    folder.write("01-a.md", lesson_text("first"));
    folder.write("02-b.md", lesson_text("second"));
    LessonList list;
    list.read_folder(folder.file(""));
    CHECK_FALSE(list.is_edited("01-a"));
    folder.write("01-a.md", lesson_text("first, and longer"));
    CHECK(list.is_edited("01-a"));
    CHECK_FALSE(list.is_edited("02-b"));
    CHECK_FALSE(list.is_edited("03-none"));
    SECTION("by being asked for") {
        CHECK(words_of(list.find("01-a")) == "first, and longer");
    }
    SECTION("with all others") {
        folder.write("03-c.md", lesson_text("third"));
        fs::remove(folder.file("02-b.md"));
        list.refresh();
        CHECK(list.all().size() == 2);
        CHECK(words_of(list.find("01-a")) == "first, and longer");
        CHECK(words_of(list.find("03-c")) == "third");
        CHECK(list.find("02-b") == nullptr);
    }
    CHECK_FALSE(list.is_edited("01-a"));
}

TEST_CASE("A change that leaves size and name is seen by its time") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("01-a.md", lesson_text("before"));
    LessonList list;
    list.read_folder(folder.file(""));
    REQUIRE(words_of(list.find("01-a")) == "before");
    folder.write("01-a.md", lesson_text("behind"));
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(2));
    CHECK(list.is_edited("01-a"));
    CHECK(words_of(list.find("01-a")) == "behind");
}

TEST_CASE("A lesson that can no longer be read leaves what was read, and says why") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("01-a.md", lesson_text("before"));
    LessonList list;
    list.read_folder(folder.file(""));
    SECTION("it holds bytes that are no text") {
        folder.write("01-a.md", lesson_text("before \xff"));
        if (GENERATE(false, true)) list.refresh();
        CHECK(words_of(list.find("01-a")) == "before");
        REQUIRE(list.find("01-a")->faults.size() == 1);
        CHECK(list.find("01-a")->faults[0].line == 10);
        folder.write("01-a.md", lesson_text("mended"));
        CHECK(words_of(list.find("01-a")) == "mended");
        CHECK(list.find("01-a")->faults.empty());
    }
    SECTION("it was taken away") {
        fs::remove(path);
        CHECK(words_of(list.find("01-a")) == "before");
        list.refresh();
        CHECK(list.find("01-a") == nullptr);
    }
    SECTION("it is a folder now") {
        fs::remove(path);
        fs::create_directory(path);
        list.refresh();
        CHECK(words_of(list.find("01-a")) == "before");
    }
}

TEST_CASE("A folder that is not there has no lessons, and one that is too full has some") {
    LessonList list;
    list.read_folder("/nowhere/at/all");
    CHECK(list.all().empty());
    const test::TemporaryFolder folder;
    for (int i = 0; i < 150; ++i)
        folder.write("01-" + std::to_string(i) + "x.md", "Text.\n");
    list.read_folder(folder.file(""));
    CHECK(list.all().size() == most_lessons);
}

TEST_CASE("A lesson's number is the one that its name begins with") {
    CHECK(lesson_number("07-painters-order") == 7);
    CHECK(lesson_number("13-a") == 13);
    CHECK(lesson_number("tiny") == 0);
    CHECK(lesson_number("") == 0);
}
