#include "ui/canvas/marks.h"

#include <string>

#include "ui/actions/picture_fit.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The part of the picture that is in view: its cells, and where these lie on the screen.
struct VisibleCells {
    VisibleRange columns, rows;
    float left, right, top, bottom;
};

VisibleCells visible_cells(const Marks& m) {
    const Viewport size = m.run.frame.settings.viewport;
    const ImVec2 origin = m.run.place.origin;
    VisibleCells cells{visible(origin.x, m.scale, m.low.x, m.high.x, size.width),
                       visible(origin.y, m.scale, m.low.y, m.high.y, size.height),
                       0.0f,
                       0.0f,
                       0.0f,
                       0.0f};
    cells.top = origin.y + m.scale * static_cast<float>(cells.rows.first);
    cells.bottom = origin.y + m.scale * static_cast<float>(cells.rows.last);
    cells.left = origin.x + m.scale * static_cast<float>(cells.columns.first);
    cells.right = origin.x + m.scale * static_cast<float>(cells.columns.last);
    return cells;
}

void draw_lines(const Marks& m, const VisibleCells& cells) {
    const ImVec2 origin = m.run.place.origin;
    const ImU32 line = IM_COL32(128, 136, 150, 60);
    for (int c = cells.columns.first; c <= cells.columns.last; ++c) {
        const float x = origin.x + m.scale * static_cast<float>(c);
        m.list->AddLine({x, cells.top}, {x, cells.bottom}, line);
    }
    for (int r = cells.rows.first; r <= cells.rows.last; ++r) {
        const float y = origin.y + m.scale * static_cast<float>(r);
        m.list->AddLine({cells.left, y}, {cells.right, y}, line);
    }
}

/// The numbers of columns and rows.
class Ruler {
  public:
    Ruler(const Marks& marks, const VisibleCells& in_view)
        : m(marks), cells(in_view), font(marks.ui.fonts.small), size(font->FontSize) {
        const ImVec2 needed = ruler_size(marks.ui);
        if (cells.top < m.low.y + needed.y) strip_bottom = m.low.y + needed.y;
        if (cells.left < m.low.x + needed.x) strip_right = m.low.x + needed.x;
    }

    void draw() const {
        const ImU32 ground = packed(palette(m.ui.options.theme).canvas);
        // The picture may be as bright or as dark as the numbers.
        if (strip_bottom > 0.0f) m.list->AddRectFilled(m.low, {m.high.x, strip_bottom}, ground);
        if (strip_right > 0.0f) m.list->AddRectFilled(m.low, {strip_right, m.high.y}, ground);
        const float number_y =
            strip_bottom > 0.0f ? m.low.y + 4.0f * m.u : cells.top - size - 4.0f * m.u;
        const int step = step_at(text_width(font, "8888"));
        for (int c = cells.columns.first; c < cells.columns.last; ++c) {
            if (c % step != 0) continue;
            const float width = text_width(font, std::to_string(c));
            const float x = m.at(static_cast<float>(c), 0.0f).x - 0.5f * width;
            if (x < std::max(m.low.x, strip_right) || x + width > m.high.x) continue;
            write(x, number_y, c, strip_bottom > 0.0f);
        }
        for (int r = cells.rows.first; r < cells.rows.last; ++r) {
            if (r % step != 0) continue;
            const float right =
                strip_right > 0.0f ? strip_right - 5.0f * m.u : cells.left - 6.0f * m.u;
            const float y = m.at(0.0f, static_cast<float>(r)).y - 0.5f * size;
            if (y < std::max(m.low.y, strip_bottom) || y + size > m.high.y) continue;
            write(right - text_width(font, std::to_string(r)), y, r, strip_right > 0.0f);
        }
    }

    /// The lower right corner of the strips.
    ImVec2 corner() const {
        return {std::max(m.low.x, strip_right), std::max(m.low.y, strip_bottom)};
    }

  private:
    int step_at(float widest) const {
        return m.scale >= widest ? 1 : m.scale * 5.0f >= widest ? 5 : 10;
    }
    void write(float x, float y, int number, bool on_strip) const {
        const Palette& p = palette(m.ui.options.theme);
        m.list->AddText(font, size, {x, y}, packed(on_strip ? p.text : p.dim),
                        std::to_string(number).c_str());
    }

    const Marks& m;
    VisibleCells cells;
    ImFont* font;
    float size;
    float strip_bottom = 0.0f; ///< of the strip of column numbers on the picture; 0: it needs none
    float strip_right = 0.0f;  ///< of the strip of row numbers; 0: it needs none
};

} // namespace

ImVec2 corner_of_cells(const Marks& m) {
    return Ruler(m, visible_cells(m)).corner();
}

ImVec2 corner_of_labels(const Marks& m) {
    const VisibleCells cells = visible_cells(m);
    const ImVec2 corner = Ruler(m, cells).corner();
    return {std::max(corner.x, cells.left), std::max(corner.y, cells.top)};
}

void draw_grid(const Marks& m) {
    const VisibleCells cells = visible_cells(m);
    if (cells.columns.first >= cells.columns.last || cells.rows.first >= cells.rows.last) return;
    if (m.ui.session.canvas.grid) draw_lines(m, cells);
}

void draw_ruler(const Marks& m) {
    const VisibleCells cells = visible_cells(m);
    if (cells.columns.first >= cells.columns.last || cells.rows.first >= cells.rows.last) return;
    Ruler(m, cells).draw();
}

} // namespace rasterwalk
