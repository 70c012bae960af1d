// The code that students are shown draws the same bits as the stages: in every scene, with the
// settings of every step of every lesson, and with each setting that it has lines for.

#include <algorithm>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text_parts.h"
#include "lab_code/code_frame.h"
#include "lab_code/code_walk.h"
#include "lab_code/missing_code.h"
#include "lessons/lesson_list.h"
#include "opening/opened_view.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/stage_functions.h"
#include "support/effort.h"
#include "support/project_scenes.h"
#include "support/samples.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

const LabCode& lab_code_on_disk() {
    static const LabCode code = read_lab_code(lessons_folder() + "/code");
    return code;
}

/// The first pixel that the code draws differently; empty: none.
std::string first_wrong_bit(CodeMachine& machine, const Framebuffer& right) {
    const bool has_depth = !machine.global("depthBuffer").empty();
    for (std::size_t i = 0; i < right.colour.size(); ++i) {
        const glm::vec3 colour = drawn_colour(machine, i);
        const float depth = has_depth ? drawn_depth(machine, i) : right.depth[i];
        const bool is_same = std::memcmp(&colour, &right.colour[i], sizeof colour) == 0 &&
                             std::memcmp(&depth, &right.depth[i], sizeof depth) == 0;
        if (is_same) continue;
        const std::size_t width = static_cast<std::size_t>(right.size.width);
        return "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) +
               "): red " + std::to_string(colour.r) + " for " + std::to_string(right.colour[i].r) +
               ", depth " + std::to_string(depth) + " for " + std::to_string(right.depth[i]);
    }
    return {};
}

/// A picture to draw, and the frame that has it.
struct Picture {
    std::string name;
    std::function<void(const std::function<void(const Frame&)>&)> with_frame;
};

/// At each stage.
std::vector<Picture> pictures_of(const std::vector<Scene>& scenes) {
    std::vector<Picture> pictures;
    for (const Scene& scene : scenes) {
        for (const StageInfo& info : stage_list()) {
            if (!is_of_use(info, scene)) continue;
            Settings settings = default_settings(scene);
            set_step(settings, info.step);
            pictures.push_back(
                {scene.name + " " + std::string(info.name),
                 [&scene, settings](const auto& take) { take(prepare_frame(scene, settings)); }});
        }
    }
    return pictures;
}

std::vector<Picture> lesson_pictures() {
    std::vector<Picture> pictures;
    LessonList lessons;
    for (const Lesson& lesson : lessons.all()) {
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            ViewOptions options;
            options.lesson = lesson.id;
            options.step = std::to_string(step);
            pictures.push_back({lesson.id + " step " + options.step, [options](const auto& take) {
                                    const Session session = open_view(options);
                                    take(prepare_frame(*session.scene, session.a.settings));
                                }});
        }
    }
    return pictures;
}

/// Fails with the first wrong pixel.
void check_code(const Frame& frame, const std::string& name) {
    CodeWalk walk;
    walk.take(lab_code_on_disk(), frame, 1);
    CodeMachine& machine = walk.machine();
    Framebuffer planes;
    clear(planes, frame);
    give_planes(machine, planes);
    machine.call(machine.program().find_function("Draw"));
    const CodeEnd end = machine.run();
    CAPTURE(name, machine.fault().line, machine.fault().sentence);
    REQUIRE(end == CodeEnd::done);
    CHECK(first_wrong_bit(machine, draw_frame(frame)) == "");
}

/// Which pictures have code, and what the others miss.
struct CodeCoverage {
    int drawn = 0;
    std::vector<std::string> missing;
};

/// At full effort draws all pictures, and otherwise for each program the one with the least work.
CodeCoverage check_pictures(const std::vector<Picture>& pictures) {
    const LabCode& code = lab_code_on_disk();
    struct Least {
        double work = 0.0;
        std::size_t picture = 0;
    };
    std::map<std::string, Least> programs; // by their text
    std::set<std::string> missing;
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        pictures[i].with_frame([&](const Frame& frame) {
            const std::string what = missing_code(code, frame);
            if (!what.empty()) {
                missing.insert(what);
                return;
            }
            drawn.push_back(i);
            const Viewport size = frame.settings.viewport;
            const double work = 1.0 * size.width * size.height * frame.triangle_count();
            const std::string text = source_text(lines_for(code, frame), {1, 1});
            const auto known = programs.emplace(text, Least{work, i}).first;
            if (work < known->second.work) known->second = {work, i};
        });
    }
    std::set<std::size_t> chosen(drawn.begin(), drawn.end());
    if (effort() < 1.0) {
        chosen.clear();
        for (const auto& [text, least] : programs)
            chosen.insert(least.picture);
    }
    for (const std::size_t i : chosen) {
        const Picture& picture = pictures[i];
        picture.with_frame([&](const Frame& frame) { check_code(frame, picture.name); });
    }
    return {static_cast<int>(drawn.size()), {missing.begin(), missing.end()}};
}

} // namespace

TEST_CASE("The lab's code draws every scene as the stages do") {
    const std::vector<Scene> scenes = project_scenes();
    const CodeCoverage coverage = check_pictures(pictures_of(scenes));
    CHECK(coverage.drawn == 250);
    CHECK(coverage.missing.empty());
}

TEST_CASE("The lab's code draws triangles whose corners have different colours") {
    const std::vector<Scene> scenes{small_scene()};
    CHECK(check_pictures(pictures_of(scenes)).drawn == 4);
}

TEST_CASE("The lab's code draws with the settings of every lesson as the stages do") {
    const CodeCoverage coverage = check_pictures(lesson_pictures());
    CHECK(coverage.drawn == 332);
    CHECK(coverage.missing.empty());
}

TEST_CASE("A line of each mistake stands next to the right one") {
    // What lets mistakes act: of other settings, and of scenes.
    const char* const partners[] = {"",
                                    "coverage=edge_functions",
                                    "line=bresenham",
                                    "transform=matrices",
                                    "shadows=rays",
                                    "samples=4;coverage=edge_functions",
                                    "texture_filter=mipmap",
                                    "light.model=blinn_phong"};
    const LabCode& code = lab_code_on_disk();
    std::vector<Scene> scenes;
    for (const char* name :
         {"lab-room", "checkered-room", "brick-heights", "studs", "glass-halves", "cylinder"})
        scenes.push_back(read_scene(lessons_folder() + "/scenes/" + name + ".toml"));
    const auto has_line = [&](const StageFunction& row) {
        for (const Scene& scene : scenes) {
            for (const std::string partner : partners) {
                Settings settings = default_settings(scene);
                set_step(settings, find_stage("pixel_light")->step);
                settings.viewport = {100, 100};
                for (std::string_view rest = partner; !rest.empty();)
                    set_from_text(settings, take_part(rest, ';'));
                set_from_text(settings,
                              std::string(row.setting->name) + "=" + std::string(row.word));
                const Frame frame = prepare_frame(scene, settings);
                if (!missing_code(code, frame).empty()) continue;
                const std::vector<ChosenLine> lines = lines_for(code, frame);
                if (std::any_of(lines.begin(), lines.end(), [](const ChosenLine& line) {
                        return line.is_mistake || !line.usual.empty();
                    }))
                    return true;
            }
        }
        return false;
    };
    std::vector<std::string> without;
    for (const StageFunction& row : stage_functions()) {
        if (row.file.starts_with("mistakes/") && !has_line(row))
            without.push_back(std::string(row.setting->name) + "=" + std::string(row.word));
    }
    std::sort(without.begin(), without.end());
    without.erase(std::unique(without.begin(), without.end()), without.end());
    // What is done before the program, or after it; and two threads.
    CHECK(without == std::vector<std::string>{"bsp_rule=exchanged", "channel_order=bgr",
                                              "colour_over_one=wrap", "depth_test=raced",
                                              "encoding=gamma", "painter_rule=nearest_corner"});
}

TEST_CASE("Each setting that the code has lines for draws the same bits in the room") {
    std::vector<Picture> pictures;
    static const Scene scene = lab_room();
    for (const Variant& variant : some_of(rule_variants(), 60)) {
        for (const StageInfo& info : stage_list()) {
            Settings settings = default_settings(scene);
            settings.viewport = {120, 110};
            settings.camera.focal_length = 130.0f;
            set_step(settings, info.step);
            variant.apply(settings);
            pictures.push_back(
                {variant.name + " " + std::string(info.name),
                 [settings](const auto& take) { take(prepare_frame(scene, settings)); }});
        }
    }
    CHECK(check_pictures(pictures).drawn > 100);
}

} // namespace rasterwalk::test
