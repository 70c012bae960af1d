#include <algorithm>
#include <cmath>

#include "explain/fragment_report.h"
#include "explain/vertex_report.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/formula_checks.h"
#include "support/recorder.h"
#include "support/small_cylinder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::same_bits;

namespace {

/// The cylinder of the lessons in a small picture, whose wall has two colours.
Scene coloured_cylinder() {
    const Scene scene = test::small_cylinder({60, 56}, 75.0f);
    Scene coloured = scene;
    coloured.mesh = {};
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        for (Vertex& corner : corners) {
            if (corner.position.y > 0.0f) corner.reflectance = {0.9f, 0.2f, 0.3f};
        }
        coloured.mesh.add_triangle_of(corners);
    }
    return coloured;
}

float shown_by(const std::vector<Formula>& formulas, const std::string& id) {
    const Formula* const formula = find_formula(formulas, id);
    if (formula == nullptr) FAIL("no formula " << id);
    return formula->result.value;
}

/// The brightest fragment of a frame, which has the highlight, and two others.
std::vector<FragmentEvent> some_fragments(const Frame& frame) {
    test::Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    const std::vector<FragmentEvent>& all = recorder.fragments;
    const auto brightest = std::max_element(
        all.begin(), all.end(),
        [](const FragmentEvent& a, const FragmentEvent& b) { return a.after.g < b.after.g; });
    return {*brightest, all[all.size() / 3], all[2 * all.size() / 3]};
}

/// The id of the light in force, by its prefix and channel.
std::string id_of_light(const Frame& frame, const FragmentReport& report, int channel) {
    constexpr std::array<const char*, 3> names{"red", "green", "blue"};
    const std::string name = names[static_cast<std::size_t>(channel)];
    switch (report.shading) {
    case Shading::unlit:
        return "flat.colour." + name;
    case Shading::flat:
        return "triangle_light.R." + name;
    case Shading::gouraud:
        return formula_id(quantity_of(&Varyings::illumination, channel),
                          frame.settings.interpolation);
    case Shading::phong:
        break;
    }
    return "pixel_light.R." + name;
}

} // namespace

TEST_CASE("Every term of a shiny, bent, coloured surface is shown with its formula") {
    const Scene scene = coloured_cylinder();
    int reported = 0, shining = 0;
    for (const char* shading : {"stage=fill", "shading=flat", "shading=gouraud", "shading=phong"}) {
        for (const char* rule :
             {"light.model=lambert", "light.falloff=linear", "light.falloff=none",
              "light.place=camera", "light.highlight=long_half", "light.highlight=unasked",
              "light.renormalize=off", "normal_w=one", "interpolation=affine", "projection_mix=0.4",
              "projection=orthographic", "light.sides=two"}) {
            Settings settings = default_settings(scene);
            for (const char* assignment : {"cull=face_normal", shading, rule})
                set_from_text(settings, assignment);
            const Frame frame = prepare_frame(scene, settings);
            for (const FragmentEvent& event : some_fragments(frame)) {
                const std::string where =
                    std::string(shading) + ", " + rule + ", " + to_text(event.cursor) + ": ";
                const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
                if (!report) FAIL(where << "has no report");
                test::check_formulas(frame, report->formulas, where);
                for (int c = 0; c < 3; ++c) {
                    const float shown = shown_by(report->formulas, id_of_light(frame, *report, c));
                    if (!same_bits(shown, report->colour[c]))
                        FAIL(where << "channel " << c << " shows " << shown << ", the shader gives "
                                   << report->colour[c]);
                    if (event.fate == Fate::written && !same_bits(shown, event.after[c]))
                        FAIL(where << "channel " << c << " shows " << shown << ", drawn is "
                                   << event.after[c]);
                }
                ++reported;
                shining += report->light.highlight.power > 0.1f ? 1 : 0;
            }
        }
    }
    CHECK(reported == 4 * 12 * 3);
    CHECK(shining > 5);
}

TEST_CASE(
    "Where both sides are lit, a back shows that its normal is flipped, a front that it is not") {
    const Scene scene = coloured_cylinder();
    int turned = 0, kept = 0;
    for (const char* shading : {"shading=flat", "shading=gouraud", "shading=phong"}) {
        Settings settings = default_settings(scene);
        for (const char* assignment : {"cull=none", "light.sides=two", shading})
            set_from_text(settings, assignment);
        const Frame frame = prepare_frame(scene, settings);
        test::Recorder recorder;
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        draw(frame, {}, framebuffer, &recorder);
        for (std::size_t i = 0; i < recorder.fragments.size(); i += 97) {
            const FragmentEvent& event = recorder.fragments[i];
            const std::string where = std::string(shading) + ", " + to_text(event.cursor) + ": ";
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            if (!report) FAIL(where << "has no report");
            test::check_formulas(frame, report->formulas, where);
            for (int c = 0; c < 3; ++c) {
                if (!same_bits(shown_by(report->formulas, id_of_light(frame, *report, c)),
                               report->colour[c]))
                    FAIL(where << "channel " << c << " shows a different colour from the shader's");
            }
            const glm::vec3 to_eye =
                settings.camera.position - report->under(settings.interpolation).position_world;
            CHECK(glm::dot(report->normal, to_eye) >= 0.0f);
            ++(shown_by(report->formulas, "pixel_light.side") < 0.0f ? turned : kept);
        }
    }
    CHECK(turned > 5);
    CHECK(kept > 5);
}

TEST_CASE("A vertex shows its highlight, and light per vertex includes it") {
    const Scene scene = coloured_cylinder();
    Settings settings = default_settings(scene);
    set_from_text(settings, "shading=gouraud");
    set_from_text(settings, "light.position=0.9,-1.5,-3"); // the highlight near a corner
    const Frame frame = prepare_frame(scene, settings);
    float brightest = 0.0f;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        for (int v = 0; v < triangle_corners; ++v) {
            const VertexReport report = vertex_report(frame, t, v);
            const std::string where = "triangle " + std::to_string(t) + ": ";
            test::check_formulas(frame, report.formulas, where);
            const glm::vec3 carried = frame.given_clip_vertex(t, v).varyings.illumination;
            if (!same_bits(shown_by(report.formulas, "light.R.green"), carried.g))
                FAIL(where << "shows a different light from the one it carries, " << carried.g);
            brightest = std::max(brightest, shown_by(report.formulas, "light.S.green"));
        }
    }
    CHECK(brightest > 0.01f);
}

TEST_CASE(
    "Halfway between normals 60 degrees apart the length is 0.866, whose 50th power is 0.00075") {
    // Two corners with normals 30 degrees to either side; lamp and eye straight in front.
    const Scene scene = parse_scene(R"(
name = "Two normals"
stage = "pixel_light"
[viewport]
width = 41
height = 41
[camera]
position = [0, 0, -4]
focal_length = 60
[light]
position = [0, 0, -4]
power = 10
model = "blinn_phong"
[points.p]
A = [-1, 0, 0]
B = [0, -1, 0]
C = [1, 0, 0]
D = [0, 1, 0]
[normals.p]
A = [-0.5, 0, -0.8660254]
B = [0.5, 0, -0.8660254]
C = [0.5, 0, -0.8660254]
D = [-0.5, 0, -0.8660254]
[materials.m]
diffuse = 0.2
specular = 1
exponent = 50
[[part]]
name = "half"
points = "p"
material = "m"
normals = "p"
triangles = ["A C D", "A B C"]
)",
                                    "two.toml");
    Settings settings = default_settings(scene);
    for (const char* coverage : {"coverage=edge_functions", "snap=subpixel"})
        set_from_text(settings, coverage);
    for (const bool is_mistaken : {false, true}) {
        settings.light_rules.renormalize = is_mistaken ? Renormalize::off : Renormalize::on;
        const Frame frame = prepare_frame(scene, settings);
        const std::optional<Cursor> at = fragment_on_pixel(frame, {20, 20}, cursor_end);
        REQUIRE(at);
        const std::optional<FragmentReport> report = fragment_report(frame, *at);
        REQUIRE(report);
        CHECK(shown_by(report->formulas, "pixel_light.n_length") ==
              Approx(std::sqrt(0.75)).margin(2e-3));
        CHECK(shown_by(report->formulas, "pixel_light.n_dot_h") ==
              Approx(is_mistaken ? std::sqrt(0.75) : 1.0).margin(2e-3));
        CHECK(shown_by(report->formulas, "pixel_light.power") ==
              Approx(is_mistaken ? 0.00075 : 1.0).margin(is_mistaken ? 1e-4 : 0.02));
    }
}
