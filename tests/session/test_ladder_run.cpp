#include "session/ladder_run.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "engines/ladder/race.h"
#include "session/content.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

Session small_room() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    for (const char* set : {"viewport.size=60x50", "camera.focal_length=55", "stage=pixel_light"})
        set_from_text(session.a.settings, set);
    return session;
}

} // namespace

TEST_CASE("A run of the ladder measures every rung in every round and compares its picture") {
    const Session session = small_room();
    for (const StepMaker maker : {StepMaker::thread, StepMaker::advance}) {
        constexpr int rounds = 3;
        LadderRun run(ladder_subject(session), rounds, maker);
        int steps = 0;
        float share = 0.0f;
        while (!run.steps().is_done()) {
            run.steps().advance();
            std::this_thread::yield();
            const float now = run.times().share;
            CHECK(now >= share);
            share = now;
            ++steps;
        }
        CHECK(run.steps().fault().empty());
        const LadderTimes times = run.times();
        REQUIRE(times.rungs.size() == rung_count());
        CHECK(times.has_all());
        CHECK(times.rounds == rounds);
        CHECK(times.share == 1.0f);
        for (const RungTime& time : times.rungs) {
            REQUIRE(time.milliseconds.size() == rounds);
            std::vector<double> sorted = time.milliseconds;
            std::sort(sorted.begin(), sorted.end());
            CHECK(time.median == sorted[1]);
            CHECK(time.from_previous.pixels == 60 * 50);
        }
        // By the caller: one step begins, and each of the others draws one picture.
        if (maker == StepMaker::advance)
            CHECK(steps == 1 + static_cast<int>(rung_count()) * (1 + rounds));
    }
}

TEST_CASE("A run of the ladder on what it cannot draw ends with the reason") {
    Session session = small_room();
    set_from_text(session.a.settings, "camera.yaw=0.2");
    const LadderSubject subject = ladder_subject(session);
    const std::string reason = ladder_refuses(*subject.scene, subject.settings);
    REQUIRE_FALSE(reason.empty());
    LadderRun run(subject, 2, StepMaker::advance);
    run.steps().advance();
    CHECK(run.steps().is_done());
    CHECK(run.steps().fault() == reason + ".");
    CHECK(run.times().rungs.empty());
    CHECK_FALSE(run.times().has_all());
}

TEST_CASE("Times belong to a scene, its size and camera, whichever engine draws the picture") {
    Session session = small_room();
    const LadderSubject before = ladder_subject(session);
    set_from_text(session.a.settings, "engine=fast");
    CHECK(ladder_subject(session) == before);
    set_from_text(session.a.settings, "viewport.size=61x50");
    CHECK_FALSE(ladder_subject(session) == before);
    session = small_room();
    session.scene = std::make_shared<const Scene>(*session.scene);
    CHECK_FALSE(ladder_subject(session) == before);
}

TEST_CASE("A race counts the wrong pixels of every picture, and one without threads of none") {
    RaceRun race(3);
    while (!race.is_done())
        std::this_thread::yield();
    const std::vector<std::int64_t> wrong = race.wrong();
    REQUIRE(wrong.size() == (ladder_threads() == 1 ? 0u : 3u));
    const Viewport size = default_settings(race_scene()).viewport;
    for (const std::int64_t count : wrong)
        CHECK(count <= std::int64_t{size.width} * size.height);
}

TEST_CASE("The middle half is between the quartiles, in whatever order the times are") {
    // The same as quantile() of R.
    TimeRange half = middle_half({8.0, 1.0, 4.0, 2.0});
    CHECK(half.low == 1.75);
    CHECK(half.high == 5.0);
    half = middle_half({3.0});
    CHECK(half.low == 3.0);
    CHECK(half.high == 3.0);
    // Of 4 k + 1 times, k are below and k are above.
    for (int k = 1; k < 6; ++k) {
        std::vector<double> times;
        for (int i = 4 * k; i >= 0; --i)
            times.push_back(static_cast<double>(i) * static_cast<double>(i));
        half = middle_half(times);
        const auto below =
            std::count_if(times.begin(), times.end(), [&](double time) { return time < half.low; });
        const auto above = std::count_if(times.begin(), times.end(),
                                         [&](double time) { return time > half.high; });
        CHECK(below == k);
        CHECK(above == k);
    }
}

} // namespace rasterwalk
