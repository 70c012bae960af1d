// Draws the scenes and models of the lessons under each value of each setting, and under many at
// once, and prints a hash of the planes and the tally of each picture. Compare the output of two
// versions of the sources with `diff`: a change that should change no bit changes no line.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/draw.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/choices.h"

namespace {

using namespace rasterwalk;

constexpr int usual_mixtures = 1000;

std::vector<std::string> scene_files() {
    std::vector<std::string> files;
    for (const char* folder : {"scenes", "models"}) {
        for (const auto& entry :
             std::filesystem::directory_iterator(lessons_folder() + "/" + folder)) {
            const std::string kind = entry.path().extension().string();
            if (kind == ".toml" || kind == ".obj") files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string tally_text(const DrawTally& t) {
    return fmt::format("{} {} {} {} {} {} {} {} {} {}", t.fragments, t.fragments_outside,
                       t.samples_outside, t.triangles_outside, t.first_outside, t.shaded,
                       t.row_lookups, t.pixels_tested, t.empty_rows, t.depth_outside);
}

void print_hash(const Scene& scene, const std::string& name, const Settings& settings) {
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    const DrawTally tally = draw(frame, {}, framebuffer);
    fmt::print("{} {} {}\n", test::hash_text(framebuffer), tally_text(tally), name);
}

/// The same with each of several ways to find pixels, whatever the settings say.
void print_coverages(const Scene& scene, const std::string& name, Settings settings) {
    for (const char* const coverage : {"rows", "scan_conversion", "active_edges"}) {
        const std::string assignment = fmt::format("coverage={}", coverage);
        set_from_text(settings, assignment);
        print_hash(scene, name + ", " + assignment, settings);
    }
}

/// Every step of the strip at full size.
void print_steps(const Scene& scene) {
    for (const StageInfo& stage : stage_list()) {
        Settings settings = default_settings(scene);
        set_step(settings, stage.step);
        print_coverages(scene, fmt::format("{}, {}", scene.name, stage.name), settings);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 2) {
        std::fputs("usage: hash_choices [MIXTURES]\n", stderr);
        return 2;
    }
    try {
        const std::vector<std::string> files = scene_files();
        const int mixtures = argc == 2 ? std::atoi(argv[1]) : usual_mixtures;
        const int of_each = std::max(mixtures / static_cast<int>(files.size()), 1);
        test::Random random(1);
        for (const std::string& file : files) {
            const Scene scene = read_scene_file(file);
            print_steps(scene);
            for (const char* const base : {"shading=unlit", "shading=gouraud", "shading=phong"}) {
                for (const test::Choice& choice : test::single_choices(scene, base))
                    print_hash(scene, choice.name, choice.settings);
                for (const test::Choice& choice : test::mixed_choices(scene, base, of_each, random))
                    print_coverages(scene, choice.name, choice.settings);
            }
        }
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return 1;
    }
    return 0;
}
