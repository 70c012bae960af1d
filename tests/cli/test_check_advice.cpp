#include <string>

#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("Advice comes after the faults, is counted, and is not a fault") {
    const TemporaryFolder folder;
    const std::string path = folder.write("01-a.md", lesson_head() + "The outcode.\n");
    const CliRun plain = run({"check", path});
    CHECK(plain.exit_code == 0);
    CHECK(plain.out == "1 file, no faults.\n");
    const CliRun advised = run({"check", "--advice", path});
    CHECK(advised.exit_code == 0);
    CHECK(advised.err.empty());
    CHECK_THAT(advised.out, ContainsSubstring(path + ":10: advice: 'outcode' is used here"));
    CHECK_THAT(advised.out, ContainsSubstring("1 file, no faults, 3 pieces of advice.\n"));

    folder.write("02-b.md", lesson_head() + "A [link](03-none.md).\n");
    const CliRun faulty = run({"check", "--advice", folder.file("")});
    CHECK(faulty.exit_code == 1);
    CHECK(faulty.out.find("03-none") < faulty.out.find("advice: "));
}

TEST_CASE("Advice on one lesson knows what the lessons before it explain") {
    const TemporaryFolder folder;
    folder.write("02-b.md", lesson_head() + "The *outcode*.\n");
    const std::string path = folder.write("01-a.md", lesson_head() + "The outcode.\n");
    CHECK_THAT(run({"check", "--advice", path}).out, ContainsSubstring("'outcode'"));
    folder.write("course.toml", "[[track]]\ntitle = 'T'\nabout = 'A.'\nneeds = 'N.'\n"
                                "lessons = [{ id = '02-b' }, { id = '01-a' }]\n");
    CHECK(run({"check", "--advice", path}).out.find("outcode") == std::string::npos);
}

TEST_CASE("check reads the course of a folder and misses a lesson that it names") {
    const TemporaryFolder folder;
    folder.write("01-a.md", lesson_head() + "Words.\n");
    const std::string head = "[[track]]\ntitle = 'T'\nabout = 'A.'\nneeds = 'N.'\n";
    const std::string path = folder.write("course.toml", head + "lessons = [{ id = '01-a' }]\n");
    CHECK(run({"check", folder.file("")}).out == "2 files, no faults.\n");
    folder.write("course.toml", head + "lessons = [{ id = '01-a' }, { id = '02-b' }]\n");
    const CliRun faulty = run({"check", path});
    CHECK(faulty.exit_code == 1);
    CHECK_THAT(faulty.out, ContainsSubstring("course.toml:5: there is no lesson '02-b'."));
    CHECK(run({"check", lessons_folder() + "/course.toml"}).out == "1 file, no faults.\n");
}
