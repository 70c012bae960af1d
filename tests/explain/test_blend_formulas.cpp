#include "explain/depth_formulas.h"

#include <string>

#include "explain/fragment_report.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace blended {

Scene panes() {
    return read_scene(lessons_folder() + "/scenes/two-panes.toml");
}

const Formula* blend_formula(const Frame& frame, const Cursor& cursor, const std::string& id) {
    static std::optional<FragmentReport> report;
    report = fragment_report(frame, cursor);
    REQUIRE(report);
    return find_formula(report->formulas, id);
}

} // namespace blended
} // namespace

TEST_CASE("The formula of a blended channel gives what the pixel shows, to the bit") {
    using namespace blended;
    const Scene scene = panes();
    int asked = 0;
    for (const char* way : {"blend=over", "blend=swapped"}) {
        Settings settings = default_settings(scene);
        set_from_text(settings, way);
        const Frame frame = prepare_frame(scene, settings);
        for (int triangle = 2; triangle < 6; ++triangle) {
            for (const char* channel : {"blend.red", "blend.green", "blend.blue"}) {
                INFO(way << ", triangle " << triangle << ", " << channel);
                const Formula* const formula =
                    blend_formula(frame, {triangle, Phase::rows, 4, 1}, channel);
                REQUIRE(formula != nullptr);
                CHECK(evaluate(*formula) == formula->result.value);
                ++asked;
            }
        }
    }
    CHECK(asked == 24);
}

TEST_CASE("Blending is not mentioned if nothing is blended") {
    using namespace blended;
    const Scene scene = panes();
    Settings settings = default_settings(scene);
    const Frame over = prepare_frame(scene, settings);
    CHECK(blend_formula(over, {0, Phase::rows, 4, 1}, "blend.red") == nullptr); // the wall
    settings.blend = Blend::off;
    const Frame off = prepare_frame(scene, settings);
    CHECK(blend_formula(off, {2, Phase::rows, 4, 1}, "blend.red") == nullptr);
    // Red on the right is drawn second and is behind blue where they overlap.
    settings.blend = Blend::over;
    const Frame failed = prepare_frame(scene, settings);
    CHECK(blend_formula(failed, {8, Phase::rows, 5, 1}, "blend.red") == nullptr);
}
