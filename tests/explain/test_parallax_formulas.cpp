#include "explain/parallax_formulas.h"

#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "explain/fragment_report.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/outside_reports.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/formula_checks.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("Every number of a shifted place follows from its formula to the bit") {
    test::Random random(9);
    int reports = 0, behind = 0;
    const std::vector<std::vector<std::string>> others{
        {"parallax=limited"},
        {"parallax=divided", "texture_filter=trilinear"},
        {"parallax=divided", "parallax_rule=subtracted", "normal_map=off"},
        {"parallax_rule=subtracted", "texture_filter=bilinear", "normal_map_space=tangent"},
        {"parallax=divided", "projection=orthographic", "texture=off"},
        {"parallax=limited", "light.model=blinn_phong", "light.sides=two",
         "normal_map_rule=mirror_missed"}};
    for (const char* const name : {"brick-heights", "cobbled-lane"}) {
        Scene scene = read_scene(fmt::format("{}/scenes/{}.toml", lessons_folder(), name));
        for (const bool is_turned : {false, true}) {
            for (const std::vector<std::string>& words : others) {
                Scene seen = scene;
                if (is_turned) {
                    seen.mesh = {};
                    for (int t = 0; t < scene.triangle_count(); ++t) {
                        auto corners = corners_of(scene, t);
                        for (Vertex& corner : corners)
                            corner.normal = -corner.normal;
                        seen.mesh.add_triangle_of(corners);
                    }
                }
                Settings settings = default_settings(seen);
                for (const std::string& word : words)
                    set_from_text(settings, word);
                const Frame frame = prepare_frame(seen, settings);
                for (int i = 0; i < 8; ++i) {
                    const Cursor at{random.integer(0, seen.triangle_count() - 1), Phase::rows,
                                    random.integer(2, 100), random.integer(0, 20)};
                    const auto report = fragment_report(frame, at);
                    if (!report) continue;
                    ++reports;
                    REQUIRE(report->parallax);
                    behind += report->parallax->terms.view.z < 0.0f ? 1 : 0;
                    test::check_formulas(frame, report->formulas, name);
                    std::set<std::string> ids;
                    for (const Formula& formula : report->formulas)
                        ids.insert(formula.id);
                    CHECK(ids.size() == report->formulas.size());
                    for (const char* const id :
                         {"parallax.height", "parallax.view.z", "parallax.shift.u", "parallax.v"})
                        CHECK(ids.contains(id));
                    if (report->texture) {
                        CHECK(report->texture->place.texcoord == report->parallax->texcoord);
                        const Formula* const x = find_formula(report->formulas, "texture.x");
                        CHECK(x->inputs.front().source == from_formula("parallax.u"));
                    }
                    if (report->fate == Fate::written)
                        CHECK(test::same_bits(report->colour, report->after));
                }
            }
        }
    }
    CHECK(reports > 60);
    CHECK(behind > 20);
}

TEST_CASE("Seen from outside, a divided step ends below where the ray is at the height") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/brick-heights.toml");
    Settings settings = default_settings(scene);
    set_from_text(settings, "parallax=divided");
    int steps = 0;
    const glm::dvec3 eye(settings.camera.position);
    const Frame frame = prepare_frame(scene, settings);
    for (int row = 60; row < 160; row += 3) {
        const auto fragment = fragment_on_pixel(frame, {200, row}, cursor_end);
        REQUIRE(fragment);
        const auto shift = sight_shift_outside(fragment_report(frame, *fragment));
        REQUIRE(shift);
        // The wall is at z = 2 and faces the camera.
        CHECK(shift->seen.z == Approx(2.0));
        CHECK(shift->texel.z == Approx(2.0));
        const glm::dvec3 on_ray =
            eye + (shift->top.z - eye.z) / (shift->seen.z - eye.z) * (shift->seen - eye);
        CHECK(glm::distance(on_ray, shift->top) < 1e-5);
        steps += glm::distance(shift->seen, shift->texel) > 0.05 ? 1 : 0;
    }
    CHECK(steps > 3);
    set_from_text(settings, "parallax=off");
    const Frame flat = prepare_frame(scene, settings);
    CHECK_FALSE(sight_shift_outside(
        fragment_report(flat, *fragment_on_pixel(flat, {200, 90}, cursor_end))));
}

TEST_CASE("Without a height map in force no shift is reported") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/brick-heights.toml");
    for (const char* const text : {"parallax=off", "shading=gouraud", "shading=flat"}) {
        Settings settings = default_settings(scene);
        set_from_text(settings, text);
        const Frame frame = prepare_frame(scene, settings);
        const auto report =
            fragment_report(frame, *fragment_on_pixel(frame, {100, 100}, cursor_end));
        INFO(text);
        REQUIRE(report);
        CHECK_FALSE(report->parallax);
        CHECK(find_formula(report->formulas, "parallax.u") == nullptr);
    }
}
