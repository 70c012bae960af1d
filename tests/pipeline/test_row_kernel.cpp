#include "pipeline/row_kernel.h"

#include <cstddef>
#include <vector>

#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/choices.h"
#include "support/effort.h"
#include "support/frames.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

using test::Choice;
using test::Random;

/// An observer that does nothing.

Rectangle random_rectangle(Random& random, Viewport size) {
    const int left = random.integer(0, size.width - 1), top = random.integer(0, size.height - 1);
    return {left, top, random.integer(left + 1, size.width), random.integer(top + 1, size.height)};
}

void check_same_when_watched(const Frame& frame, const DrawWindow& window) {
    Framebuffer unwatched, watched;
    clear(unwatched, frame);
    clear(watched, frame);
    const Observer onlooker;
    const DrawTally tally = draw(frame, window, unwatched);
    CHECK(draw(frame, window, watched, &onlooker) == tally);
    test::require_same(unwatched, watched);
}

/// A separate function that does the same.
template <auto function>
struct Again;
template <class Result, class... Arguments, Result (*function)(Arguments...)>
struct Again<function> {
    static Result call(Arguments... arguments) { return function(arguments...); }
};

bool has_kernel(const Scene& scene, const ReplaceStages& replace) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    settings.light.model = LightModel::lambert;
    return row_kernel_of(prepare_frame(scene, settings, replace)) != nullptr;
}

} // namespace

TEST_CASE("Drawing a row at a time gives the same bits as single fragments, under any settings") {
    Random random(4711);
    int by_kernel = 0, by_fragment = 0;
    for (const char* const name : {"lab-room", "cylinder", "receding-wall", "checkered-room",
                                   "two-panes", "studs", "glass-halves"}) {
        const Scene scene = test::lesson_scene(name);
        for (const char* const base :
             {"shading=unlit", "shading=flat", "shading=gouraud", "shading=phong"}) {
            for (const Choice& choice :
                 test::mixed_choices(scene, base, test::rounds(20, 1), random)) {
                for (const char* const coverage :
                     {"coverage=rows", "coverage=scan_conversion", "coverage=active_edges"}) {
                    CAPTURE(choice.name, coverage);
                    Settings settings = choice.settings;
                    set_from_text(settings, coverage);
                    const Frame frame = prepare_frame(scene, settings);
                    ++(row_kernel_of(frame) != nullptr ? by_kernel : by_fragment);
                    check_same_when_watched(frame, {});
                    DrawWindow window;
                    window.from = test::any_cursor(random, frame.triangle_count());
                    window.to = test::any_cursor(random, frame.triangle_count());
                    window.scissor = random_rectangle(random, settings.viewport);
                    check_same_when_watched(frame, window);
                }
            }
        }
    }
    CHECK(by_kernel > 0);
    CHECK(by_fragment > 0);
}

TEST_CASE("No row is drawn at once if a different function is in a slot of the row") {
    const Scene room = test::lesson_scene("lab-room");
    CHECK(has_kernel(room, nullptr));
    const std::vector<ReplaceStages> replacements{
        [](Stages& s) { s.row_fragments = Again<row_fragments>::call; },
        [](Stages& s) { s.line_step = Again<line_step>::call; },
        [](Stages& s) { s.interpolate = Again<interpolate>::call; },
        [](Stages& s) { s.span_end = Again<span_end>::call; },
        [](Stages& s) { s.recovery_weight = Again<varying_weight>::call; },
        [](Stages& s) { s.cull_fragment = Again<keep_fragment>::call; },
        [](Stages& s) { s.depth_test = Again<depth_test>::call; },
        [](Stages& s) { s.depth_cell = Again<depth_cell>::call; },
        [](Stages& s) { s.pixel_shader = Again<pixel_shader>::call; },
        [](Stages& s) { s.reflected_light = Again<reflected_light>::call; },
    };
    for (std::size_t i = 0; i < replacements.size(); ++i) {
        CAPTURE(i);
        CHECK_FALSE(has_kernel(room, replacements[i]));
    }
    const Scene bent = test::lesson_scene("cylinder");
    CHECK(has_kernel(bent, nullptr));
    CHECK_FALSE(has_kernel(bent, [](Stages& s) { s.unit_normal = Again<unit_normal>::call; }));
    CHECK_FALSE(has_kernel(bent, [](Stages& s) { s.light_normal = Again<light_normal>::call; }));
    CHECK_FALSE(has_kernel(bent, [](Stages& s) { s.light_side = Again<side_of_normal>::call; }));
}

} // namespace rasterwalk
