#include "cli/commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <ostream>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/error.h"
#include "base/numbers.h"
#include "cli/formula_report.h"
#include "cli/spaces_report.h"
#include "cli/triangle_json.h"
#include "explain/order_formulas.h"
#include "explain/vertex_report.h"
#include "inspect/coverage_comparison.h"
#include "inspect/shared_edge.h"
#include "inspect/triangle_report.h"
#include "pipeline/draw_cost.h"
#include "session/moments.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

int parse_triangle(const std::string& text, const Scene& scene) {
    const int count = scene.triangle_count();
    const std::string range =
        count == 0   ? "the scene has no triangles."
        : count == 1 ? "the scene has only triangle 0."
                     : fmt::format("the {} has triangles 0 to {}.",
                                   scene.sources.empty() ? "scene" : "drawn list", count - 1);
    // A number may be quoted with blanks before it.
    const std::string number = text.substr(std::min(text.find_first_not_of(' '), text.size()));
    int triangle = 0;
    const auto [end, fault] =
        std::from_chars(number.data(), number.data() + number.size(), triangle);
    const bool is_number = end == number.data() + number.size() && !number.empty() &&
                           fault != std::errc::invalid_argument;
    if (!is_number) {
        throw UsageError(fmt::format("'{}' is not the number of a triangle: {}", number, range));
    }
    if (fault != std::errc{} || triangle < 0 || triangle >= count) {
        throw UsageError(fmt::format("there is no triangle {}: {}", number, range));
    }
    return triangle;
}

/// One line of the vertices: a number for each, or a dash if a vertex has none.
template <class Value>
void print_vertex_line(std::ostream& out, const char* space, std::string_view axis,
                       const TriangleReport& report, bool (*has)(const ShadedVertex&),
                       Value value) {
    out << fmt::format("  {:<14} {:<6}", space, axis);
    for (const ShadedVertex& vertex : report.vertices)
        out << fmt::format(" {:>13}", has(vertex) ? value(vertex) : "-");
    out << '\n';
}

/// The space between the world and camera space.
const char* moved_name(CameraMove move) {
    switch (move) {
    case CameraMove::subtracted:
        break;
    case CameraMove::added:
        return "plus camera";
    case CameraMove::rotated_first:
        return "v R";
    }
    return "minus camera";
}

void print_vertices(std::ostream& out, const TriangleReport& report, const Frame& frame) {
    const bool is_projected_scene = frame.scene->space == SceneSpace::world;
    const auto always = [](const ShadedVertex&) { return true; };
    const auto has_pixel = [](const ShadedVertex& v) { return v.rejection == Rejection::none; };
    const auto number = [](float value) { return decimals(static_cast<double>(value), 4); };
    const auto print_vector = [&](const char* space, std::string_view of) {
        const std::array<const char*, 3> axes{"x", "y", "z"};
        for (int i = 0; i < 3; ++i) {
            print_vertex_line(out, i == 0 ? space : "", axes[static_cast<std::size_t>(i)], report,
                              always, [&](const ShadedVertex& v) { return number(v.in(of)[i]); });
        }
    };
    out << fmt::format("{:<23}", "Vertices");
    for (std::size_t v = 0; v < report.vertices.size(); ++v)
        out << fmt::format(" {:>13}", vertex_name(static_cast<int>(v)));
    out << '\n';
    print_vector(is_projected_scene ? "world" : "given", "world");
    if (is_projected_scene) {
        print_vector(moved_name(camera_move_rule(frame.settings)), "minus_camera");
        print_vector("rotated", "rotated");
        print_vertex_line(out, "projected", "x", report, is_projected,
                          [&](const ShadedVertex& v) { return number(v.in("projected").x); });
        print_vertex_line(out, "", "y", report, is_projected,
                          [&](const ShadedVertex& v) { return number(v.in("projected").y); });
    }
    print_vertex_line(out, "pixel", "column", report, has_pixel,
                      [](const ShadedVertex& v) { return std::to_string(v.pixel.column); });
    print_vertex_line(out, "", "row", report, has_pixel,
                      [](const ShadedVertex& v) { return std::to_string(v.pixel.row); });
    print_vertex_line(out, "", weight_name(frame), report, has_pixel, [](const ShadedVertex& v) {
        return decimals(static_cast<double>(v.pixel.inv_w), 6);
    });
    if (depth_kind(frame) == ClipDepth::inv_z) return;
    print_vertex_line(
        out, "", depth_words(frame).short_name, report, has_pixel,
        [](const ShadedVertex& v) { return decimals(static_cast<double>(v.pixel.depth), 6); });
}

/// Nothing if no plane cuts and nothing culls.
void print_clipping(std::ostream& out, const ClipHistory& clip) {
    if (!clip.planes.empty()) out << "\nClipping\n";
    for (const PlaneHistory& plane : clip.planes) {
        out << fmt::format("  {}: {} corners before, {} after\n",
                           plane_name(static_cast<int>(plane.plane)), plane.before.size(),
                           plane.after.size());
        for (const ClipStep& step : plane.steps)
            out << fmt::format("    {}: {}\n", edge_name(step.from), clip_step_text(step));
    }
    if (!clip.planes.empty() && !clip.polygon.empty())
        out << fmt::format("  drawn as {}\n", counted(static_cast<std::int64_t>(clip.fan.size()),
                                                      "triangle", "triangles"));
    if (!clip.cull.reason.empty() || clip.cull.is_back)
        out << "\nCulling\n  " << culling_text(clip.cull) << '\n';
}

/// The work of the stages for the whole triangle.
void print_cost(std::ostream& out, const DrawCost& cost) {
    out << "\nCost\n";
    for (const CostInfo& info : cost_list()) {
        if (info.is_of_triangle)
            out << fmt::format("  {:<18} {:>9}\n", info.title, cost.*info.count);
    }
}

void print_edges(std::ostream& out, const TriangleReport& report) {
    out << "\nEdges\n";
    for (std::size_t e = 0; e < report.edges.size(); ++e) {
        const EdgeReport& edge = report.edges[e];
        out << fmt::format("  {} from ({},{}) to ({},{}): {}", edge_name(static_cast<int>(e)),
                           edge.from.column, edge.from.row, edge.to.column, edge.to.row,
                           counted(edge.count, "sample", "samples"));
        if (static_cast<int>(edge.samples.size()) < edge.count)
            out << fmt::format(", {} of them so far", edge.samples.size());
        out << '\n';
    }
    out << "\nSamples outside the row table: " << report.rows.outside.size() << '\n';
    for (const OutsideSample& sample : report.rows.outside) {
        out << fmt::format("  {} at ({}, {}) falls in row {}; it is not written\n",
                           sample_name(sample.edge, sample.sample), nine_digits(sample.x),
                           nine_digits(sample.y), sample.row);
    }
}

/// "e1/s3", and how many earlier samples were replaced.
std::string writer_text(const EndWriter& end) {
    if (!end.is_set()) return "-";
    if (end.replaced == 0) return fmt::format("e{}/s{}", end.edge, end.sample);
    return fmt::format("e{}/s{} ({} replaced)", end.edge, end.sample, end.replaced);
}

void print_rows(std::ostream& out, const RowHistory& history, const Stages& stages) {
    out << fmt::format("\n{:<6} {:>10} {:>10} {:>7}   {:<22} {}\n", "Rows", "left", "right",
                       "count", "left by", "right by");
    for (int i = 0; i < history.rows.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool is_empty = history.rows.left[at].column == empty_left &&
                              history.rows.right[at].column == empty_right;
        const auto end = [&](int column, const char* empty) {
            return is_empty ? std::string(empty) : std::to_string(column);
        };
        out << fmt::format("{:>6} {:>10} {:>10} {:>7}   {:<22} {}\n", history.rows.first_row + i,
                           end(history.rows.left[at].column, "+INT_MAX"),
                           end(history.rows.right[at].column, "-INT_MAX"),
                           row_span(stages, history.rows, i).count,
                           writer_text(history.left_by[at]), writer_text(history.right_by[at]));
    }
}

/// Nothing if the triangle belongs to no polygon of the scene.
void print_polygon(std::ostream& out, const std::optional<CoverageComparison>& comparison) {
    if (!comparison) return;
    const auto pixels = [](std::int64_t count) { return counted(count, "pixel", "pixels"); };
    out << fmt::format("\nPolygon of {} corners, {} square pixels\n", comparison->corners,
                       comparison->area)
        << fmt::format("  inside, by active edges: {}\n", pixels(comparison->inside))
        << fmt::format("  row table: {}; {} of {} reach outside\n", pixels(comparison->table),
                       comparison->wrong_rows, counted(comparison->rows, "row", "rows"))
        << fmt::format("  fan: {}, covered {} times in all; {} square pixels\n",
                       pixels(comparison->fan), comparison->fan_writes, comparison->fan_area);
}

/// Nothing if the triangle shares no edge, or no fill rule is used.
void print_shared_edges(std::ostream& out, const Frame& frame, int triangle) {
    const std::vector<SharedEdge> all = shared_edges(frame, triangle);
    if (all.empty()) return;
    out << "\nShared edges\n";
    for (const SharedEdge& shared : all) {
        out << fmt::format("  {}, {} of {}\n", edge_name(shared.edge),
                           edge_name(shared.neighbour_edge), triangle_name(shared.neighbour));
        for (const EdgeByRule& by_rule : count_by_rules(frame, shared)) {
            out << fmt::format(
                "    {:<10} {} drawn twice, {}\n", fmt::format("{}:", word_of(by_rule.rule)),
                counted(by_rule.twice, "pixel", "pixels"), counted(by_rule.holes, "hole", "holes"));
        }
    }
}

void print_text(std::ostream& out, const TriangleReport& report, const Frame& frame) {
    const Scene& scene = *frame.scene;
    out << element_name_of(triangle_form, report.triangle, scene.triangle_count()) << " ("
        << part_words(scene, report.triangle) << ")\n\n";
    print_vertices(out, report, frame);
    print_clipping(out, report.clip);
    if (report.rejection != Rejection::none) {
        out << "\nIt is left out: " << words(report.rejection).sentence << ".\n";
        return;
    }
    print_cost(out, triangle_cost(frame, report.triangle));
    print_edges(out, report);
    print_rows(out, report.rows, frame.stages);
    print_polygon(out, coverage_comparison(frame, report.triangle));
    print_shared_edges(out, frame, report.triangle);
}

} // namespace

void triangle_command(const TriangleOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Frame frame = shown_frame(session);
    const int triangle = parse_triangle(options.triangle, *frame.scene);
    const TriangleReport report =
        triangle_report(frame, triangle, in_frame(session.cursor, frame.pass));
    std::vector<VertexReport> vertices;
    for (int v = 0; options.formulas && v < triangle_corners; ++v)
        vertices.push_back(vertex_report(frame, triangle, v));
    std::vector<Formula> order;
    if (options.formulas) order = order_formulas(frame, triangle);
    if (options.json) {
        Json answer = to_json(report, frame);
        for (const VertexReport& vertex : vertices)
            answer["formulas"].push_back(
                {{"formulas", formulas_json(vertex.formulas)}, {"vertex", vertex.vertex}});
        if (!order.empty()) answer["order"] = formulas_json(order);
        print_json(answer, out);
        return;
    }
    print_text(out, report, frame);
    if (!order.empty()) out << '\n';
    print_formulas(out, order);
    for (const VertexReport& vertex : vertices) {
        out << '\n' << vertex_name(vertex.vertex) << '\n';
        print_formulas(out, vertex.formulas);
    }
    if (!has_spaces(frame)) return;
    print_spaces(out, frame, triangle);
    print_conventions(out, frame, triangle);
}

} // namespace rasterwalk
