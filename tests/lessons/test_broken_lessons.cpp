// The lessons in tests/lessons/broken are broken on purpose, in every possible way. The expected
// messages are next to them, in expected.txt.

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/files.h"
#include "lessons/lesson_check.h"
#include "support/project_root.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

const std::string folder = project_root() + "/tests/lessons/broken";

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// Names of files as they are seen from the folder.
std::string from_folder(std::string text) {
    const std::string start = folder + "/";
    for (std::size_t at = 0; (at = text.find(start, at)) != text.npos;)
        text.erase(at, start.size());
    return text;
}

Lines expected_lines() {
    return lines_of(read_file(folder + "/expected.txt"));
}

/// Both lists, where they differ.
void compare(const Lines& reported, const Lines& expected) {
    for (const std::string& line : reported) {
        if (std::find(expected.begin(), expected.end(), line) == expected.end()) {
            UNSCOPED_INFO("is not expected: " << line);
        }
    }
    for (const std::string& line : expected) {
        if (std::find(reported.begin(), reported.end(), line) == reported.end()) {
            UNSCOPED_INFO("is not reported: " << line);
        }
    }
    CHECK(reported == expected);
}

} // namespace

TEST_CASE("Every fault of the broken lessons is named, with its line") {
    const Session session = empty_session();
    std::map<std::string, Lines> expected;
    for (const std::string& line : expected_lines())
        expected[line.substr(0, line.find(':'))].push_back(line);
    std::size_t lessons = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".md")) continue;
        INFO(name);
        const Lesson lesson = read_lesson(entry.path().string());
        Lines reported;
        for (const Fault& fault : check_lesson(lesson, session))
            reported.push_back(from_folder(fault_text(lesson, fault)));
        compare(reported, expected[name]);
        ++lessons;
    }
    CHECK(lessons == expected.size());
    CHECK(lessons >= 19);
}

TEST_CASE("rasterwalk check names the same faults, and ends with exit code 1") {
    const test::CliRun all = test::run({"check", folder});
    CHECK(all.exit_code == 1);
    compare(lines_of(from_folder(all.out)), expected_lines());
    CHECK(all.err ==
          "rasterwalk: " + std::to_string(expected_lines().size()) + " faults in 22 files.\n");

    const test::CliRun one = test::run({"check", folder + "/01-no-head.md"});
    CHECK(one.exit_code == 1);
    CHECK(lines_of(one.out).size() == 2);
    CHECK(one.err == "rasterwalk: 2 faults in 1 file.\n");
}

TEST_CASE("rasterwalk check ends with 4 for a missing file, with 3 for a folder without lessons") {
    const test::CliRun none = test::run({"check", folder + "/99-none.md"});
    CHECK(none.exit_code == 4);
    CHECK(from_folder(none.err) ==
          "rasterwalk: cannot read '99-none.md': there is no such file.\n");
    CHECK(none.out.empty());
    CHECK(test::run({"check", folder + "/images"}).exit_code == 3);
}
