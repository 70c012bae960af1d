#include "cli/row_json.h"

namespace rasterwalk {

namespace {

Json writer_json(const EndWriter& end) {
    if (!end.is_set()) return Json::object();
    return {{"edge", end.edge}, {"replaced", end.replaced}, {"sample", end.sample}};
}

} // namespace

Json rows_json(const RowHistory& history) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < history.rows.left.size(); ++i) {
        rows.push_back({{"left", history.rows.left[i].column},
                        {"left_by", writer_json(history.left_by[i])},
                        {"right", history.rows.right[i].column},
                        {"right_by", writer_json(history.right_by[i])},
                        {"row", history.rows.first_row + static_cast<int>(i)}});
    }
    return rows;
}

Json outside_json(const RowHistory& history) {
    Json outside = Json::array();
    for (const OutsideSample& sample : history.outside) {
        outside.push_back({{"column", sample.column},
                           {"edge", sample.edge},
                           {"row", sample.row},
                           {"sample", sample.sample},
                           {"x", sample.x},
                           {"y", sample.y}});
    }
    return outside;
}

} // namespace rasterwalk
