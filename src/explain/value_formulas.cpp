#include "explain/value_formulas.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/formula_writer.h"
#include "explain/test_formulas.h"
#include "inspect/pixel_tests.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// The value that the ends carry for a quantity: divided by z, if the row does that.
EndPart part_of_ends(Quantity quantity) {
    return [quantity](const RowEnd& end) { return part_of(end.varyings, quantity); };
}

FormulaInput column_in_row(const FragmentReport& report) {
    return {
        "i",
        {static_cast<float>(report.step), true},
        from_words(element_name(fragment_form, report.step) + " of the row, from its left end")};
}

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

/// How a value is mixed from the corners' values.
/// @param is_twice the corners' values are multiplied by their 1/z a second time
void set_by_weights(const FragmentReport& report, Formula& formula, Interpolation way,
                    const EndPart& part, bool is_twice) {
    constexpr std::array<const char*, edge_function_count> symbols{"p", "q", "r"};
    const WeighedCorners corners(report, way);
    formula.inputs.clear();
    formula.expression.clear();
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        const std::string symbol = symbols[i], weight = fmt::format("b{}", i);
        formula.expression += i > 0 ? " + " : "";
        formula.expression += symbol;
        formula.inputs.push_back({symbol, {part(corners.corner(i))}, corners.source(i)});
        if (is_twice) {
            formula.expression += " · z" + symbol;
            formula.inputs.push_back({"z" + symbol, {corners.corner(i).inv_w}, corners.source(i)});
        }
        formula.expression += " · " + weight;
        formula.inputs.push_back({weight, find_formula(report.formulas, weight_id(i))->result,
                                  from_formula(weight_id(i))});
    }
}

/// Does a row carry it for the depth and for the weight of varyings?
bool is_depth(std::string_view id) {
    return id == "zinv" || id == "depth.carried";
}

/// How a value gets from the left end of a row to a fragment.
/// @param left, right the ends as expressions
std::string walk_expression(const FragmentReport& report, std::string_view id,
                            std::string_view left, std::string_view right) {
    // The first sample is the left end itself, however the row is walked.
    if (report.step == 0) return std::string(left);
    switch (report.row.walk) {
    case LineWalk::accumulate:
    case LineWalk::integer_step: // only the position's step is truncated, and along a row it is 1
        break;
    case LineWalk::zinv_falls: // only the values that go with 1/z fall
        if (is_depth(id))
            return fmt::format("accumulate({0}, ({0} − {1}) / (n − 1), i)", left, right);
        break;
    case LineWalk::short_step:
        return fmt::format("accumulate({0}, ({1} − {0}) / n, i)", left, right);
    case LineWalk::multiply:
        return fmt::format("{0} + i · (({1} − {0}) / (n − 1))", left, right);
    case LineWalk::exact:
        return fmt::format("{0} · (1 − i / (n − 1)) + {1} · (i / (n − 1))", left, right);
    }
    return fmt::format("accumulate({0}, ({1} − {0}) / (n − 1), i)", left, right);
}

/// The same as along_row().
/// @param is_twice the row's ends are multiplied by 1/z a second time
Formula along_row_of_ends(const FragmentReport& report, std::string id, std::string_view name,
                          std::string_view help, Interpolation way, const EndPart& part,
                          float result, bool is_twice) {
    const CarriedRow& row = report.row;
    const RowEnds& ends = row.under(way);
    Formula formula{std::move(id), std::string(name), std::string(help), "", {}, {result}};
    if (row.is_weighted()) {
        set_by_weights(report, formula, way, part, is_twice);
        return formula;
    }
    const Source left = from_row_end(row.triangle, row.row, false),
                 right = from_row_end(row.triangle, row.row, true);
    formula.expression = walk_expression(report, formula.id, is_twice ? "left · zl" : "left",
                                         is_twice ? "right · zr" : "right");
    formula.inputs = {{"left", {part(ends.left)}, left}};
    const bool is_first = report.step == 0;
    if (!is_first) {
        formula.inputs.push_back({"right", {part(ends.right)}, right});
        formula.inputs.push_back({"n",
                                  {static_cast<float>(row.count), true},
                                  from_words("pixels of the row, both ends included")});
        formula.inputs.push_back(column_in_row(report));
    }
    if (is_twice) formula.inputs.push_back({"zl", {ends.left.inv_w}, left});
    if (is_twice && !is_first) formula.inputs.push_back({"zr", {ends.right.inv_w}, right});
    return formula;
}

using Carried = std::array<Fragment, interpolation_count>; ///< indexed by Interpolation

/// Makes the formulas of a fragment's values, in order.
class ValueFormulas {
  public:
    ValueFormulas(FragmentReport& report, const Frame& frame, const Carried& carried)
        : report_(report), frame_(frame), carried_(carried), write_(report.formulas),
          mix_(vertex_rules(frame.settings, frame.scene->space).projection.mix),
          w_(mix_ > 0.0f ? "w" : "z") {}

    void add_all() {
        if (report_.row.is_weighted()) add_weights();
        add_depths();
        for (const QuantityInfo& info : shown_quantities(frame_)) {
            if (is_varying(info.quantity)) add_varying(info);
        }
        for (Formula& formula : report_.formulas) {
            formula.section = "values";
            // Several have the same name.
            for (const std::string_view kind : {"affine", "perspective"}) {
                if (formula.id.ends_with(fmt::format(".{}", kind)))
                    formula.label = fmt::format("{} {}", formula.name, kind);
            }
        }
    }

  private:
    const Fragment& carried(Interpolation way) const {
        return carried_[static_cast<std::size_t>(way)];
    }
    /// What every value is divided by: "(1/z)", "(1/w)".
    FormulaInput weight() const { return write_.input("(1/" + w_ + ")", "zinv"); }

    void add_along_row(const std::string& id, std::string_view name, std::string_view help,
                       Interpolation way, const EndPart& part, float result) {
        report_.formulas.push_back(along_row(report_, id, name, help, way, part, result));
    }

    /// The weights of the three corners.
    void add_weights() {
        const WeightEdge made_of = weight_edge_rule(frame_.settings);
        const WeighedCorners corners(report_, Interpolation::perspective);
        const EdgeValues e = corners.values(report_);
        const Weights weights = report_.row.stages.front().weights(e, corners.triangle.area);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const std::size_t edge = edge_of_weight(i, made_of);
            write_.add(
                weight_id(i), fmt::format("b{}", i),
                fmt::format("The weight of corner {} is the edge function of {} as a fraction of "
                            "the sum of all three.",
                            corners.number(i),
                            made_of == WeightEdge::own ? "the edge that starts at it (a mistake)"
                                                       : "the opposite edge"),
                "E / A",
                {{"E",
                  {static_cast<float>(in_square_pixels(e[edge]))},
                  from_words(
                      fmt::format("edge function of {} at the pixel's centre, in square pixels",
                                  tested_edge_name(corners.triangle.edges[edge].number)))},
                 {"A",
                  {static_cast<float>(in_square_pixels(corners.triangle.area))},
                  from_words("the sum of all three, twice the area")}},
                {weights[i]});
        }
    }

    void add_depths() {
        const RowEnds& ends = report_.row.under(Interpolation::perspective);
        const Fragment& fragment = carried_[0];
        write_.add("column", "column",
                   "Where in the picture: i columns to the right of the row's left end.",
                   "left + i",
                   {{"left",
                     {static_cast<float>(ends.left.column), true},
                     from_row_end(report_.row.triangle, report_.row.row, false)},
                    column_in_row(report_)},
                   {static_cast<float>(report_.pixel.x), true});
        const QuantityInfo inverse = quantity_in(frame_, Quantity::zinv);
        add_along_row(
            "zinv", inverse.words.name, inverse.words.help, Interpolation::perspective,
            [](const RowEnd& end) { return end.inv_w; }, fragment.inv_w);
        add_along_row(
            "z.affine", "z",
            "z interpolated as if it changed in equal steps, which is wrong between the vertices.",
            Interpolation::perspective, [](const RowEnd& end) { return end.z; }, fragment.z);
        add_true_depth(fragment);
        add_difference(quantity_info(Quantity::z), Interpolation::affine, fragment.z);
    }

    /// The true z, from what the row carries.
    void add_true_depth(const Fragment& fragment) {
        Formula& z = write_.add("z.perspective", "z", "The true z: one over the interpolated 1/z.",
                                "1 / (1/z)", {weight()}, {fragment_depth(fragment, mix_)});
        if (mix_ == 0.0f) return;
        z.help = "The true z, from one over the interpolated 1/w, which is (1 − mix) z + mix.";
        z.expression = "(1 / (1/w) − mix) / (1 − mix)";
        z.inputs.push_back({"mix", {mix_}, from_setting("projection_mix")});
        if (mix_ < 1.0f) return;
        z.help = "The true z; if rays are parallel it changes in equal steps.";
        z.expression = "z";
        z.inputs = {write_.input("z", "z.affine")};
    }

    void add_varying(const QuantityInfo& info) {
        const std::string id(info.words.id), name(info.words.name), help(info.words.help),
            carried_name = carried_name_in(frame_, info.quantity);
        const EndPart part = part_of_ends(info.quantity);
        const auto walked = [&](Interpolation way) {
            return part_of(carried(way).varyings, info.quantity);
        };
        add_along_row(id + ".affine", name,
                      help + " Interpolated as it is, which is wrong between the vertices.",
                      Interpolation::affine, part, walked(Interpolation::affine));
        add_along_row(id + ".carried", carried_name,
                      "What a perspective-correct row carries: the value divided by " + w_ + ".",
                      Interpolation::perspective, part, walked(Interpolation::perspective));
        const FormulaInput value = write_.input("(" + carried_name + ")", id + ".carried"),
                           over = weight();
        write_.add(id + ".perspective", name,
                   help + " Carried divided by " + w_ + ", and multiplied by it again here.",
                   value.symbol + " / " + over.symbol, {value, over},
                   {part_of(report_.under(Interpolation::perspective), info.quantity)});
        const Interpolation wrong = report_.interpolation == Interpolation::perspective
                                        ? Interpolation::affine
                                        : report_.interpolation;
        if (wrong == Interpolation::mixed) add_mixed(info);
        if (wrong == Interpolation::zinv_twice) add_twice(info);
        if (wrong == Interpolation::undivided || wrong == Interpolation::divided_twice)
            add_divided_wrongly(info, wrong, value);
        add_difference(info, wrong, part_of(report_.under(wrong), info.quantity));
    }

    /// How a value gets along the row with a weight between affine's and that of perspective, and
    /// what is recovered of it.
    void add_mixed(const QuantityInfo& info) {
        const std::string id(info.words.id), weighted = id + ".carried_mixed";
        constexpr Interpolation way = Interpolation::mixed;
        const MixedWeight by = mixed_weight_rule(frame_.settings, frame_.scene->space);
        add_along_row(weighted, std::string(info.words.name) + " · weight",
                      "What the row carries: the value times the weight (1 − m) + m d/" + w_ + ".",
                      way, part_of_ends(info.quantity),
                      part_of(carried(way).varyings, info.quantity));
        FormulaInput over = weight();
        over.number = {carried(way).inv_w};
        write_.add(id + ".mixed", std::string(info.words.name),
                   std::string(info.words.help) +
                       " Carried with a weight, and divided here by the weight that the pixel has.",
                   "carried / ((1 − m) + m · (d · " + over.symbol + "))",
                   {write_.input("carried", weighted),
                    {"m", {by.mix}, from_setting("interpolation_mix")},
                    {"d",
                     {by.depth},
                     from_words("the reference depth: distances are measured by it, so the unit "
                                "makes no difference")},
                    over},
                   {part_of(report_.under(way), info.quantity)});
    }

    /// How a value that is divided by z twice gets along the row, and what is recovered of it.
    void add_twice(const QuantityInfo& info) {
        const std::string id(info.words.id), twice = id + ".carried_twice";
        constexpr Interpolation way = Interpolation::zinv_twice;
        report_.formulas.push_back(along_row_of_ends(
            report_, twice, carried_name_in(frame_, info.quantity) + "²",
            fmt::format("What the row carries by mistake: the ends, already divided by "
                        "{0}, are multiplied by their 1/{0} once more.",
                        w_),
            way, part_of_ends(info.quantity), part_of(carried(way).varyings, info.quantity), true));
        FormulaInput over = weight();
        over.number = {carried(way).inv_w};
        write_.add(id + ".zinv_twice", std::string(info.words.name),
                   fmt::format("{} Divided by {} twice, but multiplied by it only once here.",
                               info.words.help, w_),
                   "carried / " + over.symbol, {write_.input("carried", twice), over},
                   {part_of(report_.under(way), info.quantity)});
    }

    /// What is recovered of a value that the row carries correctly, if the pixel divides it by 1/z
    /// too few or too many times.
    void add_divided_wrongly(const QuantityInfo& info, Interpolation way,
                             const FormulaInput& carried) {
        const FormulaInput over = weight();
        const bool is_twice = way == Interpolation::divided_twice;
        Formula& formula = write_.add(
            fmt::format("{}.{}", info.words.id, word_of(way)), std::string(info.words.name),
            fmt::format("{} Carried divided by {}, and by mistake {}divided by 1/{}{} "
                        "here.",
                        info.words.help, w_, is_twice ? "" : "not ", w_, is_twice ? " twice" : ""),
            carried.symbol, {carried}, {part_of(report_.under(way), info.quantity)});
        if (!is_twice) return;
        formula.expression += fmt::format(" / ({0} · {0})", over.symbol);
        formula.inputs.push_back(over);
    }

    /// How far a wrong value is from the right one.
    void add_difference(const QuantityInfo& info, Interpolation way, float wrong) {
        const std::string id(info.words.id);
        const FormulaInput right = write_.input("perspective", id + ".perspective");
        const std::string symbol = way == Interpolation::affine ? "affine" : "wrong";
        Formula& formula =
            write_.add(id + ".off", std::string(info.words.name) + " off by",
                       "How far the affine value is from the perspective-correct one.",
                       "abs(" + symbol + " − perspective)",
                       {{symbol, {wrong}, from_formula(formula_id(info.quantity, way))}, right},
                       {std::abs(wrong - right.number.value)});
        if (way == Interpolation::affine) return;
        formula.help =
            fmt::format("How far the value {} is from the correct one.",
                        way == Interpolation::mixed        ? "with mixed weights"
                        : way == Interpolation::zinv_twice ? "divided by " + w_ + " once too often"
                        : way == Interpolation::undivided  ? "never divided by 1/" + w_
                                                           : "divided by 1/" + w_ + " twice");
    }

    FragmentReport& report_;
    const Frame& frame_;
    const Carried& carried_;
    FormulaWriter write_;
    float mix_;     ///< of the projection
    std::string w_; ///< what values are divided by: z, or w if that is a different number
};

} // namespace

Formula along_row(const FragmentReport& report, std::string id, std::string_view name,
                  std::string_view help, Interpolation way, const EndPart& part, float result) {
    return along_row_of_ends(report, std::move(id), name, help, way, part, result, false);
}

void add_values(FragmentReport& report, const Frame& frame) {
    Carried carried;
    for (const Interpolation way : all_interpolations) {
        const auto i = static_cast<std::size_t>(way);
        carried[i] = report.row.at(way, report.step);
        report.varyings[i] = recover_varyings(carried[i], report.row.stages[i]);
    }
    ValueFormulas(report, frame, carried).add_all();
}

} // namespace rasterwalk
