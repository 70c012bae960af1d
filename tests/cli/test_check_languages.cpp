#include <filesystem>
#include <string>

#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

namespace fs = std::filesystem;

/// A lesson, the list of texts, and a language.
void write_course(const TemporaryFolder& folder) {
    fs::create_directories(folder.file("languages/sv"));
    folder.write("01-a.md", lesson_head() + "Words.\n");
    folder.write("languages/texts.toml", "name = 'English'\n[texts]\n'All' = ''\n");
    folder.write("languages/sv/texts.toml", "name = 'Svenska'\n[texts]\n'All' = 'Alla'\n");
}

} // namespace

TEST_CASE("check finds a translation from each folder above it") {
    const TemporaryFolder folder;
    write_course(folder);
    const std::string texts =
        folder.write("languages/sv/texts.toml", "name = 'Svenska'\n[texts]\n'All' = \"\\n\"\n");
    for (const char* const from : {"", "languages", "languages/sv", "languages/sv/texts.toml"}) {
        INFO(from);
        const CliRun faulty = run({"check", folder.file(from)});
        CHECK(faulty.exit_code == 1);
        CHECK_THAT(faulty.out, ContainsSubstring("languages/sv/texts.toml:3: the translation of "
                                                 "'All' must have letters, and no control "
                                                 "characters."));
    }
}

TEST_CASE("check misses the texts of a language that has none") {
    const TemporaryFolder folder;
    write_course(folder);
    CHECK(run({"check", folder.file("")}).exit_code == 0);
    fs::create_directories(folder.file("languages/xx"));
    const CliRun faulty = run({"check", folder.file("")});
    CHECK(faulty.exit_code == 1);
    CHECK_THAT(faulty.out, ContainsSubstring("languages/xx/texts.toml"));
}

TEST_CASE("check reads each file once where links lead back up") {
    const TemporaryFolder folder;
    write_course(folder);
    fs::create_directories(folder.file("scenes"));
    for (const char* const link : {"scenes/scenes", "scenes/models", "languages/sv/languages"})
        fs::create_directory_symlink("..", folder.file(link));
    const CliRun once = run({"check", folder.file("")});
    CHECK(once.exit_code == 0);
    CHECK_THAT(once.out, ContainsSubstring("2 files, no faults.\n"));
}
