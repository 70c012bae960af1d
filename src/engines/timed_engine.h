#pragma once

#include "engines/picture_agreement.h"
#include "engines/stopwatch.h"

namespace rasterwalk {

/// Something that draws a workload, and can be timed: an engine of this program, or the peer. It
/// has its scene, its settings and its threads from the beginning; pictures differ only by their
/// number, see lamp_in_picture().
class TimedEngine {
  public:
    TimedEngine() = default;
    TimedEngine(const TimedEngine&) = delete;
    TimedEngine& operator=(const TimedEngine&) = delete;
    virtual ~TimedEngine() = default;

    /// Draws `count` pictures, starting with number `first`, and returns the time for all of them.
    virtual Milliseconds time_pictures(int first, int count) = 0;

    /// Draws one picture and returns it.
    virtual EnginePicture picture(int number) = 0;
};

} // namespace rasterwalk
