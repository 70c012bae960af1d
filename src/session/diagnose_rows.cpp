#include <algorithm>
#include <charconv>
#include <climits>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "pipeline/frame.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "session/bug_rule.h"
#include "session/diagnose.h"
#include "session/setting_table.h"

namespace rasterwalk {

namespace {

using Rows = std::vector<PrintedRow>;

/// An end that is off by more counts as this far off: one wild number must not drown the others.
constexpr int most_columns_off = 16;

/// Of larger scenes only the first triangles are looked at.
constexpr int most_triangles_tried = 2000;

/// Takes text from the front.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : rest_(text) { skip_blanks(); }

    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        skip_blanks();
        return true;
    }
    std::optional<int> take_number() {
        int value = 0;
        const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (fault != std::errc{}) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        skip_blanks();
        return value;
    }
    std::optional<glm::ivec2> take_place() {
        if (!take("(")) return std::nullopt;
        const std::optional<int> column = take_number();
        if (!column || !take(",")) return std::nullopt;
        const std::optional<int> row = take_number();
        if (!row || !take(")")) return std::nullopt;
        return glm::ivec2(*column, *row);
    }
    bool is_done() const { return rest_.empty(); }

  private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size()));
    }
    std::string_view rest_;
};

std::optional<PrintedRow> parse_row(std::string_view line) {
    LineReader reader(line);
    if (!reader.take("Start:")) return std::nullopt;
    const std::optional<glm::ivec2> start = reader.take_place();
    if (!start || !reader.take(".") || !reader.take("End:")) return std::nullopt;
    const std::optional<glm::ivec2> end = reader.take_place();
    reader.take(".");
    if (!end || !reader.is_done()) return std::nullopt;
    return PrintedRow{*start, *end};
}

/// The rows as the lab prints them.
Rows printed(const PolygonRows& table) {
    Rows rows;
    rows.reserve(table.left.size());
    for (std::size_t i = 0; i < table.left.size(); ++i) {
        rows.push_back({{table.left[i].column, table.left[i].row},
                        {table.right[i].column, table.right[i].row}});
    }
    return rows;
}

struct RowsDistance {
    double mean = 0.0;          ///< columns, over all ends
    std::int64_t different = 0; ///< rows
};

int columns_off(int a, int b) {
    const std::int64_t apart = std::abs(static_cast<std::int64_t>(a) - b);
    return static_cast<int>(std::min<std::int64_t>(apart, most_columns_off));
}

/// How far two tables lie apart, line by line; of a table that is longer by a few lines at the top
/// or at the bottom, that stands where it fits.
RowsDistance rows_distance(const Rows& a, const Rows& b) {
    std::map<int, std::pair<const PrintedRow*, const PrintedRow*>> rows;
    std::int64_t sum = 0, different = 0, repeated = 0;
    for (const PrintedRow& row : a) {
        const bool is_new = rows[row.start.y].first == nullptr;
        rows[row.start.y].first = &row;
        repeated += is_new ? 0 : 1;
    }
    for (const PrintedRow& row : b) {
        const bool is_new = rows[row.start.y].second == nullptr;
        rows[row.start.y].second = &row;
        repeated += is_new ? 0 : 1;
    }
    for (const auto& [number, both] : rows) {
        if (both.first == nullptr || both.second == nullptr) {
            sum += 2 * most_columns_off;
            ++different;
            continue;
        }
        const PrintedRow &p = *both.first, &q = *both.second;
        sum += columns_off(p.start.x, q.start.x) + columns_off(p.end.x, q.end.x) +
               columns_off(p.end.y, q.end.y);
        different += p == q ? 0 : 1;
    }
    different += repeated;
    sum += 2 * most_columns_off * repeated;
    const auto ends = static_cast<double>(2 * std::max<std::size_t>(rows.size(), 1));
    return {static_cast<double>(sum) / ends, different};
}

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
struct Polygon {
    std::vector<Fragment> vertices;
    int triangle = -1;
    std::string about;
};

Polygon polygon_of(const std::vector<glm::ivec2>& points) {
    Polygon polygon;
    polygon.about = "the polygon";
    for (const glm::ivec2& point : points) {
        Fragment vertex;
        vertex.column = point.x;
        vertex.row = point.y;
        vertex.zinv = vertex.z = 1.0f;
        polygon.vertices.push_back(vertex);
        polygon.about.append(" (")
            .append(std::to_string(point.x))
            .append(",")
            .append(std::to_string(point.y))
            .append(")");
    }
    return polygon;
}

/// The row table of a polygon under these settings; nothing if the triangle is left out.
Rows table_of(const Polygon& polygon, const Scene& scene, const Settings& settings) {
    PolygonRows table;
    if (polygon.triangle < 0) {
        compute_polygon_rows(polygon.vertices, edge_rules(settings), table);
        return printed(table);
    }
    Scene one = {};
    one.space = scene.space;
    one.triangles.push_back(scene.triangles[static_cast<std::size_t>(polygon.triangle)]);
    const Frame frame = prepare_frame(one, settings);
    if (!frame.is_drawn(0)) return {};
    compute_polygon_rows(frame.triangle_vertices(0), edge_rules(settings), table);
    return printed(table);
}

/// The polygon whose table comes nearest under the reference's rules.
Polygon nearest_polygon(const Rows& rows, const Scene& scene, const Settings& reference) {
    Polygon nearest = polygon_of({{10, 5}, {5, 10}, {15, 15}});
    double smallest = rows_distance(table_of(nearest, scene, reference), rows).mean;
    const Frame frame = prepare_frame(scene, reference);
    const int count = std::min(frame.triangle_count(), most_triangles_tried);
    for (int t = 0; t < count; ++t) {
        if (!frame.is_drawn(t)) continue;
        const Polygon polygon{{},
                              t,
                              std::string("triangle ")
                                  .append(std::to_string(t))
                                  .append(" (")
                                  .append(part_name(scene, t))
                                  .append(")")};
        PolygonRows table;
        compute_polygon_rows(frame.triangle_vertices(t), edge_rules(reference), table);
        const double distance = rows_distance(printed(table), rows).mean;
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = polygon;
    }
    return nearest;
}

/// A way in which a right table may have come out wrong after all.
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

/// The ends of rows that no sample reached stay as they are.
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
        {"ends_exchanged", "Left and right ends are exchanged",
         [](Rows& rows) {
             for (PrintedRow& row : rows)
                 std::swap(row.start.x, row.end.x);
         }},
        {"axes_exchanged", "Column and row are exchanged in print",
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
        {"shifted_left", "Shifted by a column to the left",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { move_column(end.x, -1); }); }},
        {"shifted_right", "Shifted by a column to the right",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { move_column(end.x, 1); }); }},
        {"shifted_up", "Shifted up by a row",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { --end.y; }); }},
        {"shifted_down", "Shifted down by a row",
         [](Rows& rows) { for_each_end(rows, [](glm::ivec2& end) { ++end.y; }); }},
    };
    return edits;
}

} // namespace

std::vector<PrintedRow> parse_printed_rows(std::string_view text, const std::string& path) {
    std::vector<PrintedRow> rows;
    int number = 0;
    while (!text.empty()) {
        ++number;
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (!line.starts_with("Start")) continue;
        const std::optional<PrintedRow> row = parse_row(line);
        if (!row) {
            throw InputError(path, number,
                             "a row is printed as 'Start: (10,5). End: (10,5).' with whole "
                             "numbers.");
        }
        if (rows.size() == most_printed_rows) {
            throw InputError(path, number, "there are too many rows.");
        }
        rows.push_back(*row);
    }
    if (rows.empty()) {
        throw InputError(path + ": this is neither a PNG or BMP picture nor a printed row table: "
                                "there is no line like 'Start: (10,5). End: (10,5).'.");
    }
    return rows;
}

Diagnosis diagnose_rows(const std::vector<PrintedRow>& rows, const std::vector<glm::ivec2>& polygon,
                        const Scene& scene, const Settings& reference, const std::vector<Bug>& bugs,
                        std::string& about) {
    const Polygon subject =
        polygon.empty() ? nearest_polygon(rows, scene, reference) : polygon_of(polygon);
    about = subject.about;
    const Rows right = table_of(subject, scene, reference);
    const std::uint64_t right_print = fingerprint(right);
    Diagnosis diagnosis;
    const RowsDistance apart = rows_distance(right, rows);
    diagnosis.distance = apart.mean;
    diagnosis.different = apart.different;
    std::vector<Hypothesis> hypotheses;
    const auto add = [&](Hypothesis hypothesis, const Rows& table) {
        hypothesis.result = fingerprint(table);
        if (hypothesis.result == right_print) return;
        const RowsDistance distance = rows_distance(table, rows);
        hypothesis.distance = distance.mean;
        hypothesis.different = distance.different;
        hypotheses.push_back(std::move(hypothesis));
    };
    if (!diagnosis.is_same()) {
        for (const Bug& bug : bugs) {
            Settings settings = reference;
            apply_bug_rule(bug, settings);
            add({.id = bug.id, .name = bug.name, .is_bug = true},
                table_of(subject, scene, settings));
        }
        for (const Setting& setting : setting_table()) {
            const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
            if (choice == nullptr) continue;
            for (const std::string_view word : choice->words) {
                Settings settings = reference;
                set_value(settings, setting, word);
                const std::string id = std::string(setting.name).append("=").append(word);
                add({.id = id, .name = "Made by " + id}, table_of(subject, scene, settings));
            }
        }
        for (const RowsEdit& edit : rows_edits()) {
            Rows edited = right;
            edit.apply(edited);
            add({.id = edit.id, .name = edit.name}, edited);
        }
    }
    rank_suspects(std::move(hypotheses), "this very table", diagnosis);
    return diagnosis;
}

} // namespace rasterwalk
