#include "model_benchmark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bare_interface.h"
#include "base/error.h"
#include "benchmark_sessions.h"
#include "figures.h"
#include "pipeline/timeline.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/results.h"
#include "session/second_run.h"
#include "session/session.h"
#include "ui/app/app.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

double model_milliseconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Hilly ground made of squares of two triangles each, without normals, as text.
std::string hills(int triangles) {
    const int side = static_cast<int>(std::lround(std::sqrt(triangles / 2.0)));
    std::string text;
    for (int i = 0; i <= side; ++i) {
        for (int j = 0; j <= side; ++j) {
            const double x = 10.0 * i / side, z = 10.0 * j / side;
            text += fmt::format("v {:.5f} {:.5f} {:.5f}\n", x, std::sin(x) * std::cos(z), z);
        }
    }
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const int a = i * (side + 1) + j + 1, b = a + side + 1;
            text += fmt::format("f {} {} {} {}\n", a, a + 1, b + 1, b);
        }
    }
    return text;
}

/// The longest frame of the window from a change until it comes to rest.
double longest_frame(BareInterface& interface) {
    double longest = 0.0;
    do
        longest = std::max(longest, model_milliseconds([&] { interface.frame(); }));
    while (is_working(interface.ui.results) || is_animating(interface.ui));
    return longest;
}

/// A change of the session, a different one each time.
using Change = std::function<void(Ui&, int)>;

/// The longest frame of a few such changes.
double longest_after(BareInterface& interface, const Change& change) {
    double longest = 0.0;
    for (int i = 0; i < 12; ++i) {
        change(interface.ui, i);
        longest = std::max(longest, longest_frame(interface));
    }
    return longest;
}

/// The same for changes that do not wait for each other.
double longest_while(BareInterface& interface, const Change& change) {
    double longest = 0.0;
    for (int i = 0; i < 120; ++i) {
        change(interface.ui, i);
        longest = std::max(longest, model_milliseconds([&] { interface.frame(); }));
    }
    return std::max(longest, longest_frame(interface));
}

void seek(Ui& ui, double place) {
    ui.session.cursor = Timeline(ui.results.a.frame).at_place(place);
}

/// Back and forth, so that the model stays in sight.
void turn_camera(Ui& ui, int i) {
    ui.session.a.settings.camera.yaw += (i + 15) / 30 % 2 == 0 ? 0.01f : -0.01f;
}

/// A model that is measured; without triangles it is the room.
struct MeasuredModel {
    std::string name;
    int triangles;
};
const std::array<MeasuredModel, 3> measured_models{
    {{"room", 0}, {"200000", 200'000}, {"1000000", 1'000'000}}};

void measure_model(const MeasuredModel& model, const KnownFigures& others) {
    const auto print = [&](const std::string& figure, double milliseconds) {
        print_figure(model.name + "-" + figure, milliseconds, others);
    };
    const std::string room = lessons_folder() + "/scenes/lab-room.toml";
    const std::string text = model.triangles > 0 ? hills(model.triangles) : std::string();
    Scene scene;
    print("open", model_milliseconds([&] {
              scene =
                  text.empty() ? read_scene(room) : scene_of_model(parse_obj(text, "hills.obj"));
          }));
    Session session = open_session(room);
    BareInterface interface(session);
    for (int i = 0; i < 4; ++i)
        longest_frame(interface); // sizes of windows and columns settle
    set_scene(interface.ui.session, std::move(scene));
    print("first", longest_frame(interface));
    seek(interface.ui, 0.6);
    longest_frame(interface);
    print("step", longest_after(interface, [](Ui& ui, int) {
              const Timeline timeline(ui.results.a.frame);
              ui.session.cursor = timeline.next(ui.session.cursor, Granularity::moment);
          }));
    print("seek", longest_after(interface, [](Ui& ui, int i) { seek(ui, 0.1 * ((7 * i) % 10)); }));
    interface.ui.session.cursor = cursor_end;
    longest_frame(interface);
    print("turn", longest_while(interface, turn_camera));
    print("pick", longest_after(interface, [](Ui& ui, int i) {
              ui.session.selection.pixel = {20 + 40 * i, 250};
          }));
    print("turn-picked", longest_while(interface, turn_camera));
    interface.ui.session.selection.pixel = {250, 2}; // the sky: nothing is drawn here
    print("turn-uncovered", longest_while(interface, turn_camera));
    interface.ui.session.selection.pixel = std::nullopt;
    compare_with_affine(interface.ui.session);
    longest_frame(interface);
    print("turn-comparing", longest_while(interface, [](Ui& ui, int i) {
              turn_camera(ui, i);
              mirror_changes_to_b(ui.session);
          }));
    stop_comparing(interface.ui.session);
    interface.ui.session.canvas.shows = CanvasShows::both;
    longest_frame(interface);
    print("turn-both", longest_while(interface, turn_camera));
    print("turn-outside",
          longest_while(interface, [](Ui& ui, int) { ui.session.canvas.outside.yaw += 0.01f; }));
}

} // namespace

void print_model_times(const ModelBenchmark& options) {
    const auto is_wanted = [&](const std::string& name) {
        return options.names.empty() ||
               std::find(options.names.begin(), options.names.end(), name) != options.names.end();
    };
    for (const std::string& name : options.names) {
        if (std::none_of(measured_models.begin(), measured_models.end(),
                         [&](const MeasuredModel& model) { return model.name == name; }))
            throw UsageError("there is no model '" + name + "'.");
    }
    const KnownFigures others = read_figures(options.against);
    for (const MeasuredModel& model : measured_models) {
        if (is_wanted(model.name)) measure_model(model, others);
    }
}

} // namespace rasterwalk
