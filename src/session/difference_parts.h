#pragma once

#include "pipeline/work.h"
#include "session/results.h"

namespace rasterwalk {

/// Continues computing how the pictures at the cursor differ. With large ones, only while neither
/// is being drawn, in parts; what a step changes in them shows at once. Only for update().
/// @param view      that both pictures show
/// @param new_scale the colours of the difference have a new scale
void update_difference(View view, bool new_scale, const WorkLimit& limit, Results& results);

} // namespace rasterwalk
