#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// How the student's program is timed.
struct MineBenchmark {
    int rounds = 5;                 ///< edits of each program; the median counts
    std::vector<std::string> names; ///< of the programs; empty: all
};

/// Prints how long a student waits after saving an edit: for each program, how many seconds after
/// the save each step of check_program() ends, next to its target, and the processor time of the
/// step. Of the first program, the first check, with an empty cache, is printed as well. A
/// temporary folder has the programs and the cache. Throws UsageError if there is no program of a
/// name, AccessError if programs cannot be compiled or guarded here.
void print_mine_times(const MineBenchmark& options);

} // namespace rasterwalk
