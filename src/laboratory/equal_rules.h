#pragma once

// Rules of which none is wrong, and in which programs of the lab differ. Most of them change a
// pixel here and there along the edges; affine light, culling and clipping may change more.

#include <string_view>
#include <vector>

#include "laboratory/bug.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Each as the settings that it takes. Those that come first are met most often.
const std::vector<Assignments>& equal_rules();

/// Is this one of the settings that the rules say? Its words are rules or mistakes then.
bool is_of_equal_rules(std::string_view setting);

/// The settings by the rule.
Settings by_equal_rule(const Assignments& rule, const Settings& settings);

/// May these settings work by that rule without being wrong? Light from the vertices may be carried
/// straight across the picture: the lab divides by z only when light is computed per pixel.
bool is_equal_there(const Assignments& rule, const Settings& settings, const Scene& scene);

} // namespace rasterwalk
