// The code that students are shown draws the same bits as the stages: in every scene, with the
// settings of every step of every lesson, and with each setting that it has lines for.

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "lab_code/code_frame.h"
#include "lab_code/code_walk.h"
#include "lessons/lesson_list.h"
#include "opening/opened_view.h"
#include "pipeline/draw.h"
#include "session/content.h"
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

/// Draws frames by the code, and notes what it has no lines for.
class CodeChecker {
  public:
    /// Fails with the first wrong pixel.
    void check(const Frame& frame, const std::string& name) {
        walk_.take(lab_code_on_disk(), frame, ++number_);
        if (!walk_.missing().empty()) {
            missing_.emplace(walk_.missing(), name);
            return;
        }
        ++drawn_;
        CodeMachine& machine = walk_.machine();
        Framebuffer planes;
        clear(planes, frame);
        give_planes(machine, planes);
        machine.call(machine.program().find_function("Draw"));
        const CodeEnd end = machine.run();
        CAPTURE(name, machine.fault().line, machine.fault().sentence);
        REQUIRE(end == CodeEnd::done);
        CHECK(first_wrong_bit(machine, draw_frame(frame)) == "");
    }

    int drawn() const { return drawn_; }
    const std::map<std::string, std::string>& missing() const { return missing_; }

  private:
    CodeWalk walk_;
    std::uint64_t number_ = 0;
    int drawn_ = 0;
    std::map<std::string, std::string> missing_; ///< what is, and where it was first
};

std::vector<std::string> names_of(const std::map<std::string, std::string>& missing) {
    std::vector<std::string> names;
    for (const auto& [name, where] : missing)
        names.push_back(name);
    return names;
}

} // namespace

TEST_CASE("The lab's code draws every scene as the stages do") {
    CodeChecker checker;
    for (const Scene& scene : project_scenes()) {
        for (const StageInfo& info : stage_list()) {
            if (!is_of_use(info, scene)) continue;
            Settings settings = default_settings(scene);
            set_step(settings, info.step);
            checker.check(prepare_frame(scene, settings),
                          scene.name + " " + std::string(info.name));
        }
    }
    CHECK(names_of(checker.missing()) == std::vector<std::string>{"normal maps"});
    CHECK(checker.drawn() == 246);
}

TEST_CASE("The lab's code draws with the settings of every lesson as the stages do") {
    CodeChecker checker;
    LessonList lessons;
    for (const Lesson& lesson : lessons.all()) {
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            ViewOptions options;
            options.lesson = lesson.id;
            options.step = std::to_string(step);
            const Session session = open_view(options);
            checker.check(prepare_frame(*session.scene, session.a.settings),
                          lesson.id + " step " + std::to_string(step));
        }
    }
    CHECK(checker.drawn() == 274);
    // What is not written out yet.
    CHECK(names_of(checker.missing()) ==
          std::vector<std::string>{
              "Box pixels tested: interval", "Clipped: by all planes", "Clipped: by the near plane",
              "Clipped: not at all", "Culled: by fragment", "Depth buffer holds: NDC z",
              "Depth buffer holds: NDC z, 16 bits", "Rejected before clipping: by outcodes",
              "Samples of a pixel: 4", "Texture filter: mipmap", "Texture filter: trilinear",
              "Vectors are: columns, M v", "Warnock's squares", "World to clip space: matrices",
              "normal maps", "shadows"});
}

TEST_CASE("Each setting that the code has lines for draws the same bits in the room") {
    CodeChecker checker;
    const Scene scene = lab_room();
    for (const Variant& variant : some_of(rule_variants(), 30)) {
        for (const StageInfo& info : stage_list()) {
            Settings settings = default_settings(scene);
            settings.viewport = {120, 110};
            settings.camera.focal_length = 130.0f;
            set_step(settings, info.step);
            variant.apply(settings);
            checker.check(prepare_frame(scene, settings),
                          variant.name + " " + std::string(info.name));
        }
    }
    CHECK(checker.drawn() > 50);
}

} // namespace rasterwalk::test
