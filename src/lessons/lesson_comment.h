#pragma once

// A block in a comment of a lesson: <!-- step, TOML, -->.

#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "base/faults.h"

namespace rasterwalk {

struct LessonComment {
    std::string_view kind; ///< its first word
    toml::table table;
    int line = 0;         ///< from 1
    bool is_good = false; ///< its TOML was read; a comment `note` has none
};

/// Reads the comment that begins on line `next`, counted from 0, and moves `next` to the line after
/// it. What is wrong with it goes to the list.
LessonComment read_comment(const std::vector<std::string_view>& lines, std::size_t& next,
                           FaultList& faults);

} // namespace rasterwalk
