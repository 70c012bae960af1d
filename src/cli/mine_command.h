#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/progress_line.h"

namespace rasterwalk {

struct MineOptions {
    std::vector<std::string> paths; ///< a program, a folder of one, or a folder of hand-ins; with
                                    ///< `merge`, tables that --json has printed
    std::string new_folder;         ///< write a program to begin with; empty: no
    std::string compiler;           ///< name or path; empty: the one that is found
    std::string html;               ///< file for the table; empty: none
    double seconds = 10.0;          ///< for searching what explains a picture, above 0
    bool skip_keys = false;         ///< no run with sanitizers
    bool merge = false;
    bool json = false;
};

/// Checks a student's program, or each of many, and prints what was found. Returns
/// ExitCode::difference if anything is wrong, ExitCode::bad_input if one program was named and does
/// not compile. Throws Error: AccessError if there is no compiler.
ExitCode mine_command(const MineOptions& options, std::ostream& out, std::ostream& err,
                      ProgressLine& progress);

} // namespace rasterwalk
