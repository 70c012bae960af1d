#include "explain/formula.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "explain/vertex_report.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/formula_checks.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using rasterwalk::test::same_bits;

namespace {

Formula formula(std::string expression, std::vector<FormulaInput> inputs = {}) {
    return {"tried", "tried", "", std::move(expression), std::move(inputs), {}};
}

FormulaInput input(std::string symbol, float value) {
    return {std::move(symbol), {value}, from_words("the test")};
}

} // namespace

TEST_CASE("An expression is read as C++ reads it") {
    CHECK(evaluate(formula("1 + 2 · 3")) == 7.0f);
    CHECK(evaluate(formula("(1 + 2) · 3")) == 9.0f);
    CHECK(evaluate(formula("8 / 4 / 2")) == 1.0f);
    CHECK(evaluate(formula("8 − 4 − 2")) == 2.0f);
    CHECK(evaluate(formula("−3²")) == -9.0f);
    CHECK(evaluate(formula("(−3)²")) == 9.0f);
    CHECK(evaluate(formula("−a + b²", {input("a", 2.0f), input("b", 3.0f)})) == 7.0f);
    CHECK(evaluate(formula("clamp(a, 0, 1)", {input("a", 1.5f)})) == 1.0f);
    CHECK(evaluate(formula("clamp(a, 0, 1)", {input("a", -1.5f)})) == 0.0f);
    CHECK(evaluate(formula("min(2, max(0, 1)) + abs(−4) + sqrt(9)")) == 8.0f);
}

TEST_CASE("A sum is made in float, in the order in which it is written") {
    const std::vector<FormulaInput> inputs{input("big", 16777216.0f), input("one", 1.0f)};
    CHECK(evaluate(formula("big + one + one", inputs)) == 16777216.0f);
    CHECK(evaluate(formula("one + one + big", inputs)) == 16777218.0f);
}

TEST_CASE("Int cuts toward zero, floor downward, and round takes halves upward") {
    const std::vector<FormulaInput> inputs{input("a", -2.5f)};
    CHECK(evaluate(formula("int(a)", inputs)) == -2.0f);
    CHECK(evaluate(formula("floor(a)", inputs)) == -3.0f);
    CHECK(evaluate(formula("round(a)", inputs)) == -2.0f);
}

TEST_CASE("Accumulate adds its step as often as it says, with every rounding error") {
    float sum = 0.0f;
    for (int i = 0; i < 1000; ++i)
        sum += 0.1f;
    CHECK(sum != 0.1f * 1000.0f);
    CHECK(evaluate(formula("accumulate(0, a, 1000)", {input("a", 0.1f)})) == sum);
}

TEST_CASE("A formula's help explains the functions used in it") {
    using Catch::Matchers::ContainsSubstring;
    CHECK_THAT(
        function_help("accumulate(left, (right − left) / (n − 1), i)"),
        ContainsSubstring("accumulate(start, step, n): starts with start and adds step n times"));
    CHECK_THAT(function_help("max(0, a · b)"),
               ContainsSubstring("max(0, x)") && !ContainsSubstring("\n"));
    CHECK_THAT(function_help("int(clamp(x, 0, 1))"),
               ContainsSubstring("int(x): ") && ContainsSubstring("\nclamp("));
    CHECK(function_help("f · x / z").empty());
}

TEST_CASE("The maximum of 0 and NaN is 0, as in the light") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(evaluate(formula("max(0, a)", {input("a", nan)})) == 0.0f);
}

TEST_CASE("A symbol can contain any characters, and the longest match counts") {
    const std::vector<FormulaInput> inputs{input("z", 4.0f),     input("1/z", 3.0f),
                                           input("(x/z)", 6.0f), input("W/2", 250.0f),
                                           input("r.x", 5.0f),   input("r²", 7.0f)};
    CHECK(evaluate(formula("1/z", inputs)) == 3.0f);
    CHECK(evaluate(formula("1 / z", inputs)) == 0.25f);
    CHECK(evaluate(formula("(x/z) / 1/z", inputs)) == 2.0f);
    CHECK(evaluate(formula("int(z) + W/2", inputs)) == 254.0f);
    CHECK(evaluate(formula("r.x² + r²", inputs)) == 32.0f);
}

TEST_CASE("An expression that cannot be read is refused") {
    for (const char* text :
         {"", "1 +", "(1", "1)", "a", "1 2", "sin()", "sin(1, 2)", "shout(1)", "1 % 2", "int 3"}) {
        INFO("'" << text << "'");
        CHECK_THROWS_AS(evaluate(formula(text)), std::invalid_argument);
    }
}

TEST_CASE("A formula that is nested too deep or too long is refused") {
    const std::string deep = std::string(100, '(') + "1" + std::string(100, ')');
    CHECK_THROWS_WITH(evaluate(formula(deep)),
                      Catch::Matchers::ContainsSubstring("nested deeper than 32 levels"));
    CHECK_THROWS_WITH(evaluate(formula(std::string(1001, '1'))),
                      Catch::Matchers::ContainsSubstring("at most 1000 bytes"));
}

TEST_CASE("A sum in parentheses is one term, and a call in parentheses is evaluated") {
    const std::vector<FormulaInput> inputs{input("a", 1.5f), input("b", 2.0f)};
    CHECK(with_terms(formula("(a + b) + int(a)", inputs)) == "3.5 + int(1.5)");
    CHECK(with_terms(formula("a − (a + b)", inputs)) == "1.5 − 3.5");
    CHECK(with_terms(formula("(int(a)) + b", inputs)) == "1 + 2");
    CHECK(with_terms(formula("a − int(a)² − −b", inputs)) == "1.5 − 1 − (−2)");
}

TEST_CASE("Numbers take the place of symbols, negative ones in parentheses after a sign") {
    const std::vector<FormulaInput> inputs{input("f", 500.0f), input("x", -1.0f),
                                           input("1/z", 0.4998f)};
    Formula pixel = formula("int(f · x · 1/z) + W/2", inputs);
    pixel.inputs.push_back({"W/2", {250.0f, true}, from_setting("viewport.size")});
    CHECK(with_numbers(pixel) == "int(500 · (−1) · 0.4998) + 250");
    CHECK(with_terms(pixel) == "int(−249.9) + 250");
    CHECK(with_numbers(formula("x − x²", inputs)) == "−1 − (−1)²");
    CHECK(with_numbers(formula("x² + x²", inputs)) == "(−1)² + (−1)²");
    CHECK(with_numbers(formula("a² + a", {input("a", 1.25e-7f)})) == "(1.25e−07)² + 1.25e−07");
    CHECK(with_terms(formula("f · x", inputs)).empty());
    CHECK(with_terms(formula("x − f · x", inputs)) == "−1 − (−500)");
}

TEST_CASE("The pieces of a formula say which number belongs to which input") {
    const Formula f = formula("L − p", {input("L", 0.5f), input("p", -0.25f)});
    const std::vector<FormulaPiece> pieces = pieces_with_numbers(f);
    std::vector<std::string> linked;
    for (const FormulaPiece& piece : pieces) {
        if (piece.input >= 0) linked.push_back(f.inputs[piece.input].symbol + "=" + piece.text);
    }
    CHECK(linked == std::vector<std::string>{"L=0.5", "p=(−0.25)"});
}

TEST_CASE("Numbers are shown with at least four digits and a true minus sign") {
    CHECK(shown({0.0f}) == "0");
    CHECK(shown({-0.0f}) == "0");
    CHECK(shown({500.0f}) == "500");
    CHECK(shown({-12.0f, true}) == "−12");
    CHECK(shown({0.45862f}) == "0.4586");
    CHECK(shown({2.1807f}) == "2.181");
    CHECK(shown({0.15f}) == "0.15");
    CHECK(shown({-1.1f}) == "−1.1");
    CHECK(shown({-0.0123456f}) == "−0.01235");
    CHECK(shown({0.000123456f}) == "1.23e−04");
    CHECK(shown({std::numeric_limits<float>::infinity()}) == "+∞");
    CHECK(shown({std::nanf("")}) == "not a number");
}

TEST_CASE("Every number of every vertex of the room follows from what its formula shows") {
    const Scene room = test::lab_room();
    for (const test::Variant& variant : test::some_of(test::rule_variants(), 12)) {
        for (const test::Pose& pose : test::some_of(test::room_poses(), 2)) {
            Settings settings = default_settings(room);
            variant.apply(settings);
            settings.camera = pose.camera;
            settings.viewport = pose.viewport;
            const Frame frame = prepare_frame(room, settings);
            for (int t = 0; t < frame.triangle_count(); ++t) {
                for (int v = 0; v < 3; ++v) {
                    const VertexReport report = vertex_report(frame, t, v);
                    test::check_formulas(frame, report.formulas,
                                         variant.name + ", " + pose.name + ", t" +
                                             std::to_string(t) + "/v" + std::to_string(v));
                    if (report.shaded.rejection != Rejection::none) continue;
                    // If a plane cuts, different corners are drawn.
                    const ScreenVertex& drawn =
                        frame.is_cut(t) ? frame.given_vertex(t, v).pixel
                                        : frame.triangle_vertices(t)[static_cast<std::size_t>(v)];
                    const auto shows = [&](const char* id, float number) {
                        const Formula* const f = find_formula(report.formulas, id);
                        return f != nullptr && same_bits(f->result.value, number);
                    };
                    const bool same = shows("pixel.column", static_cast<float>(drawn.column)) &&
                                      shows("pixel.row", static_cast<float>(drawn.row)) &&
                                      shows("zinv", drawn.inv_w);
                    // Except in perspective z is not a coordinate of clip space, but computed
                    // again.
                    const float z = report.shaded.in("rotated").z;
                    // A program that divides by the distance carries that on instead of z.
                    const bool has_z = divided_by_rule(settings) == DividedBy::z;
                    const bool same_z = !has_z || (settings.projection_mix == 0.0f
                                                       ? shows("rotated.z", drawn.z)
                                                       : drawn.z == Approx(z).epsilon(1e-4));
                    if (!same || !same_z)
                        FAIL(variant.name << ", " << pose.name << ": t" << t << "/v" << v
                                          << " is not the vertex that is drawn");
                }
            }
        }
    }
}

TEST_CASE("The light that a vertex reports is the light that it carries") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::vertex_light);
    settings.interpolation = Interpolation::affine;
    const Frame frame = prepare_frame(room, settings);
    for (int t = 0; t < frame.triangle_count(); ++t) {
        for (int v = 0; v < 3; ++v) {
            const VertexReport report = vertex_report(frame, t, v);
            const glm::vec3& carried =
                frame.triangle_vertices(t)[static_cast<std::size_t>(v)].varyings.illumination;
            if (!same_bits(report.light.reflected, carried)) {
                FAIL("t" << t << "/v" << v << " reports different light from what it carries");
            }
            CHECK(find_formula(report.formulas, "light.R.green")->result.value == carried.g);
        }
    }
}

TEST_CASE("Other roundings and the other convention are reported as they would be drawn") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    settings.camera.yaw = 0.3f;
    settings.camera.pitch = -0.2f;
    const Frame frame = prepare_frame(room, settings);
    int changed = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const VertexReport report = vertex_report(frame, t, 0);
        for (const Rounding rounding : {Rounding::truncate, Rounding::floor, Rounding::round}) {
            Settings other = settings;
            set_rounding(other, rounding);
            const Frame drawn = prepare_frame(room, other);
            const ScreenVertex& pixel = drawn.triangle_vertices(t)[0];
            const ShadedVertex& shaded = report.by_rounding[static_cast<std::size_t>(rounding)];
            CHECK(shaded.pixel.column == pixel.column);
            CHECK(vertex_number(shaded, "pixel.row").value == static_cast<float>(pixel.row));
        }
        // R v by hand, with R's columns taken as its rows.
        const glm::mat3 r = camera_rotation(settings.camera);
        const glm::vec3 d = report.shaded.in("minus_camera");
        const float x = r[0][0] * d.x + r[1][0] * d.y + r[2][0] * d.z;
        CHECK(vertex_number(report.transposed, "rotated.x").value == Approx(x).margin(1e-6));
        changed += vertex_number(report.transposed, "rotated.x").value !=
                           vertex_number(report.shaded, "rotated.x").value
                       ? 1
                       : 0;
    }
    CHECK(changed > 0);
}

TEST_CASE("Every setting that a vertex names as a source exists and every vertex value too") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    int settings_named = 0;
    for (const Formula& f : vertex_report(frame, 3, 1).formulas) {
        for (const FormulaInput& i : f.inputs) {
            if (i.source.kind != SourceKind::setting) continue;
            INFO(f.id << " names " << i.source.name);
            CHECK(find_setting(i.source.name) != nullptr);
            ++settings_named;
        }
    }
    CHECK(settings_named > 10);
}
