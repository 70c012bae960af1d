#include "explain/fragment_report.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/highlight_formulas.h"
#include "explain/light_formulas.h"
#include "explain/vertex_report.h"
#include "inspect/pixel_tests.h"
#include "pipeline/draw.h"
#include "pipeline/surface.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

constexpr std::array<Interpolation, interpolation_count> ways{
    Interpolation::perspective, Interpolation::affine, Interpolation::zinv_twice};

using Carried = std::array<Fragment, interpolation_count>; ///< indexed by Interpolation

/// Which fragment of its row it is.
std::string column_words(int step) {
    return element_name(fragment_form, step) + " of the row, from its left end";
}

/// Keeps the event of one fragment, and who wrote on its pixel before.
class Watcher : public Observer {
  public:
    explicit Watcher(const Cursor& of) : wanted(of) {}

    void fragment(const FragmentEvent& now) override {
        if (now.cursor == wanted) {
            event = now;
        } else if (now.fate == Fate::written && !event) {
            written_by = now.cursor;
        }
    }

    std::optional<FragmentEvent> event;
    std::optional<Cursor> written_by;

  private:
    Cursor wanted;
};

/// One value of an end of a row, or of a corner.
using Part = std::function<float(const RowEnd&)>;

Part part_of_ends(Quantity quantity) {
    return [quantity](const RowEnd& end) { return part_of(end.varyings, quantity); };
}

/// Where edge functions find the pixels: what weighs the fragment.
struct WeighedCorners {
    const TestedPolygon& polygon;
    const TestedTriangle& triangle;

    WeighedCorners(const FragmentReport& report, Interpolation way)
        : polygon(report.row.tested[static_cast<std::size_t>(way)]),
          triangle(triangle_of_pixel(polygon, report.pixel.x, report.pixel.y)) {}

    /// The number of a corner of what is drawn, and its values.
    int number(std::size_t i) const { return triangle.corners[i]; }
    const RowEnd& corner(std::size_t i) const {
        return polygon.corners[static_cast<std::size_t>(number(i))];
    }
    EdgeValues values(const FragmentReport& report) const {
        return triangle.values_at({pixel_centre(report.pixel.x), pixel_centre(report.pixel.y)});
    }
    Source source(std::size_t i) const {
        return from_words(fmt::format("corner {} of what is drawn", number(i)));
    }
};

std::string weight_id(std::size_t i) {
    return fmt::format("weight.{}", i);
}

/// The weights of the three corners.
void add_weights(FragmentReport& report) {
    if (!report.row.is_weighted()) return;
    const WeighedCorners corners(report, Interpolation::perspective);
    const EdgeValues e = corners.values(report);
    const Stages& stages = report.row.stages.front();
    const Weights weights = stages.weights(e, corners.triangle.area);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::size_t opposite = (i + 1) % weights.size();
        report.formulas.push_back(
            {weight_id(i),
             fmt::format("b{}", i),
             fmt::format("The weight of corner {}: the edge function of the edge opposite of it, "
                         "as a part of all three.",
                         corners.number(i)),
             "E / A",
             {{"E",
               {static_cast<float>(in_square_pixels(e[opposite]))},
               from_words(fmt::format("edge function of {} at the pixel's centre, in square pixels",
                                      tested_edge_name(corners.triangle.edges[opposite].number)))},
              {"A",
               {static_cast<float>(in_square_pixels(corners.triangle.area))},
               from_words("the sum of all three, twice the area")}},
             {weights[i]}});
    }
}

constexpr std::array<const char*, edge_function_count> corner_symbols{"p", "q", "r"};

/// How a value is mixed from those of the corners.
/// @param is_twice the corners' values are multiplied by their 1/z once more
Formula by_weights(const FragmentReport& report, Formula formula, Interpolation way,
                   const Part& part, bool is_twice) {
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

/// How a value gets along a row: by the walk that is in force, as one formula of both ends; or,
/// where edge functions find the pixels, by the weights of the corners.
Formula along_row(const FragmentReport& report, std::string id, std::string name, std::string help,
                  Interpolation way, const Part& part, float result) {
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
    case LineWalk::integer_step: // only the place's step is cut, and along a row it is 1
        formula.expression = "accumulate(left, (right − left) / (n − 1), i)";
        break;
    case LineWalk::multiply:
        formula.expression = "left + i · ((right − left) / (n − 1))";
        break;
    case LineWalk::exact:
        formula.expression = "left · (1 − i / (n − 1)) + right · (i / (n − 1))";
        break;
    }
    // The first sample is the left end itself, whichever way the row is walked.
    if (report.step == 0) {
        formula.expression = "left";
        formula.inputs.resize(1);
    }
    return formula;
}

/// The same where the row's ends are multiplied by 1/z once more.
Formula along_row_twice(const FragmentReport& report, Formula formula, const Part& part) {
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

/// z as it is, from what the row carries.
Formula true_depth(const Fragment& fragment, float mix) {
    Formula formula{"z.perspective",
                    "z",
                    "z as it is: one over the interpolated 1/z.",
                    "1 / (1/z)",
                    {{"(1/z)", {fragment.inv_w}, from_formula("zinv")}},
                    {fragment_depth(fragment, mix)}};
    if (mix == 0.0f) return formula;
    formula.inputs.push_back({"mix", {mix}, from_setting("projection_mix")});
    formula.inputs[0].symbol = "(1/w)";
    formula.help = "z as it is: from one over the interpolated 1/w, which is (1 − mix) z + mix.";
    formula.expression = "(1 / (1/w) − mix) / (1 − mix)";
    if (mix == 1.0f) {
        formula.help = "z as it is: where rays are parallel it goes in equal steps.";
        formula.expression = "z";
        formula.inputs = {{"z", {fragment.z}, from_formula("z.affine")}};
    }
    return formula;
}

void add_depths(FragmentReport& report, const Frame& frame, const Carried& carried) {
    add_weights(report);
    const RowEnds& ends = report.row.under(Interpolation::perspective);
    const Fragment& fragment = carried[0];
    report.formulas.push_back(
        {"column",
         "column",
         "Where in the picture: the row's left end, and so many columns on.",
         "left + i",
         {{"left",
           {static_cast<float>(ends.left.column), true},
           from_row_end(report.row.triangle, report.row.row, false)},
          {"i", {static_cast<float>(report.step), true}, from_words(column_words(report.step))}},
         {static_cast<float>(report.pixel.x), true}});
    const QuantityInfo weight = quantity_in(frame, Quantity::zinv);
    report.formulas.push_back(along_row(
        report, "zinv", std::string(weight.words.name), std::string(weight.words.help),
        Interpolation::perspective, [](const RowEnd& end) { return end.inv_w; }, fragment.inv_w));
    report.formulas.push_back(along_row(
        report, "z.affine", "z",
        "z interpolated as if it changed in equal steps: wrong "
        "between the vertices.",
        Interpolation::perspective, [](const RowEnd& end) { return end.z; }, fragment.z));
    const float mix = vertex_rules(frame.settings, frame.scene->space).projection.mix;
    report.formulas.push_back(true_depth(fragment, mix));
}

Formula difference(const QuantityInfo& info, Interpolation way, float wrong, float perspective) {
    const std::string id(info.words.id);
    Formula formula{id + ".off",
                    std::string(info.words.name) + " off by",
                    "How far the affine value is from the perspective-correct one.",
                    "abs(affine − perspective)",
                    {{"affine", {wrong}, from_formula(formula_id(info.quantity, way))},
                     {"perspective", {perspective}, from_formula(id + ".perspective")}},
                    {std::abs(wrong - perspective)}};
    if (way == Interpolation::zinv_twice) {
        formula.help = "How far the value divided by z once too often is from the right one.";
        formula.expression = "abs(wrong − perspective)";
        formula.inputs[0].symbol = "wrong";
    }
    return formula;
}

/// How a value that is divided by z twice gets along the row, and what is recovered of it.
void add_twice(FragmentReport& report, const QuantityInfo& info, const Carried& carried) {
    const std::string id(info.words.id), name(info.words.name),
        carried_name = std::string(info.words.carried_name);
    const Quantity quantity = info.quantity;
    const auto way = static_cast<std::size_t>(Interpolation::zinv_twice);
    const float value = part_of(carried[way].varyings, quantity);
    const Part part = part_of_ends(quantity);
    report.formulas.push_back(along_row_twice(
        report,
        along_row(report, id + ".carried_twice", carried_name + "²",
                  "What the row carries by mistake: the ends, divided by z already, once more "
                  "multiplied by their 1/z.",
                  Interpolation::zinv_twice, part, value),
        part));
    report.formulas.push_back(
        {id + ".zinv_twice",
         name,
         std::string(info.words.help) + " Divided by z twice, and multiplied by it only once here.",
         "carried / (1/z)",
         {{"carried", {value}, from_formula(id + ".carried_twice")},
          {"(1/z)", {carried[way].inv_w}, from_formula("zinv")}},
         {part_of(report.under(Interpolation::zinv_twice), quantity)}});
}

void add_varying(FragmentReport& report, const QuantityInfo& info, const Carried& carried) {
    const std::string id(info.words.id), name(info.words.name),
        carried_name(info.words.carried_name);
    const Quantity quantity = info.quantity;
    const auto add_walk = [&](Interpolation way, const std::string& formula_of,
                              const std::string& shown_name, const std::string& help) {
        report.formulas.push_back(
            along_row(report, formula_of, shown_name, help, way, part_of_ends(quantity),
                      part_of(carried[static_cast<std::size_t>(way)].varyings, quantity)));
    };
    add_walk(Interpolation::affine, id + ".affine", name,
             std::string(info.words.help) + " Interpolated as it is: wrong between the vertices.");
    add_walk(Interpolation::perspective, id + ".carried", carried_name,
             "What a perspective-correct row carries: the value divided by z.");
    const std::string symbol = "(" + carried_name + ")";
    report.formulas.push_back(
        {id + ".perspective",
         name,
         std::string(info.words.help) + " Carried divided by z, and multiplied by it again here.",
         symbol + " / (1/z)",
         {{symbol, {part_of(carried[0].varyings, quantity)}, from_formula(id + ".carried")},
          {"(1/z)", {carried[0].inv_w}, from_formula("zinv")}},
         {part_of(report.under(Interpolation::perspective), quantity)}});
    const Interpolation wrong = report.interpolation == Interpolation::zinv_twice
                                    ? Interpolation::zinv_twice
                                    : Interpolation::affine;
    if (wrong == Interpolation::zinv_twice) add_twice(report, info, carried);
    report.formulas.push_back(
        difference(info, wrong, part_of(report.under(wrong), quantity),
                   part_of(report.under(Interpolation::perspective), quantity)));
}

/// The sources of a varying's components, where the report has their formulas.
SourcedVector interpolated(const FragmentReport& report, glm::vec3 Varyings::*member,
                           const char* otherwise) {
    SourcedVector vector{report.under(report.interpolation).*member, {}};
    for (int i = 0; i < 3; ++i) {
        const std::string id = formula_id(quantity_of(member, i), report.interpolation);
        vector.sources[static_cast<std::size_t>(i)] =
            find_formula(report.formulas, id) != nullptr ? from_formula(id) : from_words(otherwise);
    }
    return vector;
}

/// What a triangle has once: as its first vertex has it.
SourcedVector of_first_vertex(int triangle, const glm::vec3& value,
                              const std::array<std::string, 3>& ids) {
    SourcedVector vector{value, {}};
    for (std::size_t i = 0; i < ids.size(); ++i)
        vector.sources[i] = from_vertex(triangle, 0, ids[i]);
    return vector;
}

std::array<std::string, 3> light_normal_ids(const Frame& frame) {
    return {light_normal_id(frame.settings, 0), light_normal_id(frame.settings, 1),
            light_normal_id(frame.settings, 2)};
}

std::array<std::string, 3> reflectance_ids() {
    std::array<std::string, 3> ids;
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = std::string("reflectance.") + channel_names[i];
    return ids;
}

/// Where the surface has a texture: the light of the vertices, which is that of its reflectance,
/// times the texture.
/// @param carried the light as it was carried
FormulaInput painted_light(FragmentReport& report, int channel, const FormulaInput& carried) {
    const std::string name = channel_names[static_cast<std::size_t>(channel)];
    const float texture = report.texture->colour[channel];
    const Number result{carried.number.value * texture};
    const std::string id = "vertex_light.painted." + name;
    report.formulas.push_back({id,
                               "R " + name,
                               "The light of the vertices, interpolated, and painted by the "
                               "texture.",
                               "R · t",
                               {carried, {"t", {texture}, from_formula("texture." + name)}},
                               result});
    return {carried.symbol, result, from_formula(id)};
}

/// What the fragment took of its texture.
void add_texture(const Frame& frame, FragmentReport& report) {
    report.texture = texture_report(frame, report.cursor.triangle, report.fragment);
    if (!report.texture) return;
    append_texture_formulas(*report.texture, frame, report.cursor.triangle,
                            formula_id(quantity_of(&Varyings::texcoord, 0), report.interpolation),
                            formula_id(quantity_of(&Varyings::texcoord, 1), report.interpolation),
                            report.formulas);
}

/// The light at the fragment's own place.
/// @return the reflectance there, interpolated where the corners' differ
SourcedVector add_pixel_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    Surface surface = surface_of(frame, triangle);
    surface.shine = frame.scene->corner(triangle, 0).shine;
    surface.differences = frame.scene->mesh.differences(triangle);
    const PixelRules rules = pixel_rules(frame.settings);
    SurfacePoint place =
        surface_point(report.under(report.interpolation), surface, rules.camera, frame.stages);
    if (report.texture) place.reflectance *= report.texture->colour;
    LitPoint point;
    point.prefix = "pixel_light.";
    point.shine = place.shine;
    point.light = report.light = surface_light(place, rules.light, rules.rays, frame.stages);
    point.position = interpolated(report, &Varyings::position_world, "");
    point.reflectance = of_first_vertex(triangle, place.reflectance, reflectance_ids());
    if (surface.differences.colours)
        point.reflectance =
            interpolated(report, &Varyings::colour, "the colours of the vertices, interpolated");
    if (report.texture) {
        point.reflectance.value = place.reflectance;
        for (std::size_t i = 0; i < 3; ++i)
            point.reflectance.sources[i] = from_formula(std::string("surface.") + channel_names[i]);
    }
    point.normal = of_first_vertex(triangle, place.normal, light_normal_ids(frame));
    if (surface.differences.normals) {
        append_normal_formulas(
            point,
            interpolated(report, &Varyings::normal, "the normals of the vertices, interpolated"),
            frame, report.formulas);
    }
    append_light_formulas(point, frame, report.formulas);
    return point.reflectance;
}

/// A part of the middle of a triangle, which is the mean of its corners' parts.
Source add_mean(const FragmentReport& report, const std::string& id, const std::string& symbol,
                const std::array<float, triangle_corners>& parts, float mean,
                const std::string& vertex_id, std::vector<Formula>& formulas) {
    Formula formula{id,
                    symbol,
                    "In the middle of the triangle: the mean of its three corners.",
                    "(a + b + c) / 3",
                    {},
                    {mean}};
    constexpr std::array<const char*, triangle_corners> symbols{"a", "b", "c"};
    for (std::size_t v = 0; v < parts.size(); ++v) {
        formula.inputs.push_back(
            {symbols[v],
             {parts[v]},
             from_vertex(report.cursor.triangle, static_cast<int>(v), vertex_id)});
    }
    formulas.push_back(formula);
    return from_formula(id);
}

/// The light in the middle of the triangle, which flat shading gives all of it.
void add_triangle_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const CornerDifferences differs = frame.scene->mesh.differences(triangle);
    const PixelRules rules = pixel_rules(frame.settings);
    const SurfacePoint place = flat_point(frame, triangle);
    LitPoint point;
    point.prefix = "triangle_light.";
    point.shine = place.shine;
    point.light = report.light_per_triangle =
        surface_light(place, rules.light, rules.rays, frame.stages);
    const auto mean_of = [&](glm::vec3 Vertex::*member, const glm::vec3& value,
                             const std::string& symbol, const std::string& vertex_id,
                             const std::array<const char*, 3>& names) {
        SourcedVector vector{value, {}};
        for (int i = 0; i < 3; ++i) {
            const auto part = static_cast<std::size_t>(i);
            std::array<float, triangle_corners> parts{};
            for (int v = 0; v < triangle_corners; ++v)
                parts[static_cast<std::size_t>(v)] = (frame.scene->corner(triangle, v).*member)[i];
            vector.sources[part] = add_mean(report, point.prefix + symbol + "." + names[part],
                                            symbol + "." + names[part], parts, value[i],
                                            vertex_id + "." + names[part], report.formulas);
        }
        return vector;
    };
    point.position = mean_of(&Vertex::position, place.position_world, "p", "world", axis_names);
    point.reflectance = differs.colours
                            ? mean_of(&Vertex::reflectance, place.reflectance, "reflectance",
                                      "reflectance", channel_names)
                            : of_first_vertex(triangle, place.reflectance, reflectance_ids());
    point.normal = of_first_vertex(triangle, place.normal, light_normal_ids(frame));
    if (differs.normals)
        point.normal.sources.fill(from_words("across the places of the triangle's corners"));
    append_light_formulas(point, frame, report.formulas);
}

void add_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const VertexRules vertex = vertex_rules(frame.settings, frame.scene->space);
    constexpr std::array<Quantity, 3> colour{quantity_of(&Varyings::illumination, 0),
                                             quantity_of(&Varyings::illumination, 1),
                                             quantity_of(&Varyings::illumination, 2)};
    const SourcedVector reflectance = add_pixel_light(frame, report);
    if (report.shading == Shading::flat) add_triangle_light(frame, report);
    for (std::size_t v = 0; v < report.at_vertex.size(); ++v) {
        report.at_vertex[v] = light_at_vertex(frame.scene->corner(triangle, static_cast<int>(v)),
                                              vertex, frame.stages);
    }
    report.light_per_vertex = report.under(report.interpolation).illumination;
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        const std::string name = channel_names[part];
        FormulaInput carried{"R",
                             {report.light_per_vertex[i]},
                             from_formula(formula_id(colour[part], report.interpolation))};
        if (report.texture) carried = painted_light(report, i, carried);
        Formula by_vertex = shown_channel("vertex_light.colour." + name, name, carried, frame);
        by_vertex.help = "The light of the vertices, interpolated. " + by_vertex.help;
        report.formulas.push_back(by_vertex);
        Formula flat =
            shown_channel("flat.colour." + name, name,
                          {"ρ", {reflectance.value[i]}, reflectance.sources[part]}, frame);
        flat.help = "The surface's own colour: this stage computes no light. " + flat.help;
        report.formulas.push_back(flat);
    }
}

/// The depth rounded to one of the values that the buffer has.
/// @param whole the depth before
void round_depth(Formula& depth, float whole, const DepthRules& rules) {
    const ClipDepth kind = rules.projection.clip_depth;
    const int largest = (1 << rules.bits) - 1;
    // 1/z reaches up to 1/near.
    const bool is_scaled = kind == ClipDepth::inv_z;
    depth.expression = is_scaled ? "k / n / near" : "k / n";
    depth.inputs = {{"k",
                     {static_cast<float>(held_step(whole, rules)), true},
                     from_words(fmt::format("{} {} times {}, to the nearest whole number",
                                            depth_words(kind).name, shown({whole}),
                                            is_scaled ? "near times n" : "n"))},
                    {"n",
                     {static_cast<float>(largest), true},
                     from_words(fmt::format("2^{} − 1", rules.bits))}};
    if (is_scaled) depth.inputs.push_back({"near", {rules.near}, from_setting("near")});
}

/// The depth of a z that was interpolated as if it changed in equal steps.
void add_linear_depth(Formula& depth, float z, const DepthRules& rules) {
    depth.help += " Made from z that was interpolated as if it changed in equal steps.";
    depth.inputs = {{"z", {z}, from_formula("z.affine")}};
    depth.result = {depth_at(z, rules)};
    const float mix = rules.projection.mix;
    if (rules.projection.clip_depth == ClipDepth::inv_z) {
        depth.expression = "1 / z";
        return;
    }
    const bool is_ndc = rules.projection.clip_depth == ClipDepth::ndc;
    const std::string plane = is_ndc ? "far" : "near";
    const std::string scale = mix == 0.0f ? plane : "((1 − mix) · " + plane + " + mix)";
    const std::string w = mix == 0.0f ? "z" : "((1 − mix) · z + mix)";
    depth.expression =
        scale + " · (" + (is_ndc ? "(z − near)" : "(far − z)") + " / (far − near)) / " + w;
    depth.inputs.push_back({"near", {rules.near}, from_setting("near")});
    depth.inputs.push_back({"far", {rules.far}, from_setting("far")});
    if (mix != 0.0f) depth.inputs.push_back({"mix", {mix}, from_setting("projection_mix")});
}

void add_depth_test(FragmentReport& report, const Frame& frame) {
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const ClipDepth kind = rules.projection.clip_depth;
    const DepthWords& words = depth_words(kind);
    const std::string name(words.name);
    Formula depth{"depth",
                  "new",
                  fmt::format("The fragment's value for the depth buffer, {}: {} is nearer.", name,
                              words.nearer),
                  "(1/z)",
                  {{"(1/z)", {report.fragment.depth}, from_formula("zinv")}},
                  {report.depth}};
    // What is culled never came to the test.
    const bool is_tested = report.fate != Fate::back_facing;
    if (is_tested && report.depth_test == DepthTest::linear_z) {
        add_linear_depth(depth, report.fragment.z, rules);
    } else if (kind != ClipDepth::inv_z) {
        report.formulas.push_back(along_row(
            report, "depth.carried", name,
            "Interpolated in equal steps. " + std::string(words.ends), report.interpolation,
            [](const RowEnd& end) { return end.depth; }, report.fragment.depth));
        depth.expression = "depth";
        depth.inputs = {{"depth", {report.fragment.depth}, from_formula("depth.carried")}};
    }
    if (is_tested && rules.bits > 0) round_depth(depth, depth.result.value, rules);
    depth.result = {report.depth};
    report.formulas.push_back(depth);
    Source stored = report.stored_by
                        ? from_moment(*report.stored_by)
                        : from_words("the depth buffer's start: nothing drawn here yet");
    if (!report.stored_by && report.stored != farthest_depth(kind))
        stored = from_setting("depth_clear");
    if (!report.has_cell) stored = from_words("this pixel has no cell in the depth buffer");
    report.formulas.push_back(
        {"margin",
         "margin",
         report.depth_test == DepthTest::reversed
             ? "How much nearer than what is stored; the test is the wrong way round, and below 0 "
               "the fragment is drawn."
             : "How much nearer than what is stored; above 0 the fragment is drawn.",
         is_smaller_nearer(kind) ? "stored − new" : "new − stored",
         {{"new", {report.depth}, from_formula("depth")}, {"stored", {report.stored}, stored}},
         {depth_ahead(report.depth, report.stored, kind)}});
}

} // namespace

std::string formula_id(Quantity quantity, Interpolation way) {
    if (quantity == Quantity::zinv) return "zinv";
    const std::string id(quantity_info(quantity).words.id);
    if (way == Interpolation::perspective) return id + ".perspective";
    const bool is_twice = way == Interpolation::zinv_twice && is_varying(quantity);
    return id + (is_twice ? ".zinv_twice" : ".affine");
}

namespace {

/// Where w is not z, values are carried divided by w.
void say_w_for_z(std::vector<Formula>& formulas) {
    const auto put = [](std::string& text, std::string_view word, std::string_view by) {
        for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
            text.replace(at, word.size(), by);
    };
    for (Formula& formula : formulas) {
        put(formula.name, "/z", "/w");
        put(formula.expression, "/z", "/w");
        put(formula.help, "divided by z", "divided by w");
        put(formula.help, "Divided by z", "Divided by w");
        put(formula.help, "1/z", "1/w");
        for (FormulaInput& input : formula.inputs)
            put(input.symbol, "/z", "/w");
    }
}

} // namespace

std::optional<FragmentReport> fragment_report(const Frame& frame, const Cursor& cursor) {
    if (!has_fragments(frame.settings.stage) || cursor.phase != Phase::rows) return std::nullopt;
    if (cursor.triangle < 0 || cursor.triangle >= frame.triangle_count()) return std::nullopt;
    if (!frame.is_drawn(cursor.triangle)) return std::nullopt;
    const std::optional<CarriedRow> row = carried_row(frame, cursor.triangle, cursor.index);
    if (!row || cursor.step < 0 || cursor.step >= row->count) return std::nullopt;

    FragmentReport report;
    report.cursor = cursor;
    report.row = *row;
    report.step = cursor.step;
    report.pixel = {row->under(Interpolation::perspective).left.column + cursor.step, row->row};
    const Viewport size = frame.settings.viewport;
    if (report.pixel.x < 0 || report.pixel.x >= size.width || report.pixel.y < 0 ||
        report.pixel.y >= size.height) {
        return std::nullopt;
    }
    Framebuffer one_pixel;
    clear(one_pixel, frame, {1, 1}, report.pixel);
    Watcher watcher(cursor);
    Cursor after = cursor;
    ++after.step;
    draw(frame, {cursor_begin, after, {}}, one_pixel, &watcher);
    if (!watcher.event) return std::nullopt;
    const FragmentEvent& event = *watcher.event;
    report.fragment = event.fragment;
    report.depth = event.depth;
    report.stored = event.stored;
    report.has_cell = has_depth_cell(frame.stages, report.pixel.x, report.pixel.y, size);
    if (report.has_cell) report.stored_by = watcher.written_by;
    report.fate = event.fate;
    report.before = event.before;
    report.after = event.after;

    const PixelRules rules = pixel_rules(frame.settings);
    report.interpolation = frame.settings.interpolation;
    report.shading = rules.shading;
    report.depth_test = depth_rule(frame.settings);
    report.colour = frame.stages.pixel_shader(report.fragment, surface_of(frame, cursor.triangle),
                                              rules, frame.stages);

    Carried carried;
    for (const Interpolation way : ways) {
        const auto i = static_cast<std::size_t>(way);
        carried[i] = report.row.at(way, report.step);
        report.varyings[i] = recover_varyings(carried[i], report.row.stages[i]);
    }
    add_depths(report, frame, carried);
    report.formulas.push_back(
        difference(quantity_info(Quantity::z), Interpolation::affine, carried[0].z,
                   find_formula(report.formulas, "z.perspective")->result.value));
    for (const QuantityInfo& info : shown_quantities(frame)) {
        if (is_varying(info.quantity)) add_varying(report, info, carried);
    }
    add_texture(frame, report);
    add_light(frame, report);
    add_depth_test(report, frame);
    if (vertex_rules(frame.settings, frame.scene->space).projection.mix > 0.0f)
        say_w_for_z(report.formulas);
    return report;
}

namespace {

/// The last fragment written on a pixel.
class LastWritten : public Observer {
  public:
    void fragment(const FragmentEvent& event) override {
        if (event.fate == Fate::written) cursor = event.cursor;
    }
    std::optional<Cursor> cursor;
};

} // namespace

std::optional<Cursor> fragment_on_pixel(const Frame& frame, const glm::ivec2& pixel,
                                        const Cursor& moment) {
    const Viewport size = frame.settings.viewport;
    const bool inside =
        pixel.x >= 0 && pixel.x < size.width && pixel.y >= 0 && pixel.y < size.height;
    if (!inside || !has_fragments(frame.settings.stage)) return std::nullopt;
    Framebuffer one_pixel;
    clear(one_pixel, frame, {1, 1}, pixel);
    LastWritten watcher;
    draw(frame, {cursor_begin, moment, {}}, one_pixel, &watcher);
    if (!watcher.cursor) draw(frame, {moment, cursor_end, {}}, one_pixel, &watcher);
    return watcher.cursor;
}

} // namespace rasterwalk
