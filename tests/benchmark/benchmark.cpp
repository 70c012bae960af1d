// Prints how long things take. Asserts nothing, because a machine can be slow.
//
// To add a measurement, write a function that takes the measurements and adds a line to them.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "bare_interface.h"
#include "base/error.h"
#include "camera_benchmark.h"
#include "compare/compare.h"
#include "diagnosis_benchmark.h"
#include "frame_benchmark.h"
#include "inspect/measures.h"
#include "inspect/pixel_history.h"
#include "mine_benchmark.h"
#include "model_benchmark.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "replay_benchmark.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "support/made_scene.h"
#include "ui/app/app.h"
#include "ui/ui.h"

namespace {

using namespace rasterwalk;

constexpr const char* usage =
    "usage: rasterwalk-benchmark [REPETITIONS]\n"
    "       rasterwalk-benchmark camera [--steps N] [--against FILE] [NAME...]\n"
    "       rasterwalk-benchmark models [--against FILE] [NAME...]\n"
    "       rasterwalk-benchmark frames [NAME...]\n"
    "       rasterwalk-benchmark diagnoses [ID...]\n"
    "       rasterwalk-benchmark mine [--rounds N] [NAME...]";

/// How long one thing took, over all its repetitions.
struct Measurement {
    std::string name;
    double shortest = 0.0; ///< milliseconds
    double median = 0.0;   ///< milliseconds
};

struct Measurements {
    int repetitions = 50;
    std::vector<Measurement> list;
};

/// Times `work`; the first call, which fills caches and tables, does not count.
void measure(Measurements& measurements, const std::string& name,
             const std::function<void()>& work) {
    work();
    std::vector<double> times;
    for (int i = 0; i < measurements.repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        times.push_back(time.count());
    }
    std::sort(times.begin(), times.end());
    measurements.list.push_back({name, times.front(), times[times.size() / 2]});
}

void measure_prepare_frame(Measurements& measurements, const Scene& scene) {
    const Settings settings = default_settings(scene);
    measure(measurements, "prepare_frame", [&] { prepare_frame(scene, settings); });
}

std::string stage_name(const StageInfo& stage) {
    return "draw " + std::string(stage.name);
}

void measure_stages(Measurements& measurements, const Scene& scene) {
    Framebuffer framebuffer;
    for (const StageInfo& stage : stage_list()) {
        Settings settings = default_settings(scene);
        set_step(settings, stage.step);
        const Frame frame = prepare_frame(scene, settings);
        measure(measurements, stage_name(stage), [&] {
            clear(framebuffer, settings.viewport);
            draw(frame, {}, framebuffer);
        });
    }
}

void measure_view_image(Measurements& measurements, const Scene& scene) {
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const Framebuffer framebuffer = draw_frame(frame);
    measure(measurements, "picture of colours", [&] { view_image(framebuffer, View::colour); });
    measure(measurements, "picture of depth", [&] { view_image(framebuffer, View::depth); });
}

/// A pixel in the middle of the picture, on which something falls, and one on which nothing does.
void measure_pixel_history(Measurements& measurements, const Scene& scene,
                           const std::string& name) {
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const Framebuffer picture = draw_frame(frame);
    const glm::ivec2 middle(picture.size.width / 2, picture.size.height / 2);
    measure(measurements, "pixel history, " + name, [&] { pixel_history(frame, middle); });
    const auto gap = std::find(picture.overdraw.begin(), picture.overdraw.end(), 0U);
    if (gap == picture.overdraw.end()) return;
    const int place = static_cast<int>(gap - picture.overdraw.begin());
    const glm::ivec2 uncovered(place % picture.size.width, place / picture.size.width);
    measure(measurements, "why uncovered, " + name, [&] { pixel_history(frame, uncovered); });
}

/// The room compared with itself under other rules, all of it and by a jump of the cursor.
void measure_comparison(Measurements& measurements, const std::string& scene_path) {
    Session session = open_session(scene_path);
    const Frame a = prepare_frame(*session.scene, session.a.settings);
    const auto whole = [&](const std::string& assignment) {
        Settings settings = session.a.settings;
        set_from_text(settings, assignment);
        const Frame b = prepare_frame(*session.scene, settings);
        measure(measurements, "compare " + assignment, [&] { compare_runs(a, b); });
    };
    whole("rounding=floor");
    whole("interpolation=affine");
    whole("depth_test=off");
    start_pair(session, compare_pairs().front());
    Results results;
    update(session, results);
    const Frame& frame = results.a.frame;
    const Timeline timeline(frame);
    session.cursor = timeline.at_place(0.7);
    measure(measurements, "comparing, a step", [&] {
        session.cursor = timeline.next(session.cursor, Granularity::moment);
        update(session, results);
    });
}

void measure_interface(Measurements& measurements, const std::string& scene_path) {
    BareInterface interface(open_session(scene_path));
    Ui& ui = interface.ui;
    const auto frame = [&] { interface.frame(); };
    for (int i = 0; i < 4; ++i)
        frame(); // sizes of windows and columns settle
    std::printf("interface: %d vertices at %.0f x %.0f\n\n", ImGui::GetDrawData()->TotalVtxCount,
                static_cast<double>(ImGui::GetIO().DisplaySize.x),
                static_cast<double>(ImGui::GetIO().DisplaySize.y));
    measure(measurements, "interface at rest", frame);
    ui.session.canvas.shows = CanvasShows::both;
    for (int i = 0; i < 4; ++i)
        frame();
    measure(measurements, "interface, seen from outside too", frame);
    ui.session.canvas.shows = CanvasShows::picture;
    // The row table next to its rows, a number and a sign in every cell.
    ui.session.canvas.zoom = 24.0f;
    ui.session.canvas.centre = {250.0f, 300.0f};
    ui.session.canvas.numbers = CellNumbers::overdraw;
    ui.session.selection.triangle = 22;
    for (int i = 0; i < 4; ++i)
        frame();
    std::printf("large cells: %d vertices\n\n", ImGui::GetDrawData()->TotalVtxCount);
    measure(measurements, "interface, large cells", frame);
    ui.session.canvas = {};
    ui.session.selection = {};
    float yaw = 0.0f;
    measure(measurements, "interface, camera turns", [&] {
        yaw += 0.001f;
        ui.session.a.settings.camera.yaw = yaw;
        frame();
    });
}

void print_table(const Measurements& measurements) {
    const std::string unit = "draw fill";
    std::optional<double> fill;
    for (const Measurement& one : measurements.list) {
        if (one.name == unit) fill = one.shortest;
    }
    std::printf("%-32s %12s %12s %12s\n", "milliseconds, one core", "shortest", "median",
                "x draw fill");
    for (const Measurement& one : measurements.list) {
        std::printf("%-32s %12.3f %12.3f", one.name.c_str(), one.shortest, one.median);
        if (fill) std::printf(" %12.3f", one.shortest / *fill);
        std::printf("\n");
    }
}

double milliseconds_now() {
    const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now().time_since_epoch();
    return time.count();
}

/// What each measure against useless work saves in a frame.
void print_measures(const Scene& scene) {
    const MeasureCosts costs =
        measure_costs(scene, default_settings(scene), cursor_end, milliseconds_now);
    std::printf("\n%-32s %12s %12s %12s %12s\n", ("measures, " + scene.name).c_str(), "fragments",
                "shaded", "median", "x plain");
    for (const MeasureCost& cost : costs.ways) {
        const std::string name = std::string(cost.measure->name) + "=" + std::string(cost.way);
        std::printf("%-32s %12lld %12lld %12.3f %12.3f\n", name.c_str(),
                    static_cast<long long>(cost.stats.fragments),
                    static_cast<long long>(cost.stats.shaded), cost.milliseconds, cost.share);
    }
}

/// The words behind `camera`. Throws UsageError.
CameraBenchmark camera_options(const std::vector<std::string>& words) {
    CameraBenchmark options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool has_value = i + 1 < words.size();
        if (word == "--steps" && has_value) {
            options.steps = std::clamp(std::atoi(words[++i].c_str()), 1, 100000);
        } else if (word == "--against" && has_value) {
            options.against = words[++i];
        } else if (!word.starts_with("-")) {
            options.names.push_back(word);
        } else {
            throw UsageError(usage);
        }
    }
    return options;
}

/// The words behind `models`. Throws UsageError.
ModelBenchmark model_options(const std::vector<std::string>& words) {
    ModelBenchmark options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--against" && i + 1 < words.size()) {
            options.against = words[++i];
        } else if (!words[i].starts_with("-")) {
            options.names.push_back(words[i]);
        } else {
            throw UsageError(usage);
        }
    }
    return options;
}

/// The words behind `mine`. Throws UsageError.
MineBenchmark mine_options(const std::vector<std::string>& words) {
    MineBenchmark options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--rounds" && i + 1 < words.size()) {
            options.rounds = std::clamp(std::atoi(words[++i].c_str()), 1, 1000);
        } else if (!words[i].starts_with("-")) {
            options.names.push_back(words[i]);
        } else {
            throw UsageError(usage);
        }
    }
    return options;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (!words.empty() && words.front() == "camera") {
            print_camera_times(camera_options({words.begin() + 1, words.end()}));
            return 0;
        }
        if (!words.empty() && words.front() == "models") {
            print_model_times(model_options({words.begin() + 1, words.end()}));
            return 0;
        }
        if (!words.empty() && words.front() == "frames") {
            print_frame_times({words.begin() + 1, words.end()});
            return 0;
        }
        if (!words.empty() && words.front() == "diagnoses") {
            print_diagnosis_times({words.begin() + 1, words.end()});
            return 0;
        }
        if (!words.empty() && words.front() == "mine") {
            print_mine_times(mine_options({words.begin() + 1, words.end()}));
            return 0;
        }
        if (words.size() > 1) throw UsageError(usage);
        Measurements measurements;
        if (!words.empty())
            measurements.repetitions = std::clamp(std::atoi(words[0].c_str()), 1, 100000);
        const std::string path = lessons_folder() + "/scenes/lab-room.toml";
        const Scene scene = read_scene(path);
        std::printf("%s, %d x %d, %d repetitions\n\n", scene.name.c_str(), scene.viewport.width,
                    scene.viewport.height, measurements.repetitions);
        measure_prepare_frame(measurements, scene);
        measure_stages(measurements, scene);
        measure_view_image(measurements, scene);
        measure_pixel_history(measurements, scene, "room");
        measure_pixel_history(measurements, test::made_scene(100'000), "100,000");
        measure_comparison(measurements, path);
        measure_interface(measurements, path);
        print_table(measurements);
        print_measures(scene);
        print_measures(test::made_scene(100'000));
        print_replay_times(scene);
        print_replay_times(test::made_scene(100'000));
    } catch (const Error& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return static_cast<int>(fault.code);
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return 1;
    }
    return 0;
}
