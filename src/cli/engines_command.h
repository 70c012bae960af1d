#pragma once

#include <iosfwd>
#include <string>

#include "base/error.h"
#include "cli/progress_line.h"

namespace rasterwalk {

/// As written on the command line; empty: not given.
struct EnginesOptions {
    std::string simd;
    std::string threads;
    std::string size; ///< WIDTHxHEIGHT
    std::string rounds;
    std::string workload;
    bool json = false;
};

/// Times the engines and llvmpipe, and prints how they compare. Returns ExitCode::difference if one
/// draws something wrong, ExitCode::interrupted if Ctrl+C has stopped it. Throws Error.
ExitCode engines_command(const EnginesOptions& options, std::ostream& out, ProgressLine& progress);

/// What is measured and what the columns mean: for its help.
std::string engines_footer();

} // namespace rasterwalk
