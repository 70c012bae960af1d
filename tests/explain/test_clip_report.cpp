#include "explain/clip_report.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "explain/cull_formulas.h"
#include "explain/vertex_report.h"
#include "settings/setting_table.h"
#include "support/clipped_room.h"
#include "support/effort.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("Every number of clipping follows from its formula, bit for bit") {
    const Scene room = lab_room();
    Random random(19);
    int count = 0;
    const auto check = [&](const Frame& frame, const ClipHistory& history, const std::string& id,
                           float value) {
        const auto formula = clip_formula(frame, history, id);
        CAPTURE(id);
        REQUIRE(formula);
        CHECK(formula->id == id);
        CHECK(formula->result.value == value);
        CHECK(evaluate(*formula) == value);
        CHECK(formula->expression != "v");
        ++count;
    };
    for (int i = 0; i < rounds(12, 4); ++i) {
        const Frame frame = room_frame(room, random, i % 3 == 2 ? Clip::guard_band : Clip::all);
        const VertexRules rules = vertex_rules(frame.settings, room.space);
        for (int t = 0; t < frame.triangle_count(); t += 5) {
            const ClipHistory history = clip_history(frame, t);
            CAPTURE(i, t);
            for (int v = 0; v < 3; ++v) {
                const glm::vec4& clip = history.corners[static_cast<std::size_t>(v)].position_clip;
                check(frame, history, "corner." + std::to_string(v) + ".x", clip.x);
                check(frame, history, "corner." + std::to_string(v) + ".y", clip.y);
                for (std::size_t p = 0; p < history.codes.plane_count; ++p) {
                    check(frame, history, "code." + std::to_string(p) + "." + std::to_string(v),
                          inner_distance(history.codes.planes[p],
                                         history.corners[static_cast<std::size_t>(v)]));
                }
            }
            for (std::size_t p = 0; p < history.planes.size(); ++p) {
                const std::string plane =
                    std::to_string(static_cast<int>(history.planes[p].plane)) + ".";
                for (const ClipStep& step : history.planes[p].steps) {
                    check(frame, history, "d." + plane + std::to_string(step.from), step.d_from);
                    if (!step.is_cut) continue;
                    check(frame, history, "t." + plane + std::to_string(step.from), step.t);
                    const auto made = corner_made(history, static_cast<int>(p), step.from);
                    REQUIRE(made);
                    for (int k = 0; k < 4; ++k)
                        check(frame, history, corner_formula_id(*made, k),
                              step.cut.position_clip[k]);
                    const std::string made_id = "new." + std::to_string(made->new_index);
                    for (int v = 0; v < varying_count; ++v) {
                        const VaryingInfo& info = varying_list[static_cast<std::size_t>(v)];
                        for (int k = 0; k < info.count; ++k)
                            check(frame, history,
                                  made_id + "." + std::to_string(v) + "." + std::to_string(k),
                                  info.component(step.cut.varyings, k));
                    }
                }
            }
            if (history.polygon.empty()) continue;
            check(frame, history, "cull.normal",
                  away_from_camera(history.polygon[0].varyings, sight_rays(rules)));
            check(frame, history, "cull.area", screen_area_sign(history.polygon, rules));
            if (!frame.is_drawn(t)) continue;
            const auto pixels = frame.triangle_vertices(t);
            for (std::size_t c = 0; c < pixels.size(); ++c) {
                const std::string id = "pixel." + std::to_string(c);
                check(frame, history, id + ".column", static_cast<float>(pixels[c].column));
                check(frame, history, id + ".row", static_cast<float>(pixels[c].row));
            }
        }
    }
    CHECK(count > 500);
}

TEST_CASE("If division comes before cutting, the formulas go back to the vertices") {
    const Scene room = lab_room();
    Random random(21);
    int count = 0, changed = 0, left = 0;
    for (int i = 0; i < rounds(12, 4); ++i) {
        const Frame frame = room_frame(room, random, Clip::after_division);
        for (int t = 0; t < frame.triangle_count(); t += 3) {
            const ClipHistory history = clip_history(frame, t);
            // Each number in a formula is the result of the formula it refers to.
            const auto check = [&](const std::string& id, float value) {
                const auto formula = clip_formula(frame, history, id);
                CAPTURE(i, t, id);
                REQUIRE(formula);
                CHECK(formula->result.value == value);
                CHECK(evaluate(*formula) == value);
                CHECK(formula->expression != "v");
                for (const FormulaInput& input : formula->inputs) {
                    if (input.source.kind != SourceKind::formula) continue;
                    const auto of = clip_formula(frame, history, input.source.name);
                    CAPTURE(input.source.name);
                    REQUIRE(of);
                    CHECK(of->result.value == input.number.value);
                }
                ++count;
            };
            for (std::size_t p = 0; p < history.planes.size(); ++p) {
                const PlaneHistory& work = history.planes[p];
                const std::string plane = std::to_string(static_cast<int>(work.plane)) + ".";
                const auto before = corners_before(history, static_cast<int>(p));
                REQUIRE(before.size() == work.before.size());
                for (std::size_t c = 0; c < before.size(); ++c) {
                    CHECK(before[c].vertex.position_clip == work.before[c].position_clip);
                    for (int k = 0; k < 4; ++k)
                        check(corner_formula_id(before[c], k), work.before[c].position_clip[k]);
                    changed += before[c].place == CornerPlace::changed ? 1 : 0;
                }
                for (const ClipStep& step : work.steps) {
                    check("d." + plane + std::to_string(step.from), step.d_from);
                    if (step.is_cut) check("t." + plane + std::to_string(step.from), step.t);
                }
            }
            if (history.planes.empty() || history.polygon.empty()) continue;
            const auto rest = corners_before(history);
            REQUIRE(rest.size() == history.polygon.size());
            for (std::size_t c = 0; c < rest.size(); ++c) {
                CHECK(rest[c].vertex.position_clip == history.polygon[c].position_clip);
                for (const int k : {0, 1, 3})
                    check(corner_formula_id(rest[c], k), history.polygon[c].position_clip[k]);
                left += rest[c].place == CornerPlace::handed_on ? 1 : 0;
            }
        }
    }
    CHECK(count > 500);
    CHECK(changed > 20);
    CHECK(left > 20);
}

TEST_CASE("Anything but a number of the triangle has no formula") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, near_clipped_room(room));
    const ClipHistory history = clip_history(frame, 1);
    for (const char* const id : {"",
                                 ".",
                                 "corner",
                                 "corner.3.x",
                                 "corner.0.q",
                                 "corner.-1.x",
                                 "code.1.0",
                                 "code.0.9",
                                 "d.6.0",
                                 "d.0.99",
                                 "t.0.0",
                                 "t.1.0",
                                 "new.9.x",
                                 "new.0.x.y",
                                 "new.0.99.0",
                                 "new.0.0.3",
                                 "new.0.0.0.0",
                                 "changed.0.x",
                                 "left.0.x",
                                 "pixel.9.column",
                                 "pixel.0.depth",
                                 "cull",
                                 "cull.area.9",
                                 "cull.normal.9",
                                 "cull.nothing",
                                 "t.99999999999.0"}) {
        CAPTURE(id);
        CHECK_FALSE(clip_formula(frame, history, id));
    }
}

TEST_CASE("With a box a corner's x and y are the vertex's, and no focal length is named") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    // As large as what f = 500 shows, so that f times x would be the same number.
    for (const char* set :
         {"transform=matrices", "clip=all", "near=1", "view_box=-0.5,0.5,-0.5,0.5"})
        set_from_text(settings, set);
    const Frame frame = prepare_frame(room, settings);
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const ClipHistory history = clip_history(frame, t);
        for (int v = 0; v < 3; ++v) {
            const VertexReport vertex = vertex_report(frame, t, v);
            for (int i = 0; i < 2; ++i) {
                const std::string axis = i == 0 ? "x" : "y";
                CAPTURE(t, v, axis);
                const auto formula =
                    clip_formula(frame, history, fmt::format("corner.{}.{}", v, axis));
                REQUIRE(formula);
                REQUIRE(formula->inputs.size() == 1);
                CHECK(formula->inputs[0].source.name == "clip." + axis);
                const Formula* const of = find_formula(vertex.formulas, "clip." + axis);
                REQUIRE(of != nullptr);
                CHECK(of->result.value == formula->result.value);
                CHECK(evaluate(*formula) == formula->result.value);
            }
        }
    }
}

TEST_CASE("The test for culling is written as each projection has it") {
    const Scene room = lab_room();
    struct {
        float mix;
        std::string measure, name;
    } const projections[] = {
        {0.0f, "dot(n, p - C)", "n · (p − C)"},
        {0.3f, "dot(n, (1 - mix) (p - C) + mix forward)", "n · ((1 − mix) (p − C) + mix forward)"},
        {1.0f, "dot(n, forward)", "n · forward"},
    };
    for (const auto& projection : projections) {
        Settings settings = default_settings(room);
        settings.projection_mix = projection.mix;
        settings.camera.yaw = 0.4f;
        settings.camera.pitch = -0.2f;
        for (const Cull way : {Cull::face_normal, Cull::vertex_normals}) {
            settings.cull = way;
            const Frame frame = prepare_frame(room, settings);
            for (int t = 0; t < frame.triangle_count(); ++t) {
                CAPTURE(projection.mix, t);
                const ClipHistory history = clip_history(frame, t);
                CHECK(history.cull.measure == projection.measure);
                REQUIRE_FALSE(history.polygon.empty());
                const auto formula = clip_formula(frame, history, "cull.normal");
                REQUIRE(formula);
                CHECK(formula->name == projection.name);
                CHECK(formula->expression != "v");
                CHECK(evaluate(*formula) == history.cull.values.front());
                // The direction to the corner becomes the direction of the camera.
                const Varyings& at = history.polygon.front().varyings;
                const double mix = projection.mix, yaw = 0.4, pitch = -0.2;
                const glm::dvec3 forward(std::cos(pitch) * std::sin(yaw), -std::sin(pitch),
                                         std::cos(pitch) * std::cos(yaw));
                const glm::dvec3 first_click_to =
                    glm::dvec3(at.position_world) - glm::dvec3(settings.camera.position);
                CHECK(
                    glm::dot(glm::dvec3(at.normal), (1.0 - mix) * first_click_to + mix * forward) ==
                    Approx(history.cull.values.front()).margin(1e-5));
                const VertexReport vertex = vertex_report(frame, t, 0);
                for (const FormulaInput& input : formula->inputs) {
                    if (input.symbol.find("forward") == std::string::npos) continue;
                    CAPTURE(input.symbol, input.source.name);
                    const Formula* const of = find_formula(vertex.formulas, input.source.name);
                    REQUIRE(of != nullptr);
                    CHECK(of->result.value == input.number.value);
                }
            }
        }
    }
}

TEST_CASE("Each way of culling says what it would do") {
    const Scene room = lab_room();
    Random random(20);
    int backs = 0;
    for (int i = 0; i < rounds(20, 6); ++i) {
        Frame frame = room_frame(room, random, Clip::all);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const std::vector<CullAnswer> answers = cull_answers(frame, clip_history(frame, t));
            for (const CullAnswer& answer : answers) {
                if (answer.rule == Cull::fragment_normal) continue; // it leaves out no triangle
                Settings settings = frame.settings;
                settings.cull = answer.rule;
                const Frame culled = prepare_frame(room, settings);
                CAPTURE(i, t, std::string(word_of(answer.rule)));
                CHECK((culled.rejection(t) == Rejection::back_facing) == answer.is_back);
                if (!answer.is_open && answer.rule != Cull::screen_area)
                    CHECK((answer.measure > 0.0f) == answer.is_back);
                if (!answer.is_open && answer.rule == Cull::screen_area)
                    CHECK((answer.measure < 0.0f) == answer.is_back);
                backs += answer.is_back ? 1 : 0;
            }
            if (!answers.empty()) t += 4; // some of them are enough
        }
    }
    CHECK(backs > 0);
}
