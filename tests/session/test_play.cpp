// The play with a separate clock: what the dial says is what happens, at every frame rate.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "session/content.h"
#include "session/results.h"
#include "session/walk.h"
#include "support/moments.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Session session_on(Scene scene, Stage stage) {
    Session session = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    set_scene(session, std::move(scene));
    session.a.settings.stage = stage;
    return session;
}

Session bench_session() {
    return open_session(lessons_folder() + "/scenes/one-triangle.toml");
}

/// A frame that is played, with everything that is known of it by plain loops.
struct Player {
    Session session;
    Results results;
    std::vector<Cursor> moments;        ///< all of the frame
    std::vector<std::size_t> triangles; ///< where each drawn one begins among them; and the end

    explicit Player(Session opened) : session(std::move(opened)) {
        finish(session, results);
        moments = test::all_moments(results.a.frame);
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (i == 0 || moments[i].triangle != moments[i - 1].triangle) triangles.push_back(i);
        }
        triangles.push_back(moments.size());
    }

    /// Presses Play at the end of the frame.
    void begin(Granularity step, const Speed& speed) {
        session.cursor = cursor_end;
        session.play = {};
        session.play.granularity = step;
        session.play.speed = speed;
        toggle_play(session, Timeline(results.a.frame));
    }

    /// Lets the clock run in ticks of 1 / frame_rate seconds until the play ends; returns how
    /// many seconds that took.
    double run(double seconds, int frame_rate) {
        const Timeline timeline(results.a.frame);
        const float tick = 1.0f / static_cast<float>(frame_rate);
        advance_play(session, timeline, results.length, 0.0f);
        const int ticks = static_cast<int>(std::lround(seconds * frame_rate));
        int done = 0;
        for (; done < ticks && session.play.running; ++done)
            advance_play(session, timeline, results.length, tick);
        return static_cast<double>(done) / frame_rate;
    }

    /// The beginning of every step, and `end`.
    std::vector<Cursor> steps(Granularity step) const {
        const Timeline timeline(results.a.frame);
        std::vector<Cursor> all{timeline.first()};
        while (all.back() != cursor_end)
            all.push_back(timeline.next(all.back(), step));
        return all;
    }

    /// The step at a part of the frame: drawn triangles are equally long.
    Cursor step_at(double part, const std::vector<Cursor>& all) const {
        const auto count = static_cast<double>(triangles.size() - 1);
        const double place = std::max(part, 0.0) * count;
        if (place >= count) return cursor_end;
        const auto t = static_cast<std::size_t>(place);
        const auto of_triangle = static_cast<double>(triangles[t + 1] - triangles[t]);
        const auto within = static_cast<std::size_t>((place - std::floor(place)) * of_triangle);
        return *(std::upper_bound(all.begin(), all.end(), moments[triangles[t] + within]) - 1);
    }
};

constexpr Granularity sizes_of_steps[] = {Granularity::moment, Granularity::line,
                                          Granularity::triangle, Granularity::phase};

/// Ten seconds at every position of the dial, in every size of steps.
void check_every_speed(Player& player, std::initializer_list<int> frame_rates) {
    for (const Granularity step : sizes_of_steps) {
        const std::vector<Cursor> all = player.steps(step);
        const std::size_t last = all.size() - 1;
        REQUIRE(player.results.length.of(step) == static_cast<double>(last));
        for (const Speed& speed : speed_dial(player.results.length.of(step))) {
            for (const int frame_rate : frame_rates) {
                CAPTURE(word_of(step), speed_text(speed), frame_rate);
                player.begin(step, speed);
                REQUIRE(player.session.cursor == all.front());
                player.run(10.0, frame_rate);
                const Cursor& now = player.session.cursor;
                CAPTURE(to_text(now));
                switch (speed.unit) {
                case SpeedUnit::steps:
                    REQUIRE(now ==
                            all[std::min(static_cast<std::size_t>(10.0 * speed.value), last)]);
                    break;
                case SpeedUnit::frame:
                    // The clock's own ticks are floats.
                    REQUIRE(now >= player.step_at(10.0 / speed.value - 1e-6, all));
                    REQUIRE(now <= player.step_at(10.0 / speed.value + 1e-6, all));
                    break;
                case SpeedUnit::unlimited:
                    REQUIRE(now == cursor_end);
                    break;
                }
                REQUIRE(player.session.play.running == (now != cursor_end));
            }
        }
    }
}

} // namespace

TEST_CASE("At every position of the dial ten seconds do what it says: the bench") {
    Player player(bench_session());
    check_every_speed(player, {1, 7, 60, 1000});
}

TEST_CASE("At every position of the dial ten seconds do what it says: triangles left out and cut") {
    Player player(session_on(test::small_scene(), Stage::depth));
    check_every_speed(player, {1, 60});
}

TEST_CASE("At every position of the dial ten seconds do what it says: the room") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.a.settings.viewport = {60, 60};
    session.a.settings.camera.focal_length = 60.0f;
    session.a.settings.stage = Stage::depth;
    Player player(std::move(session));
    check_every_speed(player, {1, 60});
}

TEST_CASE("A whole frame takes 15 seconds, whatever the rate of frames and the size of steps") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Player player(std::move(session));
    for (const Granularity step : {Granularity::moment, Granularity::line, Granularity::phase}) {
        for (const int frame_rate : {1, 60}) {
            CAPTURE(word_of(step), frame_rate);
            player.begin(step, Speed{});
            const double seconds = player.run(60.0, frame_rate);
            CHECK(player.session.cursor == cursor_end);
            CHECK_FALSE(player.session.play.running);
            CHECK(std::abs(seconds - 15.0) <= 1.0 / frame_rate + 1e-9);
        }
    }
}

TEST_CASE("Eleven samples are played two a second") {
    // The eleven rows of the bench's table, and the four lines before them.
    Player player(bench_session());
    const auto lines = static_cast<double>(player.steps(Granularity::line).size() - 1);
    CHECK(lines == 15.0);
    player.begin(Granularity::line, Speed{});
    CHECK(player.run(60.0, 60) == Approx(lines / 2.0).margin(1.0 / 60.0));
}

TEST_CASE(
    "The first time after Play is pressed shows the beginning, however long nothing happened") {
    Player player(bench_session());
    const Timeline timeline(player.results.a.frame);
    player.begin(Granularity::moment, {SpeedUnit::steps, 1000.0});
    advance_play(player.session, timeline, player.results.length, 30.0f);
    CHECK(player.session.cursor == timeline.first());
    CHECK(player.session.play.running);
    player.begin(Granularity::moment, {SpeedUnit::unlimited, 0.0});
    advance_play(player.session, timeline, player.results.length, 30.0f);
    CHECK(player.session.cursor == timeline.first());
    advance_play(player.session, timeline, player.results.length, 0.001f);
    CHECK(player.session.cursor == cursor_end);
}

TEST_CASE("A window that was hidden for long has missed one second, no more") {
    Player player(bench_session());
    const Timeline timeline(player.results.a.frame);
    player.begin(Granularity::moment, {SpeedUnit::steps, 8.0});
    advance_play(player.session, timeline, player.results.length, 0.0f);
    advance_play(player.session, timeline, player.results.length, 3600.0f);
    CHECK(player.session.cursor == advance(timeline, cursor_begin, 8, Granularity::moment));
    // A clock that has stopped, or runs back, or is broken, moves nothing.
    const Cursor before = player.session.cursor;
    for (const float seconds : {0.0f, -5.0f, std::nanf("")}) {
        advance_play(player.session, timeline, player.results.length, seconds);
        CHECK(player.session.cursor == before);
    }
}

TEST_CASE("Play from the middle goes on from there, and a pause keeps the moment") {
    Player player(bench_session());
    const Timeline timeline(player.results.a.frame);
    player.session.cursor = {0, Phase::edges, 1, 4};
    player.session.play.speed = {SpeedUnit::steps, 4.0};
    toggle_play(player.session, timeline);
    player.run(0.5, 60);
    CHECK(player.session.cursor == Cursor{0, Phase::edges, 1, 6});
    toggle_play(player.session, timeline);
    CHECK_FALSE(player.session.play.running);
    player.run(5.0, 60);
    CHECK(player.session.cursor == Cursor{0, Phase::edges, 1, 6});
}
