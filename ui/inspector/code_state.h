#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab_code/code_walk.h"

namespace rasterwalk {

/// An entry of leftPixels or rightPixels that a line of the code reads or writes.
struct CodeEntry {
    int index = 0;
    bool is_left = false;
};

/// What the lab's code keeps from one frame to the next, see ui/actions/code.h.
struct CodeLook {
    std::optional<LabCode> code; ///< none: not read yet
    CodeWalk walk;
    bool is_ready = false; ///< `walk` is at `place`, which is the moment of the picture
    std::string fault;     ///< why it is not; empty: there is no fault
    /// The frame and the moment at which it failed; none: it has not.
    std::optional<std::pair<std::uint64_t, Cursor>> failed_at;
    CodePlace place;         ///< the line that comes next
    bool is_running = false; ///< to a goal, over several frames
    bool is_meeting = false; ///< the goal is a line or a condition
    int asked_line = 0;      ///< of the program; 0: any whose condition holds
    std::vector<LineCondition> conditions;
    std::string condition_fault;         ///< of the condition last given; empty: none
    std::optional<LineCondition> edited; ///< the condition in the field
    std::optional<std::size_t> call; ///< whose lines are shown, from outside; none: the innermost
    std::vector<CodeEntry> pointed;  ///< those of the line under the pointer; lit in the table
    int scrolled_to = 0;             ///< line of the program that the page was last scrolled to
    float scrolled_in = 0.0f;        ///< and how high the box was, screen pixels
};

} // namespace rasterwalk
