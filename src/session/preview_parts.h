#pragma once

#include "pipeline/work.h"
#include "session/results.h"
#include "session/session.h"

namespace rasterwalk {

/// While the hand moves, shows only previews if the steps cannot keep up. False: they can, or there
/// can be no previews. Only for update(), before the steps' part of it.
bool follow_hand(const Session& session, const WorkLimit& limit, Results& results);

/// After the steps' part of an update, keeps previews until the steps have drawn what the hand has
/// left to do. Only for update().
void update_previews(const Session& session, Results& results);

} // namespace rasterwalk
