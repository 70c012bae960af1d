#include "inspect/depth_prepass.h"

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "settings/setting_table.h"
#include "support/frames.h"
#include "support/project_root.h"
#include "support/project_scenes.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings prepass_settings(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    if (scene.space == SceneSpace::world) {
        settings.camera.focal_length *= 90.0f / static_cast<float>(settings.viewport.width);
        settings.viewport = {90, 90};
    }
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

} // namespace

TEST_CASE("With a pre-pass the picture has the same bits, and each covered pixel one colour") {
    const std::vector<std::vector<std::string>> many_settings{
        {},
        {"depth_format=ndc_16"},
        {"depth_format=reversed_32"},
        {"depth_format=inv_z_24"},
        {"depth_order=before_depth_test"},
        {"shadows=rays"},
        {"texture_filter=trilinear"},
        {"draw_order=far_first"},
        {"cull=fragment_normal"},
        {"shading=flat", "interpolation=affine"},
        {"coverage=edge_functions", "clip=near"},
        {"stage=depth"},
    };
    int drawn = 0;
    for (const Scene& scene : test::project_scenes()) {
        for (const std::vector<std::string>& assignments : many_settings) {
            const Settings settings = prepass_settings(scene, assignments);
            const Frame plain = prepare_frame(scene, settings);
            if (!can_have_prepass(plain)) continue;
            CAPTURE(scene.path, assignments);
            Framebuffer picture;
            const PrepassTally tally =
                draw_with_prepass(prepare_prepass(scene, settings), cursor_end, picture);
            require_same(picture, draw_frame(plain));
            const std::int64_t covered =
                std::count_if(picture.owner.begin(), picture.owner.end(),
                              [](std::int32_t owner) { return owner >= 0; });
            if (settings.depth_order == DepthOrder::after_depth_test)
                CHECK(tally.picture.shaded == covered);
            CHECK(tally.depth.fragments == tally.picture.fragments);
            ++drawn;
        }
    }
    CHECK(drawn > 300);
}

TEST_CASE("The room's pre-pass saves the colours that are drawn over") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::pixel_light);
    Framebuffer picture;
    const PrepassTally tally =
        draw_with_prepass(prepare_prepass(room, settings), cursor_end, picture);
    CHECK(tally.depth.fragments == 328789);
    CHECK(tally.picture.fragments == 328789);
    CHECK(tally.picture.shaded == 250'000 - 998);
}

TEST_CASE("A pre-pass is refused where it would change the picture") {
    const Scene room = lab_room();
    for (const char* setting :
         {"depth_test=or_equal", "depth_test=reversed", "depth_test=linear_z", "depth_test=off",
          "depth_test=raced", "depth_epsilon=0.01", "depth_index=transposed", "hidden=painter",
          "hidden=warnock", "stage=fill"}) {
        CAPTURE(setting);
        CHECK_FALSE(can_have_prepass(prepare_frame(room, prepass_settings(room, {setting}))));
    }
    CHECK_FALSE(can_have_prepass(
        prepare_frame(room, prepass_settings(room, {"coverage=edge_functions", "samples=4"}))));
    const Scene panes = read_scene(project_root() + "/lessons/scenes/two-panes.toml");
    CHECK_FALSE(can_have_prepass(prepare_frame(panes, prepass_settings(panes, {}))));
    CHECK(can_have_prepass(prepare_frame(panes, prepass_settings(panes, {"blend=off"}))));
}
