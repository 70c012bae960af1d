#include "explain/fragment_report.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/depth_formulas.h"
#include "explain/highlight_formulas.h"
#include "explain/light_formulas.h"
#include "explain/value_formulas.h"
#include "explain/vertex_report.h"
#include "inspect/pixel_history.h"
#include "pipeline/event_source.h"
#include "pipeline/surface.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

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
/// @param id of the vertex's formulas, without the names of the components
SourcedVector of_first_vertex(int triangle, const glm::vec3& value, const std::string& id,
                              const std::array<const char*, 3>& names) {
    SourcedVector vector{value, {}};
    for (std::size_t i = 0; i < names.size(); ++i)
        vector.sources[i] = from_vertex(triangle, 0, id + "." + names[i]);
    return vector;
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

/// How a height map shifts the fragment's place in its maps.
void add_parallax(const Frame& frame, const Surface& surface, const LitPoint& point,
                  FragmentReport& report) {
    report.parallax = parallax_report(report.fragment, surface, frame);
    if (!report.parallax) return;
    append_parallax_formulas(
        *report.parallax, frame, report.cursor.triangle, point.normal, point.position,
        formula_id(quantity_of(&Varyings::texcoord, 0), report.interpolation),
        formula_id(quantity_of(&Varyings::texcoord, 1), report.interpolation), report.formulas);
}

/// The light at the fragment's own position, and before it what the fragment takes from its maps.
/// @return the reflectance there, interpolated if the corners' differ
SourcedVector add_pixel_light(const Frame& frame, FragmentReport& report) {
    const int triangle = report.cursor.triangle;
    const Surface surface = lit_surface_of(frame, triangle);
    const PixelRules rules = pixel_rules(frame);
    const glm::vec3 unbent =
        surface_point(report.fragment, surface, rules.camera, frame.stages).normal;
    LitPoint point;
    point.prefix = "pixel_light.";
    point.position = interpolated(report, &Varyings::position_world, "");
    point.normal = of_first_vertex(triangle, unbent, light_normal_id(frame.settings), axis_names);
    if (surface.differences.normals) {
        append_normal_formulas(
            point,
            interpolated(report, &Varyings::normal, "the normals of the vertices, interpolated"),
            frame, report.formulas);
    }
    add_parallax(frame, surface, point, report);
    add_texture(frame, report);
    const SurfacePoint place = lit_point(report.fragment, surface, rules, frame.stages);
    if (surface.normal_map != nullptr)
        report.bump = bump_report(report.fragment, surface, unbent, frame);
    report.normal = place.normal;
    point.shine = place.shine;
    point.light = report.light =
        surface_light(place, rules.light, rules.rays, rules.occluders, frame.stages);
    point.reflectance = of_first_vertex(triangle, place.reflectance, "reflectance", channel_names);
    if (surface.differences.colours)
        point.reflectance =
            interpolated(report, &Varyings::colour, "the colours of the vertices, interpolated");
    if (report.texture) {
        point.reflectance.value = place.reflectance;
        for (std::size_t i = 0; i < 3; ++i)
            point.reflectance.sources[i] = from_formula(std::string("surface.") + channel_names[i]);
    }
    const SourcedVector flat_normal = point.normal;
    if (report.bump) append_bump_formulas(*report.bump, frame, triangle, point, report.formulas);
    append_side_formulas(point, flat_normal, frame, report.formulas);
    append_light_formulas(point, frame, report.formulas);
    return point.reflectance;
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
    FormulaWriter write(report.formulas, point.prefix);
    const auto mean_of = [&](glm::vec3 Vertex::*member, const glm::vec3& value,
                             const std::string& symbol, const std::string& vertex_id,
                             const std::array<const char*, 3>& names) {
        SourcedVector vector{value, {}};
        for (int i = 0; i < 3; ++i) {
            const std::string name = names[static_cast<std::size_t>(i)];
            FormulaInputs inputs;
            for (int v = 0; v < triangle_corners; ++v) {
                inputs.push_back({std::string(1, static_cast<char>('a' + v)),
                                  {(frame.scene->corner(triangle, v).*member)[i]},
                                  from_vertex(triangle, v, vertex_id + "." + name)});
            }
            const std::string id = symbol + "." + name;
            write.add(id, id, "In the middle of the triangle, at the mean of its three corners.",
                      "(a + b + c) / 3", inputs, {value[i]});
            vector.sources[static_cast<std::size_t>(i)] = from_formula(point.prefix + id);
        }
        return vector;
    };
    point.position = mean_of(&Vertex::position, place.position_world, "p", "world", axis_names);
    point.reflectance = differs.colours ? mean_of(&Vertex::reflectance, place.reflectance,
                                                  "reflectance", "reflectance", channel_names)
                                        : of_first_vertex(triangle, place.reflectance,
                                                          "reflectance", channel_names);
    point.normal = of_first_vertex(triangle, flat_normal(frame, triangle),
                                   light_normal_id(frame.settings), axis_names);
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
        FormulaWriter write(report.formulas);
        const std::string id = formula_id(colour[part], report.interpolation);
        by_vertex[part] = write.input("R", id);
        Formula& light = write.formula(id);
        light.section = "vertex_light.reflected";
        light.label = "R " + channel_name(i);
        light.warns = light.result.value > 1.0f;
        if (report.texture) {
            FormulaWriter of_light = write.under("vertex_light.");
            by_vertex[part] = append_painted(
                of_light, "The light of the vertices, interpolated and multiplied by the texture.",
                i, by_vertex[part], report.texture->colour[i]);
        }
        own[part] = reflectance.part("ρ", i);
    }
    append_shown_colour("vertex_light.colour.", by_vertex,
                        "The light of the vertices, interpolated. ", frame, report.formulas);
    append_shown_colour("flat.colour.", own,
                        "The surface's own colour, because this stage computes no light. ", frame,
                        report.formulas);
}

/// What was tested at one of the samples, and what becomes of all of them.
void add_samples(const Frame& frame, FragmentReport& report) {
    const TestedPolygon& polygon = report.row.tested[static_cast<std::size_t>(
        frame.settings.interpolation == Interpolation::perspective ? Interpolation::perspective
                                                                   : Interpolation::affine)];
    const GridPoint& place = polygon.samples[static_cast<std::size_t>(report.sample())];
    const int column = report.pixel.x, row = report.pixel.y;
    const Fragment at_sample =
        weighted_fragment(polygon, triangle_of_point(polygon, column, row, place), column, row,
                          place, frame.stages, {});
    report.tested = frame.stages.fragment_at_sample(report.fragment, at_sample);
    const Observer keep{.resolve = [&](const ResolveEvent& event) { report.resolve = event; }};
    EventSource(frame).play({moment_of_resolve(0, 0), cursor_end, only_pixel(report.pixel)}, keep);
}

} // namespace

std::string formula_id(Quantity quantity, Interpolation mode) {
    if (quantity == Quantity::zinv) return "zinv";
    const std::string id(quantity_info(quantity).words.id);
    if (mode == Interpolation::perspective) return id + ".perspective";
    return id + "." + std::string(word_of(is_varying(quantity) ? mode : Interpolation::affine));
}

std::string_view light_in_use(Shading shading) {
    switch (shading) {
    case Shading::unlit:
        return "flat";
    case Shading::flat:
        return "triangle_light";
    case Shading::gouraud:
        return "vertex_light";
    case Shading::phong:
        break;
    }
    return "pixel_light";
}

bool is_fragment_formula(std::string_view id) {
    constexpr std::array<std::string_view, 4> whole{"column", "zinv", "depth", "margin"};
    static const std::vector<std::string_view> first_parts = [] {
        std::vector<std::string_view> parts{
            "weight", "depth",       "blend",          "texture",      "surface",  "bump",
            "flat",   "pixel_light", "triangle_light", "vertex_light", "parallax", "resolve"};
        for (const QuantityInfo& info : quantity_list())
            parts.push_back(info.words.id);
        return parts;
    }();
    return is_possible_id(id, whole, first_parts);
}

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
    OfSamples<std::optional<Cursor>> written_by; // the earlier writers of its pixel
    const Observer watch{.fragment = [&](const FragmentEvent& now) {
        if (now.cursor == cursor) {
            found = now;
        } else if (now.fate == Fate::written && !found) {
            for (int sample = 0; sample < sample_count; ++sample) {
                const bool is_written = now.covered == 0 || has_sample(now.passed, sample);
                if (is_written) written_by[static_cast<std::size_t>(sample)] = now.cursor;
            }
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
    report.covered = event.covered;
    report.passed = event.passed;
    if (report.has_cell) report.stored_by = written_by[static_cast<std::size_t>(report.sample())];
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

    report.tested = report.fragment;
    if (frame.has_samples()) add_samples(frame, report);

    add_values(report, frame);
    add_light(frame, report);
    add_depth_test(report, frame);
    // With supersampling the colour is not that of the pixel's centre.
    if (sampling_rule(frame.settings) != Sampling::supersample) add_blend(report, frame);
    add_resolve(report, frame);
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
    const bool is_final = !last || moment_of_resolve(pixel.y, pixel.x) < moment;
    if (!last) source.play({moment, cursor_end, only_pixel(pixel)}, keep_written);
    if (!last || !is_final || !frame.has_samples()) return last;
    // The last one may have few of the samples.
    const PixelHistory history = pixel_history(source, pixel);
    if (history.winner < 0) return last; // nothing there can be seen
    return history.entries[static_cast<std::size_t>(history.winner)].cursor;
}

} // namespace rasterwalk
