#include "session/background_steps.h"

#include <atomic>
#include <future>
#include <new>
#include <stdexcept>
#include <thread>

#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

/// Waits for the thread, or makes the steps.
void finish_steps(BackgroundSteps& steps) {
    while (!steps.is_done()) {
        steps.advance();
        std::this_thread::yield();
    }
}

} // namespace

TEST_CASE("Steps in the background are made until one is the last, by a thread or by the caller") {
    for (const StepMaker maker : {StepMaker::thread, StepMaker::advance}) {
        int made = 0;
        BackgroundSteps steps([&] { return ++made < 5; }, maker);
        CHECK(steps.has_thread() == (maker == StepMaker::thread));
        finish_steps(steps);
        CHECK(made == 5);
        CHECK(steps.fault().empty());
        steps.advance();
        CHECK(made == 5);
    }
}

TEST_CASE("The caller makes one step at a time, and none after stop()") {
    int made = 0;
    BackgroundSteps steps([&] { return ++made > 0; }, StepMaker::advance);
    CHECK(made == 0);
    steps.advance();
    steps.advance();
    CHECK(made == 2);
    steps.stop();
    CHECK_FALSE(steps.is_done());
    steps.advance();
    CHECK(steps.is_done());
    CHECK(made == 2);
}

TEST_CASE("A thread that is stopped finishes the step that it makes, and nothing waits for it") {
    std::promise<void> may_go_on;
    std::atomic<int> made = 0;
    BackgroundSteps steps([&] {
        may_go_on.get_future().wait();
        ++made;
        return true;
    });
    steps.stop();
    CHECK(made == 0);
    may_go_on.set_value();
    finish_steps(steps);
    CHECK(made <= 1); // it may have been stopped before its first step
    CHECK(steps.fault().empty());
}

TEST_CASE("A step that fails is the last, and what it says is kept") {
    for (const StepMaker maker : {StepMaker::thread, StepMaker::advance}) {
        int made = 0;
        BackgroundSteps steps(
            [&]() -> bool {
                if (++made == 3) throw std::runtime_error("The third failed.");
                return true;
            },
            maker);
        finish_steps(steps);
        CHECK(made == 3);
        CHECK(steps.fault() == "The third failed.");
        BackgroundSteps large([]() -> bool { throw std::bad_alloc(); }, maker);
        finish_steps(large);
        CHECK(large.fault() == "There is not enough memory for this.");
    }
}

} // namespace rasterwalk
