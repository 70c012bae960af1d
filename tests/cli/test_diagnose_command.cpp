#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/made_images.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using test::CliRun;
using test::run;

namespace {

CliRun render(const std::string& path, std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "-o", path, "--size", "100x90"});
    return run(more);
}

} // namespace

TEST_CASE("diagnose finds no difference in the reference itself, exit code 0") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(render(path, {}).exit_code == 0);
    const CliRun result = run({"diagnose", path, "--json"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, ContainsSubstring("\"verdict\" : \"no difference\""));
    CHECK_THAT(result.out, ContainsSubstring("\"candidates\" : []"));
    CHECK_THAT(result.err,
               ContainsSubstring("100 x 90 pixels; the reference is drawn at that size"));
}

TEST_CASE("diagnose names the mistake, exit code 1") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(render(path, {"--set", "interpolation=affine", "--set", "light.power=14"}).exit_code ==
            0);
    const CliRun result = run({"diagnose", path, "--set", "light.power=14", "--size", "100x90"});
    CHECK(result.exit_code == 1);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, ContainsSubstring(": B3 "));
    CHECK_THAT(result.out, ContainsSubstring("Exact match: "));
    const CliRun json = run({"diagnose", path, "--json"});
    CHECK(json.exit_code == 1);
    CHECK_THAT(json.out, ContainsSubstring("\"kind\" : \"picture\""));
    CHECK_THAT(json.out, ContainsSubstring("\"B3\""));
}

TEST_CASE("diagnose names the rules that a correct picture is drawn by") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(render(path, {"--set", "vertex_rounding=truncate_sum", "--stage", "fill"}).exit_code ==
            0);
    const CliRun result = run({"diagnose", path});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, ContainsSubstring("no difference"));
    CHECK_THAT(result.out, ContainsSubstring("Your program draws with stage=fill and "
                                             "vertex_rounding=truncate_sum, which is just as "
                                             "correct"));
}

TEST_CASE("diagnose stops after its seconds and says so") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(
        render(path, {"--set", "edge_samples=rows", "--set", "interpolation=affine"}).exit_code ==
        0);
    const CliRun result = run({"diagnose", path, "--seconds", "0.000001"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, ContainsSubstring("The search was stopped before everything had been "
                                             "tried"));
    CHECK_THAT(run({"diagnose", path, "--seconds", "0.000001", "--json"}).out,
               ContainsSubstring("\"complete\" : false"));
}

TEST_CASE("A picture given as a scene gets a message that says where to give it, exit code 2") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(render(path, {}).exit_code == 0);
    const std::vector<std::vector<std::string>> wrong = {
        {path},
        {"--scene", path},
        {"--lesson", "05-row-table", "--scene", path},
        {"stats", "--scene", path}};
    for (const std::vector<std::string>& arguments : wrong) {
        const CliRun result = run(arguments);
        INFO(result.err);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK_FALSE(result.request.open_window);
        CHECK_THAT(result.err, ContainsSubstring("mine.png' is a picture, not a scene"));
        CHECK_THAT(result.err, ContainsSubstring("'rasterwalk diagnose FILE'"));
    }
    CHECK(run({folder.file("none.png")}).exit_code == 4);
}

TEST_CASE("A picture that cannot be diagnosed is named, exit code 3, before it is unpacked") {
    const test::TemporaryFolder folder;
    const auto said = [&](const std::string& bytes) {
        const std::string path = folder.write("mine", bytes);
        const CliRun result = run({"diagnose", path});
        CHECK(result.exit_code == 3);
        CHECK(result.out.empty());
        const std::string begin = "rasterwalk: " + path + ": ";
        CHECK(result.err.starts_with(begin));
        return result.err.substr(std::min(begin.size(), result.err.size()));
    };
    // These have only a header with their size.
    CHECK(said(test::png(8192, 8192, 8, "")) ==
          "a picture of 8192 x 8192 pixels is too large: a side may have at most 4096.\n");
    CHECK(said(test::bmp(0, 2)) == "a picture of 0 x 2 pixels is empty.\n");
    CHECK(said(test::png(2, 2, 8, "\x78\x01\x07")) ==
          "the picture cannot be read: its data is damaged.\n");
}

TEST_CASE("diagnose reads a printed row table") {
    const test::TemporaryFolder folder;
    const CliRun rows = run({"rows", "2,3", "30,8", "11,19", "--set", "edge_samples=rows"});
    const std::string path = folder.write("rows.txt", rows.out);
    const CliRun result =
        run({"diagnose", path, "--polygon", "2,3", "--polygon", "30,8", "--polygon", "11,19"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out,
               ContainsSubstring("the polygon (2,3) (30,8) (11,19).\nExact match: B5 "));
    CHECK(run({"diagnose", path, "--polygon", "2;3"}).exit_code == 2);
}

TEST_CASE("diagnose complains about files in a sentence") {
    const test::TemporaryFolder folder;
    const auto exit_code = [&](const std::string& bytes) {
        const CliRun result = run({"diagnose", folder.write("result", bytes)});
        CHECK_FALSE(result.err.empty());
        CHECK(result.out.empty());
        return result.exit_code;
    };
    CHECK(exit_code("") == 3);
    CHECK(exit_code("something else\n") == 3);
    CHECK(exit_code("Start: (1,2). End: here.\n") == 3);
    CHECK(exit_code("\x89PNG\r\n\x1a\n and then nothing") == 3);
    CHECK(exit_code("BM and then nothing") == 3);
    CHECK(run({"diagnose", folder.file("none.png")}).exit_code == 4);
    CHECK(run({"diagnose"}).exit_code == 2);
    for (const char* seconds : {"0", "-1", "nan", "soon"})
        CHECK(run({"diagnose", folder.file("none.png"), "--seconds", seconds}).exit_code == 2);
}

TEST_CASE("diagnose and check show their progress on a terminal, and leave nothing there") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    REQUIRE(render(path, {"--set", "interpolation=affine"}).exit_code == 0);
    std::ostringstream terminal;
    const CliRun watched = run({"diagnose", path}, {}, &terminal);
    const CliRun plain = run({"diagnose", path});
    CHECK(watched.out == plain.out);
    CHECK(watched.err == plain.err);
    CHECK_THAT(terminal.str(), ContainsSubstring("\rTrying each mistake: "));
    CHECK_THAT(terminal.str(), ContainsSubstring(" pictures\x1b[K"));
    CHECK_THAT(terminal.str(), Catch::Matchers::EndsWith("\r\x1b[K"));

    terminal.str("");
    const std::string lesson = lessons_folder() + "/14-arrows.md";
    CHECK(run({"check", lesson}, {}, &terminal).out == run({"check", lesson}).out);
    CHECK_THAT(terminal.str(), ContainsSubstring("\rChecking 14-arrows.md: question 2 of "));
    CHECK_THAT(terminal.str(), Catch::Matchers::EndsWith("\r\x1b[K"));
}
