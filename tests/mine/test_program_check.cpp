#include "mine/program_check.h"

#include <atomic>
#include <chrono>
#include <thread>

#include "base/error.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

CheckedProgram named_program(const char* name) {
    CheckedProgram checked;
    checked.files.name = name;
    return checked;
}

void wait_until_stopped(const CheckProgramOptions& options) {
    while (!options.is_stopped())
        std::this_thread::yield();
}

} // namespace

TEST_CASE("A check hands over what is known, step by step, and then the whole") {
    std::atomic<bool> may_end = false;
    ProgramCheck check(
        [&](const CheckProgramOptions& options) {
            options.say("Running it");
            options.report(named_program("so far"));
            while (!may_end)
                std::this_thread::yield();
            return named_program("whole");
        },
        {});
    while (check.so_far() == nullptr)
        std::this_thread::yield();
    CHECK(check.so_far()->files.name == "so far");
    CHECK(check.doing() == "Running it");
    CHECK_FALSE(check.is_done());
    may_end = true;
    CHECK(check.take()->files.name == "whole");
    CHECK(check.is_done());
}

TEST_CASE("What a check throws is thrown where its result is taken") {
    ProgramCheck check(
        [](const CheckProgramOptions&) -> CheckedProgram { throw InputError("no main()."); }, {});
    CHECK_THROWS_AS(check.take(), InputError);
}

TEST_CASE("A check that is stopped, or dropped in the middle, ends") {
    const auto work = [](const CheckProgramOptions& options) {
        wait_until_stopped(options);
        return named_program("stopped");
    };
    ProgramCheck check(work, {});
    CHECK_FALSE(check.is_done());
    check.stop();
    CHECK(check.is_done(std::chrono::seconds(60)));
    { const ProgramCheck dropped(work, {}); } // its destructor stops it
}

} // namespace rasterwalk
