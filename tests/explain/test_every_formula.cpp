// The explanations, under every value of every setting: each formula gives the number that it
// shows, and the last of them is the colour that was drawn.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "explain/fragment_report.h"
#include "explain/vertex_report.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/choices.h"
#include "support/effort.h"
#include "support/formula_checks.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace every_formula_tests {

using test::Choice;

constexpr std::array<const char*, 3> channels{"red", "green", "blue"};

/// The stage's result if this shading is in force.
const char* shown_id(Shading shading) {
    switch (shading) {
    case Shading::unlit:
        return "flat.colour.";
    case Shading::flat:
        return "triangle_light.colour.";
    case Shading::gouraud:
        return "vertex_light.colour.";
    case Shading::phong:
        break;
    }
    return "pixel_light.colour.";
}

float number_of(const std::vector<Formula>& formulas, const std::string& id) {
    const Formula* const formula = find_formula(formulas, id);
    if (formula == nullptr) FAIL("no formula " << id);
    return formula->result.value;
}

bool is_same(float a, float b) {
    return test::same_bits(a, b) || (std::isnan(a) && std::isnan(b));
}

void check_colour(const Frame& frame, const FragmentReport& report, const FragmentEvent& event,
                  const std::string& where) {
    const bool is_blue_first = frame.settings.channel_order == ChannelOrder::bgr;
    const bool is_blended = report.alpha < 1.0f;
    for (int c = 0; c < 3; ++c) {
        const std::string channel = channels[static_cast<std::size_t>(c)];
        const Formula* const shown =
            find_formula(report.formulas, shown_id(report.shading) + channel);
        REQUIRE(shown != nullptr);
        const float worked_out = shown->inputs.front().number.value;
        const float expected = report.colour[is_blue_first ? 2 - c : c];
        if (!is_same(worked_out, expected))
            FAIL(where << ": " << shown->id << " is of " << worked_out << ", the shader gives "
                       << expected);
        if (event.fate != Fate::written) continue;
        // The formulas explain the centre of a pixel, which is then no sample.
        if (sampling_rule(frame.settings) == Sampling::supersample) continue;
        const float put =
            is_blended ? number_of(report.formulas, "blend." + channel) : report.colour[c];
        if (!is_same(put, event.after[c]))
            FAIL(where << ": " << channel << " is " << put << ", drawn is " << event.after[c]);
    }
}

/// Some random fragments of a frame, and the brightest.
std::vector<FragmentEvent> some_fragments(const Frame& frame, int count, test::Random& random) {
    test::Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    const std::vector<FragmentEvent>& all = recorder.fragments;
    if (all.empty()) return {};
    std::vector<FragmentEvent> some{*std::max_element(
        all.begin(), all.end(),
        [](const FragmentEvent& a, const FragmentEvent& b) { return a.after.g < b.after.g; })};
    for (int i = 0; i < count; ++i)
        some.push_back(
            all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))]);
    return some;
}

/// @return how many fragments were looked at
int check_choice(const Scene& scene, const Choice& choice, test::Random& random) {
    const Frame frame = prepare_frame(scene, choice.settings);
    int checked = 0;
    for (const FragmentEvent& event : some_fragments(frame, 2, random)) {
        const std::string where = fmt::format("{}, {}", choice.name, to_text(event.cursor));
        const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
        if (!report) FAIL(where << " has no report");
        test::check_formulas(frame, report->formulas, where);
        check_colour(frame, *report, event, where);
        const int vertex = random.integer(0, triangle_corners - 1);
        test::check_formulas(
            frame, vertex_report(frame, event.cursor.triangle, vertex).formulas,
            fmt::format("{}, t{}/v{}", choice.name, event.cursor.triangle, vertex));
        ++checked;
    }
    return checked;
}

constexpr std::array<const char*, 4> shadings{"shading=unlit", "shading=flat", "shading=gouraud",
                                              "shading=phong"};

TEST_CASE("Under every setting each formula gives its number, and the last the drawn colour") {
    test::Random random(1);
    int checked = 0;
    for (const char* const name :
         {"lab-room", "six-sides", "studs", "checkered-floor", "two-panes", "one-triangle"}) {
        const Scene scene = test::lesson_scene(name);
        for (const Choice& choice : test::some_of(test::single_choices(scene, "shading=phong"), 12))
            checked += check_choice(scene, choice, random);
        for (const char* const shading : shadings) {
            for (const Choice& choice :
                 test::mixed_choices(scene, shading, test::rounds(40, 6), random))
                checked += check_choice(scene, choice, random);
        }
    }
    CHECK(checked > 400);
}

/// A number that follows an unusual rule.
struct Exception {
    const char* scene;
    std::vector<const char*> assignments;
    const char* id;         ///< of a formula of the fragment or of its vertex 0
    const char* expression; ///< that it has at some fragment
};

TEST_CASE("A formula whose number follows an unusual rule says so") {
    const std::vector<const char*> flat_view{"near=1", "far=1", "projection_mix=0.5"};
    const std::vector<Exception> exceptions{
        {"six-sides", {"light.direction=from_light"}, "pixel_light.h.x", "0"},
        {"cylinder", {"row_start=window", "camera.focal_length=1500"}, "pixel_light.n.x", "0"},
        {"lab-room", flat_view, "clip.z", "((1 − mix) · near + mix) · ((far − z) / length)"},
        {"lab-room",
         {"near=1", "far=1", "depth_format=ndc_32", "depth_test=linear_z"},
         "depth",
         "far · ((z − near) / length) / z"},
    };
    for (const auto& [name, assignments, id, expression] : exceptions) {
        CAPTURE(name, id);
        const Scene scene = test::lesson_scene(name);
        Settings settings = default_settings(scene);
        for (const char* const assignment : assignments)
            set_from_text(settings, assignment);
        const Frame frame = prepare_frame(scene, settings);
        bool is_found = false;
        test::Recorder recorder;
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        draw(frame, {}, framebuffer, &recorder);
        // In the row through the lamp's mirror image, and a few in each other row.
        for (const FragmentEvent& event : recorder.fragments) {
            if (event.fragment.row != 120 && event.fragment.column % 40 != 0) continue;
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            REQUIRE(report);
            const VertexReport vertex = vertex_report(frame, event.cursor.triangle, 0);
            for (const std::vector<Formula>* const formulas :
                 {&report->formulas, &vertex.formulas}) {
                const Formula* const formula = find_formula(*formulas, id);
                if (formula == nullptr || formula->expression != expression) continue;
                test::check_formulas(frame, *formulas, to_text(event.cursor));
                is_found = true;
            }
            if (is_found) break;
        }
        CHECK(is_found);
    }
}

TEST_CASE("If there is no highlight its formulas say why, whatever function is in force") {
    const Scene scene = test::lesson_scene("lab-room");
    Settings settings = default_settings(scene);
    settings.light.model = LightModel::blinn_phong;
    settings.light.position = scene.corner(0, 0).position;
    const auto reason = [&](HighlightRule rule, int vertex) {
        settings.light_rules.highlight = rule;
        const VertexReport report = vertex_report(prepare_frame(scene, settings), 0, vertex);
        const Formula* const formula = find_formula(report.formulas, "light.n_dot_h");
        REQUIRE(formula != nullptr);
        return formula->help;
    };
    const std::string no_direction = "There is no direction to the lamp or to the eye, so there is "
                                     "no highlight.";
    CHECK(reason(HighlightRule::right, 0) == no_direction);
    CHECK(reason(HighlightRule::unasked, 0) == no_direction);
    // Light along the wall does not fall on it.
    CHECK(reason(HighlightRule::right, 1) ==
          "The lamp is behind the surface (n · l is not above 0), so there is no highlight.");
}

} // namespace every_formula_tests
} // namespace
