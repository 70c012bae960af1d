#include <regex>
#include <set>

#include "base/child_process.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using test::run;

namespace {

std::string printed(const std::string& what) {
    return run({"--print-for-package", what}).out;
}

/// What stands first in the indented lines of a help: "--scene", or the name of a command.
std::set<std::string> names_in(const std::string& help, const std::string& pattern) {
    const std::regex entry("\n  (?:-[a-z],)?(" + pattern + ")(?= |\n)");
    return {std::sregex_token_iterator(help.begin(), help.end(), entry, 1),
            std::sregex_token_iterator()};
}

/// A name as the man page has it.
std::string in_manual(const std::string& name) {
    return "\\fB" + std::regex_replace(name, std::regex("-"), "\\-") + "\\fR";
}

std::set<std::string> commands() {
    const std::string help = run({"--help"}).out;
    return names_in(help.substr(help.find("Subcommands:")), "[a-z]+");
}

/// What bash offers after these words.
std::string completed(const std::string& words) {
    const test::TemporaryFolder folder;
    folder.write("script", printed("bash"));
    ChildProcess bash({"/bin/bash", "-c",
                       "source " + folder.file("script") + "; COMP_WORDS=(rasterwalk " + words +
                           "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1));"
                           "_rasterwalk rasterwalk \"${COMP_WORDS[-1]}\" \"${COMP_WORDS[-2]}\";"
                           "echo \"${COMPREPLY[*]}\""},
                      {});
    return bash.read_line();
}

} // namespace

TEST_CASE("The man page explains every option, and those of a command in its section") {
    const std::string page = printed("manual");
    const std::string own = page.substr(0, page.find(".SH COMMANDS"));
    for (const std::string& option : names_in(run({"--help"}).out, "--[a-z-]+"))
        CHECK_THAT(own, ContainsSubstring("\n" + in_manual(option)) ||
                            ContainsSubstring(", " + in_manual(option)));
    REQUIRE(commands().size() > 10);
    for (const std::string& command : commands()) {
        const std::size_t begin = page.find("\n.SS " + command + " ");
        REQUIRE(begin != std::string::npos);
        const std::string section = page.substr(begin, page.find("\n.S", begin + 1) - begin);
        for (const std::string& option : names_in(run({command, "--help"}).out, "--[a-z-]+"))
            CHECK_THAT(section, ContainsSubstring(in_manual(option)));
    }
}

TEST_CASE("The completions know every option of every command") {
    for (const std::string& command : commands()) {
        INFO(command);
        std::string offered = ' ' + completed(command + " --") + ' ';
        for (const std::string& option : names_in(run({command, "--help"}).out, "--[a-z-]+")) {
            CHECK_THAT(offered, ContainsSubstring(' ' + option + ' '));
            CHECK_THAT(printed("zsh"), ContainsSubstring("'*" + option + '['));
            CHECK_THAT(printed("fish"),
                       ContainsSubstring("'__fish_seen_subcommand_from " + command + "' ") &&
                           ContainsSubstring(" -l " + option.substr(2) + ' '));
        }
    }
}

TEST_CASE("bash completes a command, and does not take a value for one") {
    CHECK(completed("rend") == "render");
    CHECK(completed("--stage rows --sce") == "--scene");
    CHECK(completed("rows --sce").empty());
    CHECK(completed("render x").empty());
}

TEST_CASE("What is printed for a package has a name") {
    CHECK(run({"--print-for-package", "pdf"}).exit_code == 2);
    CHECK_FALSE(names_in(run({"--help"}).out, "--[a-z-]+").contains("--print-for-package"));
}
