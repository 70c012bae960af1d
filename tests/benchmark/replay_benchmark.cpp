#include "replay_benchmark.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <random>
#include <vector>

#include "pipeline/replay.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

/// Time of the processor, so that other programs do not count.
double milliseconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void print_line(const char* name, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    std::printf("  %-40s %9.3f %9.3f %9.3f\n", name, times[times.size() / 2],
                times[times.size() * 95 / 100], times.back());
}

void print_one(const char* name, double time) {
    std::printf("  %-40s %9.3f\n", name, time);
}

/// The cost of a change of the cursor: finding the moment, and drawing it.
double seek_time(const Frame& frame, Replay& replay, double place) {
    return milliseconds([&] {
        const Timeline timeline(frame);
        const Cursor cursor = timeline.at_place(place);
        replay.at(timeline.at_or_after(cursor));
    });
}

void print_steps(const Frame& frame, Replay& replay, const char* name, bool forwards) {
    constexpr int steps = 400;
    Cursor cursor = Timeline(frame).at_place(0.6);
    replay.at(cursor);
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        times.push_back(milliseconds([&] {
            const Timeline timeline(frame);
            cursor = forwards ? timeline.next(cursor, Granularity::moment)
                              : timeline.previous(cursor, Granularity::moment);
            replay.at(cursor);
        }));
    }
    print_line(name, std::move(times));
}

void print_scrub(const Frame& frame, Replay& replay, const char* name, bool forwards) {
    constexpr int steps = 500;
    std::vector<double> times;
    for (int i = 0; i <= steps; ++i) {
        const double place = static_cast<double>(i) / steps;
        times.push_back(seek_time(frame, replay, forwards ? place : 1.0 - place));
    }
    print_line(name, std::move(times));
}

} // namespace

void print_replay_times(const Scene& scene) {
    Frame frame;
    const double preparation =
        milliseconds([&] { frame = prepare_frame(scene, default_settings(scene)); });
    Replay replay;
    replay.begin(frame);
    DrawTally tally;
    Framebuffer whole;
    clear(whole, frame);
    const double drawing = milliseconds([&] { tally = draw(frame, {}, whole); });
    std::printf("\n%s: %d triangles, %lld fragments, %d x %d\n", scene.name.c_str(),
                frame.triangle_count(), static_cast<long long>(tally.fragments), whole.size.width,
                whole.size.height);
    std::printf("  %-40s %9s %9s %9s\n", "milliseconds, one core", "median", "95 %", "longest");
    print_one("prepare the frame", preparation);
    print_one("draw the frame", drawing);
    print_one("replay: to the end, the first time", milliseconds([&] { replay.at(cursor_end); }));
    print_one("replay: first step back", milliseconds([&] {
                  replay.at(Timeline(frame).previous(cursor_end, Granularity::moment));
              }));
    print_scrub(frame, replay, "scrub back, 500 steps", false);
    print_scrub(frame, replay, "scrub forward, 500 steps", true);
    std::mt19937 random(1);
    std::vector<double> times;
    for (int i = 0; i < 200; ++i)
        times.push_back(seek_time(frame, replay, random() / 4294967296.0));
    print_line("random seek, 200 of them", std::move(times));
    print_steps(frame, replay, "one moment on", true);
    print_steps(frame, replay, "one moment back", false);
    std::printf("  copies: %zu, %.1f MB\n", replay.keyframe_count(),
                static_cast<double>(replay.keyframe_bytes()) / (1 << 20));
}

} // namespace rasterwalk
