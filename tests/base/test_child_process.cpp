#include "base/child_process.h"

#include <string>

#include "base/error.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;

namespace {

ChildProcess shell(const std::string& script, const ChildProcess::Patience& patience = {}) {
    return ChildProcess({"/bin/sh", "-c", script}, patience);
}

/// The message when the program is asked for a line.
std::string complaint(const std::string& script, std::chrono::milliseconds longest = 30s) {
    ChildProcess child({"/bin/sh", "-c", script}, {.longest = longest, .is_stopped = {}});
    try {
        return "no fault, but: " + child.read_line();
    } catch (const Error& fault) {
        CHECK(fault.code == ExitCode::no_access);
        return fault.what();
    }
}

} // namespace

TEST_CASE("A child process answers line by line, and byte by byte") {
    ChildProcess child = shell("while read -r line; do echo \"heard $line\"; printf 'a\\nb'; done");
    child.write_line("one");
    CHECK(child.read_line() == "heard one");
    CHECK(child.read_bytes(3) == "a\nb");
    child.write_line("two words");
    CHECK(child.read_line() == "heard two words");
}

TEST_CASE("A long answer arrives completely") {
    ChildProcess child = shell("head -c 3000000 /dev/zero; echo end");
    CHECK(child.read_bytes(3'000'000) == std::string(3'000'000, '\0'));
    CHECK(child.read_line() == "end");
}

TEST_CASE("Many bytes are written, however slowly they are read") {
    ChildProcess child = shell("sleep 0.2; head -c 3000001 | cksum; echo end");
    child.write_bytes(std::string(3'000'000, 'x'));
    child.write_bytes("y");
    std::string expected;
    {
        ChildProcess sum = shell("{ head -c 3000000 /dev/zero | tr '\\000' x; printf y; } | cksum");
        expected = sum.read_line();
    }
    CHECK(child.read_line() == expected);
    CHECK(child.read_line() == "end");
}

TEST_CASE("Bytes that are not taken are an error") {
    ChildProcess deaf({"/bin/sh", "-c", "exec sleep 10"}, {.longest = 300ms, .is_stopped = {}});
    try {
        deaf.write_bytes(std::string(3'000'000, 'x'));
        FAIL("they were taken");
    } catch (const AccessError& fault) {
        CHECK(std::string(fault.what()) == "'/bin/sh' has not answered for 0.3 s.");
    }
    ChildProcess gone = shell("exit 3");
    CHECK_THROWS_AS(gone.write_bytes(std::string(3'000'000, 'x')), AccessError);
}

TEST_CASE("A missing program is an error that names it") {
    try {
        ChildProcess({"/nowhere/at-all"}, {});
        FAIL("it was started");
    } catch (const AccessError& fault) {
        CHECK(std::string(fault.what()) ==
              "cannot start '/nowhere/at-all': No such file or directory.");
    }
}

TEST_CASE("If a program ends before it answers, the error says how it ended") {
    CHECK_THAT(complaint("exit 7"), ContainsSubstring("ended with exit code 7"));
    CHECK_THAT(complaint("kill -SEGV $$"), ContainsSubstring("signal: Segmentation fault"));
    CHECK_THAT(complaint("printf half; exit 0"), ContainsSubstring("ended with exit code 0"));
    CHECK_THAT(complaint("exec head -c 100000 /dev/zero"), ContainsSubstring("too long"));
}

TEST_CASE("Asking a program that has ended is an error, not a signal") {
    ChildProcess child = shell("exit 3");
    const auto ask_on = [&] {
        for (int i = 0; i < 1000; ++i) {
            child.write_line("?");
            child.read_line();
        }
    };
    CHECK_THROWS_AS(ask_on(), AccessError);
}

TEST_CASE("A silent program is waited for up to the time limit, not longer") {
    CHECK_THAT(complaint("exec sleep 1000", 50ms),
               ContainsSubstring("has not answered for 0.05 s"));
}

TEST_CASE("Waiting stops when asked to") {
    int asked = 0;
    ChildProcess child =
        shell("exec sleep 1000", {.longest = 1000s, .is_stopped = [&] { return ++asked > 1; }});
    CHECK_THROWS_AS(child.read_line(), WaitingStopped);
    CHECK(asked == 2);
}
