#include "ui/widgets/row_ends.h"

#include "base/element_names.h"
#include "base/numbers.h"
#include "session/walk.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"

namespace rasterwalk {

std::string sample_text(int edge, int sample) {
    return short_place({0, Phase::edges, edge, sample});
}

std::string end_text(const RowEnd& end, bool is_left, bool is_short) {
    const bool is_extreme = end.column == empty_left || end.column == empty_right;
    if (!is_extreme) return whole_text(end.column);
    if (is_short) return is_left ? "+MAX" : "−MAX";
    return is_left ? "+INT_MAX" : "−INT_MAX";
}

std::string replaced_tooltip(const EndWriter& writer) {
    return "↻: this end has been replaced " + counted(writer.replaced, "time", "times") +
           " so far.";
}

std::string writer_tooltip(const EndWriter& writer) {
    return "Written by " + sample_name(writer.edge, writer.sample) + "." +
           (writer.replaced > 0 ? "\n" + replaced_tooltip(writer) : "") +
           "\nClick to go to the moment when it was written.";
}

std::string end_tooltip(const Ui& ui, const RowEnd& end, const EndWriter& writer) {
    if (writer.is_set()) return writer_tooltip(writer);
    const bool is_extreme = end.column == empty_left || end.column == empty_right;
    if (!walks_edges(ui.results.a.frame.stages)) {
        return is_extreme ? "INT_MAX with its sign: so far no pixel of this row is inside."
                          : "The outermost pixel of this row that is inside.";
    }
    return is_extreme
               ? "INT_MAX with its sign: no sample has reached this row yet, so any column is "
                 "an improvement."
               : "Where this end starts: no sample has improved on it.";
}

void go_to_sample(Ui& ui, int edge, int sample) {
    const Timeline timeline(ui.results.a.frame);
    const Cursor cursor{*ui.results.a.triangle, Phase::edges, edge, sample};
    if (timeline.exists(cursor))
        go_to(ui.session, timeline, timeline.next(cursor, Granularity::moment));
}

std::optional<int> row_at_work(const Ui& ui) {
    const RowHistory& history = ui.results.a.rows;
    const std::optional<Cursor>& done = ui.results.a.done;
    if (!done || done->triangle != ui.results.a.triangle) return std::nullopt;
    if (done->phase == Phase::rows) return history.rows.first_row + done->index;
    if (done->phase == Phase::tests) return tested_row(history.rows.tested, done->index).row;
    if (done->phase == Phase::edges && history.last && history.last->write.inside)
        return history.rows.first_row + history.last_index;
    return std::nullopt;
}

RowWrite just_written(const Ui& ui, int row) {
    const RowHistory& history = ui.results.a.rows;
    const std::optional<Cursor>& done = ui.results.a.done;
    const bool is_sample =
        done && done->triangle == ui.results.a.triangle && done->phase == Phase::edges;
    const int written = history.rows.first_row + history.last_index;
    if (!is_sample || history.last_index < 0 || written != row) return {};
    return history.last->write;
}

} // namespace rasterwalk
