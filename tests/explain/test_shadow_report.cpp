#include "explain/shadow_formulas.h"

#include "explain/fragment_report.h"
#include "explain/vertex_report.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/outside_reports.h"
#include "settings/setting_table.h"
#include "support/formula_checks.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace shadow_report_tests {

const Scene& room() {
    static const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    return scene;
}

Frame small_frame(std::initializer_list<const char*> assignments) {
    Settings settings = default_settings(room());
    for (const char* usual :
         {"viewport.size=40x40", "camera.focal_length=40", "light.power=8", "shadow_resolution=32"})
        set_from_text(settings, usual);
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    return prepare_frame(room(), settings);
}

float shown_by(const FragmentReport& report, const std::string& id) {
    const Formula* const formula = find_formula(report.formulas, id);
    if (formula == nullptr) FAIL("no formula " << id);
    return formula->result.value;
}

TEST_CASE("Every number on the way to a shadow has a formula that gives it") {
    struct Case {
        std::initializer_list<const char*> settings;
        const char* id; ///< of a formula that exists if the shadow is looked up
    };
    for (const Case& one :
         {Case{{"shadows=rays"}, "pixel_light.shadow.from.x"},
          Case{{"shadows=rays", "shadow_ray=past_lamp"}, "pixel_light.shadow.way.y"},
          Case{{"shadows=rays", "shading=flat"}, "triangle_light.shadow.from.x"},
          Case{{"shadows=rays", "shading=gouraud"}, "pixel_light.lit"},
          Case{{"shadows=rays", "light.model=blinn_phong"}, "pixel_light.lit"},
          Case{{"shadows=rays", "light.sum=reflectance_plus"}, "pixel_light.lit"},
          Case{{"shadows=map"}, "pixel_light.shadow.compared"},
          Case{{"shadows=map", "shadow_slope_bias=1"}, "pixel_light.shadow.bias"},
          Case{{"shadows=map", "shadow_filter=four"}, "pixel_light.shadow.column"}}) {
        const Frame frame = small_frame(one.settings);
        test::Recorder recorder;
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        draw(frame, {}, framebuffer, &recorder);
        int asked = 0, dark = 0, facing_away = 0;
        for (std::size_t i = 0; i < recorder.fragments.size(); i += 41) {
            const FragmentEvent& event = recorder.fragments[i];
            const std::string where =
                std::string(*(one.settings.end() - 1)) + ", " + to_text(event.cursor) + ": ";
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            if (!report) FAIL(where << "has no report");
            test::check_formulas(frame, report->formulas, where);
            const bool is_flat = report->shading == Shading::flat;
            const SurfaceLight& light = is_flat ? report->light_per_triangle : report->light;
            const std::string said = shadow_text(light.shadow, frame);
            if (!light.shadow.is_tested) {
                ++facing_away;
                CHECK(find_formula(report->formulas, one.id) == nullptr);
                CHECK(said == "Unlit: the surface faces away from the lamp");
                CHECK_FALSE(lamp_ray_outside(frame, report));
                continue;
            }
            ++asked;
            dark += light.shadow.is_dark() ? 1 : 0;
            CHECK(find_formula(report->formulas, one.id) != nullptr);
            CHECK(shown_by(*report, is_flat ? "triangle_light.lit" : "pixel_light.lit") ==
                  light.shadow.lit);
            CHECK(said.starts_with("Lit") == (light.shadow.lit == 1.0f));
            const std::optional<LampRay> way = lamp_ray_outside(frame, report);
            REQUIRE(way);
            CHECK(way->met.has_value() == light.shadow.is_dark());
            if (report->shading != Shading::phong || event.fate != Fate::written) continue;
            // What the shader has drawn is the result of the formulas.
            for (int channel = 0; channel < 3; ++channel) {
                constexpr std::array<const char*, 3> names{"red", "green", "blue"};
                CHECK(shown_by(*report, std::string("pixel_light.R.") +
                                            names[static_cast<std::size_t>(channel)]) ==
                      event.after[channel]);
            }
        }
        INFO(one.id << " " << *(one.settings.end() - 1));
        CHECK(asked > 10);
        CHECK(dark > 0);
        CHECK(facing_away > 0);
    }
}

TEST_CASE("The report of a vertex shows its shadow too") {
    const Frame frame = small_frame({"shadows=rays", "stage=vertex_light", "tessellation=4"});
    int dark = 0;
    for (int t = 0; t < frame.triangle_count(); t += 7) {
        const VertexReport report = vertex_report(frame, t, 1);
        test::check_formulas(frame, report.formulas, "triangle " + std::to_string(t) + ": ");
        CHECK(report.light.reflected == frame.given_clip_vertex(t, 1).varyings.illumination);
        dark += report.light.shadow.is_dark() ? 1 : 0;
    }
    CHECK(dark > 3);
}

TEST_CASE("Without shadows nothing is said about them") {
    const Frame frame = small_frame({});
    const std::optional<Cursor> cursor = fragment_on_pixel(frame, {20, 36}, cursor_end);
    REQUIRE(cursor);
    const std::optional<FragmentReport> report = fragment_report(frame, *cursor);
    REQUIRE(report);
    CHECK(shadow_text(report->light.shadow, frame).empty());
    CHECK(find_formula(report->formulas, "pixel_light.lit") == nullptr);
    CHECK_FALSE(lamp_ray_outside(frame, report));
    for (const Formula& formula : report->formulas)
        CHECK(formula.id.find("shadow") == std::string::npos);
}

TEST_CASE("Where light is blocked, the blocker is on the way to the lamp, by rays and by map") {
    for (const char* way_of : {"shadows=rays", "shadows=map"}) {
        const Frame frame = small_frame({way_of});
        const glm::dvec3 lamp(frame.settings.light.position);
        int met = 0;
        for (int row = 20; row < 40; ++row) {
            for (int column = 0; column < 40; ++column) {
                const auto cursor = fragment_on_pixel(frame, {column, row}, cursor_end);
                if (!cursor) continue;
                const auto way = lamp_ray_outside(frame, fragment_report(frame, *cursor));
                if (!way || !way->met) continue;
                ++met;
                const glm::dvec3 whole = lamp - way->from, part = *way->met - way->from;
                const double share = glm::dot(part, whole) / glm::dot(whole, whole);
                CAPTURE(way_of, column, row, share);
                CHECK(share > 0.0);
                CHECK(share < 1.0);
                CHECK(glm::length(part - share * whole) < 2e-3);
            }
        }
        CHECK(met > 40);
    }
}

} // namespace shadow_report_tests
} // namespace
