// Checks that the pictures of the second rasterizer are what the list says.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "laboratory/student_pictures.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace student_picture_tests {

/// How many pixels differ by more than `most` in some channel.
int pixels_that_differ(const Image& a, const Image& b, int most) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int largest = 0;
        for (std::size_t k = i; k < i + 4; ++k)
            largest = std::max(largest, std::abs(int{a.rgba[k]} - int{b.rgba[k]}));
        count += largest > most ? 1 : 0;
    }
    return count;
}

/// The program's settings for the student's choices.
Settings settings_of(const StudentProgram& program, const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.viewport = {program.width, program.height};
    settings.camera.position = program.camera;
    settings.camera.yaw = program.yaw;
    settings.camera.focal_length = program.zoom * static_cast<float>(program.height);
    settings.light.position = program.lamp;
    settings.light.power = program.power;
    settings.light.indirect = program.indirect;
    static const std::map<StudentStage, StripStep> stages = {
        {StudentStage::fill, {Stage::fill, Shading::unlit}},
        {StudentStage::depth, {Stage::depth, Shading::unlit}},
        {StudentStage::vertex_light, StripStep::vertex_light},
        {StudentStage::pixel_light, StripStep::pixel_light}};
    set_step(settings, stages.at(program.stage));
    static const std::map<VertexCut, VertexRounding> cuts = {
        {VertexCut::cut, VertexRounding::truncate},
        {VertexCut::floor, VertexRounding::floor},
        {VertexCut::round, VertexRounding::round},
        {VertexCut::sum_cut, VertexRounding::truncate_sum}};
    settings.vertex_rounding = cuts.at(program.vertex_cut);
    static const std::map<Walk, LineWalk> walks = {{Walk::add_steps, LineWalk::accumulate},
                                                   {Walk::multiply_step, LineWalk::multiply},
                                                   {Walk::blend_ends, LineWalk::exact}};
    settings.line_walk = walks.at(program.walk);
    if (program.lines_rounded) set_from_text(settings, "line_rounding=round");
    if (program.vertex_light_straight) settings.interpolation = Interpolation::affine;
    return settings;
}

TEST_CASE("The second rasterizer draws what the stages draw, correctly or with a known mistake") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    int compared = 0;
    for (const BroughtPicture& picture : some_of(student_pictures(), 12)) {
        Settings settings = settings_of(picture.program, scene);
        const bool is_known = std::all_of(picture.mistakes.begin(), picture.mistakes.end(),
                                          [&](const KnownMistake& mistake) {
                                              const Bug* const bug = bug_of_id(bugs, mistake.id);
                                              if (bug != nullptr) apply_bug_rule(*bug, settings);
                                              return bug != nullptr;
                                          });
        if (picture.kind == StudentKind::unknown || !is_known) continue;
        const Image stages = view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
        INFO(picture.name);
        CHECK(pixels_that_differ(draw(picture.program), stages, 1) == 0);
        ++compared;
    }
    CHECK(compared > 0);
}

TEST_CASE("Every mistake of the students' pictures shows") {
    std::set<std::string> names;
    for (const BroughtPicture& picture : some_of(student_pictures(), 12)) {
        INFO(picture.name);
        CHECK(names.insert(picture.name).second);
        const Image image = draw(picture.program);
        const StudentProgram right = picture.program.without_mistakes();
        if (picture.kind == StudentKind::unknown)
            CHECK(pixels_that_differ(image, draw(right), 1) >= 200);
        // Each mistake of a pair shows next to the other one.
        for (const KnownMistake& mistake : picture.mistakes) {
            StudentProgram without = right;
            for (const KnownMistake& other : picture.mistakes) {
                if (other.id != mistake.id) other.make(without.mistakes);
            }
            INFO("without " << mistake.id);
            CHECK(pixels_that_differ(image, draw(without), 0) > 2);
        }
    }
}

} // namespace student_picture_tests
} // namespace
