#pragma once

// The search for what may have made a picture: by which rules and with which numbers it is drawn,
// none of them wrong, and which mistake is made on top of them, or which two.

#include <vector>

#include "laboratory/attempt.h"
#include "laboratory/picture_trial.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Everything that was tried and is drawn, in no order; the first is the reference. Asks the trial:
/// as long as that is waiting, more is to come.
std::vector<Attempt> search_picture(PictureTrial& trial, const Settings& reference,
                                    const std::vector<Change>& changes);

} // namespace rasterwalk
