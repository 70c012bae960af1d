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

#include "pipeline/timeline.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "session/results.h"
#include "session/session.h"

namespace rasterwalk {

namespace {

double model_milliseconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A hilly ground of squares, without normals, as text: two triangles each.
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

/// The longest of the updates by which a window comes to rest again.
double longest_update(const Session& session, Results& results) {
    double longest = 0.0;
    do
        longest =
            std::max(longest, model_milliseconds([&] { update(session, results, frame_limit); }));
    while (is_working(results));
    return longest;
}

constexpr std::array figure_of_models{"open", "first update", "step", "seek", "pick", "turn"};
using ModelFigures = std::array<double, figure_of_models.size()>;

ModelFigures figures_of(int triangles) {
    ModelFigures figures{};
    const std::string text = hills(triangles);
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Scene scene;
    figures[0] = model_milliseconds([&] { scene = scene_of_model(parse_obj(text, "hills.obj")); });
    set_scene(session, std::move(scene));
    Results results;
    figures[1] = longest_update(session, results);
    const auto largest_of = [&](int count, const std::function<void(int)>& change) {
        double longest = 0.0;
        for (int i = 0; i < count; ++i) {
            change(i);
            longest = std::max(longest, longest_update(session, results));
        }
        return longest;
    };
    session.cursor = Timeline(results.a.frame).at_place(0.6);
    longest_update(session, results);
    figures[2] = largest_of(20, [&](int) {
        session.cursor = Timeline(results.a.frame).next(session.cursor, Granularity::moment);
    });
    figures[3] = largest_of(10, [&](int i) {
        session.cursor = Timeline(results.a.frame).at_place(0.1 * ((7 * i) % 10));
    });
    session.cursor = cursor_end;
    longest_update(session, results);
    figures[4] = largest_of(10, [&](int i) { session.selection.pixel = {200 + 10 * i, 250}; });
    figures[5] = largest_of(10, [&](int) { session.a.settings.camera.yaw += 0.01f; });
    return figures;
}

} // namespace

void print_model_times() {
    const ModelFigures small = figures_of(200'000), large = figures_of(1'000'000);
    std::printf("%-16s %12s %12s %8s\n", "longest, ms", "200,000", "1,000,000", "ratio");
    for (std::size_t i = 0; i < small.size(); ++i) {
        std::printf("%-16s %12.1f %12.1f %8.2f\n", figure_of_models[i], small[i], large[i],
                    small[i] > 0.0 ? large[i] / small[i] : 0.0);
    }
}

} // namespace rasterwalk
