#include "camera_benchmark.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

#include <imgui.h>

#include "bare_interface.h"
#include "base/error.h"
#include "benchmark_sessions.h"
#include "figures.h"
#include "pipeline/timeline.h"
#include "session/results.h"
#include "session/second_run.h"
#include "ui/app/app.h"
#include "ui/ui.h"

/// The measured work runs inside this function, and nothing else does, so that its instructions can
/// be counted: valgrind --tool=callgrind --toggle-collect=measured_work.
extern "C" [[gnu::noinline]] void measured_work(const std::function<void()>& work) {
    work();
    asm volatile(""); // keeps the call from becoming a jump
}

namespace rasterwalk {

namespace {

/// A step of the camera to the side, radians: so small that the picture is nearly the same.
constexpr float turn = 0.001f;

double processor_milliseconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    measured_work(work);
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Takes the requested figures and prints a line for each.
class Figures {
  public:
    explicit Figures(const CameraBenchmark& options)
        : options_(options), other_(read_figures(options.against)) {}

    bool is_wanted(const std::string& name) const {
        return options_.names.empty() || std::find(options_.names.begin(), options_.names.end(),
                                                   name) != options_.names.end();
    }

    /// The smallest time of all steps. The first step, which fills tables, does not count.
    void take(const std::string& name, const std::function<void()>& step) const {
        if (!is_wanted(name)) return;
        step();
        double smallest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < options_.steps; ++i)
            smallest = std::min(smallest, processor_milliseconds(step));
        print_figure(name, smallest, other_);
    }

  private:
    const CameraBenchmark& options_;
    KnownFigures other_;
};

/// The work for the session, without the window, of a camera step or a moment: all of it, including
/// what the window leaves for later frames.
void take_session_figures(const Figures& figures, const std::string& scene, Session (*open)()) {
    for (const bool is_comparing : {false, true}) {
        const std::string ending = is_comparing ? "-comparing" : "";
        const std::string step = scene + "-step" + ending, moment = scene + "-moment" + ending;
        if (!figures.is_wanted(step) && !figures.is_wanted(moment)) continue;
        Session session = open();
        if (is_comparing) compare_with_affine(session);
        Results results;
        figures.take(step, [&] {
            session.a.settings.camera.yaw += turn;
            mirror_changes_to_b(session);
            finish(session, results);
        });
        finish(session, results);
        session.cursor = Timeline(results.a.frame).at_place(0.7);
        figures.take(moment, [&] {
            session.cursor = Timeline(results.a.frame).next(session.cursor, Granularity::moment);
            finish(session, results);
        });
    }
}

/// Whole frames of the window: at rest, while the camera turns, and one moment after another;
/// then the same of the scene from outside.
void take_frame_figures(const Figures& figures, const std::string& scene, Session (*open)()) {
    const std::string rest = scene + "-frame-at-rest", turning = scene + "-frame-turning",
                      moment = scene + "-frame-moment", outside_rest = scene + "-outside-at-rest",
                      outside_turning = scene + "-outside-turning",
                      outside_whole = scene + "-outside-whole",
                      outside_moment = scene + "-outside-moment",
                      outside_triangle = scene + "-outside-triangle";
    const auto all = {rest,          turning,        moment,          outside_rest, outside_turning,
                      outside_whole, outside_moment, outside_triangle};
    if (std::none_of(all.begin(), all.end(),
                     [&](const std::string& name) { return figures.is_wanted(name); })) {
        return;
    }
    BareInterface interface(open());
    Ui& ui = interface.ui;
    const auto frame = [&] { interface.frame(); };
    for (int i = 0; i < 4 || !ui.results.a.is_drawn(); ++i)
        frame(); // sizes of windows and columns settle, and all is drawn
    const auto walk = [&](Granularity granularity) {
        return [&, granularity] {
            const Timeline timeline(ui.results.a.frame);
            ui.session.cursor = timeline.next(ui.session.cursor, granularity);
            frame();
        };
    };
    const auto settle = [&] {
        do
            frame();
        while (is_animating(ui));
    };
    figures.take(rest, frame);
    figures.take(turning, [&] {
        ui.session.a.settings.camera.yaw += turn;
        frame();
    });
    ui.session.cursor = Timeline(ui.results.a.frame).at_place(0.7);
    settle();
    figures.take(moment, walk(Granularity::moment));
    ui.session.canvas.shows = CanvasShows::both;
    settle();
    figures.take(outside_moment, walk(Granularity::moment));
    figures.take(outside_triangle, walk(Granularity::triangle));
    ui.session.cursor = cursor_end;
    settle();
    figures.take(outside_rest, frame);
    figures.take(outside_turning, [&] {
        ui.session.canvas.outside.yaw += turn;
        frame();
    });
    // All the frames after a turn until the full scene is shown.
    figures.take(outside_whole, [&] {
        ui.session.canvas.outside.yaw += turn;
        settle();
    });
}

constexpr const char* figure_names[] = {
    "room-step",
    "room-moment",
    "room-step-comparing",
    "room-moment-comparing",
    "room-frame-at-rest",
    "room-frame-turning",
    "made-step",
    "made-moment",
    "made-step-comparing",
    "made-moment-comparing",
    "made-frame-at-rest",
    "made-frame-turning",
    "room-outside-at-rest",
    "room-outside-turning",
    "room-outside-whole",
    "room-frame-moment",
    "room-outside-moment",
    "room-outside-triangle",
    "made-frame-moment",
    "made-outside-moment",
    "made-outside-triangle",
    "wide-frame-at-rest",
    "wide-frame-turning",
    "wide-frame-moment",
    "wide-outside-at-rest",
    "wide-outside-turning",
    "wide-outside-whole",
    "wide-outside-moment",
    "wide-outside-triangle",
    "made-outside-at-rest",
    "made-outside-turning",
    "made-outside-whole",
};

} // namespace

void print_camera_times(const CameraBenchmark& options) {
    for (const std::string& name : options.names) {
        if (std::find(std::begin(figure_names), std::end(figure_names), name) ==
            std::end(figure_names)) {
            throw UsageError("there is no figure '" + name + "'.");
        }
    }
    const Figures figures(options);
    take_session_figures(figures, "room", room);
    take_frame_figures(figures, "room", room);
    take_session_figures(figures, "made", made);
    take_frame_figures(figures, "made", made);
    take_frame_figures(figures, "wide", wide);
}

} // namespace rasterwalk
