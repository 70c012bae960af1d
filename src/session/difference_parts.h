#pragma once

#include "pipeline/work.h"
#include "session/results.h"

namespace rasterwalk {

/// Goes on working out how the pictures at the cursor differ. Of large ones only while neither is
/// being drawn, in parts; what a step changes of them is seen at once. To be called by update()
/// alone.
/// @param view      that both pictures show
/// @param new_scale the colours of the difference have another scale
void update_difference(View view, bool new_scale, const WorkLimit& limit, Results& results);

} // namespace rasterwalk
