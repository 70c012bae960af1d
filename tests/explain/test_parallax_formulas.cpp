#include "explain/parallax_formulas.h"

#include <set>

#include <fmt/format.h>

#include "explain/fragment_report.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/bits.h"
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
                for (int i = 0; i < 5; ++i) {
                    const Cursor at{random.integer(0, seen.triangle_count() - 1), Phase::rows,
                                    random.integer(2, 100), random.integer(0, 20)};
                    const auto report = fragment_report(frame, at);
                    if (!report) continue;
                    ++reports;
                    REQUIRE(report->parallax);
                    behind += report->parallax->terms.view.z < 0.0f ? 1 : 0;
                    std::set<std::string> ids;
                    for (const Formula& formula : report->formulas) {
                        ids.insert(formula.id);
                        if (!test::same_bits(evaluate(formula), formula.result.value)) {
                            FAIL(name << " " << formula.id << " = " << with_numbers(formula)
                                      << " gives " << evaluate(formula) << " and shows "
                                      << formula.result.value);
                        }
                        for (const FormulaInput& input : formula.inputs) {
                            if (input.source.kind != SourceKind::formula) continue;
                            const Formula* const from =
                                find_formula(report->formulas, input.source.name);
                            if (from == nullptr)
                                FAIL(formula.id << " asks for " << input.source.name);
                            if (!test::same_bits(from->result.value, input.number.value))
                                FAIL(formula.id << " has a different " << input.source.name);
                        }
                    }
                    CHECK(ids.size() == report->formulas.size());
                    for (const char* const id :
                         {"parallax.height", "parallax.view.z", "parallax.shift.u", "parallax.v"})
                        CHECK(ids.contains(id));
                    if (report->texture) {
                        CHECK(report->texture->place.texcoord == report->parallax->texcoord);
                        const Formula* const x = find_formula(report->formulas, "texture.x");
                        CHECK(x->inputs.front().source == from_formula("parallax.u"));
                    }
                    CHECK(test::same_bits(report->colour, report->after));
                }
            }
        }
    }
    CHECK(reports > 60);
    CHECK(behind > 20);
}

TEST_CASE("Without a height map in force no shift is reported") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/brick-heights.toml");
    for (const char* const text : {"parallax=off", "shading=gouraud", "shading=flat"}) {
        Settings settings = default_settings(scene);
        set_from_text(settings, text);
        const auto report =
            fragment_report(prepare_frame(scene, settings), {0, Phase::rows, 40, 10});
        INFO(text);
        REQUIRE(report);
        CHECK_FALSE(report->parallax);
        CHECK(find_formula(report->formulas, "parallax.u") == nullptr);
    }
}
