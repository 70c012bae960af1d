#include "cli/commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/error.h"
#include "base/numbers.h"
#include "cli/json.h"
#include "cli/points.h"
#include "cli/row_json.h"
#include "inspect/row_history.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

[[noreturn]] void refuse_point(const std::string& text) {
    const int largest = static_cast<int>(largest_pixel_coordinate);
    throw UsageError(
        fmt::format("'{}' is not a point. Write it as X,Y in whole numbers from -{} to {}.", text,
                    largest, largest));
}

int parse_coordinate(std::string_view part, const std::string& whole) {
    int value = 0;
    const char* const last = part.data() + part.size();
    const auto [end, fault] = std::from_chars(part.data(), last, value);
    const int largest = static_cast<int>(largest_pixel_coordinate);
    if (fault != std::errc{} || end != last || value < -largest || value > largest) {
        refuse_point(whole);
    }
    return value;
}

void check_assignment(const std::string& assignment) {
    constexpr std::array<std::string_view, 9> known{"rounding",      "line",       "bresenham_rule",
                                                    "line_rounding", "line_walk",  "edge_samples",
                                                    "row_start",     "row_search", "viewport.size"};
    const std::string_view name = std::string_view(assignment).substr(0, assignment.find('='));
    if (find_setting(name) == nullptr) return; // set_from_text has a better sentence for it
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw UsageError("rows depend on rounding, line, bresenham_rule, line_walk, edge_samples, "
                         "row_start, row_search and viewport.size, not on " +
                         std::string(name) + ".");
    }
}

Settings read_rules(const RowsOptions& options) {
    Settings settings;
    if (!options.presets.empty()) {
        const std::vector<Preset> presets = read_presets(lessons_folder() + "/presets.toml");
        for (const std::string& name : options.presets) {
            apply_preset(find_preset(presets, name), settings);
        }
    }
    for (const std::string& assignment : options.assignments) {
        check_assignment(assignment);
        set_from_text(settings, assignment);
    }
    return settings;
}

} // namespace

ScreenVertex parse_point(const std::string& text) {
    std::string_view rest = text;
    // A point may be quoted with blanks around it.
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::size_t comma = rest.find(',');
    if (comma == std::string_view::npos) refuse_point(text);
    ScreenVertex point;
    point.column = parse_coordinate(rest.substr(0, comma), text);
    point.row = parse_coordinate(rest.substr(comma + 1), text);
    point.depth = point.inv_w = point.z = 1.0f;
    return point;
}

void rows_command(const RowsOptions& options, std::ostream& out, std::ostream& err) {
    if (options.points.size() > max_polygon_vertices) {
        throw UsageError(
            fmt::format("a polygon may have at most {} points.", max_polygon_vertices));
    }
    std::vector<ScreenVertex> vertices;
    for (const std::string& point : options.points)
        vertices.push_back(parse_point(point));
    const Settings settings = read_rules(options);
    const RowHistory history = row_history(vertices, edge_rules(settings), choose_stages(settings));
    if (options.json) {
        print_json({{"outside", outside_json(history)}, {"rows", rows_json(history)}}, out);
    } else {
        out << rows_text(history.rows);
    }
    for (const OutsideSample& sample : history.outside) {
        err << fmt::format("rasterwalk: {} at ({}, {}) falls in row {}, outside the table; it is "
                           "not written.\n",
                           sample_name(sample.edge, sample.sample), nine_digits(sample.x),
                           nine_digits(sample.y), sample.row);
    }
}

} // namespace rasterwalk
