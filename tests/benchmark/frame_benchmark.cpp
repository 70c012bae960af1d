#include "frame_benchmark.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>

#include "bare_interface.h"
#include "base/error.h"
#include "benchmark_sessions.h"
#include "session/results.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "ui/app/app.h"
#include "ui/canvas/large_frame.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A step of the camera to the side, radians, and how many of them go the same way: the scene stays
/// in sight.
constexpr float frame_turn = 0.01f;
constexpr int turns_one_way = 30;

/// Turns that are measured. Some come first, so that memory is taken and tables are filled.
constexpr int turns = 60;
constexpr int turns_before = 6;

/// By the clock and by the processor, milliseconds.
struct Time {
    double clock = 0.0, processor = 0.0;

    Time& operator+=(const Time& more) {
        clock += more.clock;
        processor += more.processor;
        return *this;
    }
};

Time time_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    work();
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    return {passed.count(),
            1000.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

Time frame_time(BareInterface& interface) {
    return time_of([&] { interface.frame(); });
}

Time longest(const std::vector<Time>& frames) {
    Time most;
    for (const Time& frame : frames) {
        most.clock = std::max(most.clock, frame.clock);
        most.processor = std::max(most.processor, frame.processor);
    }
    return most;
}

Time median(const std::vector<Time>& frames) {
    const auto middle = [&](double Time::*member) {
        std::vector<double> times;
        for (const Time& frame : frames)
            times.push_back(frame.*member);
        std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
        return times[times.size() / 2];
    };
    return {middle(&Time::clock), middle(&Time::processor)};
}

/// The work left after the last turn.
struct Rest {
    Time longest; ///< frame
    Time whole;   ///< until the picture is complete
    Time all;     ///< until everything is worked out
};

/// Is the requested picture complete, so that the cursor can go to any of its moments?
bool is_whole(const Results& results) {
    return !results.a.is_frame_late && results.a.is_drawn();
}

void turn_once(Session& session, int i) {
    const bool is_back = (i + turns_one_way / 2) / turns_one_way % 2 != 0;
    session.a.settings.camera.yaw += is_back ? -frame_turn : frame_turn;
}

/// Frames until there is nothing left to do.
Rest come_to_rest(BareInterface& interface) {
    Rest rest;
    std::vector<Time> frames;
    std::optional<Time> whole;
    do {
        if (!whole && is_whole(interface.ui.results)) whole = rest.all;
        frames.push_back(frame_time(interface));
        rest.all += frames.back();
    } while (is_working(interface.ui.results) || is_animating(interface.ui));
    rest.whole = whole.value_or(rest.all);
    rest.longest = longest(frames);
    return rest;
}

/// The fast engine can stand in for both runs of `-comparing`, and not for run B of `-affine`.
struct FrameCase {
    const char* name;
    Session (*open)();
    const char* a; ///< a setting of run A
    const char* b; ///< in which run B differs; null: there is no run B
};

constexpr const char* by_steps = "engine=steps";
constexpr const char* by_fast = "engine=fast";
constexpr const char* per_vertex = "stage=vertex_light";
constexpr const char* affine = "interpolation=affine";

constexpr FrameCase frame_cases[] = {
    {"room", room, by_steps, nullptr},
    {"room-affine", room, by_steps, affine},
    {"made", made, by_steps, nullptr},
    {"made-comparing", made, by_steps, per_vertex},
    {"made-affine", made, by_steps, affine},
    {"made-fast", made, by_fast, nullptr},
    {"made-to-fast", made, by_steps, by_fast},
    {"knot", knot, by_steps, nullptr},
    {"knot-comparing", knot, by_steps, per_vertex},
    {"knot-affine", knot, by_steps, affine},
    {"wide", wide, by_steps, nullptr},
    {"wide-comparing", wide, by_steps, per_vertex},
    {"wide-affine", wide, by_steps, affine},
    {"wide-fast", wide, by_fast, nullptr},
};

void measure_frames(const FrameCase& one) {
    BareInterface interface(one.open());
    Ui& ui = interface.ui;
    set_from_text(ui.session.a.settings, one.a);
    come_to_rest(interface);
    Rest begun;
    if (one.b != nullptr) {
        compare_with_setting(ui.session, one.b);
        begun = come_to_rest(interface);
    }
    std::vector<Time> updates, frames;
    for (int i = 0; i < turns_before + turns; ++i) {
        turn_once(ui.session, i);
        mirror_changes_to_b(ui.session);
        const Time of_update = time_of([&] { update(ui.session, ui.results, work_limit(ui)); });
        Time of_frame = frame_time(interface);
        of_frame += of_update;
        if (i < turns_before) continue;
        updates.push_back(of_update);
        frames.push_back(of_frame);
    }
    const Rest rest = come_to_rest(interface);
    std::printf("%-16s", one.name);
    for (const Time& time : {median(updates), median(frames), longest(frames), rest.longest,
                             rest.whole, rest.all, begun.longest})
        std::printf(" %8.1f |%7.1f", time.clock, time.processor);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

void print_frame_times(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::none_of(std::begin(frame_cases), std::end(frame_cases),
                         [&](const FrameCase& one) { return one.name == name; }))
            throw UsageError("there is no case '" + name + "'.");
    }
    std::printf("%-16s", "ms, clock | cpu");
    for (const char* column : {"median update", "median turn", "longest turn", "longest then",
                               "picture whole", "all is done", "B is begun"})
        std::printf(" %17s", column);
    std::printf("\n");
    for (const FrameCase& one : frame_cases) {
        if (names.empty() || std::find(names.begin(), names.end(), one.name) != names.end())
            measure_frames(one);
    }
}

} // namespace rasterwalk
