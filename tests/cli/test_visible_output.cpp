// Texts and file names cannot send commands to the terminal.

#include "cli/visible_output.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include <unistd.h>

#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using test::CliRun;
using test::run;

namespace {

const std::string orders = "\x1b[31m\xc2\x9b"
                           "5m\xe2\x80\xae";
const std::string shown = "\\u001b[31m\\u009b5m\\u202e";

bool is_harmless(const std::string& text) {
    return text.find('\x1b') == text.npos && text.find("\xc2\x9b") == text.npos &&
           text.find("\xe2\x80\xae") == text.npos;
}

/// The lab's room with terminal commands in its name and in the names of its parts.
std::string bad_room(const test::TemporaryFolder& folder) {
    std::string text = test::bytes_of(lessons_folder() + "/scenes/lab-room.toml");
    for (std::size_t at = 0; (at = text.find("name = \"", at)) != text.npos; at += 8)
        text.insert(at + 8, "\\u001b[31m\\u009b5m\\u202e");
    return folder.write("room" + orders + ".toml", text);
}

/// Feeds a file to the standard input during its lifetime.
class StandardInput {
  public:
    explicit StandardInput(const std::string& path) : kept_(::dup(STDIN_FILENO)) {
        if (std::freopen(path.c_str(), "r", stdin) == nullptr) std::abort();
    }
    StandardInput(const StandardInput&) = delete;
    StandardInput& operator=(const StandardInput&) = delete;
    ~StandardInput() {
        ::dup2(kept_, STDIN_FILENO);
        ::close(kept_);
    }

  private:
    int kept_;
};

} // namespace

TEST_CASE("Text is passed on line by line, and a letter is never cut") {
    std::ostringstream target;
    {
        VisibleOutput out(target);
        out << "a" << 1 << "\xe2"
            << "\x82"
            << "\xac";
        CHECK(target.str().empty());
        out << "\nb";
        CHECK(target.str() == "a1€\n");
        out.put('\x1b');
        out.flush();
        CHECK(target.str() == "a1€\nb\\u001b");
        out << "end";
    }
    CHECK(target.str() == "a1€\nb\\u001bend");
    target.setstate(std::ios::badbit);
    VisibleOutput out(target);
    out << "lost\n" << std::flush;
    CHECK_FALSE(out);
}

TEST_CASE("A scene's name cannot send commands to the terminal") {
    const test::TemporaryFolder folder;
    const std::string room = bad_room(folder);
    for (const std::vector<std::string>& command : {std::vector<std::string>{"triangle", "3"},
                                                    {"pixel", "250,250"},
                                                    {"stats"},
                                                    {"compare", "--b", "interpolation=affine"}}) {
        for (const bool json : {false, true}) {
            std::vector<std::string> arguments = command;
            arguments.insert(arguments.end(), {"--scene", room});
            if (json) arguments.emplace_back("--json");
            INFO(command[0] << (json ? " --json" : ""));
            const CliRun result = run(arguments);
            CHECK(result.exit_code <= 1);
            CHECK(is_harmless(result.out));
            CHECK(is_harmless(result.err));
            if (command[0] == "triangle" && !json)
                CHECK(result.out.find(shown) != std::string::npos);
        }
    }
}

TEST_CASE("Messages show control characters as escapes, on one line") {
    const test::TemporaryFolder folder;
    const std::string name = orders + "\nrasterwalk: all is well.toml";
    const CliRun result = run({"stats", "--scene", folder.file(name)});
    CHECK(result.exit_code == 4);
    CHECK(is_harmless(result.err));
    CHECK(result.err.find(shown + "\\u000arasterwalk") != std::string::npos);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    const CliRun check =
        run({"check", folder.write("x.toml", "name = '" + orders.substr(7) + "'\n" + orders)});
    CHECK(check.exit_code == 1);
    CHECK(is_harmless(check.out));
    CHECK(is_harmless(run({orders}).err));
    CHECK(is_harmless(run({"stats", "--set", orders}).err));
    const CliRun rows = run({"diagnose", folder.write("rows", "Start: " + orders)});
    CHECK(rows.exit_code == 3);
    CHECK(is_harmless(rows.err));
}

TEST_CASE("'-' is the standard input: rows, a picture, a scene") {
    const test::TemporaryFolder folder;
    const std::string rows = folder.write("rows", run({"rows", "10,5", "5,10", "15,15"}).out);
    const std::vector<std::string> polygon{"diagnose",  "-",    "--polygon", "10,5",
                                           "--polygon", "5,10", "--polygon", "15,15"};
    {
        const StandardInput input(rows);
        const CliRun result = run(polygon);
        CHECK(result.exit_code == 0);
    }
    const std::string picture = folder.file("x.png");
    REQUIRE(run({"render", "--stage", "points", "--size", "60x60", "-o", picture}).exit_code == 0);
    {
        const StandardInput input(picture);
        const CliRun result = run({"diagnose", "--stage", "points", "--size", "60x60", "-"});
        CHECK(result.exit_code == 0);
    }
    {
        const StandardInput input(lessons_folder() + "/scenes/lab-room.toml");
        CHECK(run({"stats", "--scene", "-"}).out == run({"stats"}).out);
    }
    const StandardInput input(folder.write("bad", "name = 5\n"));
    CHECK(run({"-"}).err.starts_with("rasterwalk: standard input:1: "));
}
