#include "ui/canvas/cost_legend.h"

#include <algorithm>
#include <cfloat>

#include <fmt/format.h>

#include "picture/overlay.h"
#include "ui/actions/compare.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// From one column of the counts of work to the next, at least, design pixels.
constexpr float cost_gap = 24.0f;

} // namespace

std::size_t CostTable::columns(float width) const {
    return static_cast<std::size_t>(std::max(width / least_column, 1.0f));
}

std::size_t CostTable::rows(float width) const {
    return (lines.size() + columns(width) - 1) / columns(width);
}

CostTable cost_table(const Ui& ui) {
    const DrawCost& cost = ui.results.overlay.cost.cost();
    const ImFont& font = *ui.fonts.small;
    CostTable table;
    for (const CostInfo& info : cost_list()) {
        if (cost.*info.count == 0) continue;
        table.lines.push_back({info.title, grouped(cost.*info.count)});
        const std::string text = fmt::format("{} {}", info.title, table.lines.back().count);
        const float width = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.c_str()).x;
        table.least_column = std::max(table.least_column, width);
    }
    table.least_column += cost_gap * ui.options.text_scale;
    return table;
}

std::string tooltip_lines(const CostTable& table) {
    std::string lines;
    for (const CostLine& line : table.lines)
        lines += fmt::format("\n{}: {}", line.title, line.count);
    return lines;
}

void draw_cost_table(const Ui& ui, const CostTable& table, float width, ImVec2 at, float right,
                     float line) {
    const Palette& p = palette(ui.options.theme);
    const std::size_t rows = table.rows(width);
    const float gap = cost_gap * ui.options.text_scale;
    const float column = (right - at.x + gap) / static_cast<float>(table.columns(width));
    for (std::size_t i = 0; i < table.lines.size(); ++i) {
        const std::size_t columns_before = i / rows, rows_before = i % rows;
        const float x = at.x + column * static_cast<float>(columns_before);
        const float y = at.y + line * static_cast<float>(rows_before);
        const std::string& count = table.lines[i].count;
        ImGui::SetCursorScreenPos({x, y});
        text_in(p.dim, table.lines[i].title);
        ImGui::SetCursorScreenPos({x + column - gap - ImGui::CalcTextSize(count.c_str()).x, y});
        text_in(p.text, count);
    }
}

} // namespace rasterwalk
