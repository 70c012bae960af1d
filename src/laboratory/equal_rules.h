#pragma once

// Equally right rules, in which programs of the lab differ. Most of them change a pixel here and
// there along the edges; affine light, culling and clipping may change more.

#include <string_view>
#include <vector>

#include "laboratory/bug.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Each rule as the settings it takes, the most common first.
const std::vector<Assignments>& equal_rules();

/// Is this one of the settings that the rules set? Its words are then rules or mistakes.
bool is_of_equal_rules(std::string_view setting);

/// The settings with the rule.
Settings by_equal_rule(const Assignments& rule, const Settings& settings);

/// Can these settings use that rule without being wrong? Light from the vertices may be
/// interpolated linearly on the screen, because the lab divides by z only for light per pixel.
bool is_equal_there(const Assignments& rule, const Settings& settings, const Scene& scene);

} // namespace rasterwalk
