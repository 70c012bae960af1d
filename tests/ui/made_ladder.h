#pragma once

#include <cmath>

#include "tests/ui/driver.h"

namespace rasterwalk {

/// Times of the ladder that were not measured: rung i takes 64 ms / 2^i, and one round of three
/// took twice as long. 5553 pixels differ where the rule of coverage changes.
inline void show_made_times(Driver& driver) {
    LadderLook& look = driver.ui.ladder;
    look.of = ladder_subject(driver.ui.session);
    look.processor = "a made processor with a name that is long enough to need two lines";
    look.times = {};
    for (const auto list : {ladder(), wrong_turnings()}) {
        for (const Rung& rung : list) {
            const double time = 64.0 / std::pow(2.0, static_cast<double>(look.times.rungs.size()));
            RungTime made{{time, 2.0 * time, time}, time, {}};
            made.from_previous.pixels = 1; // it was compared
            if (rung.has_other_edges) made.from_previous.different = 5553;
            look.times.rungs.push_back(made);
        }
    }
    look.times.rounds = 3;
    look.times.share = 1.0f;
}

} // namespace rasterwalk
