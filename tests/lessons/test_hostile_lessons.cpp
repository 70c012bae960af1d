// Lessons made to cause harm are refused with a sentence. If one keeps the reader busy without end,
// the time limit of all tests ends it.

#include <filesystem>
#include <fstream>

#include <sys/stat.h>

#include "lessons/lesson_check.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
namespace fs = std::filesystem;

namespace {

/// Reads and checks a lesson, which must say this first.
Lesson refused(const std::string& path, const Fault& wanted) {
    const Session session = empty_session();
    Lesson lesson = read_lesson(path);
    const std::vector<Fault> faults = check_lesson(lesson, session);
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.front().line == wanted.line);
    CHECK(faults.front().sentence == wanted.sentence);
    return lesson;
}

} // namespace

TEST_CASE("Every hostile lesson is refused, with its line") {
    const test::TemporaryFolder folder;
    for (const test::HostileLesson& hostile : test::hostile_lessons()) {
        INFO(hostile.about);
        const std::string path = folder.write("01-hostile.md", hostile.text);
        const Lesson lesson = refused(path, {hostile.line, hostile.sentence});
        CHECK(is_readable(lesson) == hostile.is_readable);
        if (!hostile.is_readable) CHECK(lesson.tasks.empty());
    }
}

TEST_CASE("rasterwalk check refuses a hostile lesson with the same words") {
    const test::TemporaryFolder folder;
    for (const test::HostileLesson& hostile : test::some_of(test::hostile_lessons(), 6)) {
        INFO(hostile.about);
        const std::string path = folder.write("01-hostile.md", hostile.text);
        std::string place = path;
        if (hostile.line > 0) place.append(":").append(std::to_string(hostile.line));
        place.append(": ");
        const test::CliRun check = test::run({"check", path});
        CHECK(check.exit_code == 1);
        CHECK(check.out.substr(0, check.out.find('\n')) == place + hostile.sentence);
    }
}

TEST_CASE("No letter keeps the reader busy") {
    const Session session = empty_session();
    for (const test::HostileLesson& tiring : test::some_of(test::tiring_lessons(), 6)) {
        INFO("'" << tiring.about << "', " << tiring.text.size() << " bytes");
        const Lesson lesson = parse_lesson(tiring.text, "01-tiring.md");
        check_lesson(lesson, session);
        CHECK(lesson.faults.size() <= static_cast<std::size_t>(most_faults));
    }
}

TEST_CASE("Marks of emphasis that never close are words, and nested in nothing") {
    std::string marks;
    while (marks.size() < 3'000)
        marks += "*a **b ";
    CHECK(parse_lesson(test::lesson_head() + marks, "01-flat.md").faults.empty());
}

TEST_CASE("Only a text file can be a lesson") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("01-hostile.md");
    SECTION("a folder") {
        fs::create_directory(path);
        refused(path, {0, "the file cannot be read: Is a directory."});
    }
    SECTION("a pipe that is never written to") {
        REQUIRE(mkfifo(path.c_str(), 0600) == 0);
        CHECK_FALSE(is_readable(
            refused(path, {1, "the block 'lesson' is missing at the top of the file."})));
    }
    SECTION("a file without an end") {
        fs::create_symlink("/dev/zero", path);
        refused(path, {0, "the file is larger than 1 MB."});
    }
    SECTION("a file that is not there") {
        refused(path, {0, "the file cannot be read: No such file or directory."});
    }
    SECTION("an empty file") {
        folder.write("01-hostile.md", "");
        refused(path, {1, "the block 'lesson' is missing at the top of the file."});
    }
    SECTION("a file of zeros") {
        folder.write("01-hostile.md", std::string(5'000, '\0'));
        refused(path, {1, "the line is longer than 4000 bytes."});
    }
}

TEST_CASE("No link of the file system leads a lesson out of its folder") {
    const test::TemporaryFolder outside, folder;
    std::ofstream(outside.file("secret.png"), std::ios::binary) << test::endless_picture();
    std::ofstream(outside.file("secret.toml")) << "name = 'secret'\n";
    fs::create_directory(folder.file("images"));
    fs::create_symlink(outside.file("secret.png"), folder.file("images/dot.png"));
    fs::create_symlink(outside.file(""), folder.file("images/all"));
    fs::create_symlink(outside.file("secret.toml"), folder.file("images/scene.toml"));
    const auto lesson_with = [&](const std::string& text) {
        return folder.write("01-hostile.md", test::lesson_head() + text);
    };
    const std::string must_be = " must be a PNG in the lessons folder or in ../screenshots/.";
    refused(lesson_with("![a](images/dot.png)"), {10, "the picture 'images/dot.png'" + must_be});
    refused(lesson_with("![a](images/all/secret.png)"),
            {10, "the picture 'images/all/secret.png'" + must_be});
    refused(lesson_with("## Step\n<!-- step\nscene = \"images/scene.toml\"\n-->\n"),
            {12, "there is no file 'images/scene.toml' in the lessons folder."});
}

TEST_CASE("A picture that claims a huge size is refused for the claim") {
    const test::TemporaryFolder folder;
    folder.write("dot.png", test::endless_picture());
    const std::string path = folder.write("01-hostile.md", test::lesson_head() + "![a](dot.png)");
    refused(path, {10, "the picture 'dot.png': a picture of 100000 x 100000 pixels is too large: a "
                       "side may have at most 4096."});
}

TEST_CASE("Tables of TOML nested a thousand deep are refused") {
    const test::TemporaryFolder folder;
    std::string row = "row = ";
    for (int i = 0; i < 1'000; ++i)
        row += "[";
    const std::string path = folder.write(
        "01-hostile.md", test::lesson_head() + "## Step\n<!-- step\n" + row + "\n-->\n");
    const Lesson lesson = read_lesson(path);
    REQUIRE(lesson.faults.size() == 1);
    CHECK(lesson.faults[0].line == 12);
    CHECK(lesson.faults[0].sentence.find("nest") != std::string::npos);
}

TEST_CASE("A mark of the byte order and lines that end as on Windows do no harm") {
    std::string text("\xef\xbb\xbf");
    for (const char c : test::lesson_head() + "Text.\n\n## A step\n\nMore.\n") {
        if (c == '\n') text += '\r';
        text += c;
    }
    const Lesson lesson = parse_lesson(text, "01-made.md");
    CHECK(lesson.faults.empty());
    CHECK(lesson.title == "Made to hurt");
    CHECK(lesson.steps.size() == 2);
}
