#include "explain/test_formulas.h"

#include <cmath>

#include "settings/choose_stages.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

ScreenVertex corner_at(double x, double y) {
    ScreenVertex vertex;
    vertex.position = {static_cast<float>(x), static_cast<float>(y)};
    vertex.column = static_cast<int>(std::floor(x));
    vertex.row = static_cast<int>(std::floor(y));
    vertex.inv_w = 1.0f;
    return vertex;
}

const Formula& formula_of(const std::vector<Formula>& all, const std::string& id) {
    const Formula* const found = find_formula(all, id);
    REQUIRE(found != nullptr);
    return *found;
}

} // namespace

TEST_CASE("The formulas of a tested pixel give the numbers of the stage") {
    Random random(21);
    for (int i = 0; i < rounds(600, 100); ++i) {
        Settings settings;
        settings.stage = Stage::fill;
        settings.coverage = Coverage::edge_functions;
        settings.weight_edge = i % 3 == 0 ? WeightEdge::own : WeightEdge::opposite;
        settings.pixel_sample = i % 5 == 0 ? PixelSample::corner : PixelSample::centre;
        settings.snap = i % 2 == 0 ? Snap::pixel : Snap::subpixel;
        const Stages stages = choose_stages(settings);
        std::vector<ScreenVertex> corners;
        for (int v = 0; v < 3; ++v)
            corners.push_back(corner_at(random.number(0.0, 40.0), random.number(0.0, 40.0)));
        TestedPolygon polygon;
        set_up_tests(corners, stages, polygon);
        const TestedTriangle& triangle = polygon.triangles.front();
        const int column = random.integer(0, 39), row = random.integer(0, 39);
        const PixelTest test = test_pixel(polygon, 0, column, row, stages);
        const std::vector<Formula> formulas =
            test_formulas(triangle, test, {"v0", "v1", "v2"}, settings);
        CAPTURE(i, column, row);
        float sum = 0.0f;
        for (int e = 0; e < 3; ++e) {
            const Formula& formula = formula_of(formulas, "e." + std::to_string(e));
            // On whole pixels floats hold every product; elsewhere the last digits are off.
            if (settings.snap == Snap::pixel)
                CHECK(evaluate(formula) == formula.result.value);
            else
                CHECK(evaluate(formula) == Approx(formula.result.value).margin(2e-3));
            // The second way: the area of edge and point from the corners themselves.
            const GridPoint a = stages.snap(corners[static_cast<std::size_t>(e)]);
            const GridPoint b = stages.snap(corners[static_cast<std::size_t>((e + 1) % 3)]);
            const double area = std::abs(static_cast<double>(
                                    double_area(a, b, {pixel_centre(column), pixel_centre(row)}))) /
                                65536.0;
            CHECK(std::abs(formula.result.value) == static_cast<float>(area));
            sum += formula.result.value;
            // The names give the two corners in the direction that the numbers go.
            const std::string way = formula.inputs[0].source.name;
            CHECK((formula.inputs[2].source.name.find("half a pixel") != std::string::npos) ==
                  (settings.pixel_sample == PixelSample::corner));
            const std::string from = "v" + std::to_string(e),
                              to = "v" + std::to_string((e + 1) % 3);
            const bool is_turned = !(triangle.edges[static_cast<std::size_t>(e)].from == a);
            if (triangle.area != 0)
                CHECK(way.find(is_turned ? "from " + to + " to " + from
                                         : "from " + from + " to " + to) != std::string::npos);
        }
        const Formula& area = formula_of(formulas, "area");
        CHECK(area.result.value == Approx(sum).margin(1e-3));
        if (triangle.area == 0) {
            CHECK(find_formula(formulas, "weight.0") == nullptr);
            continue;
        }
        for (int v = 0; v < 3; ++v) {
            const Formula& formula = formula_of(formulas, "weight." + std::to_string(v));
            CHECK(evaluate(formula) == test.weights[static_cast<std::size_t>(v)]);
            CHECK(formula.result.value == test.weights[static_cast<std::size_t>(v)]);
            CHECK(formula.name == "weight of v" + std::to_string(v));
        }
    }
}
