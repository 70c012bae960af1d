#pragma once

#include <string>

#include "session/ladder_run.h"

namespace rasterwalk {

/// Times of the ladder that were not measured here.
struct MadeTimes {
    std::string processor;
    LadderTimes times;
};

/// Reads such times, so that a picture of the Speed tab is the same on every machine. The first
/// line names the processor. Each of the others begins with a rung's name and how many pixels
/// differ; the milliseconds of its rounds follow. All rungs are in it, each once. Throws Error.
MadeTimes read_made_times(const std::string& path);

} // namespace rasterwalk
