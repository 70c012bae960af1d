#include "cli/commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <ostream>

#include "base/error.h"
#include "cli/json.h"
#include "cli/row_json.h"
#include "inspect/triangle_report.h"
#include "session/moments.h"

namespace rasterwalk {

namespace {

int parse_triangle(const std::string& text, const Scene& scene) {
    const int count = static_cast<int>(scene.triangles.size());
    const std::string range =
        count == 0   ? "the scene has no triangles."
        : count == 1 ? "the scene has only the triangle 0."
                     : "the scene has the triangles 0 to " + std::to_string(count - 1) + ".";
    // A number may be quoted with blanks before it.
    const std::string number = text.substr(std::min(text.find_first_not_of(' '), text.size()));
    int triangle = 0;
    const auto [end, fault] =
        std::from_chars(number.data(), number.data() + number.size(), triangle);
    const bool is_number = end == number.data() + number.size() && !number.empty() &&
                           fault != std::errc::invalid_argument;
    if (!is_number) {
        throw UsageError("'" + number + "' is not the number of a triangle: " + range);
    }
    if (fault != std::errc{} || triangle < 0 || triangle >= count) {
        throw UsageError("there is no triangle " + number + ": " + range);
    }
    return triangle;
}

template <class... Values>
std::string printed(const char* format, Values... values) {
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

// JSON

bool is_projected(const ShadedVertex& vertex) {
    return vertex.rejection == Rejection::none || vertex.rejection == Rejection::too_far_out;
}

Json to_json(const ShadedVertex& vertex) {
    Json object{{"fault", words(vertex.rejection).name},
                {"minus_camera", vector_to_json(vertex.in("minus_camera"))}};
    const bool has_pixel = vertex.rejection == Rejection::none;
    if (has_pixel) object["pixel"] = {vertex.pixel.column, vertex.pixel.row};
    if (is_projected(vertex)) {
        object["projected"] = {vertex.in("projected").x, vertex.in("projected").y};
    }
    object["rotated"] = vector_to_json(vertex.in("rotated"));
    object["world"] = vector_to_json(vertex.in("world"));
    if (has_pixel) object["zinv"] = vertex.pixel.inv_w;
    return object;
}

Json to_json(const EdgeSample& step) {
    return {{"column", step.fragment.column},
            {"row", step.fragment.row},
            {"sample", step.sample},
            {"wrote", write_name(step.write)},
            {"x", step.x},
            {"y", step.y}};
}

Json to_json(const EdgeReport& edge, int number) {
    Json samples = Json::array();
    for (const EdgeSample& step : edge.samples)
        samples.push_back(to_json(step));
    return {{"count", edge.count},
            {"edge", number},
            {"from", {edge.from.column, edge.from.row}},
            {"samples", std::move(samples)},
            {"to", {edge.to.column, edge.to.row}}};
}

Json to_json(const TriangleReport& report, const Scene& scene) {
    Json vertices = Json::array(), edges = Json::array();
    for (const ShadedVertex& vertex : report.vertices)
        vertices.push_back(to_json(vertex));
    if (report.rejection == Rejection::none) {
        for (std::size_t e = 0; e < report.edges.size(); ++e)
            edges.push_back(to_json(report.edges[e], static_cast<int>(e)));
    }
    return {{"edges", std::move(edges)},
            {"left_out", words(report.rejection).name},
            {"name", part_name(scene, report.triangle)},
            {"outside", outside_json(report.rows)},
            {"rows", rows_json(report.rows)},
            {"triangle", report.triangle},
            {"vertices", std::move(vertices)}};
}

// Text

/// One line of the vertices: a number of each, or a dash where a vertex has none.
template <class Value>
void print_vertex_line(std::ostream& out, const char* space, const char* axis,
                       const TriangleReport& report, bool (*has)(const ShadedVertex&),
                       Value value) {
    out << printed("  %-14s %-6s", space, axis);
    for (const ShadedVertex& vertex : report.vertices)
        out << (has(vertex) ? value(vertex) : printed(" %13s", "-"));
    out << '\n';
}

void print_vertices(std::ostream& out, const TriangleReport& report, bool is_projected_scene) {
    const auto always = [](const ShadedVertex&) { return true; };
    const auto has_pixel = [](const ShadedVertex& v) { return v.rejection == Rejection::none; };
    const auto number = [](float value) { return printed(" %13.4f", static_cast<double>(value)); };
    const auto print_vector = [&](const char* space, std::string_view of) {
        const std::array<const char*, 3> axes{"x", "y", "z"};
        for (int i = 0; i < 3; ++i) {
            print_vertex_line(out, i == 0 ? space : "", axes[static_cast<std::size_t>(i)], report,
                              always, [&](const ShadedVertex& v) { return number(v.in(of)[i]); });
        }
    };
    out << printed("%-23s", "Vertices");
    for (std::size_t v = 0; v < report.vertices.size(); ++v)
        out << printed(" %13s", ("v" + std::to_string(v)).c_str());
    out << '\n';
    print_vector(is_projected_scene ? "world" : "given", "world");
    if (is_projected_scene) {
        print_vector("minus camera", "minus_camera");
        print_vector("rotated", "rotated");
        print_vertex_line(out, "projected", "x", report, is_projected,
                          [&](const ShadedVertex& v) { return number(v.in("projected").x); });
        print_vertex_line(out, "", "y", report, is_projected,
                          [&](const ShadedVertex& v) { return number(v.in("projected").y); });
    }
    print_vertex_line(out, "pixel", "column", report, has_pixel,
                      [](const ShadedVertex& v) { return printed(" %13d", v.pixel.column); });
    print_vertex_line(out, "", "row", report, has_pixel,
                      [](const ShadedVertex& v) { return printed(" %13d", v.pixel.row); });
    print_vertex_line(out, "", "1/z", report, has_pixel, [](const ShadedVertex& v) {
        return printed(" %13.6f", static_cast<double>(v.pixel.inv_w));
    });
}

void print_edges(std::ostream& out, const TriangleReport& report) {
    out << "\nEdges\n";
    for (std::size_t e = 0; e < report.edges.size(); ++e) {
        const EdgeReport& edge = report.edges[e];
        out << "  e" << e << " from (" << edge.from.column << ',' << edge.from.row << ") to ("
            << edge.to.column << ',' << edge.to.row << "): " << edge.count
            << (edge.count == 1 ? " sample" : " samples");
        if (static_cast<int>(edge.samples.size()) < edge.count)
            out << ", " << edge.samples.size() << " of them so far";
        out << '\n';
    }
    out << "\nSamples outside the row table: " << report.rows.outside.size() << '\n';
    for (const OutsideSample& sample : report.rows.outside) {
        out << "  e" << sample.edge << "/s" << sample.sample << " at "
            << printed("(%.9g, %.9g)", static_cast<double>(sample.x), static_cast<double>(sample.y))
            << " falls in row " << sample.row << "; it is not written\n";
    }
}

/// "e1/s3", and how often someone else's sample had to go for it.
std::string writer_text(const EndWriter& end) {
    if (!end.is_set()) return "-";
    std::string text = printed("e%d/s%d", end.edge, end.sample);
    if (end.replaced > 0) text += printed(" (%d replaced)", end.replaced);
    return text;
}

void print_rows(std::ostream& out, const RowHistory& history) {
    out << printed("\n%-6s %10s %10s %7s   %-22s %s\n", "Rows", "left", "right", "count", "left by",
                   "right by");
    for (int i = 0; i < history.rows.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool is_empty = history.rows.left[at].column == empty_left &&
                              history.rows.right[at].column == empty_right;
        const auto end = [&](int column, const char* empty) {
            return is_empty ? std::string(empty) : std::to_string(column);
        };
        out << printed("%6d %10s %10s %7d   %-22s %s\n", history.rows.left[at].row,
                       end(history.rows.left[at].column, "+INT_MAX").c_str(),
                       end(history.rows.right[at].column, "-INT_MAX").c_str(),
                       history.rows.pixel_count(i), writer_text(history.left_by[at]).c_str(),
                       writer_text(history.right_by[at]).c_str());
    }
}

void print_text(std::ostream& out, const TriangleReport& report, const Scene& scene) {
    out << "Triangle " << report.triangle << " (" << part_name(scene, report.triangle)
        << "), counted from 0, one of " << scene.triangles.size() << "\n\n";
    print_vertices(out, report, scene.space == SceneSpace::world);
    if (report.rejection != Rejection::none) {
        out << "\nIt is left out: " << words(report.rejection).sentence << ".\n";
        return;
    }
    print_edges(out, report);
    print_rows(out, report.rows);
}

} // namespace

void triangle_command(const TriangleOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Scene& scene = *session.scene;
    const int triangle = parse_triangle(options.triangle, scene);
    const Frame frame = prepare_frame(scene, session.a.settings);
    const TriangleReport report = triangle_report(frame, triangle, session.cursor);
    if (options.json) {
        print_json(to_json(report, scene), out);
    } else {
        print_text(out, report, scene);
    }
}

} // namespace rasterwalk
