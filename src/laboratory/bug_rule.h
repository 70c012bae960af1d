#pragma once

#include "laboratory/bug.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Does the mistake change a rule by which pictures are drawn? Otherwise it only leads the camera
/// to a wrong place, which no picture shows, since any place may be intended.
bool changes_rule(const Bug& bug);

/// Makes the mistake in these settings and changes nothing else: not the stage, nor whatever else
/// the laboratory sets to make the mistake easy to see.
void apply_bug_rule(const Bug& bug, Settings& settings);

/// Do these settings already make the mistake? The lab's own make some, which are mistakes only
/// compared with better rules.
bool is_made_by(const Bug& bug, const Settings& settings);

} // namespace rasterwalk
