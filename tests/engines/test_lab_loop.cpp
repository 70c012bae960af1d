// The student's loop compared with the stages of this program under the lab's rules: two programs
// that were written independently, and should draw the same pixels.

#include "engines/ladder/rungs.h"

#include "engines/knot.h"
#include "engines/workload.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "stages/put_pixel.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Scene lit_room() {
    const Scene room = read_scene(lessons_folder() + '/' + std::string(usual_scene));
    return workload_scene(Workload::w1, room);
}

/// The lab's own rules.
Settings lab_rules(const Scene& scene, StripStep step, Viewport size) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.viewport = size;
    settings.camera.focal_length = static_cast<float>(size.height);
    return settings;
}

struct Counts {
    int drawn = 0;              ///< pixels on which the student's loop has drawn
    int other_depth = 0;        ///< pixels whose depth has different bits
    int other_colour = 0;       ///< pixels with a different byte
    int largest_difference = 0; ///< of a channel
};

Counts compared(const Scene& scene, const Settings& settings) {
    LadderPicture picture;
    rungs::lab_loop::draw(scene, settings, picture);
    const Framebuffer stages = draw_frame(prepare_frame(scene, settings));
    REQUIRE(picture.depth.size() == stages.depth.size());
    Counts counts;
    for (std::size_t i = 0; i < stages.depth.size(); ++i) {
        counts.drawn += picture.depth[i] > 0.0f;
        counts.other_depth += picture.depth[i] != stages.depth[i];
        const glm::vec3& colour = stages.colour[i];
        bool differs = false;
        for (int channel = 0; channel < 3; ++channel) {
            const int theirs = to_byte(colour[channel]);
            const int own = static_cast<int>(picture.colour[i] >> (16 - 8 * channel) & 0xffU);
            counts.largest_difference = std::max(counts.largest_difference, std::abs(own - theirs));
            differs = differs || own != theirs;
        }
        counts.other_colour += differs;
    }
    return counts;
}

} // namespace

TEST_CASE("In the lit room the student's loop draws what the stages draw, pixel for pixel") {
    const Scene room = lit_room();
    for (const StripStep step : {StripStep::pixel_light, StripStep::vertex_light}) {
        const Counts counts = compared(room, lab_rules(room, step, {500, 500}));
        CHECK(counts.drawn == 250'000 - 998); // as `rasterwalk stats` counts what is uncovered
        CHECK(counts.other_depth == 0);
        CHECK(counts.other_colour == 0);
    }
}

TEST_CASE("The same holds if the picture's sides are odd and the room extends beyond it") {
    Scene room = lit_room();
    room.camera.position.x = 0.4f;
    const Counts counts = compared(room, lab_rules(room, StripStep::pixel_light, {201, 123}));
    CHECK(counts.drawn > 10'000);
    CHECK(counts.other_depth == 0);
    CHECK(counts.other_colour == 0);
}

TEST_CASE("On a bent surface normals are interpolated as the stages do") {
    const Scene knot = knot_scene();
    for (const StripStep step : {StripStep::pixel_light, StripStep::vertex_light}) {
        const Counts counts = compared(knot, lab_rules(knot, step, {120, 120}));
        CHECK(counts.drawn > 3'000);
        CHECK(counts.other_depth == 0);
        CHECK(counts.largest_difference <= 1); // glm::normalize() multiplies by 1 / length
    }
}
