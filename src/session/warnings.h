#pragma once

#include <string>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/tally.h"
#include "settings/choices.h"

namespace rasterwalk {

/// Something wrong in a frame.
struct Warning {
    std::string sentence;
    std::string in_short;    ///< the same where there is little room
    bool is_of_rows = false; ///< it is about row tables, which not everyone knows yet
    int triangle = -1;       ///< one that shows it; -1: none does
    int lesson = 0;          ///< the number of the one that explains why it happens; 0: none does

    friend bool operator==(const Warning&, const Warning&) = default;
};

/// What is wrong in a frame: settings that contradict each other, triangles left out, samples
/// outside.
/// @param of_steps the sums over its row tables
/// @param engine   that draws the picture: row tables, and what is left out, are those of the steps
std::vector<Warning> describe_warnings(const Frame& frame, const DrawTally& of_steps,
                                       Engine engine = Engine::steps);

/// The engine of the settings cannot draw, or has failed.
/// @param why a sentence without its full stop
Warning steps_draw_instead(Engine engine, const std::string& why);

} // namespace rasterwalk
