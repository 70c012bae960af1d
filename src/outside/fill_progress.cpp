#include "outside/fill_progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stages/stages.h"

namespace rasterwalk {

FillProgress::FillProgress(const Frame& frame, const Cursor& cursor, int triangle)
    : frame_(frame), cursor_(cursor), triangle_(triangle),
      is_whole_(frame.is_drawn(triangle) && triangle < cursor.triangle),
      has_columns_(has_fragments(frame.settings.stage)) {
    // A triangle whose rows have not begun is not filled at all.
    has_rows_ = !is_whole_ && frame.is_drawn(triangle) && frame.settings.stage >= Stage::rows &&
                cursor > Cursor{triangle, Phase::rows, 0, 0};
    if (has_rows_) compute_rows(frame, triangle, rows_, nullptr, VaryingSet());
}

bool FillProgress::has(const glm::dvec2& pixel) const {
    const double row = std::floor(pixel.y) - rows_.first_row;
    const auto index = static_cast<int>(std::clamp(row, 0.0, rows_.size() - 1.0));
    int step = 0;
    if (has_columns_) {
        const double column =
            std::floor(pixel.x) - rows_.left[static_cast<std::size_t>(index)].column;
        const int last = std::max(row_span(frame_.stages, rows_, index).count - 1, 0);
        step = static_cast<int>(std::clamp(column, 0.0, static_cast<double>(last)));
    }
    return Cursor{triangle_, Phase::rows, index, step} < cursor_;
}

} // namespace rasterwalk
