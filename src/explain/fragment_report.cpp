#include "explain/fragment_report.h"

#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/along_row.h"
#include "explain/blend_formulas.h"
#include "explain/depth_formulas.h"
#include "explain/highlight_formulas.h"
#include "explain/light_formulas.h"
#include "explain/vertex_report.h"
#include "pipeline/event_source.h"
#include "pipeline/surface.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

using Carried = std::array<Fragment, interpolation_count>; ///< indexed by Interpolation

/// The true z, from what the row carries.
Formula true_depth(const Fragment& fragment, float mix) {
    Formula formula{"z.perspective",
                    "z",
                    "The true z: one over the interpolated 1/z.",
                    "1 / (1/z)",
                    {{"(1/z)", {fragment.inv_w}, from_formula("zinv")}},
                    {fragment_depth(fragment, mix)}};
    if (mix == 0.0f) return formula;
    formula.inputs.push_back({"mix", {mix}, from_setting("projection_mix")});
    formula.inputs[0].symbol = "(1/w)";
    formula.help = "The true z, from one over the interpolated 1/w, which is (1 − mix) z + mix.";
    formula.expression = "(1 / (1/w) − mix) / (1 − mix)";
    if (mix == 1.0f) {
        formula.help = "The true z; if rays are parallel it changes in equal steps.";
        formula.expression = "z";
        formula.inputs = {{"z", {fragment.z}, from_formula("z.affine")}};
    }
    return formula;
}

void add_depths(FragmentReport& report, const Frame& frame, const Carried& carried) {
    add_weights(report, frame.settings.weight_edge);
    const RowEnds& ends = report.row.under(Interpolation::perspective);
    const Fragment& fragment = carried[0];
    report.formulas.push_back(
        {"column",
         "column",
         "Where in the picture: i columns to the right of the row's left end.",
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
        "z interpolated as if it changed in equal steps, which is wrong between the vertices.",
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
    if (way == Interpolation::affine) return formula;
    formula.help = fmt::format("How far the value {} is from the correct one.",
                               way == Interpolation::zinv_twice  ? "divided by z once too often"
                               : way == Interpolation::undivided ? "never divided by 1/z"
                                                                 : "divided by 1/z twice");
    formula.expression = "abs(wrong − perspective)";
    formula.inputs[0].symbol = "wrong";
    return formula;
}

/// How a value that is divided by z twice gets along the row, and what is recovered of it.
void add_twice(FragmentReport& report, const QuantityInfo& info, const Carried& carried) {
    const std::string id(info.words.id), name(info.words.name),
        carried_name = std::string(info.words.carried_name);
    const Quantity quantity = info.quantity;
    const auto way = static_cast<std::size_t>(Interpolation::zinv_twice);
    const float value = part_of(carried[way].varyings, quantity);
    const EndPart part = part_of_ends(quantity);
    report.formulas.push_back(along_row_twice(
        report,
        along_row(report, id + ".carried_twice", carried_name + "²",
                  "What the row carries by mistake: the ends, already divided by z, are multiplied "
                  "by their 1/z once more.",
                  Interpolation::zinv_twice, part, value),
        part));
    report.formulas.push_back(
        {id + ".zinv_twice",
         name,
         std::string(info.words.help) + " Divided by z twice, but multiplied by it only once here.",
         "carried / (1/z)",
         {{"carried", {value}, from_formula(id + ".carried_twice")},
          {"(1/z)", {carried[way].inv_w}, from_formula("zinv")}},
         {part_of(report.under(Interpolation::zinv_twice), quantity)}});
}

/// What is recovered of a value that the row carries correctly, if the pixel divides it by 1/z too
/// few or too many times.
void add_divided_wrongly(FragmentReport& report, const QuantityInfo& info, Interpolation way,
                         float carried) {
    const std::string id(info.words.id), symbol = "(" + std::string(info.words.carried_name) + ")";
    Formula formula{id + "." + std::string(word_of(way)),
                    std::string(info.words.name),
                    std::string(info.words.help) +
                        " Carried divided by z, and by mistake not divided by 1/z here.",
                    symbol,
                    {{symbol, {carried}, from_formula(id + ".carried")}},
                    {part_of(report.under(way), info.quantity)}};
    if (way == Interpolation::divided_twice) {
        formula.help = std::string(info.words.help) +
                       " Carried divided by z, and by mistake divided by 1/z twice here.";
        formula.expression += " / ((1/z) · (1/z))";
        formula.inputs.push_back({"(1/z)", {report.fragment.inv_w}, from_formula("zinv")});
    }
    report.formulas.push_back(formula);
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
             std::string(info.words.help) + " Interpolated as it is, which is wrong between the "
                                            "vertices.");
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
    const Interpolation wrong = report.interpolation == Interpolation::perspective
                                    ? Interpolation::affine
                                    : report.interpolation;
    if (wrong == Interpolation::zinv_twice) add_twice(report, info, carried);
    if (wrong == Interpolation::undivided || wrong == Interpolation::divided_twice)
        add_divided_wrongly(report, info, wrong, part_of(carried[0].varyings, quantity));
    report.formulas.push_back(
        difference(info, wrong, part_of(report.under(wrong), quantity),
                   part_of(report.under(Interpolation::perspective), quantity)));
}

/// The sources of a varying's components, if the report has their formulas.
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

/// A value that a triangle has once: its first vertex's.
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

/// What the fragment took from its texture.
void add_texture(const Frame& frame, FragmentReport& report) {
    report.texture = texture_report(frame, report.cursor.triangle, report.fragment);
    if (!report.texture) return;
    append_texture_formulas(*report.texture, frame, report.cursor.triangle,
                            formula_id(quantity_of(&Varyings::texcoord, 0), report.interpolation),
                            formula_id(quantity_of(&Varyings::texcoord, 1), report.interpolation),
                            report.formulas);
}

/// The light at the fragment's own position.
/// @return the reflectance there, interpolated if the corners' differ
SourcedVector add_pixel_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const Surface surface = lit_surface_of(frame, triangle);
    const PixelRules rules = pixel_rules(frame);
    const glm::vec3 unbent =
        surface_point(report.fragment, surface, rules.camera, frame.stages).normal;
    const SurfacePoint place = lit_point(report.fragment, surface, rules, frame.stages);
    if (surface.normal_map != nullptr)
        report.bump = bump_report(report.fragment, surface, unbent, frame);
    report.normal = place.normal;
    LitPoint point;
    point.prefix = "pixel_light.";
    point.shine = place.shine;
    point.light = report.light =
        surface_light(place, rules.light, rules.rays, rules.occluders, frame.stages);
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
    point.normal = of_first_vertex(triangle, unbent, light_normal_ids(frame));
    if (surface.differences.normals) {
        append_normal_formulas(
            point,
            interpolated(report, &Varyings::normal, "the normals of the vertices, interpolated"),
            frame, report.formulas);
    }
    const SourcedVector surface_normal = point.normal;
    if (report.bump) append_bump_formulas(*report.bump, frame, triangle, point, report.formulas);
    append_side_formulas(point, surface_normal, frame, report.formulas);
    append_light_formulas(point, frame, report.formulas);
    return point.reflectance;
}

/// A component of the middle of a triangle, the mean of its corners' components.
Source add_mean(const FragmentReport& report, const std::string& id, const std::string& symbol,
                const std::array<float, triangle_corners>& parts, float mean,
                const std::string& vertex_id, std::vector<Formula>& formulas) {
    Formula formula{id,
                    symbol,
                    "In the middle of the triangle, at the mean of its three corners.",
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

/// The light in the middle of the triangle, which flat shading applies to all of it.
void add_triangle_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const CornerDifferences differs = frame.scene->mesh.differences(triangle);
    const PixelRules rules = pixel_rules(frame);
    const SurfacePoint place = flat_point(frame, triangle);
    LitPoint point;
    point.prefix = "triangle_light.";
    point.shine = place.shine;
    point.light = report.light_per_triangle =
        surface_light(place, rules.light, rules.rays, rules.occluders, frame.stages);
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
    point.normal = of_first_vertex(triangle, flat_normal(frame, triangle), light_normal_ids(frame));
    if (differs.normals)
        point.normal.sources.fill(from_words("perpendicular to the plane of the triangle's "
                                             "corners"));
    append_side_formulas(point, SourcedVector(point.normal), frame, report.formulas);
    if (report.texture) point.paint = report.texture->colour;
    append_light_formulas(point, frame, report.formulas);
}

void add_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const VertexRules vertex = vertex_rules(frame);
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
    std::array<FormulaInput, 3> by_vertex, own;
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        FormulaInput& carried = by_vertex[part];
        carried = {"R",
                   {report.light_per_vertex[i]},
                   from_formula(formula_id(colour[part], report.interpolation))};
        if (report.texture) {
            carried = append_painted(
                "vertex_light.",
                "The light of the vertices, interpolated and multiplied by the texture.", i,
                carried, report.texture->colour[i], report.formulas);
        }
        own[part] = {"ρ", {reflectance.value[i]}, reflectance.sources[part]};
    }
    append_shown_colour("vertex_light.colour.", by_vertex,
                        "The light of the vertices, interpolated. ", frame, report.formulas);
    append_shown_colour("flat.colour.", own,
                        "The surface's own colour, because this stage computes no light. ", frame,
                        report.formulas);
}

} // namespace

std::string formula_id(Quantity quantity, Interpolation way) {
    if (quantity == Quantity::zinv) return "zinv";
    const std::string id(quantity_info(quantity).words.id);
    if (way == Interpolation::perspective) return id + ".perspective";
    return id + "." + std::string(word_of(is_varying(quantity) ? way : Interpolation::affine));
}

namespace {

/// If w is not z, values are carried divided by w.
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
    std::optional<FragmentEvent> found;
    std::optional<Cursor> written_by; // the earlier writer of its pixel
    const Observer watch{.fragment = [&](const FragmentEvent& now) {
        if (now.cursor == cursor) {
            found = now;
        } else if (now.fate == Fate::written && !found) {
            written_by = now.cursor;
        }
    }};
    Cursor after = cursor;
    ++after.step;
    EventSource(frame).play({cursor_begin, after, only_pixel(report.pixel)}, watch);
    if (!found) return std::nullopt;
    const FragmentEvent& event = *found;
    report.fragment = event.fragment;
    report.depth = event.depth;
    report.stored = event.stored;
    report.has_cell = has_depth_cell(frame.stages, report.pixel.x, report.pixel.y, size);
    if (report.has_cell) report.stored_by = written_by;
    report.fate = event.fate;
    report.before = event.before;
    report.after = event.after;

    const PixelRules rules = pixel_rules(frame);
    report.interpolation = frame.settings.interpolation;
    report.shading = rules.shading;
    report.depth_test = depth_rule(frame.settings);
    const Surface surface = surface_of(frame, cursor.triangle);
    report.colour = frame.stages.pixel_shader(report.fragment, surface, rules, frame.stages);
    report.alpha = event.alpha;
    report.texture_alpha = surface.texture_alpha;

    Carried carried;
    for (const Interpolation way : all_interpolations) {
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
    add_blend(report, frame);
    if (vertex_rules(frame.settings, frame.scene->space).projection.mix > 0.0f)
        say_w_for_z(report.formulas);
    return report;
}

std::optional<Cursor> fragment_on_pixel(const Frame& frame, const glm::ivec2& pixel,
                                        const Cursor& moment) {
    const Viewport size = frame.settings.viewport;
    const bool inside =
        pixel.x >= 0 && pixel.x < size.width && pixel.y >= 0 && pixel.y < size.height;
    if (!inside || !has_fragments(frame.settings.stage)) return std::nullopt;
    std::optional<Cursor> last;
    const Observer keep_written{.fragment = [&](const FragmentEvent& event) {
        if (event.fate == Fate::written) last = event.cursor;
    }};
    const EventSource source(frame);
    source.play({cursor_begin, moment, only_pixel(pixel)}, keep_written);
    if (!last) source.play({moment, cursor_end, only_pixel(pixel)}, keep_written);
    return last;
}

} // namespace rasterwalk
