#pragma once

#include "laboratory/bug.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Does the mistake change a rule by which pictures are drawn? Otherwise it only leads the camera
/// to a wrong place. No picture tells that, since any place may be meant.
bool changes_rule(const Bug& bug);

/// Makes the mistake in these settings and leaves everything else as it is: the stage and whatever
/// else the laboratory sets so that the mistake is easy to see.
void apply_bug_rule(const Bug& bug, Settings& settings);

/// Do these settings make the mistake already? The lab's own make some, which are mistakes only
/// beside better rules.
bool is_made_by(const Bug& bug, const Settings& settings);

} // namespace rasterwalk
