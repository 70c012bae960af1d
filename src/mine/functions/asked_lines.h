#pragma once

#include <vector>

#include "mine/functions/check_parts.h"

namespace rasterwalk {

/// The questions that were answered, and how.
struct AskedLines {
    const std::vector<LineQuestion>& questions;
    const std::vector<PixelList>& answers;
    bool is_real = false; ///< positions keep their fractions

    int count() const { return static_cast<int>(answers.size()); }
};

/// Checks what the samples of the lines carry: 1/z, the position, the light.
/// @param right loses the lines on which a value is wrong
void check_carried_values(const AskedLines& asked, RightQuestions& right, FunctionCheck& check);

} // namespace rasterwalk
