#pragma once

#include "engines/picture_agreement.h"
#include "engines/stopwatch.h"

namespace rasterwalk {

/// Something that draws a workload, and can be timed: an engine of this program, or the peer. It
/// has its scene, its settings and its threads from the beginning; pictures differ by their number
/// alone, see lamp_in_picture().
class TimedEngine {
  public:
    TimedEngine() = default;
    TimedEngine(const TimedEngine&) = delete;
    TimedEngine& operator=(const TimedEngine&) = delete;
    virtual ~TimedEngine() = default;

    /// Draws `count` pictures from number `first` on, and says how long all of them took together.
    virtual Milliseconds time_pictures(int first, int count) = 0;

    /// Draws one picture and hands it over.
    virtual EnginePicture picture(int number) = 0;
};

} // namespace rasterwalk
