#include "explain/along_row.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/test_formulas.h"
#include "inspect/pixel_tests.h"

namespace rasterwalk {

std::string column_words(int step) {
    return element_name(fragment_form, step) + " of the row, from its left end";
}

EndPart part_of_ends(Quantity quantity) {
    return [quantity](const RowEnd& end) { return part_of(end.varyings, quantity); };
}

namespace {

/// For pixels found by edge functions: the corners whose weighted values make the fragment.
struct WeighedCorners {
    const TestedPolygon& polygon;
    const TestedTriangle& triangle;

    WeighedCorners(const FragmentReport& report, Interpolation way)
        : polygon(report.row.tested[static_cast<std::size_t>(way)]),
          triangle(triangle_of_pixel(polygon, report.pixel.x, report.pixel.y)) {}

    /// The number of a corner of the drawn polygon, and its values.
    int number(std::size_t i) const { return triangle.corners[i]; }
    const RowEnd& corner(std::size_t i) const {
        return polygon.corners[static_cast<std::size_t>(number(i))];
    }
    EdgeValues values(const FragmentReport& report) const {
        return triangle.values_at({pixel_centre(report.pixel.x), pixel_centre(report.pixel.y)});
    }
    Source source(std::size_t i) const {
        return from_words(fmt::format("corner {} of the polygon that is drawn", number(i)));
    }
};

std::string weight_id(std::size_t i) {
    return fmt::format("weight.{}", i);
}

} // namespace

void add_weights(FragmentReport& report, WeightEdge made_of) {
    if (!report.row.is_weighted()) return;
    const WeighedCorners corners(report, Interpolation::perspective);
    const EdgeValues e = corners.values(report);
    const Stages& stages = report.row.stages.front();
    const Weights weights = stages.weights(e, corners.triangle.area);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::size_t edge = edge_of_weight(i, made_of);
        report.formulas.push_back(
            {weight_id(i),
             fmt::format("b{}", i),
             fmt::format(
                 "The weight of corner {} is the edge function of {} as a fraction of the sum of "
                 "all three.",
                 corners.number(i),
                 made_of == WeightEdge::own ? "the edge that starts at it (a mistake)"
                                            : "the opposite edge"),
             "E / A",
             {{"E",
               {static_cast<float>(in_square_pixels(e[edge]))},
               from_words(fmt::format("edge function of {} at the pixel's centre, in square pixels",
                                      tested_edge_name(corners.triangle.edges[edge].number)))},
              {"A",
               {static_cast<float>(in_square_pixels(corners.triangle.area))},
               from_words("the sum of all three, twice the area")}},
             {weights[i]}});
    }
}

namespace {

constexpr std::array<const char*, edge_function_count> corner_symbols{"p", "q", "r"};

/// How a value is mixed from the corners' values.
/// @param is_twice the corners' values are multiplied by their 1/z a second time
Formula by_weights(const FragmentReport& report, Formula formula, Interpolation way,
                   const EndPart& part, bool is_twice) {
    const WeighedCorners corners(report, way);
    formula.inputs.clear();
    formula.expression.clear();
    for (std::size_t i = 0; i < corner_symbols.size(); ++i) {
        const std::string symbol = corner_symbols[i], weight = fmt::format("b{}", i);
        formula.expression += i > 0 ? " + " : "";
        formula.expression += symbol;
        formula.inputs.push_back({symbol, {part(corners.corner(i))}, corners.source(i)});
        if (is_twice) {
            formula.expression += " · z" + symbol;
            formula.inputs.push_back({"z" + symbol, {corners.corner(i).inv_w}, corners.source(i)});
        }
        formula.expression += " · " + weight;
        formula.inputs.push_back({weight,
                                  {find_formula(report.formulas, weight_id(i))->result.value},
                                  from_formula(weight_id(i))});
    }
    return formula;
}

} // namespace

namespace {

/// Does a row carry it for the depth and for the weight of varyings?
bool is_depth(std::string_view id) {
    return id == "zinv" || id == "depth.carried";
}

} // namespace

Formula along_row(const FragmentReport& report, std::string id, std::string name, std::string help,
                  Interpolation way, const EndPart& part, float result) {
    const CarriedRow& row = report.row;
    const RowEnds& ends = row.under(way);
    Formula formula{
        std::move(id),
        std::move(name),
        std::move(help),
        "",
        {{"left", {part(ends.left)}, from_row_end(row.triangle, row.row, false)},
         {"right", {part(ends.right)}, from_row_end(row.triangle, row.row, true)},
         {"n",
          {static_cast<float>(row.count), true},
          from_words("pixels of the row, both ends included")},
         {"i", {static_cast<float>(report.step), true}, from_words(column_words(report.step))}},
        {result}};
    if (row.is_weighted()) return by_weights(report, std::move(formula), way, part, false);
    switch (row.walk) {
    case LineWalk::accumulate:
    case LineWalk::integer_step: // only the position's step is truncated, and along a row it is 1
    case LineWalk::zinv_falls:   // only the values that go with 1/z fall
        formula.expression = "accumulate(left, (right − left) / (n − 1), i)";
        if (row.walk == LineWalk::zinv_falls && is_depth(formula.id))
            formula.expression = "accumulate(left, (left − right) / (n − 1), i)";
        break;
    case LineWalk::short_step:
        formula.expression = "accumulate(left, (right − left) / n, i)";
        break;
    case LineWalk::multiply:
        formula.expression = "left + i · ((right − left) / (n − 1))";
        break;
    case LineWalk::exact:
        formula.expression = "left · (1 − i / (n − 1)) + right · (i / (n − 1))";
        break;
    }
    // The first sample is the left end itself, however the row is walked.
    if (report.step == 0) {
        formula.expression = "left";
        formula.inputs.resize(1);
    }
    return formula;
}

Formula along_row_twice(const FragmentReport& report, Formula formula, const EndPart& part) {
    const CarriedRow& row = report.row;
    constexpr Interpolation way = Interpolation::zinv_twice;
    if (row.is_weighted()) return by_weights(report, std::move(formula), way, part, true);
    const RowEnds& ends = row.under(way);
    formula.inputs.push_back({"zl", {ends.left.inv_w}, from_row_end(row.triangle, row.row, false)});
    if (report.step > 0) {
        formula.inputs.push_back(
            {"zr", {ends.right.inv_w}, from_row_end(row.triangle, row.row, true)});
    }
    const auto put = [&](std::string_view word, std::string_view by) {
        for (std::size_t at = 0; (at = formula.expression.find(word, at)) != std::string::npos;
             at += by.size())
            formula.expression.replace(at, word.size(), by);
    };
    put("left", "left · zl");
    put("right", "right · zr");
    return formula;
}

} // namespace rasterwalk
