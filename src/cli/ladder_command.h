#pragma once

#include <iosfwd>
#include <string>

#include "base/error.h"
#include "cli/progress_line.h"
#include "opening/opened_view.h"

namespace rasterwalk {

/// Numbers are as written on the command line; empty: not given.
struct LadderOptions {
    ViewOptions view;
    std::string rounds;
    std::string rung; ///< the only one that is printed
    std::string race; ///< runs of the race, in place of the ladder
    bool json = false;
};

/// Times the rungs of the ladder and prints what each gains, or runs the race. Returns
/// ExitCode::difference if a rung draws something wrong, ExitCode::interrupted if Ctrl+C has
/// stopped it. Throws Error.
ExitCode ladder_command(const LadderOptions& options, std::ostream& out, ProgressLine& progress);

/// The rungs, and what the columns mean: for its help.
std::string ladder_footer();

} // namespace rasterwalk
