#include <algorithm>
#include <climits>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "base/element_names.h"
#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "pipeline/frame.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

using Rows = std::vector<PrintedRow>;

/// In larger scenes only the first triangles are examined: at most this many, with at most this
/// many rows in all to compare with the table.
constexpr int most_triangles_tried = 2000;
constexpr std::size_t most_rows_held = 10'000'000;

std::uint64_t fingerprint(const Rows& rows) {
    std::uint64_t hash = 14695981039346656037u;
    for (const PrintedRow& row : rows) {
        for (const int value : {row.start.x, row.start.y, row.end.x, row.end.y}) {
            hash = (hash ^ static_cast<std::uint32_t>(value)) * 1099511628211u;
        }
    }
    return hash;
}

/// A polygon that the table may belong to: its vertices, or a triangle of the scene.
struct TablePolygon {
    std::vector<ScreenVertex> vertices;
    int triangle = -1;
    std::string about;
};

TablePolygon polygon_of(const std::vector<glm::ivec2>& points) {
    TablePolygon polygon;
    polygon.about = "the polygon";
    for (const glm::ivec2& point : points) {
        ScreenVertex vertex;
        vertex.column = point.x;
        vertex.row = point.y;
        vertex.depth = vertex.inv_w = vertex.z = 1.0f;
        polygon.vertices.push_back(vertex);
        polygon.about += fmt::format(" ({},{})", point.x, point.y);
    }
    return polygon;
}

/// The row table of a polygon under these settings; nothing if the triangle is left out.
Rows table_of(const TablePolygon& polygon, const Scene& scene, const Settings& settings) {
    PolygonRows table;
    if (polygon.triangle < 0) {
        const Stages stages = choose_stages(settings);
        stages.compute_polygon_rows(polygon.vertices, edge_rules(settings), stages, table, nullptr);
        return printed(table);
    }
    Scene one = {};
    one.space = scene.space;
    one.mesh.add_triangle_of(corners_of(scene, polygon.triangle));
    const Frame frame = prepare_frame(one, settings);
    if (!frame.is_drawn(0)) return {};
    compute_rows(frame, 0, table);
    return printed(table);
}

/// The polygon whose table comes nearest under the reference's rules.
TablePolygon nearest_polygon(const Rows& rows, const Scene& scene, const Settings& reference) {
    TablePolygon nearest = polygon_of({{10, 5}, {5, 10}, {15, 15}});
    double smallest = rows_distance(table_of(nearest, scene, reference), rows).mean;
    const Frame frame = prepare_frame(scene, reference);
    const std::size_t fitting = most_rows_held / std::max<std::size_t>(rows.size(), 1);
    const int tried = static_cast<int>(std::min<std::size_t>(most_triangles_tried, fitting));
    const int count = std::min(frame.triangle_count(), tried);
    for (int t = 0; t < count; ++t) {
        if (!frame.is_drawn(t)) continue;
        const TablePolygon polygon{
            {}, t, fmt::format("{} ({})", triangle_name(t), part_name(scene, t))};
        PolygonRows table;
        compute_rows(frame, t, table);
        const double distance = rows_distance(printed(table), rows).mean;
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = polygon;
    }
    return nearest;
}

/// A way in which a right table may still have come out wrong.
struct RowsEdit {
    const char *id, *name;
    void (*apply)(Rows&);
};

template <class Change>
void for_each_end(Rows& rows, Change change) {
    for (PrintedRow& row : rows) {
        change(row.start);
        change(row.end);
    }
}

/// The ends of rows that no sample reached stay unchanged.
void move_column(int& column, int by) {
    if (std::abs(column) != INT_MAX) column += by;
}

const std::vector<RowsEdit>& rows_edits() {
    static const std::vector<RowsEdit> edits{
        {"last_column_dropped", "The last column of every row is missing",
         [](Rows& rows) {
             for (PrintedRow& row : rows)
                 move_column(row.end.x, -1);
         }},
        {"ends_exchanged", "Left and right ends are swapped",
         [](Rows& rows) {
             for (PrintedRow& row : rows)
                 std::swap(row.start.x, row.end.x);
         }},
        {"axes_exchanged", "Column and row are printed in the wrong order",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { std::swap(end.x, end.y); }); }},
        {"last_row_dropped", "The last row is missing",
         [](Rows& rows) {
             if (!rows.empty()) rows.pop_back();
         }},
        {"first_row_dropped", "The first row is missing",
         [](Rows& rows) {
             if (!rows.empty()) rows.erase(rows.begin());
         }},
        {"rows_from_zero", "Rows are counted from the top of the polygon",
         [](Rows& rows) {
             const int first = rows.empty() ? 0 : rows.front().start.y;
             for_each_end(rows, [&](glm::ivec2& end) { end.y -= first; });
         }},
        {"shifted_left", "Shifted one column to the left",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { move_column(end.x, -1); }); }},
        {"shifted_right", "Shifted one column to the right",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { move_column(end.x, 1); }); }},
        {"shifted_up", "Shifted up one row",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { --end.y; }); }},
        {"shifted_down", "Shifted down one row",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { ++end.y; }); }},
    };
    return edits;
}

} // namespace

Diagnosis diagnose_rows(const std::vector<PrintedRow>& rows, const std::vector<glm::ivec2>& polygon,
                        const Scene& scene, Settings reference, const std::vector<Bug>& bugs,
                        std::string& about) {
    reference.tessellation = 1; // the table is one of the scene's own triangles
    const TablePolygon subject =
        polygon.empty() ? nearest_polygon(rows, scene, reference) : polygon_of(polygon);
    about = subject.about;
    const Rows right = table_of(subject, scene, reference);
    const std::uint64_t right_print = fingerprint(right);
    Diagnosis diagnosis;
    const RowsDistance apart = rows_distance(right, rows);
    diagnosis.distance = apart.mean;
    diagnosis.different = apart.different;
    diagnosis.place = first_different_row(right, rows);
    std::vector<Hypothesis> hypotheses;
    const auto add = [&](const std::string& id, const std::string& name, const Rows& table) {
        Hypothesis hypothesis;
        hypothesis.result = fingerprint(table);
        if (hypothesis.result == right_print) return;
        const RowsDistance distance = rows_distance(table, rows);
        Candidate& candidate = hypothesis.candidate;
        candidate.mistakes = {{{id}, {name}}};
        candidate.distance = distance.mean;
        candidate.different = distance.different;
        candidate.explained = std::clamp(1.0 - distance.mean / apart.mean, 0.0, 1.0);
        // Rows are few: at most one in a hundred of those that differed may still differ.
        candidate.is_likely = static_cast<double>(distance.different) <=
                              (1.0 - explains_nearly_all) * static_cast<double>(apart.different);
        hypothesis.price = distance.mean;
        hypothesis.assumed = 1.0;
        hypothesis.is_of_bugs = is_bug_id(id);
        hypotheses.push_back(std::move(hypothesis));
    };
    if (!diagnosis.is_same()) {
        for (const Bug& bug : bugs) {
            if (!changes_rule(bug)) continue;
            Settings settings = reference;
            apply_bug_rule(bug, settings);
            add(bug.id, bug.name, table_of(subject, scene, settings));
        }
        for (const Setting& setting : setting_table()) {
            const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
            if (choice == nullptr || !setting.ties.part_of.empty()) continue;
            for (const std::string_view word : choice->words) {
                Settings settings = reference;
                set_value(settings, setting, word);
                const std::string id = fmt::format("{}={}", setting.name, word);
                add(id, "Made by " + id, table_of(subject, scene, settings));
            }
        }
        for (const RowsEdit& edit : rows_edits()) {
            Rows edited = right;
            edit.apply(edited);
            add(edit.id, edit.name, edited);
        }
    }
    diagnosis.candidates = ranked(std::move(hypotheses));
    diagnosis.verdict = verdict_on(diagnosis);
    return diagnosis;
}

} // namespace rasterwalk
