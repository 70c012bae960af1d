// `rasterwalk mine` on whole programs. Most of the time goes into the student's compiler, so one
// cache serves all tests of the file, and keys are held nowhere: other tests do that.

#include "cli/cli.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/json.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using test::CliRun;
using test::TemporaryFolder;

namespace {

CliRun run_mine(std::vector<std::string> arguments) {
    static const TemporaryFolder cache;
    setenv("RASTERWALK_CACHE", cache.file("cache").c_str(), 1);
    arguments.insert(arguments.begin(), {"mine", "--no-keys"});
    return test::run(arguments);
}

std::string student(const std::string& path) {
    return project_root() + "/tests/mine/" + path;
}

/// A program that shows an empty window, and has one function of the lab or none.
std::string empty_program(const std::string& functions = {}) {
    return "#include <vector>\n"
           "#include <glm/glm.hpp>\n"
           "#include <SDL.h>\n"
           "#include \"SDLauxiliary.h\"\n"
           "#include \"TestModel.h\"\n"
           "SDL_Surface* screen;\n" +
           functions +
           "int main(int argc, char* argv[]) {\n"
           "    screen = InitializeSDL(32, 24);\n"
           "    while (NoQuitMessageSDL()) SDL_UpdateRect(screen, 0, 0, 0, 0);\n"
           "    return 0;\n"
           "}\n";
}

} // namespace

TEST_CASE("mine says that a right program is right") {
    const CliRun result = run_mine({student("styles/classic.cpp")});
    CAPTURE(result.out, result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, ContainsSubstring("classic.cpp\n"));
    CHECK_THAT(result.out, ContainsSubstring("\nNothing wrong was found in the first frame"));
    CHECK(result.out.find("Fix first") == std::string::npos);
    for (const char* function :
         {"VertexShader", "Interpolate", "ComputePolygonRows", "DrawPolygonRows", "PixelShader"})
        CHECK_THAT(result.out, ContainsSubstring(std::string("  right           ") + function));
}

TEST_CASE("mine names the mistake of a wrong program, and its lesson") {
    const CliRun result = run_mine({student("handout/02-wireframe.cpp")});
    CAPTURE(result.out, result.err);
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, ContainsSubstring("Fix first:\n"));
    CHECK_THAT(result.out, ContainsSubstring("    B11: "));
    CHECK_THAT(result.out, ContainsSubstring("Lesson "));
    CHECK(result.out.find("Nothing wrong was found") == std::string::npos);
}

TEST_CASE("mine prints why a program does not compile, with file and line") {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("lab.cpp", empty_program("int answer() {\n    return 42\n}\n"));
    const CliRun result = run_mine({path});
    CAPTURE(result.out, result.err);
    CHECK(result.exit_code == 3);
    CHECK_THAT(result.out, ContainsSubstring("It does not compile with "));
    CHECK_THAT(result.out, ContainsSubstring("lab.cpp:8: "));
    // The path of a copy in the cache means nothing to the student.
    CHECK(result.out.find("copies") == std::string::npos);
    const CliRun json = run_mine({path, "--json"});
    CHECK(json.exit_code == 3);
    const Json program = Json::parse(json.out);
    CHECK(program["compiles"] == false);
    CHECK(program["right"] == false);
    CHECK(program["messages"][0]["line"] == 8);
    CHECK(program["messages"][0]["error"] == true);
    CHECK_FALSE(program.contains("run"));
}

TEST_CASE("mine ends with a sentence if there is nothing to check") {
    const TemporaryFolder folder;
    folder.write("lines.cpp", "int two() { return 2; }\n");
    struct Expected {
        std::vector<std::string> arguments;
        int exit_code;
    };
    for (const Expected& expected :
         {Expected{{folder.file("nowhere.cpp")}, 4}, Expected{{folder.file("")}, 3},
          Expected{{folder.file("lines.cpp")}, 3}, Expected{{}, 2},
          Expected{{student("styles/classic.cpp"), "--compiler", "nonesuch"}, 4},
          Expected{{student("styles/classic.cpp"), "--seconds", "0"}, 2}}) {
        const CliRun result = run_mine(expected.arguments);
        CAPTURE(expected.arguments, result.out, result.err);
        CHECK(result.exit_code == expected.exit_code);
        CHECK(result.out.empty());
        CHECK(result.err.ends_with(".\n"));
    }
}

TEST_CASE("mine --new writes a program that compiles and claims nothing") {
    const TemporaryFolder folder;
    const std::string lab = folder.file("lab");
    const CliRun written = run_mine({"--new", lab});
    CAPTURE(written.err);
    REQUIRE(written.exit_code == 0);
    CHECK(written.out.empty());
    CHECK_THAT(written.err, ContainsSubstring("a program to begin with is in"));
    const std::string skeleton = test::bytes_of(lab + "/skeleton.cpp");
    CHECK(std::filesystem::exists(lab + "/TestModel.h"));

    const CliRun again = run_mine({"--new", lab});
    CHECK(again.exit_code == 2);
    CHECK_THAT(again.err, ContainsSubstring("is there already; nothing was written."));
    CHECK(test::bytes_of(lab + "/skeleton.cpp") == skeleton);

    const CliRun checked = run_mine({lab, "--json"});
    CAPTURE(checked.err);
    REQUIRE((checked.exit_code == 0 || checked.exit_code == 1));
    const Json program = Json::parse(checked.out);
    CHECK(program["compiles"] == true);
    CHECK(program["run"]["faults"].empty());
    for (const Json& function : program["functions"]) {
        CAPTURE(function.dump());
        CHECK(function["state"] != "wrong");
        CHECK(function["state"] != "died");
    }
    for (const Json& mistake : program["mistakes"])
        CHECK(mistake["bugs"].empty());
}

TEST_CASE("mine checks a folder of hand-ins: table, page, and tables put together") {
    const TemporaryFolder folder, tables;
    const std::string right = "a-right", broken = "b-broken", hostile = "c<script>alert(1)";
    for (const std::string& name : {right, broken, hostile})
        std::filesystem::create_directory(folder.file(name));
    folder.write(right + "/lab.cpp", test::bytes_of(student("styles/classic.cpp")));
    folder.write(broken + "/lab.cpp", empty_program("int answer() { return 42 }\n"));
    folder.write(hostile + "/lab.cpp", empty_program());

    const std::string page = tables.file("page.html");
    const CliRun result = run_mine({folder.file(""), "--json", "--html", page});
    CAPTURE(result.err);
    CHECK(result.exit_code == 1);
    const Json table = Json::parse(result.out);
    REQUIRE(table.is_array());
    REQUIRE(table.size() == 3);
    CHECK(table[0]["name"] == right);
    CHECK(table[0]["right"] == true);
    CHECK(table[0]["compiles"] == true);
    CHECK(table[0]["mistakes"].empty());
    CHECK(table[0]["keys_tested"] == false);
    CHECK(table[0]["functions"][0]["state"] == "right");
    CHECK(table[0]["picture"]["right"] == true);
    CHECK(table[0]["picture"]["pixels"] == 250000);
    CHECK(table[0]["sequence"]["same"] == true);
    CHECK(table[1]["name"] == broken);
    CHECK(table[1]["compiles"] == false);
    CHECK(table[1]["right"] == false);
    CHECK(table[2]["name"] == hostile);
    CHECK(table[2]["right"] == false);
    CHECK(table[2]["run"]["width"] == 32);
    CHECK(table[2]["run"]["height"] == 24);
    CHECK(table[2]["functions"][0]["state"] == "not written yet");

    const std::string html = test::bytes_of(page);
    CHECK(html.starts_with("<!DOCTYPE html>"));
    CHECK_THAT(html, ContainsSubstring("c&lt;script&gt;alert(1)"));
    for (const char* forbidden : {"<script", "http:", "https:", "src=\"//", "<link", "@import"})
        CHECK(html.find(forbidden) == std::string::npos);
    CHECK_THAT(html, ContainsSubstring("<h1>1 of 3 programs are right</h1>"));
    CHECK_THAT(html, ContainsSubstring("src=\"data:image/png;base64,"));

    // The same programs, in two tables in the wrong order.
    const std::string first = tables.write("first.json", Json::array({table[2], table[0]}).dump());
    const std::string second = tables.write("second.json", table[1].dump());
    const CliRun merged = run_mine({"--merge", first, second, "--json"});
    CHECK(merged.exit_code == 1);
    CHECK(Json::parse(merged.out) == table);
    const CliRun only_right = run_mine({"--merge", tables.write("right.json", table[0].dump())});
    CHECK(only_right.exit_code == 0);
    CHECK(only_right.out == "right       a-right\n");
}

TEST_CASE("a hand-in that cannot be checked has a line, and the others are checked") {
    const TemporaryFolder folder, tables;
    for (const char* const name : {"a-none", "b-empty", "c-empty"})
        std::filesystem::create_directory(folder.file(name));
    folder.write("a-none/lab.cpp", "int WinMain() { }\n");
    folder.write("b-empty/lab.cpp", empty_program());
    folder.write("c-empty/lab.cpp", empty_program());
    folder.write("d.zip", "PK");
    const std::string page = tables.file("page.html");
    const CliRun result = run_mine({folder.file(""), "--html", page});
    CAPTURE(result.out, result.err);
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out,
               ContainsSubstring("not checked a-none: no source in this folder has a main().\n"));
    CHECK_THAT(result.out, ContainsSubstring("differs     b-empty: "));
    CHECK_THAT(result.out, ContainsSubstring("differs     c-empty: "));
    CHECK_THAT(result.out, ContainsSubstring("not checked d.zip: an archive must be unpacked "
                                             "first.\n"));
    const std::string html = test::bytes_of(page);
    CHECK_THAT(html, ContainsSubstring("<h1>0 of 4 programs are right, 2 not checked</h1>"));

    // By itself: a sentence, and a table all the same.
    const CliRun single = run_mine({folder.file("a-none"), "--json"});
    CHECK(single.exit_code == 3);
    CHECK_THAT(single.err, ContainsSubstring("no source in this folder has a main()."));
    const CliRun merged = run_mine({"--merge", tables.write("a.json", single.out)});
    CHECK_THAT(merged.out, ContainsSubstring("not checked a-none: "));
}

TEST_CASE("mine says that a page cannot be written before it checks anything") {
    const TemporaryFolder folder;
    const std::string program = folder.write("lab.cpp", empty_program());
    const CliRun result = run_mine({program, "--html", folder.file("gone/page.html")});
    CHECK(result.exit_code == 4);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, ContainsSubstring("there is no folder"));
}

TEST_CASE("a program that could not be judged is not said to differ") {
    const TemporaryFolder folder;
    const std::string table = folder.write("table.json", R"([
        {"name": "a", "compiles": true, "judged": false, "right": false, "mistakes": []},
        {"name": "b", "compiles": true, "judged": true, "right": false,
         "mistakes": [{"bugs": ["B5"], "sentence": "Rows are missing."}]},
        {"name": "c", "compiles": true, "judged": true, "right": true, "mistakes": []}])");
    const std::string page = folder.file("page.html");
    const CliRun result = run_mine({"--merge", table, "--html", page});
    CHECK(result.exit_code == 1);
    CHECK(result.out == "not judged  a\ndiffers     b: B5. Rows are missing.\nright       c\n");
    CHECK_THAT(test::bytes_of(page),
               ContainsSubstring("<h1>1 of 3 programs are right, 1 could not be judged</h1>"));
}

TEST_CASE("mine --merge takes only tables that mine has printed") {
    const TemporaryFolder folder;
    for (const char* nonsense : {"", "nonsense", "{\"name\": 3}", "[1, 2]", "[{\"name\": \"a\"}]",
                                 "{\"name\": [], \"mistakes\": []}"}) {
        const CliRun result = run_mine({"--merge", folder.write("table.json", nonsense)});
        CAPTURE(nonsense, result.err);
        CHECK(result.exit_code == 3);
        CHECK(result.out.empty());
        CHECK_THAT(result.err, ContainsSubstring("is no table that"));
    }
    CHECK(run_mine({"--merge", folder.file("none.json")}).exit_code == 4);
}

TEST_CASE("mine --merge makes a harmless page of a hostile table") {
    const TemporaryFolder folder;
    const std::string table = folder.write("table.json", R"([{
        "name": "<img src=x onerror=alert(1)>", "mistakes": [{"bugs": [7, "<b>"], "sentence": 3,
        "file": "\"><script>", "line": 1e300}, 5, null], "right": "yes", "functions": {"a": 1},
        "picture": {"theirs": "https://example.org/x.png", "ours": "data:image/svg+xml,<svg/>"},
        "messages": [{"error": true, "text": "<script>"}], "run": [], "keys": 4}])");
    const std::string page = folder.file("page.html");
    const CliRun result = run_mine({"--merge", table, "--html", page});
    CAPTURE(result.err);
    const std::string html = test::bytes_of(page);
    CHECK_THAT(html, ContainsSubstring("&lt;img src=x onerror=alert(1)&gt;"));
    for (const char* forbidden : {"<script", "<img src=x", "example.org", "svg+xml", "<b><b>"})
        CHECK(html.find(forbidden) == std::string::npos);
}
