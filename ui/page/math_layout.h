#pragma once

#include "text/math.h"
#include "ui/page/markdown_layout.h"

namespace rasterwalk {

/// A formula set in two dimensions. Places are screen pixels from the left end of its baseline.
struct MathBox {
    float width = 0.0f;
    float ascent = 0.0f;  ///< above the baseline
    float descent = 0.0f; ///< below the baseline
    std::vector<PagePiece> pieces;
    std::vector<PageShape> shapes;
};

/// Sets a formula. Its text is kept in `made`, which must live as long as the box.
/// @param unit screen pixels per design pixel
MathBox set_math(const MathNode& formula, const Fonts& fonts, float unit,
                 std::deque<std::string>& made);

} // namespace rasterwalk
