#include "explain/texture_report.h"

#include <set>
#include <string>

#include <fmt/format.h>

#include "explain/fragment_report.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/recorder.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// One choice of the settings that a texture's formulas depend on.
Settings settings_of_texture(const Scene& scene, std::string_view step,
                             std::string_view interpolation, std::string_view filter,
                             std::string_view wrap) {
    Settings settings = default_settings(scene);
    set_from_text(settings, fmt::format("stage={}", step));
    set_from_text(settings, fmt::format("interpolation={}", interpolation));
    set_from_text(settings, fmt::format("texture_filter={}", filter));
    set_from_text(settings, fmt::format("texture_wrap={}", wrap));
    return settings;
}

/// Fails unless every formula gives its number again, and names inputs that exist.
void check_formulas(const FragmentReport& report, const std::string& where) {
    std::set<std::string> ids;
    for (const Formula& formula : report.formulas)
        ids.insert(formula.id);
    for (const Formula& formula : report.formulas) {
        const float again = evaluate(formula);
        if (!test::same_bits(again, formula.result.value)) {
            FAIL(where << formula.id << " = " << formula.expression << " = "
                       << with_numbers(formula) << " gives " << again << " and shows "
                       << formula.result.value);
        }
        for (const FormulaInput& input : formula.inputs) {
            if (input.source.kind != SourceKind::formula) continue;
            const Formula* const from = find_formula(report.formulas, input.source.name);
            if (from == nullptr) FAIL(where << formula.id << " asks for " << input.source.name);
            if (!test::same_bits(from->result.value, input.number.value)) {
                FAIL(where << formula.id << " has " << input.number.value << " of "
                           << input.source.name << ", which is " << from->result.value);
            }
        }
    }
    CHECK(ids.size() == report.formulas.size());
}

} // namespace

TEST_CASE("Every number of a textured fragment follows from its formula to the bit") {
    const Scene scene = test::receding_wall(test::many_colours(9, 6), 3.7f);
    test::Random random(3);
    int reports = 0;
    std::set<int> counts, levels;
    for (const std::string_view step : {"fill", "vertex_light", "pixel_light"}) {
        for (const std::string_view interpolation : enum_words<Interpolation>) {
            for (const std::string_view filter : enum_words<TextureFilter>) {
                const std::string_view wrap =
                    enum_words<TextureWrap>[static_cast<std::size_t>(random.integer(0, 2))];
                Settings settings = settings_of_texture(scene, step, interpolation, filter, wrap);
                settings.texel_rule = random.integer(0, 1) == 0
                                          ? TexelRule::right
                                          : static_cast<TexelRule>(random.integer(
                                                1, int{enum_words<TexelRule>.size()} - 1));
                const Frame frame = prepare_frame(scene, settings);
                Framebuffer picture;
                clear(picture, frame);
                test::Recorder recorder;
                draw(frame, {}, picture, &recorder);
                const int last = static_cast<int>(recorder.fragments.size()) - 1;
                for (int i = 0; i < test::rounds(12, 4); ++i) {
                    const FragmentEvent& event =
                        recorder.fragments[static_cast<std::size_t>(random.integer(0, last))];
                    const std::string where =
                        fmt::format("{} {} {} {} pixel {},{}: ", step, interpolation, filter, wrap,
                                    event.fragment.column, event.fragment.row);
                    const auto report = fragment_report(frame, event.cursor);
                    REQUIRE(report);
                    REQUIRE(report->texture);
                    check_formulas(*report, where);
                    INFO(where);
                    if (event.fate == Fate::written)
                        CHECK(test::same_bits(report->colour, event.after));
                    // What the screen shows of the stage is the last of its formulas.
                    const std::string shown = step == "fill"           ? "flat.colour.green"
                                              : step == "vertex_light" ? "vertex_light.colour.green"
                                                                       : "pixel_light.colour.green";
                    CHECK(find_formula(report->formulas, shown)->result.value ==
                          frame.stages.screen.visible_channel(report->colour.g));
                    const auto alone = texture_report(frame, event.cursor);
                    REQUIRE(alone);
                    CHECK(alone->colour == report->texture->colour);
                    CHECK(alone->place.texcoord == report->texture->place.texcoord);
                    const auto taken = static_cast<std::size_t>(alone->taken.count);
                    CHECK(std::equal(alone->taken.begin(), alone->taken.end(),
                                     report->texture->taken.begin(), report->texture->taken.end()));
                    counts.insert(static_cast<int>(taken));
                    levels.insert(alone->heaviest().level);
                    ++reports;
                }
            }
        }
    }
    CHECK(reports >= 3 * 3 * 4 * 4);
    CHECK(counts == std::set<int>{1, 4, 8});
    CHECK(levels.size() >= 2);
}

TEST_CASE(
    "Whatever the shading, a painted surface of many colours reports the colour that is drawn") {
    const Scene plain = test::receding_wall(test::many_colours(5, 4), 2.3f);
    Scene scene = plain;
    scene.mesh = {};
    for (int t = 0; t < plain.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(plain, t);
        for (Vertex& corner : corners) {
            const float part = corner.texcoord.x / 2.3f;
            corner.reflectance = {0.9f - 0.5f * part, 0.4f, 0.2f + 0.6f * part};
        }
        scene.mesh.add_triangle_of(corners);
    }
    struct Shown {
        std::string_view shading, colour;
    };
    test::Random random(8);
    for (const Shown& one : {Shown{"shading=unlit", "flat.colour."},
                             {"shading=flat", "triangle_light.colour."},
                             {"shading=gouraud", "vertex_light.colour."},
                             {"shading=phong", "pixel_light.colour."}}) {
        for (const char* const coverage :
             {"coverage=rows", "weight_edge=opposite", "weight_edge=own"}) {
            for (const char* const model : {"light.model=lambert", "light.model=blinn_phong"}) {
                Settings settings =
                    settings_of_texture(scene, "pixel_light", "perspective", "bilinear", "repeat");
                set_from_text(settings, "coverage=edge_functions");
                for (const std::string_view assignment : {one.shading, {coverage}, {model}})
                    set_from_text(settings, std::string(assignment));
                const Frame frame = prepare_frame(scene, settings);
                Framebuffer picture;
                clear(picture, frame);
                test::Recorder recorder;
                draw(frame, {}, picture, &recorder);
                REQUIRE_FALSE(recorder.fragments.empty());
                for (int i = 0; i < 5; ++i) {
                    const FragmentEvent& event = recorder.fragments[static_cast<std::size_t>(
                        random.integer(0, static_cast<int>(recorder.fragments.size()) - 1))];
                    const auto report = fragment_report(frame, event.cursor);
                    REQUIRE(report);
                    const std::string where = fmt::format("{} {} {} {}: ", one.shading, coverage,
                                                          model, to_text(event.cursor));
                    check_formulas(*report, where);
                    INFO(where);
                    const std::array<const char*, 3> names{"red", "green", "blue"};
                    for (int c = 0; c < 3; ++c) {
                        const Formula* const shown =
                            find_formula(report->formulas, std::string(one.colour) +
                                                               names[static_cast<std::size_t>(c)]);
                        REQUIRE(shown != nullptr);
                        CHECK(test::same_bits(
                            shown->result.value,
                            frame.stages.screen.visible_channel(report->colour[c])));
                    }
                }
            }
        }
    }
}

TEST_CASE("A fragment without a texture has no texture formulas") {
    Scene scene = test::receding_wall(test::many_colours(4, 4));
    Settings settings = default_settings(scene);
    const auto has_story = [&] {
        const Frame frame = prepare_frame(scene, settings);
        const auto report = fragment_report(frame, {0, Phase::rows, 10, 2});
        REQUIRE(report);
        CHECK(report->texture.has_value() ==
              (find_formula(report->formulas, "texture.level") != nullptr));
        CHECK(report->texture.has_value() ==
              texture_report(frame, Cursor{0, Phase::rows, 10, 2}).has_value());
        return report->texture.has_value();
    };
    CHECK(has_story());
    settings.texture = TextureUse::off;
    CHECK_FALSE(has_story());
    settings.texture = TextureUse::on;
    scene.parts.front().texture = -1;
    CHECK_FALSE(has_story());
    const Frame frame = prepare_frame(scene, settings);
    CHECK_FALSE(texture_report(frame, Cursor{0, Phase::edges, 1, 1}));
    CHECK_FALSE(texture_report(frame, Cursor{1, Phase::rows, 10000, 2}));
}
