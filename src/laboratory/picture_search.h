#pragma once

// The search for what may have made a picture: the rules and numbers it is drawn with, none of them
// wrong, and the one or two mistakes made on top of them.

#include <vector>

#include "laboratory/attempt.h"
#include "laboratory/picture_trial.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Everything that was tried and is drawn; the first is the reference, the rest are in no order.
/// Asks the trial: as long as that is waiting, more will follow.
std::vector<Attempt> search_picture(PictureTrial& trial, const Settings& reference,
                                    const std::vector<Change>& changes);

} // namespace rasterwalk
