#include "session/speed.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Speed steps_a_second(double rate) {
    return {SpeedUnit::steps, rate};
}
Speed frame_in(double seconds) {
    return {SpeedUnit::frame, seconds};
}
constexpr Speed no_limit{SpeedUnit::unlimited, 0.0};

std::vector<std::string> labels(double steps) {
    std::vector<std::string> all;
    for (const Speed& speed : speed_dial(steps))
        all.push_back(speed_text(speed));
    return all;
}

/// Frames of one step, of the bench, of the room, of very many triangles.
constexpr double frames[] = {0, 1, 11, 29, 30, 31, 42, 300, 5'000, 19'000, 900'000, 3e9};

} // namespace

TEST_CASE("A speed has a name in words") {
    CHECK(speed_text(steps_a_second(1)) == "1 step/s");
    CHECK(speed_text(steps_a_second(8)) == "8 steps/s");
    CHECK(speed_text(steps_a_second(1000)) == "1000 steps/s");
    CHECK(speed_text(Speed{}) == "frame in 15 s");
    CHECK(speed_text(frame_in(60)) == "frame in 1 min");
    CHECK(speed_text(frame_in(600)) == "frame in 10 min");
    CHECK(speed_text(no_limit) == "no limit");
}

TEST_CASE("A frame of few steps does not take 15 seconds, but half a second per step") {
    CHECK(speed_in(Speed{}, 11) == steps_a_second(2));
    CHECK(speed_in(Speed{}, 29.9) == steps_a_second(2));
    CHECK(speed_in(Speed{}, 30) == Speed{});
    CHECK(speed_in(frame_in(4), 11) == frame_in(4));
    CHECK(speed_in(steps_a_second(1), 11) == steps_a_second(1));
    CHECK(speed_in(no_limit, 11) == no_limit);
    CHECK(rate_of(Speed{}, 11) == 2.0);
    CHECK(rate_of(Speed{}, 900) == 60.0);
}

TEST_CASE("The dial leads from one step a second over the frame in 15 s to no limit") {
    CHECK(labels(42) == std::vector<std::string>{"1 step/s", "2 steps/s", "frame in 15 s",
                                                 "frame in 8 s", "frame in 4 s", "frame in 2 s",
                                                 "frame in 1 s", "no limit"});
    CHECK(labels(11) == std::vector<std::string>{"1 step/s", "2 steps/s", "frame in 4 s",
                                                 "frame in 2 s", "frame in 1 s", "no limit"});
    const std::vector<std::string> large = labels(900'000);
    CHECK(large.front() == "1 step/s");
    CHECK(std::count(large.begin(), large.end(), "1000 steps/s") == 1);
    CHECK(std::count(large.begin(), large.end(), "frame in 10 min") == 1);
    CHECK(std::count(large.begin(), large.end(), "frame in 15 s") == 1);
    CHECK(large.back() == "no limit");
}

TEST_CASE("Every turn of the dial makes the play faster, whatever the frame, and none too much") {
    for (const double steps : frames) {
        const std::vector<Speed> dial = speed_dial(steps);
        REQUIRE(dial.size() >= 3);
        CHECK(dial.front() == steps_a_second(1));
        CHECK(dial.back() == no_limit);
        for (std::size_t i = 1; i < dial.size(); ++i) {
            const double before = rate_of(dial[i - 1], steps), now = rate_of(dial[i], steps);
            CAPTURE(steps, speed_text(dial[i - 1]), speed_text(dial[i]));
            CHECK(now > before);
            const bool leads_over = dial[i].unit != dial[i - 1].unit;
            if (!leads_over && steps < 1e6) CHECK(now < 3.0 * before);
        }
    }
}

TEST_CASE("Every speed of the dial is found again at its place, and from its neighbours") {
    for (const double steps : frames) {
        const std::vector<Speed> dial = speed_dial(steps);
        for (std::size_t i = 0; i < dial.size(); ++i) {
            CAPTURE(steps, speed_text(dial[i]));
            CHECK(speed_at(dial_place(dial[i], steps), steps) == dial[i]);
            CHECK(faster(dial[i], steps) == dial[std::min(i + 1, dial.size() - 1)]);
            CHECK(slower(dial[i], steps) == dial[i > 0 ? i - 1 : 0]);
        }
        CHECK(dial_place(dial.front(), steps) == 0.0);
        CHECK(dial_place(dial.back(), steps) == 1.0);
        CHECK(speed_at(-3.0, steps) == dial.front());
        CHECK(speed_at(3.0, steps) == dial.back());
    }
}

TEST_CASE("A speed that this frame's dial does not have is between its neighbours") {
    // 250 steps a second are the bench's frame in a sixth of a second.
    CHECK(dial_place(steps_a_second(250), 42) < 1.0);
    CHECK(speed_at(dial_place(steps_a_second(250), 42), 42) == frame_in(1));
    CHECK(faster(steps_a_second(250), 42) == no_limit);
    CHECK(slower(steps_a_second(250), 42) == frame_in(1));
    CHECK(speed_at(dial_place(frame_in(600), 900), 900) == steps_a_second(2));
}
