#include "cli/row_json.h"

namespace rasterwalk {

namespace {

toml::table writer_json(const EndWriter& end) {
    if (!end.is_set()) return {};
    return toml::table{{"edge", end.edge}, {"sample", end.sample}, {"replaced", end.replaced}};
}

} // namespace

toml::array rows_json(const RowHistory& history) {
    toml::array rows;
    for (std::size_t i = 0; i < history.rows.left.size(); ++i) {
        rows.push_back(toml::table{{"row", history.rows.left[i].row},
                                   {"left", history.rows.left[i].column},
                                   {"right", history.rows.right[i].column},
                                   {"left_by", writer_json(history.left_by[i])},
                                   {"right_by", writer_json(history.right_by[i])}});
    }
    return rows;
}

toml::array outside_json(const RowHistory& history) {
    toml::array outside;
    for (const OutsideSample& sample : history.outside) {
        outside.push_back(toml::table{{"edge", sample.edge},
                                      {"sample", sample.sample},
                                      {"x", static_cast<double>(sample.x)},
                                      {"y", static_cast<double>(sample.y)},
                                      {"column", sample.column},
                                      {"row", sample.row}});
    }
    return outside;
}

} // namespace rasterwalk
