// The settings that take the place of what materials give: the picture is that of a scene with
// other materials.

#include <array>
#include <string>

#include "settings/setting_table.h"
#include "support/choices.h"
#include "support/frames.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The same scene with this exponent in all materials.
Scene with_exponent(const Scene& scene, float exponent) {
    Scene changed = scene;
    changed.mesh = Mesh{};
    for (int t = 0; t < scene.mesh.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        for (Vertex& corner : corners)
            corner.shine.exponent = exponent;
        changed.mesh.add_triangle_of(corners);
    }
    return changed;
}

Framebuffer drawn_with(const Scene& scene, Settings settings, const char* assignment) {
    set_from_text(settings, assignment);
    return draw_frame(prepare_frame(scene, settings));
}

} // namespace

TEST_CASE("light.exponent is the exponent of every material's highlight") {
    const Scene scene = lesson_scene("cylinder");
    for (const StripStep step :
         {StripStep{Stage::shade, Shading::flat}, StripStep{Stage::shade, Shading::gouraud},
          StripStep{Stage::shade, Shading::phong}}) {
        Settings settings = default_settings(scene);
        set_step(settings, step);
        set_from_text(settings, "light.model=blinn_phong");
        const Framebuffer own = drawn_with(scene, settings, "light.exponent=0");
        for (const float exponent : {1.0f, 7.5f, 400.0f}) {
            const std::string assignment = "light.exponent=" + std::to_string(exponent);
            const Framebuffer set = drawn_with(scene, settings, assignment.c_str());
            require_same(set, draw_frame(prepare_frame(with_exponent(scene, exponent), settings)));
            CHECK_FALSE(set == own);
        }
        // Without highlights there is nothing to sharpen.
        set_from_text(settings, "light.model=lambert");
        require_same(drawn_with(scene, settings, "light.exponent=9"),
                     drawn_with(scene, settings, "light.exponent=0"));
    }
}

TEST_CASE("surface.alpha is the alpha of whatever is half transparent, and of nothing else") {
    const Scene scene = lesson_scene("two-panes");
    REQUIRE(has_alpha(scene));
    Settings settings = default_settings(scene);
    set_step(settings, {Stage::shade, Shading::phong});
    const Framebuffer own = drawn_with(scene, settings, "surface.alpha=0");
    for (const float alpha : {0.125f, 0.75f, 1.0f}) {
        Scene changed = scene;
        for (Part& part : changed.parts) {
            if (part.alpha < 1.0f) part.alpha = alpha;
        }
        const std::string assignment = "surface.alpha=" + std::to_string(alpha);
        const Framebuffer set = drawn_with(scene, settings, assignment.c_str());
        const Framebuffer wanted = draw_frame(prepare_frame(changed, settings));
        CHECK(set.colour == wanted.colour);
        CHECK(set.owner == wanted.owner);
        CHECK_FALSE(set.colour == own.colour);
    }
}
