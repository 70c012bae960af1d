#include "explain/bump_formulas.h"

#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "explain/fragment_report.h"
#include "mistakes/normal_map.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/random.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("Every number of a bent normal follows from its formula to the bit") {
    test::Random random(5);
    std::set<float> signs;
    int in_space = 0;
    // The other settings for each reading of the map.
    const std::string_view others[] = {
        "normal_map_space=world", "normal_map_space=tangent",
        "normal_map_space=tangent light.model=blinn_phong light.sides=two",
        "normal_map_space=tangent light.model=blinn_phong projection=orthographic shadows=rays",
        "normal_map_space=tangent light.direction=from_light normal_w=one"};
    int round = 0;
    for (const char* const name : {"studs", "brick-relief"}) {
        const Scene scene = read_scene(fmt::format("{}/scenes/{}.toml", lessons_folder(), name));
        for (const std::string_view rule : enum_words<NormalMapRule>) {
            for (const std::string_view filter : {"nearest", "trilinear"}) {
                Settings settings = default_settings(scene);
                set_from_text(settings, "stage=pixel_light");
                set_from_text(settings, fmt::format("normal_map_rule={}", rule));
                set_from_text(settings, fmt::format("texture_filter={}", filter));
                std::istringstream words{std::string(others[round++ % std::size(others)])};
                for (std::string assignment; words >> assignment;)
                    set_from_text(settings, assignment);
                const Frame frame = prepare_frame(scene, settings);
                for (int i = 0; i < 4; ++i) {
                    const Cursor at{random.integer(0, scene.triangle_count() - 1), Phase::rows,
                                    random.integer(2, 100), 3};
                    const auto report = fragment_report(frame, at);
                    if (!report) continue;
                    REQUIRE(report->bump);
                    signs.insert(report->bump->sign);
                    std::set<std::string> ids;
                    for (const Formula& formula : report->formulas) {
                        ids.insert(formula.id);
                        if (!test::same_bits(evaluate(formula), formula.result.value)) {
                            FAIL(name << " " << rule << " " << filter << " " << formula.id << " = "
                                      << with_numbers(formula) << " gives " << evaluate(formula)
                                      << " and shows " << formula.result.value);
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
                    CHECK(ids.count("bump.sum.x") == 1);
                    const bool is_here = report->bump->space.has_value();
                    CHECK(is_here == (settings.normal_map_space == NormalMapSpace::tangent));
                    CHECK(ids.count("bump.square.normal.x") == (is_here ? 1u : 0u));
                    CHECK(ids.count("pixel_light.way.x") == (is_here ? 1u : 0u));
                    in_space += is_here ? 1 : 0;
                    CHECK(test::same_bits(report->colour, report->after));
                }
            }
        }
    }
    CHECK(signs == std::set<float>{-1.0f, 1.0f});
    CHECK(in_space > 10);
}

TEST_CASE("Without a normal map in force no bent normal is reported") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/studs.toml");
    for (const char* const text : {"normal_map=off", "shading=gouraud", "shading=flat"}) {
        Settings settings = default_settings(scene);
        set_from_text(settings, "stage=pixel_light");
        set_from_text(settings, text);
        const auto report =
            fragment_report(prepare_frame(scene, settings), {0, Phase::rows, 40, 10});
        INFO(text);
        REQUIRE(report);
        CHECK_FALSE(report->bump);
        CHECK(find_formula(report->formulas, "bump.normal.x") == nullptr);
    }
}

TEST_CASE("The handedness is the one that the function in the slot gives the bitangent") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/studs.toml");
    Settings settings = default_settings(scene);
    set_from_text(settings, "stage=pixel_light");
    const Frame asked = prepare_frame(scene, settings);
    const Frame unasked = prepare_frame(
        scene, settings, [](Stages& stages) { stages.tangent_frame = tangent_frame_unasked; });
    int mirrored = 0;
    for (int triangle = 0; triangle < scene.triangle_count(); ++triangle) {
        const Cursor at{triangle, Phase::rows, 20, 3};
        const auto right = fragment_report(asked, at), wrong = fragment_report(unasked, at);
        if (!right || !wrong) continue;
        REQUIRE(wrong->bump);
        CHECK(wrong->bump->sign == 1.0f);
        mirrored += right->bump->sign < 0.0f ? 1 : 0;
    }
    CHECK(mirrored > 0);
}
