#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

void write(const std::string& path, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << text;
}

} // namespace

TEST_CASE("The style check finds a planted phrase, with file, line and advice") {
    const TemporaryFolder folder;
    // In two parts, or the check would find it here.
    const std::string planted = std::string("Tell") + " a triangle's vertices";
    write(folder.file("ui/panel.cpp"), "int a;\n// Shows the vertices.\n");
    write(folder.file("lessons/01-one.md"), "# One\n\nThe vertices.\n");
    const CliRun clean = run({"check", "--style", folder.file("ui"), folder.file("lessons")});
    CHECK(clean.exit_code == 0);
    CHECK(clean.out == "2 files, no faults.\n");

    write(folder.file("ui/panel.cpp"), "int a;\nadd(\"" + planted + "\");\n");
    const CliRun faulty = run({"check", "--style", folder.file("ui"), folder.file("lessons")});
    CHECK(faulty.exit_code == 1);
    CHECK_THAT(faulty.out, StartsWith(folder.file("ui/panel.cpp") + ":2: \"tell"));
    CHECK_THAT(faulty.err, ContainsSubstring("1 fault in 2 files"));
}

TEST_CASE("The style check reads subfolders, and named files whatever their names") {
    const TemporaryFolder folder;
    const std::string planted = std::string("# Tell") + " a triangle's vertices\n";
    write(folder.file("a/b/CMakeLists.txt"), planted);
    write(folder.file("a/build/made.cmake"), planted);
    write(folder.file("a/.hidden/c.cmake"), planted);
    write(folder.file("a/picture.png"), planted);
    write(folder.file("script"), planted);
    const CliRun below = run({"check", "--style", folder.file("a")});
    CHECK_THAT(below.err, ContainsSubstring("1 fault in 1 file"));
    const CliRun named = run({"check", "--style", folder.file("script")});
    CHECK_THAT(named.err, ContainsSubstring("1 fault in 1 file"));
    CHECK(run({"check", "--style", folder.file("nowhere")}).exit_code == 4);
    CHECK(run({"check", "--style", folder.file("a/.hidden/none")}).exit_code == 4);
}
