#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session/ladder_run.h"

namespace rasterwalk {

/// What the Speed tab keeps from one frame to the next.
struct LadderLook {
    StepMaker maker = StepMaker::thread;
    int rounds = usual_ladder_rounds;   ///< of the next measurement
    std::unique_ptr<LadderRun> run;     ///< null: nothing is being measured
    std::optional<LadderSubject> of;    ///< what the times belong to; none: there are none
    LadderTimes times;                  ///< so far, or of the last measurement
    std::string processor;              ///< that they were measured on
    std::string fault;                  ///< why the last measurement ended early; empty: it did not
    std::optional<LadderSubject> asked; ///< what the next was found for
    std::string obstacle;               ///< why it cannot be measured; empty: it can
    std::optional<std::size_t> chosen;  ///< place of the rung that is explained; none: none is
    std::unique_ptr<RaceRun> race;      ///< null: none is running
    std::vector<std::int64_t> wrong;    ///< pixels in each picture of the last race
    std::size_t in_sight = 0;           ///< the chosen rung that was last scrolled to
    float bottom = 0.0f;                ///< of the list at that time, screen pixels
    /// What was stopped, until its thread has noticed: the window does not wait.
    std::vector<std::unique_ptr<LadderRun>> stopped;
};

} // namespace rasterwalk
