#include "laboratory/printed_rows.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/image_format.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

/// An end that is off by more counts as this far off: one wild number must not drown the others.
constexpr std::int64_t most_columns_off = 16;

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

std::int64_t columns_off(int a, int b) {
    const std::int64_t apart = std::abs(static_cast<std::int64_t>(a) - b);
    return std::min(apart, most_columns_off);
}

/// The rows of two tables that have the same number.
using RowsByNumber = std::map<int, std::pair<const PrintedRow*, const PrintedRow*>>;

/// @param repeated grows by the rows that a table has more than once; the last of these counts
RowsByNumber by_number(const std::vector<PrintedRow>& a, const std::vector<PrintedRow>& b,
                       std::int64_t& repeated) {
    RowsByNumber rows;
    const auto take = [&](const PrintedRow& row, const PrintedRow*& place) {
        repeated += place == nullptr ? 0 : 1;
        place = &row;
    };
    for (const PrintedRow& row : a)
        take(row, rows[row.start.y].first);
    for (const PrintedRow& row : b)
        take(row, rows[row.start.y].second);
    return rows;
}

} // namespace

std::vector<PrintedRow> printed(const PolygonRows& table) {
    std::vector<PrintedRow> rows;
    rows.reserve(table.left.size());
    for (std::size_t i = 0; i < table.left.size(); ++i) {
        const int row = table.first_row + static_cast<int>(i);
        rows.push_back({{table.left[i].column, row}, {table.right[i].column, row}});
    }
    return rows;
}

std::string first_different_row(const std::vector<PrintedRow>& reference,
                                const std::vector<PrintedRow>& table) {
    const auto columns = [](const PrintedRow& row) {
        if (row.start.x > row.end.x && row.start.y == row.end.y) return std::string("no pixels");
        return row.start.y == row.end.y ? fmt::format("columns {} to {}", row.start.x, row.end.x)
                                        : fmt::format("({},{}) to ({},{})", row.start.x,
                                                      row.start.y, row.end.x, row.end.y);
    };
    std::int64_t repeated = 0;
    for (const auto& [number, both] : by_number(reference, table, repeated)) {
        const auto& [right, own] = both;
        if (own == nullptr)
            return fmt::format("The first is row {}, which is missing from yours.", number);
        if (right == nullptr) {
            return fmt::format("The first is row {}, which the reference does not have.", number);
        }
        if (*right == *own) continue;
        return fmt::format("The first is row {}: {} in the reference, {} in yours.", number,
                           columns(*right), columns(*own));
    }
    return "";
}

RowsDistance rows_distance(const std::vector<PrintedRow>& a, const std::vector<PrintedRow>& b) {
    std::int64_t sum = 0, different = 0, repeated = 0;
    const RowsByNumber rows = by_number(a, b, repeated);
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

std::vector<PrintedRow> parse_printed_rows(std::string_view text, const std::string& path) {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // that some editors put before UTF-8
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        throw InputError(path, 1, "the text is UTF-16; save it as UTF-8.");
    }
    std::vector<PrintedRow> rows;
    int number = 0;
    while (!text.empty()) {
        ++number;
        std::string_view line = take_part(text, '\n');
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (!line.starts_with("Start")) continue;
        const std::optional<PrintedRow> row = parse_row(line);
        if (!row) {
            throw InputError(path, number,
                             "a row must look like 'Start: (10,5). End: (10,5).' with whole "
                             "numbers.");
        }
        if (rows.size() == most_printed_rows) {
            throw InputError(path, number, "there are too many rows.");
        }
        rows.push_back(*row);
    }
    if (rows.empty()) {
        throw InputError(fmt::format("{}: this is neither a picture ({}) nor a printed row table, "
                                     "which has lines like 'Start: (10,5). End: (10,5).'.",
                                     path, exact_image_formats));
    }
    return rows;
}

} // namespace rasterwalk
