#pragma once

// Rules of which none is wrong: programs of the lab differ in them, and their pictures do by a
// pixel here and there along the edges.

#include <string_view>
#include <vector>

#include "laboratory/bug.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Each as the settings that it takes. Those that come first are met most often.
const std::vector<Assignments>& equal_rules();

/// Is this one of the settings that the rules say? Its words are rules or mistakes then.
bool is_of_equal_rules(std::string_view setting);

/// The settings by the rule. Before light is worked out at each pixel, it may be carried straight
/// across the picture: the lab divides by z only afterwards.
Settings by_equal_rule(const Assignments& rule, const Settings& settings);

/// May these settings work by that rule without being wrong?
bool is_equal_there(const Assignments& rule, const Settings& settings);

} // namespace rasterwalk
