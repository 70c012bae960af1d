#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "stages/polygon_rows.h"

namespace rasterwalk {

/// The row table of one polygon as printed: a pair of ends per line.
struct PrintedRow {
    glm::ivec2 start{0, 0}, end{0, 0}; ///< column, row

    friend bool operator==(const PrintedRow&, const PrintedRow&) = default;
};

/// Reads lines of the form `Start: (10,5). End: (10,5).`; lines that do not begin with Start are
/// skipped. Throws InputError with file:line, also if there is no such line at all.
std::vector<PrintedRow> parse_printed_rows(std::string_view text, const std::string& path);

/// A row table as the lab prints it.
std::vector<PrintedRow> printed(const PolygonRows& table);

/// The first row, from the top, in which a table differs from the reference, as a sentence: "The
/// first is row 7: columns 10 to 13 in the reference, columns 10 to 12 in yours." Empty if no row
/// differs, except for one that is printed twice.
std::string first_different_row(const std::vector<PrintedRow>& reference,
                                const std::vector<PrintedRow>& table);

/// How different two printed tables are, row by row.
struct RowsDistance {
    double mean = 0.0;          ///< columns, over all ends
    std::int64_t different = 0; ///< rows
};
RowsDistance rows_distance(const std::vector<PrintedRow>& a, const std::vector<PrintedRow>& b);

/// The most rows that a printed table may have.
inline constexpr std::size_t most_printed_rows = 100'000;

} // namespace rasterwalk
