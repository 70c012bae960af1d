#include "ui/actions/go_to_source.h"

#include "pipeline/timeline.h"
#include "session/tabs.h"
#include "session/walk.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

void go_to_source(Ui& ui, const Source& source) {
    Selection& selection = ui.session.selection;
    switch (source.kind) {
    case SourceKind::given:
    case SourceKind::formula:
        return;
    case SourceKind::setting:
        ui.inspector.setting_search = source.name;
        open_tab(ui, settings_tab);
        return;
    case SourceKind::vertex:
        selection.triangle = source.triangle;
        selection.vertex = source.vertex;
        ui.inspector.chosen.vertex_number = source.name;
        open_tab(ui, "vertices");
        return;
    case SourceKind::row_end:
        selection.triangle = source.triangle;
        selection.row = source.row;
        ui.inspector.shows_end_values = true;
        ui.inspector.scroll_to_row = true;
        open_tab(ui, "rows");
        return;
    case SourceKind::texel:
        go_to_texel(ui.session, source.face, {source.column, source.row});
        return;
    case SourceKind::moment: {
        selection.triangle = source.moment.triangle;
        // Where squares are the moments, an edge sample or a row has none.
        const bool has_squares = ui.results.a.frame.squares != nullptr;
        if (has_squares && source.moment.square < 0) return;
        const Timeline timeline(ui.results.a.frame);
        const Cursor moment = in_frame(source.moment, timeline.frame().pass);
        go_to(ui.session, timeline, timeline.next(moment, Granularity::moment));
        return;
    }
    }
}

} // namespace rasterwalk
